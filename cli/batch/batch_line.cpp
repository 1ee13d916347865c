#include "cli/batch/batch_line.h"

#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/bounding_box.h>
#include <exsect/geometry/text_file.h>
#include <exsect/solver/intersect_rational.h>

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "cli/patch_choice.h"
#include "output/text/intersection_json.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

Json head(const BatchInput& input, const Shard& shard, std::uint64_t local, const Subject* subject) {
  Json line = {{"exsect", batch_line_form}, {"line", shard.global(local)}};
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

BatchLine counted_line(const Json& line) {
  BatchLine result;
  // Invalid UTF-8, which only paths can hold, is replaced.
  result.text = line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  count_line(line, result.tally);
  return result;
}

/// Which control point is beyond the range of doubles, with a colon; empty if each one for itself is not.
std::string beyond_doubles(const Subject& subject) {
  for (const NamedRationalPatch* patch : {&subject.x, &subject.y}) {
    const std::string place = place_beyond_doubles(patch->patch);
    if (!place.empty()) return "patch \"" + printable(patch->name) + "\": " + place + ": ";
  }
  return "";
}

static_assert(std::is_trivially_copyable_v<Tally>);

}  // namespace

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
  } catch (const BeyondDoubles& error) {
    return failed_line(input, shard, local, beyond_doubles(*subject) + error.what());
  } catch (const std::invalid_argument& error) {  // options out of range for this pair
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

}  // namespace exsect::cli
