// Reads all files of a folder by fuzz_reader.cpp, each as it is and then with many random changes.
//
//   replay FOLDER COUNT

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void read(const std::string& bytes)
{
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string changed(std::string bytes, const std::string& other, std::mt19937& random)
{
  const auto below = [&](std::size_t n) { return n ? random() % n : 0; };
  for (int k = 1 + int(below(4)); k > 0; --k) {
    const std::size_t at = below(bytes.size() + 1);
    switch (below(6)) {
    case 0:
      bytes.resize(at);
      break;
    case 1:
      bytes.insert(at, 1, char(below(256)));
      break;
    case 2:
      bytes.erase(at, 1 + below(8));
      break;
    case 3:
      bytes.insert(at, other.substr(below(other.size() + 1), below(40)));
      break;
    case 4:
      if (at < bytes.size()) bytes[at] = char("0123456789-. \n\xff"[below(15)]);
      break;
    default:
      if (at < bytes.size()) bytes[at] = char(bytes[at] ^ (1 << below(8)));
    }
  }
  return bytes;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "replay FOLDER COUNT\n";
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> contents;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    contents.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    read(contents.back());
  }
  if (contents.empty()) {
    std::cerr << argv[1] << " has no file\n";
    return 2;
  }
  std::mt19937 random(1);
  const int count = std::atoi(argv[2]);
  for (int k = 0; k < count; ++k)
    read(changed(contents[random() % contents.size()], contents[random() % contents.size()], random));
  std::cout << contents.size() << " files and " << count << " changed ones were read or refused\n";
}
