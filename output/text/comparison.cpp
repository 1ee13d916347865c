#include "output/text/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <set>

#include "output/text/peak_memory.h"

namespace exsect::cli {
namespace {

struct Cost {
  double milliseconds;
  std::optional<long> peak_kib;
};

template <class Work>
Cost measured(Work work) {
  reset_peak_memory();
  const std::clock_t start = std::clock();
  work();
  return {1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, peak_memory_kib()};
}

std::size_t exact_points(const std::vector<CheckLine>& lines) {
  std::size_t points = 0;
  for (const CheckLine& line : lines) points += line.points.size();
  return points;
}

/// Real roots of the lines' eliminants in [0,1] that belong to no point.
std::size_t dismissed_roots(const std::vector<CheckLine>& lines) {
  std::size_t phantoms = 0;
  for (const CheckLine& line : lines)
    phantoms += line.eliminant_roots - std::min(line.eliminant_roots, line.points.size());
  return phantoms;
}

std::size_t count(const std::vector<CurveComponent>& components, bool closed) {
  return static_cast<std::size_t>(
      std::count_if(components.begin(), components.end(),
                    [&](const CurveComponent& c) { return !c.branched && c.closed == closed; }));
}

MethodRow row_of_lines(const IntersectResult& result, const std::vector<CheckLine>& lines, const Cost& cost) {
  const IntersectionGraph& graph = result.graph;
  const std::size_t phantoms = dismissed_roots(lines);
  return {"parameter lines",
          "exact sweep",
          result.status == Status::complete ? "complete" : "incomplete: " + result.incomplete.front().why,
          graph.components.size(),
          static_cast<std::size_t>(graph.count(ComponentShape::open)),
          static_cast<std::size_t>(graph.count(ComponentShape::closed)),
          0,
          0,
          exact_points(lines),
          exact_points(lines),
          0,
          phantoms,
          phantoms,
          cost.milliseconds,
          cost.peak_kib};
}

MethodRow row_of_resultant(const ResultantMethod& result, ResultantPlane plane,
                           const std::vector<CheckLine>& lines, const Cost& cost) {
  MethodRow row{"resultant",
                plane == ResultantPlane::u_r ? "curve in (u,r)" : "curve in (v,s)",
                "complete up to isolated points",
                result.components.size(),
                count(result.components, false),
                count(result.components, true),
                result.phantoms.size(),
                result.phantoms.size(),
                exact_points(lines),
                0,
                0,
                0,
                0,
                cost.milliseconds,
                cost.peak_kib};
  if (result.incomplete) row.answer = "incomplete: " + *result.incomplete;
  if (result.curve.is_zero()) {
    row.missed = row.points;
    return row;
  }
  const ResultantCheck found = check(result, lines);
  row.certified = found.points;
  row.missed = row.points - found.points;
  row.phantom_points = row.phantom_points_removed = found.phantoms;
  return row;
}

MethodRow row_of_quartics(const QuarticMethod& result, const QuarticOptions& options, const Cost& cost) {
  const auto phantoms =
      static_cast<std::size_t>(std::count_if(result.regions.begin(), result.regions.end(),
                                             [](const QuarticRegion& region) { return region.is_phantom; }));
  const std::size_t pieces = result.pieces.size();
  return {
      "quartics",
      fmt::format("{}, {}", name(options.fit), pieces == 1 ? "1 piece" : fmt::format("{} pieces", pieces)),
      "regions",
      result.regions.size() - phantoms,
      std::nullopt,
      std::nullopt,
      phantoms,
      0,
      result.check.points,
      0,
      result.check.missed,
      result.check.phantoms,
      0,
      cost.milliseconds,
      cost.peak_kib};
}

}  // namespace

bool Comparison::is_complete() const {
  return parameter_lines.status == Status::complete && !resultant.incomplete;
}

Comparison compare(const BezierPatch& x, const BezierPatch& y, const ComparisonOptions& options) {
  Comparison result;
  const std::vector<CheckLine> lines = check_lines(x, y, options.lines);
  result.lines = lines.size();
  IntersectOptions exact;
  exact.exact = true;  // the method itself
  Cost cost = measured([&] { result.parameter_lines = intersect(x, y, exact); });
  result.rows.push_back(row_of_lines(result.parameter_lines, lines, cost));
  result.plane = options.plane;
  if (options.plane == ResultantPlane::u_r) {
    cost = measured([&] { result.resultant = intersect_by_resultant(x, y); });
    result.rows.push_back(row_of_resultant(result.resultant, options.plane, lines, cost));
  } else {
    const BezierPatch first = x.exchanged(), second = y.exchanged();
    cost = measured([&] { result.resultant = intersect_by_resultant(first, second); });
    result.rows.push_back(
        row_of_resultant(result.resultant, options.plane, check_lines(first, second, options.lines), cost));
  }
  for (const int pieces : std::set<int>{0, options.pieces}) {
    QuarticOptions quartics;
    quartics.fit = options.fit;
    quartics.pieces = pieces;
    result.quartic_options.push_back(quartics);
    cost = measured([&] { result.quartics.push_back(intersect_by_quartics(x, y, quartics, lines)); });
    result.rows.push_back(row_of_quartics(result.quartics.back(), quartics, cost));
  }
  return result;
}

}  // namespace exsect::cli
