// A folder for the files of one test case.

#ifndef SIMPLE_MANIFOLDS_TEST_TEMPORARY_FOLDER_H
#define SIMPLE_MANIFOLDS_TEST_TEMPORARY_FOLDER_H

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

class Temporary_folder {
public:
  Temporary_folder()
  {
    const std::filesystem::path base = std::filesystem::temp_directory_path() / "simple_manifolds_test";
    for (int i = 0;; ++i) { // tests may run in several processes
      path_ = base.string() + std::to_string(i);
      if (std::filesystem::create_directory(path_)) return;
    }
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder() { std::filesystem::remove_all(path_); }

  std::string operator()(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& contents) const
  {
    std::ofstream(path_ / name, std::ios::binary) << contents;
    return (*this)(name);
  }

  std::string read(const std::string& name) const
  {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// All files and folders in it, sorted.
  std::vector<std::string> entries() const
  {
    std::vector<std::string> names;
    for (const auto& e : std::filesystem::recursive_directory_iterator(path_))
      names.push_back(e.path().lexically_relative(path_).string());
    std::sort(names.begin(), names.end());
    return names;
  }

private:
  std::filesystem::path path_;
};

#endif // SIMPLE_MANIFOLDS_TEST_TEMPORARY_FOLDER_H
