#include "text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <system_error>

namespace exsect {
namespace {

namespace fs = std::filesystem;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File open(const std::string& path, const char* mode) {
  return File(std::fopen(path.c_str(), mode), std::fclose);
}

std::string message_of(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_to_write(const std::string& path, int error) {
  throw OutputError(path + ": cannot be written: " + message_of(error));
}

/// Writes everything and closes; the error number, 0 for success.
int write_and_close(File file, const std::string& text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  const int write_error = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (written && closed) return 0;
  const int error = written ? errno : write_error;
  return error != 0 ? error : EIO;
}

/// A new empty file beside `path`, opened; the name is returned in `name`.
File open_beside(const std::string& path, std::string& name) {
  std::random_device random;
  File file(nullptr, std::fclose);
  for (int attempt = 0; attempt < 100 && !file; ++attempt) {
    name = path + "." + std::to_string(random()) + ".tmp";
    file = open(name, "wbx");
    if (!file && errno != EEXIST) break;
  }
  if (!file) fail_to_write(path, errno);
  return file;
}

}  // namespace

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw InputError(path, "", "is a directory, not a file");
  const File file = open(path, "rb");
  if (!file) throw InputError(path, "", "cannot be opened: " + message_of(errno));
  std::string text;
  std::size_t got = 0;
  do {
    constexpr std::size_t chunk = 1 << 16;
    const std::size_t had = text.size();
    text.resize(had + std::min(chunk, max_bytes + 1 - had));
    got = std::fread(text.data() + had, 1, text.size() - had, file.get());
    text.resize(had + got);
    if (text.size() > max_bytes)
      throw InputError(path, "", "longer than " + std::to_string(max_bytes) + " bytes");
  } while (got > 0);
  if (std::ferror(file.get()) != 0) throw InputError(path, "", "cannot be read: " + message_of(errno));
  return text;
}

void write_file_atomically(const std::string& path, const std::string& text) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail_to_write(path, EISDIR);
  if (fs::exists(status)) {
    File existing = open(path, "ab");  // changes nothing; refused if the file itself may not be written
    if (!existing) fail_to_write(path, errno);
    if (!fs::is_regular_file(status)) {
      const int failed = write_and_close(std::move(existing), text);
      if (failed != 0) fail_to_write(path, failed);
      return;
    }
  }
  // The file a symbolic link names is replaced, not the link.
  const std::string target = fs::exists(status) ? fs::canonical(path).string() : path;
  std::string temporary;
  const int failed = write_and_close(open_beside(target, temporary), text);
  if (failed != 0) {
    std::remove(temporary.c_str());
    fail_to_write(path, failed);
  }
  if (fs::exists(status)) fs::permissions(temporary, status.permissions(), error);
  if (std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::remove(temporary.c_str());
    fail_to_write(path, reason);
  }
}

}  // namespace exsect
