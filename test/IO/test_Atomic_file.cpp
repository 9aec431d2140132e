#include "catch.h"

#include "short_of_memory.h"
#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>

#include <sys/stat.h>

#include <new>

namespace test_Atomic_file {

namespace SM = CGAL::Simple_manifolds;
using Names = std::vector<std::string>;

TEST_CASE("a file appears in commit(), and before that the old one stays")
{
  const Temporary_folder folder;
  folder.write("a.txt", "old");
  {
    SM::Atomic_file file(folder("a.txt"));
    file.stream() << "new";
    CHECK(folder.read("a.txt") == "old");
    file.commit();
  }
  CHECK(folder.read("a.txt") == "new");
  {
    SM::Atomic_file file(folder("a.txt"));
    file.stream() << "abandoned";
  }
  CHECK(folder.read("a.txt") == "new");
  CHECK(folder.entries() == Names{"a.txt"});
}

TEST_CASE("a file that cannot be written is an error that names it")
{
  const Temporary_folder folder;
  std::filesystem::create_directory(folder("is_folder"));
  for (const std::string& name : Names{"missing/a.txt", "is_folder", std::string(300, 'a')}) {
    try {
      SM::Atomic_file file(folder(name));
      FAIL("no error");
    } catch (const SM::IO_error& e) {
      CHECK(e.code() == SM::Error_code::cannot_write);
      CHECK(e.file() == folder(name));
    }
  }
  CHECK(folder.entries() == Names{"is_folder"});
  CHECK_THROWS_AS(SM::Atomic_file(""), SM::IO_error);
}

TEST_CASE("whenever memory is short, nothing is left behind")
{
  const Temporary_folder folder;
  folder.write("a.txt", "old");
  const std::string name = folder("a.txt");
  bool is_written = false;
  for (long n = 0; !is_written; ++n) {
    allocations_left = n;
    try {
      SM::Atomic_file file(name);
      file.stream() << "new";
      file.commit();
      is_written = true;
    } catch (const std::bad_alloc&) {
    }
    allocations_left = -1;
    REQUIRE(folder.entries() == Names{"a.txt"});
    REQUIRE(folder.read("a.txt") == (is_written ? "new" : "old"));
  }
  const std::string there = folder("there");
  is_written = false;
  for (long n = 0; !is_written; ++n) {
    allocations_left = n;
    try {
      SM::Atomic_folder output(there);
      const std::string b = output.file("b");
      allocations_left = -1;
      std::ofstream(b) << "B";
      allocations_left = n;
      output.commit();
      is_written = true;
    } catch (const std::bad_alloc&) {
    }
    allocations_left = -1;
    REQUIRE(folder.entries() == (is_written ? Names{"a.txt", "there", "there/b"} : Names{"a.txt"}));
  }
}

TEST_CASE("links are followed, devices and their like are no files")
{
  const Temporary_folder folder;
  folder.write("a.txt", "old");
  std::filesystem::create_symlink("a.txt", folder("link"));
  {
    SM::Atomic_file file(folder("link"));
    file.stream() << "new";
    file.commit();
  }
  CHECK(std::filesystem::is_symlink(folder("link")));
  CHECK(folder.read("a.txt") == "new");
  CHECK(folder.entries() == Names{"a.txt", "link"});
  std::filesystem::create_symlink("b.txt", folder("to_nothing"));
  {
    SM::Atomic_file file(folder("to_nothing"));
    file.stream() << "new";
    file.commit();
  }
  CHECK(std::filesystem::is_symlink(folder("to_nothing")));
  CHECK(folder.read("b.txt") == "new");
  std::filesystem::remove(folder("b.txt"));
  CHECK_THROWS_AS(SM::Atomic_folder(folder("to_nothing")), SM::IO_error);
  CHECK_THROWS_AS(SM::Atomic_folder(folder("to_nothing/out")), SM::IO_error);
  std::filesystem::remove(folder("to_nothing"));
  std::filesystem::create_symlink("circle", folder("circle"));
  CHECK_THROWS_AS(SM::Atomic_file(folder("circle")), SM::IO_error);
  std::filesystem::remove(folder("circle"));

  REQUIRE(mkfifo(folder("pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(SM::Atomic_file(folder("pipe")), SM::IO_error);
  CHECK(folder.entries() == Names{"a.txt", "link", "pipe"});
  for (const char* name : {"a.txt", "a.txt/out", "a.txt/deep/out", "pipe/out"})
    CHECK_THROWS_AS(SM::Atomic_folder(folder(name)), SM::IO_error);
}

TEST_CASE("the files of a folder appear together, foreign files stay")
{
  const Temporary_folder base;
  for (const char* name : {"out", "deep/er/out", "slash/"}) {
    SM::Atomic_folder folder(base(name));
    std::ofstream(folder.file("a")) << "A";
    std::ofstream(folder.file("b")) << "B";
    CHECK_FALSE(std::filesystem::exists(base(name)));
    folder.commit();
  }
  CHECK(base.entries() == Names{"deep", "deep/er", "deep/er/out", "deep/er/out/a", "deep/er/out/b", "out",
                                "out/a", "out/b", "slash", "slash/a", "slash/b"});
  base.write("out/mine", "M");
  {
    SM::Atomic_folder folder(base("out"));
    std::ofstream(folder.file("a")) << "A2";
    CHECK(base.read("out/a") == "A");
    folder.commit();
  }
  CHECK(base.read("out/a") == "A2");
  CHECK(base.read("out/b") == "B");
  CHECK(base.read("out/mine") == "M");
  CHECK(base.entries().size() == 12);
}

TEST_CASE("a file elsewhere appears with a folder, or not at all")
{
  const Temporary_folder base;
  {
    SM::Atomic_folder folder(base("out"));
    std::ofstream(folder.file("a")) << "A";
    std::ofstream(folder.file_elsewhere(base("b"))) << "B";
    std::ofstream(folder.file_elsewhere(base("out/c"))) << "C"; // the folder is not there yet
    CHECK_FALSE(std::filesystem::exists(base("b")));
    folder.commit();
  }
  CHECK(base.entries() == Names{"b", "out", "out/a", "out/c"});
  CHECK(base.read("b") == "B");
  CHECK(base.read("out/c") == "C");
  {
    SM::Atomic_folder folder(base("out"));
    std::ofstream(folder.file_elsewhere(base("b"))) << "B2";
    folder.file("never written");
    CHECK_THROWS_AS(folder.commit(), SM::IO_error);
  }
  CHECK(base.read("b") == "B");
  {
    SM::Atomic_folder folder(base("new"));
    std::ofstream(folder.file("a")) << "A";
    folder.file_elsewhere(base("d")); // never written
    CHECK_THROWS_AS(folder.commit(), SM::IO_error);
  }
  CHECK(base.entries().size() == 4);
  CHECK_THROWS_AS(SM::Atomic_folder(base("out")).file_elsewhere(base("out")), SM::IO_error);
}

TEST_CASE("a folder that is not committed leaves nothing behind")
{
  const Temporary_folder base;
  base.write("file", "");
  {
    SM::Atomic_folder folder(base("out"));
    std::ofstream(folder.file("a")) << "A";
  }
  CHECK(base.entries() == Names{"file"});
  CHECK_THROWS_AS(SM::Atomic_folder(base("file")), SM::IO_error);
  CHECK_THROWS_AS(SM::Atomic_folder(""), SM::IO_error);
  {
    SM::Atomic_folder folder(base("deep/out"));
    folder.file("never written");
    CHECK_THROWS_AS(folder.commit(), SM::IO_error);
  }
  CHECK(base.entries() == Names{"file"});
}

// The names a, b, c and d are given in this order; b is missing before, and d has become a folder.
template <class Output>
void check_that_old_files_return(const Temporary_folder& base, Output& output, const std::string& prefix)
{
  base.write("a", "old a");
  base.write("c", "old c");
  for (const char* name : {"a", "b", "c", "d"}) std::ofstream(output.file(prefix + name)) << "new";
  std::filesystem::create_directory(base("d"));
  CHECK_THROWS_AS(output.commit(), SM::IO_error);
}

TEST_CASE("a folder can have files in folders of its own")
{
  const Temporary_folder folder;
  const auto write_all = [&](SM::Atomic_folder& output) {
    for (const char* name : {"a", "in/b", "in/c", "on/d"}) std::ofstream(output.file(name)) << name;
  };
  {
    SM::Atomic_folder output(folder("out"));
    write_all(output);
  }
  CHECK(folder.entries().empty());
  {
    SM::Atomic_folder output(folder("out"));
    write_all(output);
    output.commit();
  }
  CHECK(folder.entries() ==
        std::vector<std::string>{"out", "out/a", "out/in", "out/in/b", "out/in/c", "out/on", "out/on/d"});

  // What is in the way is an error, and nothing changes.
  folder.write("out/file", "");
  {
    SM::Atomic_folder blocked(folder("out"));
    CHECK_THROWS_AS(blocked.file("file/x"), SM::IO_error);
    SM::Atomic_folder late(folder("out"));
    std::ofstream(late.file("new/x")) << "x";
    std::ofstream(late.file("late/y")) << "y";
    folder.write("out/late", "");
    CHECK_THROWS_AS(late.commit(), SM::IO_error);
  }
  CHECK(folder.entries().size() == 9);
}

TEST_CASE("when one of several files cannot have its name, those that were there before return")
{
  const Temporary_folder base;
  {
    SM::Atomic_folder output(base("."));
    check_that_old_files_return(base, output, "");
  }
  CHECK(base.entries() == Names{"a", "c", "d"});
  std::filesystem::remove(base("d"));
  {
    SM::Atomic_files output;
    check_that_old_files_return(base, output, base(""));
  }
  CHECK(base.entries() == Names{"a", "c", "d"});
  CHECK(base.read("a") == "old a");
  CHECK(base.read("c") == "old c");
}

TEST_CASE("nobody else gets the temporary path of a file that is not yet written")
{
  const Temporary_folder base;
  SM::Atomic_files one, other;
  CHECK(one.file(base("a")) != other.file(base("a")));
}

TEST_CASE("several files appear together, in different folders")
{
  const Temporary_folder base;
  std::filesystem::create_directory(base("sub"));
  base.write("a", "old");
  std::filesystem::create_symlink("../a", base("sub/link"));
  for (const bool is_complete : {false, true}) {
    SM::Atomic_files files;
    std::ofstream(files.file(base("sub/link"))) << "A";
    std::ofstream(files.file(base("sub/b"))) << "B";
    CHECK(base.read("a") == "old");
    CHECK_THROWS_AS(files.file(base("sub")), SM::IO_error);
    if (is_complete) files.commit();
  }
  CHECK(base.read("a") == "A");
  CHECK(base.read("sub/b") == "B");
  CHECK(base.entries() == Names{"a", "sub", "sub/b", "sub/link"});
}

} // namespace test_Atomic_file
