#include <exsect/geometry/text_file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "scratch_directory.h"
#include "support/catch.h"

namespace exsect::text_file_test {
namespace fs = std::filesystem;

TEST_CASE("a file is written whole and read back", "[text_file]") {
  const ScratchDirectory directory;
  const std::string path = directory.path("a.txt");
  const std::string text("line\nbinary \0 byte\xff", 18);
  write_file_atomically(path, text);
  CHECK(read_text_file(path, 18) == text);
  write_file_atomically(path, "");
  CHECK(read_text_file(path, 0).empty());
  write_file_atomically(path, std::string(1 << 20, 'x'));
  CHECK(read_text_file(path, 1 << 20) == std::string(1 << 20, 'x'));
  CHECK(directory.number_of_files() == 1);
}

TEST_CASE("unreadable files are refused by name", "[text_file]") {
  const ScratchDirectory directory;
  const std::string path = directory.path("a.txt");
  write_file_atomically(path, "four");
  CHECK_THROWS_AS(read_text_file(path, 3), InputError);
  CHECK_THROWS_AS(read_text_file(directory.path("missing"), 100), InputError);
  CHECK_THROWS_AS(read_text_file(directory.path(""), 100), InputError);
  CHECK_THROWS_AS(read_text_file("", 100), InputError);
  CHECK_THROWS_AS(read_text_file("/dev/zero", 1000000), InputError);
  CHECK_THROWS_WITH(read_text_file(directory.path("missing"), 100),
                    Catch::Matchers::Contains("missing") && Catch::Matchers::Contains("cannot be opened"));
}

TEST_CASE("a failed write changes nothing and leaves no temporary file", "[text_file]") {
  const ScratchDirectory directory;
  CHECK_THROWS_AS(write_file_atomically(directory.path("no/such/file"), "x"), OutputError);
  CHECK_THROWS_AS(write_file_atomically(directory.path(""), "x"), OutputError);
  CHECK_THROWS_AS(write_file_atomically("", "x"), OutputError);
  CHECK_THROWS_WITH(write_file_atomically(directory.path("no/file"), "x"),
                    Catch::Matchers::Contains("no/file"));
  const std::string path = directory.path("file/under");
  write_file_atomically(directory.path("file"), "old");
  CHECK_THROWS_AS(write_file_atomically(path, "x"), OutputError);
  CHECK(read_text_file(directory.path("file"), 10) == "old");
  CHECK(directory.number_of_files() == 1);
  if (fs::exists("/dev/full")) CHECK_THROWS_AS(write_file_atomically("/dev/full", "x"), OutputError);
  if (geteuid() != 0) {
    fs::permissions(directory.path("file"), fs::perms::owner_read);
    CHECK_THROWS_AS(write_file_atomically(directory.path("file"), "new"), OutputError);
  }
}

TEST_CASE("a write that fails half-way keeps the old file", "[text_file]") {
  const ScratchDirectory directory;
  const std::string path = directory.path("a.txt");
  write_file_atomically(path, "old");
  struct rlimit before = {};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  struct rlimit small = before;
  small.rlim_cur = 10000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  bool refused = false;
  try {
    write_file_atomically(path, std::string(1 << 20, 'x'));
  } catch (const OutputError&) {
    refused = true;
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(refused);
  CHECK(read_text_file(path, 10) == "old");
  CHECK(directory.number_of_files() == 1);
}

TEST_CASE("devices, links and permissions survive a write", "[text_file]") {
  const ScratchDirectory directory;
  write_file_atomically("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
  const std::string target = directory.path("target");
  write_file_atomically(target, "old");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target", directory.path("link"));
  write_file_atomically(directory.path("link"), "new");
  CHECK(fs::is_symlink(directory.path("link")));
  CHECK(read_text_file(target, 10) == "new");
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

}  // namespace exsect::text_file_test
