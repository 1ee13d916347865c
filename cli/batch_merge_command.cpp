#include <exsect/geometry/text_file.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "cli/batch/batch_line.h"
#include "cli/batch/batch_output.h"
#include "cli/batch/batch_summary.h"
#include "cli/batch/line_reader.h"
#include "cli/batch/natural.h"
#include "cli/batch_command.h"
#include "output/options/output_files.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr std::size_t max_header_bytes = std::size_t{1} << 16;

/// The finished output of one shard.
class ShardFile {
 public:
  explicit ShardFile(const std::string& path) : path_(path), file_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_.get() < 0) throw InputError(path, "", std::string("cannot be opened: ") + std::strerror(errno));
    reader_.emplace(file_.get(), path);
    read_header();
  }

  const std::string& path() const { return path_; }
  const Shard& shard() const { return shard_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t apart() const { return apart_; }
  /// The header of the batch as one run writes it.
  const std::string& whole_header() const { return whole_header_; }

  /// The next line, which must be the given one of the whole batch.
  std::string_view next(std::uint64_t line, Tally& tally) {
    ++number_;
    const std::string_view text = reader_->next();
    if (text.empty()) fail("is missing: the shard is not finished");
    try {
      if (count_line(text, tally) != line) fail("is not line " + std::to_string(line) + " of the batch");
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
    return text;
  }
  void expect_end() {
    ++number_;
    if (!reader_->next().empty()) fail("follows the end of the shard");
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(path_, "line " + std::to_string(number_), reason);
  }

  void read_header() {
    try {
      const std::string_view text = reader_->next();
      if (text.size() > max_header_bytes) fail("is not of the form batch/1");
      Json header = Json::parse(text);
      if (header.at("exsect") != "batch/1") fail("is not of the form batch/1");
      shard_ = {natural(header.at("shard").at(0)), natural(header.at("shard").at(1))};
      lines_ = natural(header.at("lines"));
      if (header.contains("model")) apart_ = natural(header.at("model").at("apart"));
      header["shard"] = {1, 1};
      whole_header_ = header.dump() + "\n";
    } catch (const Json::exception&) {
      fail("is not of the form batch/1");
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
    if (shard_.index < 1 || shard_.index > shard_.count || shard_.count > std::uint64_t{most_shards})
      fail("names no shard");
    struct stat status = {};
    const bool measured = fstat(file_.get(), &status) == 0;
    if (measured && shard_.size(lines_) > static_cast<std::uint64_t>(status.st_size))
      fail("names more lines than the file can hold");
  }

  std::string path_;
  FileDescriptor file_;
  std::optional<LineReader> reader_;
  Shard shard_;
  std::uint64_t lines_ = 0;
  std::uint64_t apart_ = 0;
  std::string whole_header_;
  std::uint64_t number_ = 1;
};

using Shards = std::vector<std::unique_ptr<ShardFile>>;

/// In their order, each once and all of one batch.
Shards opened(const std::vector<std::string>& paths) {
  Shards shards;
  for (const std::string& path : paths) {
    auto file = std::make_unique<ShardFile>(path);
    if (shards.empty()) shards.resize(file->shard().count);
    const auto refuse = [&](const std::string& reason) { throw InputError(path, "line 1", reason); };
    if (file->shard().count != shards.size())
      refuse("is one of " + std::to_string(file->shard().count) + " shards, not of " +
             std::to_string(shards.size()));
    std::unique_ptr<ShardFile>& place = shards.at(file->shard().index - 1);
    if (place) refuse("is the same shard as " + place->path());
    place = std::move(file);
  }
  for (std::size_t i = 0; i < shards.size(); ++i) {
    if (!shards[i])
      throw InputError(
          paths.front(), "line 1",
          "shard " + std::to_string(i + 1) + " of " + std::to_string(shards.size()) + " is missing");
    if (shards[i]->whole_header() != shards[0]->whole_header())
      throw InputError(shards[i]->path(), "line 1", "is of another batch than " + shards[0]->path());
  }
  return shards;
}

Tally merged(Shards& shards, BatchOutput& output) {
  Tally tally;
  const std::uint64_t lines = shards[0]->lines();
  output.read_earlier(lines, [](std::string_view) -> std::uint64_t { return 0; });
  for (std::uint64_t line = 0; line < lines; ++line) {
    std::size_t holder = 0;
    while (!shards[holder]->shard().contains(line)) ++holder;
    output.add(line, shards[holder]->next(line, tally));
  }
  for (const auto& shard : shards) shard->expect_end();
  return tally;
}

}  // namespace

ExitStatus run(const BatchMergeCommand& command, const Streams& streams) {
  if (!command.output.empty()) check_output("--output", command.output, command.shards);
  Shards shards = opened(command.shards);
  BatchOutput output(command.output, shards[0]->whole_header(), BatchOutput::Journal::none);
  const Tally tally = merged(shards, output);
  output.finish(streams.out);
  if (!command.quiet && !command.output.empty()) streams.out << batch_summary(tally, shards[0]->apart(), {});
  return tally.incomplete + tally.failed == 0 ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli
