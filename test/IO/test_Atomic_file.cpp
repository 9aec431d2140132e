#include "catch.h"

#include "temporary_folder.h"

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>

#include <sys/stat.h>

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
  for (const char* name : {"missing/a.txt", "is_folder"}) {
    try {
      SM::Atomic_file file(folder(name));
      FAIL("no error");
    } catch (const SM::IO_error& e) {
      CHECK(e.code() == SM::Error_code::cannot_write);
      CHECK(e.file() == folder(name));
    }
  }
  CHECK(folder.entries() == Names{"is_folder"});
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
  CHECK(base.entries() == Names{"deep", "deep/er", "deep/er/out", "deep/er/out/a", "deep/er/out/b", "out", "out/a",
                                "out/b", "slash", "slash/a", "slash/b"});
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
    SM::Atomic_folder folder(base("out"));
    folder.file("never written");
    CHECK_THROWS_AS(folder.commit(), SM::IO_error);
  }
}
