#include "cli/batch/batch_line.h"

#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/text_file.h>
#include <exsect/solver/self_intersect.h>

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "output/text/intersection_json.h"

namespace exsect::cli {
namespace {

constexpr const char* form = "batch-line/1";

/// The last key of a line, which the summary does not need.
constexpr std::string_view result_key = ",\"result\":{";

Json head(const BatchInput& input, const Shard& shard, std::uint64_t local, const Subject* subject) {
  Json line = {{"exsect", form}, {"line", shard.global(local)}};
  line.update(input.names(local));
  if (subject != nullptr && subject->self) line["patch"] = subject->x.name;
  if (subject != nullptr && !subject->self) {
    line["first"] = subject->x.name;
    line["second"] = subject->y.name;
  }
  return line;
}

IntersectResult solved_pair(const Subject& subject, bool meet, const IntersectOptions& options) {
  if (!meet) return {Status::complete, {}, {}, {}};
  return subject.self ? self_intersect(subject.x.patch, options)
                      : intersect(subject.x.patch, subject.y.patch, options);
}

Json whole_json(const Subject& subject, const IntersectResult& result) {
  if (subject.self) return self_json(result, subject.x.name);
  return intersection_json(result, {subject.x.name, subject.y.name});
}

const char* decided_by(const IntersectResult& result, bool meet) {
  if (!meet) return "boxes";
  return result.work.steps.count("filtered") != 0 ? "doubles" : "exact";
}

void count_summary(const Json& summary, Tally& tally) {
  const auto number = [&](const char* key) { return summary.at(key).get<std::uint64_t>(); };
  if (number("components") + number("isolated") + number("overlaps") > 0) ++tally.meeting;
  tally.open += number("open");
  tally.closed += number("closed");
  tally.branched += number("branched");
  tally.isolated += number("isolated");
  tally.overlaps += number("overlaps");
}

void count_complete(const std::string& by, Tally& tally) {
  ++tally.complete;
  ++(by == "boxes" ? tally.by_boxes : by == "doubles" ? tally.by_doubles : tally.by_exact);
}

/// Counts a line, of which the result may be missing; its number.
std::uint64_t count(const Json& line, Tally& tally) {
  const std::string status = line.at("status").get<std::string>();
  ++tally.lines;
  if (line.contains("patch")) ++tally.selves;
  if (status == "failed") {
    ++tally.failed;
  } else {
    count_summary(line.at("summary"), tally);
    if (status == "complete")
      count_complete(line.at("by").get<std::string>(), tally);
    else
      ++tally.incomplete;
  }
  return line.at("line").get<std::uint64_t>();
}

BatchLine counted_line(const Json& line) {
  BatchLine result;
  // Invalid UTF-8, which only paths can hold, is replaced.
  result.text = line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  count(line, result.tally);
  return result;
}

/// Every number of a tally.
constexpr std::uint64_t Tally::*numbers[] = {
    &Tally::lines,    &Tally::selves,     &Tally::complete, &Tally::incomplete, &Tally::failed,
    &Tally::by_boxes, &Tally::by_doubles, &Tally::by_exact, &Tally::meeting,    &Tally::open,
    &Tally::closed,   &Tally::branched,   &Tally::isolated, &Tally::overlaps};
static_assert(sizeof numbers / sizeof numbers[0] == sizeof(Tally) / sizeof(std::uint64_t));
static_assert(std::is_trivially_copyable_v<Tally>);

}  // namespace

Tally& operator+=(Tally& sum, const Tally& more) {
  for (const auto number : numbers) sum.*number += more.*number;
  return sum;
}

BatchLine failed_line(const BatchInput& input, const Shard& shard, std::uint64_t local,
                      const std::string& why) {
  Json line = head(input, shard, local, nullptr);
  line["status"] = "failed";
  line["error"] = why;
  return counted_line(line);
}

BatchLine solved_line(const BatchInput& input, const Shard& shard, std::uint64_t local,
                      const LineOptions& options) {
  std::optional<Subject> subject;
  try {
    subject.emplace(input.load(local));
  } catch (const InputError& error) {
    return failed_line(input, shard, local, error.what());
  }
  const bool meet = subject->self || input.pairs_meet() ||
                    intersects(bounding_box(subject->x.patch), bounding_box(subject->y.patch));
  IntersectResult result;
  try {
    result = solved_pair(*subject, meet, options.solver);
  } catch (const std::invalid_argument& error) {  // control points out of range
    return failed_line(input, shard, local, error.what());
  }
  const ParameterNames& names = subject->self ? self_names : pair_names;
  Json line = head(input, shard, local, &*subject);
  line["status"] = result.status == Status::complete ? "complete" : "incomplete";
  line["by"] = decided_by(result, meet);
  line["summary"] = summary_json(result.graph, names);
  line["incomplete"] = incomplete_json(result.incomplete, names);
  if (options.full) {
    line["result"] = whole_json(*subject, result);
    line["result"].erase("work");  // times differ from run to run
  }
  return counted_line(line);
}

std::string packed(const BatchLine& line) {
  std::string bytes(sizeof line.tally, '\0');
  std::memcpy(bytes.data(), &line.tally, sizeof line.tally);
  return bytes + line.text;
}

BatchLine unpacked(std::string_view bytes) {
  BatchLine line;
  std::memcpy(&line.tally, bytes.data(), sizeof line.tally);
  line.text = bytes.substr(sizeof line.tally);
  return line;
}

std::uint64_t count_line(std::string_view line, Tally& tally) {
  const std::size_t result = line.find(result_key);
  std::string needed(line.substr(0, result));
  if (result != std::string_view::npos) needed += "}";
  try {
    const Json json = Json::parse(needed);
    if (json.at("exsect") != form) throw std::invalid_argument("not a line of the form batch-line/1");
    return count(json, tally);
  } catch (const Json::exception&) {
    throw std::invalid_argument("not a line of the form batch-line/1");
  }
}

}  // namespace exsect::cli
