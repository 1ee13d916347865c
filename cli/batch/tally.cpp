#include "cli/batch/tally.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "cli/batch/natural.h"

namespace exsect::cli {
namespace {

/// The last key of a line, which the summary does not need.
constexpr std::string_view result_key = ",\"result\":{";

template <class Object>
void count_summary(const Object& summary, Tally& tally) {
  const auto number = [&](const char* key) { return natural(summary.at(key)); };
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
template <class Object>
std::uint64_t count(const Object& line, Tally& tally) {
  const std::string status = line.at("status").template get<std::string>();
  ++tally.lines;
  if (line.contains("patch")) ++tally.selves;
  if (status == "failed") {
    ++tally.failed;
  } else {
    count_summary(line.at("summary"), tally);
    if (status == "complete")
      count_complete(line.at("by").template get<std::string>(), tally);
    else if (status == "incomplete")
      ++tally.incomplete;
    else
      throw std::invalid_argument("has a status that is unknown");
  }
  return natural(line.at("line"));
}

/// Every number of a tally.
constexpr std::uint64_t Tally::*numbers[] = {
    &Tally::lines,    &Tally::selves,     &Tally::complete, &Tally::incomplete, &Tally::failed,
    &Tally::by_boxes, &Tally::by_doubles, &Tally::by_exact, &Tally::meeting,    &Tally::open,
    &Tally::closed,   &Tally::branched,   &Tally::isolated, &Tally::overlaps};
static_assert(sizeof numbers / sizeof numbers[0] == sizeof(Tally) / sizeof(std::uint64_t));
}  // namespace

Tally& operator+=(Tally& sum, const Tally& more) {
  for (const auto number : numbers) sum.*number += more.*number;
  return sum;
}

std::uint64_t count_line(std::string_view line, Tally& tally) {
  const std::size_t result = line.find(result_key);
  std::string needed(line.substr(0, result));
  if (result != std::string_view::npos) needed += "}";
  try {
    const auto json = nlohmann::json::parse(needed);  // sorted: keys are found in logarithmic time
    if (json.at("exsect") != batch_line_form)
      throw std::invalid_argument("not a line of the form batch-line/1");
    return count(json, tally);
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("not a line of the form batch-line/1");
  }
}

std::uint64_t count_line(const nlohmann::ordered_json& line, Tally& tally) { return count(line, tally); }

}  // namespace exsect::cli
