#include "cli/batch_command.h"

#include <exsect/geometry/text_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "cli/batch/batch_input.h"
#include "cli/batch/batch_line.h"
#include "cli/batch/batch_output.h"
#include "cli/batch/batch_summary.h"
#include "cli/batch/worker_pool.h"
#include "cli/progress.h"
#include "output/options/implicitize_options.h"
#include "output/options/option_values.h"
#include "output/options/output_files.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

using BatchClock = std::chrono::steady_clock;

constexpr double bytes_in_mib = 1024.0 * 1024.0;

struct Options {
  LineOptions line;
  PoolLimits limits;
  Shard shard;
};

Shard parsed_shard(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos)
    throw UsageError("--shard: \"" + printable(text) + "\" is not of the form I/N");
  const int count = integer_value("--shard", text.substr(slash + 1), 1, most_shards);
  const int index = integer_value("--shard", text.substr(0, slash), 1, count);
  return {static_cast<std::uint64_t>(index), static_cast<std::uint64_t>(count)};
}

unsigned parsed_jobs(const std::string& text) {
  if (text.empty()) return std::max(std::thread::hardware_concurrency(), 1U);
  return static_cast<unsigned>(integer_value("--jobs", text, 1, 1024));
}

Options parsed(const BatchCommand& command) {
  Options options;
  options.line.solver.turning = parameter_list("--turning", command.turning);
  options.line.solver.tolerance = positive_value("--tolerance", command.tolerance);
  options.line.solver.exact = command.exact;
  options.line.full = command.full;
  options.limits.workers = parsed_jobs(command.jobs);
  options.shard = parsed_shard(command.shard);
  if (!command.max_seconds.empty()) {
    const double seconds = positive_value("--max-seconds", command.max_seconds);
    options.line.solver.max_seconds = seconds;
    // The solver stops itself; this is for a pair in which it does not come to that.
    options.limits.max_time = std::chrono::milliseconds(std::llround(std::min(2000 * seconds, 1e12)) + 2000);
  }
  if (!command.max_memory.empty()) {
    const double mib = std::min(positive_value("--max-memory", command.max_memory), 1e9);
    options.limits.max_memory = static_cast<std::uint64_t>(mib * bytes_in_mib);
  }
  if (command.resume && command.output.empty()) throw UsageError("--resume: needs --output");
  return options;
}

std::unique_ptr<BatchInput> read_input(const BatchCommand& command, const Shard& shard) {
  const std::string& first = command.inputs.front();
  if (command.inputs.size() > 1) return list_of_pairs(command.inputs, command.self, shard);
  if (holds_patches(first)) return read_model(first, command.self, shard);
  return list_of_pairs(read_list(first), command.self, shard);
}

std::string header(const BatchCommand& command, const BatchInput& input, const Shard& shard) {
  Json json = {{"exsect", "batch/1"}, {"version", EXSECT_VERSION}};
  json.update(input.header());
  json["shard"] = {shard.index, shard.count};
  json["options"] = {{"turning", command.turning},
                     {"tolerance", command.tolerance},
                     {"exact", command.exact},
                     {"self", command.self},
                     {"full", command.full},
                     {"max_seconds", command.max_seconds},
                     {"max_memory", command.max_memory}};
  return json.dump() + "\n";
}

std::string duration(double seconds) {
  const auto s = static_cast<long>(std::min(seconds, 1e9));
  return s >= 3600 ? fmt::format("{}:{:02d}:{:02d}", s / 3600, s / 60 % 60, s % 60)
                   : fmt::format("{}:{:02d}", s / 60, s % 60);
}

/// The progress line: a bar, how many of all, rate and time left.
class BatchProgress {
 public:
  BatchProgress(const Streams& streams, bool quiet, std::uint64_t earlier, std::uint64_t all)
      : progress_(streams.err, streams.watched && !quiet), earlier_(earlier), all_(all) {}

  void report(std::uint64_t done) {
    const double seconds = std::chrono::duration<double>(BatchClock::now() - begun_).count();
    const double rate = static_cast<double>(done - earlier_) / std::max(seconds, 1e-3);
    const double fraction = static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(all_, 1));
    const std::string bar(static_cast<std::size_t>(20 * fraction), '#');
    const std::string left = rate > 0 ? duration(static_cast<double>(all_ - done) / rate) + " left" : "";
    progress_.report(
        fraction, fmt::format("[{:<20}] {} of {}, {:.0f} a second, {}", bar, done, all_, rate, left).c_str());
  }

 private:
  Progress progress_;
  BatchClock::time_point begun_ = BatchClock::now();
  std::uint64_t earlier_;
  std::uint64_t all_;
};

/// A batch between its input and its output.
class Run {
 public:
  Run(const Options& options, const BatchInput& input, BatchOutput& output)
      : options_(options), input_(input), output_(output) {
    output_.read_earlier(input.size(),
                         [&](std::string_view line) { return place(count_line(line, tally_)); });
  }

  PoolEnd solve(const Streams& streams, bool quiet) {
    BatchProgress progress(streams, quiet, tally_.lines, input_.size());
    std::uint64_t next = 0;
    const PoolUser user = {
        .next = [&]() -> std::optional<std::uint64_t> {
          while (next < input_.size() && output_.done(next)) ++next;
          return next < input_.size() ? std::optional(next++) : std::nullopt;
        },
        .work =
            [&](std::uint64_t local) {
              return packed(solved_line(input_, options_.shard, local, options_.line));
            },
        .done = [&](const TaskResult& result) { add(result.task, unpacked(result.text)); },
        .lost = [&](std::uint64_t local,
                    const std::string& why) { add(local, failed_line(input_, options_.shard, local, why)); },
        .tick =
            [&] {
              output_.flush();
              progress.report(tally_.lines);
            }};
    return run_pool(options_.limits, user);
  }

  const Tally& tally() const { return tally_; }

 private:
  void add(std::uint64_t local, const BatchLine& line) {
    output_.add(local, line.text);
    tally_ += line.tally;
  }
  std::uint64_t place(std::uint64_t line) const {
    if (!options_.shard.contains(line)) throw std::invalid_argument("is not a line of this shard");
    return options_.shard.local(line);
  }

  const Options& options_;
  const BatchInput& input_;
  BatchOutput& output_;
  Tally tally_;
};

ExitStatus interrupted(const BatchCommand& command, const Run& run, std::uint64_t all, int signal,
                       const Streams& streams) {
  streams.err << fmt::format("exsect: interrupted by signal {} after {} of {} lines; ", signal,
                             run.tally().lines, all)
              << (command.output.empty() ? "without --output nothing is kept"
                                         : printable(command.output) +
                                               ".partial keeps them: the same command with --resume goes on")
              << std::endl;
  return static_cast<ExitStatus>(static_cast<int>(ExitStatus::interrupted) + signal);
}

}  // namespace

ExitStatus run(const BatchCommand& command, const Streams& streams) {
  const Options options = parsed(command);
  if (std::ranges::find(command.inputs, "-") != command.inputs.end())
    throw UsageError("INPUT: the standard input cannot be read again, as a batch does; write it to a file");
  if (!command.output.empty()) check_output("--output", command.output, command.inputs);
  const std::unique_ptr<BatchInput> input = read_input(command, options.shard);
  BatchOutput output(command.output, header(command, *input, options.shard),
                     command.resume ? BatchOutput::Journal::resume : BatchOutput::Journal::begin);
  Run run(options, *input, output);
  const BatchClock::time_point begun = BatchClock::now();
  const std::uint64_t earlier = run.tally().lines;
  PoolEnd end;
  if (!output.finished()) {
    end = run.solve(streams, command.quiet);
    if (end.signal != 0) return interrupted(command, run, input->size(), end.signal, streams);
    output.finish(streams.out);
  }
  if (!command.quiet && !command.output.empty()) {
    const double seconds = std::chrono::duration<double>(BatchClock::now() - begun).count();
    streams.out << batch_summary(
        run.tally(), input->apart(),
        {run.tally().lines - earlier, seconds, options.limits.workers, end.peak_kib});
  }
  return run.tally().incomplete + run.tally().failed == 0 ? ExitStatus::complete : ExitStatus::incomplete;
}

}  // namespace exsect::cli
