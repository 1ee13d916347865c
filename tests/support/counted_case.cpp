#include "support/counted_case.h"

#include <exsect/geometry/rational_patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "support/graph_checks.h"

namespace exsect {
namespace {

using Json = nlohmann::ordered_json;

Numbers exchanged(Numbers numbers) {
  std::swap(numbers.turning[0], numbers.turning[2]);
  std::swap(numbers.turning[1], numbers.turning[3]);
  return numbers;
}

std::string difference(const std::string& how, const IntersectResult& result, const Numbers& expected) {
  if (result.status != Status::complete) return how + ": incomplete, " + result.incomplete.at(0).why;
  const Numbers found = numbers_of(result.graph);
  return found == expected ? "" : how + ": " + to_string(found) + "; expected: " + to_string(expected);
}

Numbers stated_numbers(const Json& json) {
  const auto number = [&](const char* key) { return json.value(key, 0); };
  return {number("open"),
          number("closed"),
          number("branched"),
          number("boundary"),
          json.value("turning", std::array<int, 4>{}),
          number("isolated"),
          number("overlaps")};
}

std::string counted_failure(const RationalPatch& x, const RationalPatch& y, const Numbers& expected) {
  const std::string why = difference("in doubles", intersect(x, y), expected);
  return why.empty() ? difference("exchanged", intersect(y, x), exchanged(expected)) : why;
}

}  // namespace

Numbers numbers_of(const IntersectionGraph& graph) {
  const auto nodes = [&](const auto& has) {
    return static_cast<int>(std::count_if(graph.nodes.begin(), graph.nodes.end(), has));
  };
  Numbers numbers;
  numbers.open = static_cast<int>(graph.count(ComponentShape::open));
  numbers.closed = static_cast<int>(graph.count(ComponentShape::closed));
  numbers.branched = static_cast<int>(graph.count(ComponentShape::branched));
  numbers.boundary =
      nodes([](const Node& node) { return std::ranges::count(node.kinds, NodeKind::boundary) > 0; });
  for (const Parameter p : all_parameters)
    numbers.turning[index(p)] = nodes([&](const Node& node) { return std::ranges::count(node.wrt, p) > 0; });
  numbers.isolated = static_cast<int>(graph.isolated_points.size());
  numbers.overlaps = static_cast<int>(graph.overlaps.size());
  return numbers;
}

std::string to_string(const Numbers& numbers) {
  std::string text = std::to_string(numbers.open) + " open, " + std::to_string(numbers.closed) + " closed, " +
                     std::to_string(numbers.branched) + " branched, " + std::to_string(numbers.boundary) +
                     " boundary points, turning";
  for (const int turning : numbers.turning) text += " " + std::to_string(turning);
  return text + ", " + std::to_string(numbers.isolated) + " isolated, " + std::to_string(numbers.overlaps) +
         " overlaps";
}

std::string counted_failure(const random_pairs::Pair& pair, const Numbers& expected, bool exact) {
  IntersectOptions options;
  options.exact = exact;
  const std::string how = exact ? "exact" : "in doubles";
  const IntersectResult result = intersect(pair.x, pair.y, options);
  std::string why = difference(how, result, expected);
  if (why.empty()) why = unsound(pair.x, pair.y, result);
  if (why.empty())
    why = difference(how + ", exchanged", intersect(pair.y, pair.x, options), exchanged(expected));
  return why;
}

bool states_numbers(const std::string& expected) { return !Json::parse(expected).contains("nodes"); }

std::string counted_failure(const std::string& patches, const std::string& expected) {
  const RationalPatchFile file = parse_rational_patches(patches, "patches");
  const Json stated = Json::parse(expected);
  const Numbers numbers = stated_numbers(stated);
  if (!stated.contains("patch")) {
    const RationalPatch& x = file.patches.at(0).patch;
    const RationalPatch& y = file.patches.at(1).patch;
    const auto first = x.biquadratic();
    const auto second = y.biquadratic();
    if (!first || !second) return counted_failure(x, y, numbers);
    const random_pairs::Pair pair = {*first, *second};
    const std::string why = counted_failure(pair, numbers, false);
    return why.empty() ? counted_failure(pair, numbers, true) : why;
  }
  for (const auto& named : file.patches) {
    if (named.name == stated.at("patch").get<std::string>())
      return difference("with itself", self_intersect(named.patch), numbers);
  }
  throw std::runtime_error("no such patch: " + stated.at("patch").dump());
}

}  // namespace exsect
