#include "lift/crossing_names.h"

#include <functional>
#include <map>
#include <utility>

#include "lift/connected_parts.h"
#include "lift/plane_conic.h"

namespace exsect {
namespace {

/// Curves of one factor: arcs with equal numbers are one like `curve`.
struct FactorParts {
  std::function<int(const CrossingArc&)> part;
  SpaceCurve curve;
};

/// The frame's coordinates, as those of a chart.
SurfaceChart coordinates(const SpaceFrame& frame) {
  return {{0, 0, 0}, frame.columns[0], frame.columns[1], frame.columns[2], {}};
}

/// Of an irreducible factor of degree 1 or 2, above which y is a function of u and v: a line or a conic.
/// Empty for others.
std::optional<FactorParts> parts_by_name(const CrossingCurve& curve, std::size_t factor) {
  const SpaceProjection& seen = *curve.projection;
  const BivariatePolynomial& g = curve.factors[factor];
  const bool is_line = g.total_degree() == 1;
  if (!is_line && (g.total_degree() != 2 || PlaneConic(g).is_degenerate())) return std::nullopt;
  const std::optional<PlaneAbove> plane = plane_through({seen.offset, seen.slope}, g);
  if (!plane) return std::nullopt;
  const SurfaceChart chart = coordinates(seen.frame);
  return FactorParts{
      [](const CrossingArc&) { return 0; },
      is_line ? line_in_plane(chart, g, *plane) : conic_in_plane(chart, PlaneConic(g), *plane)};
}

FactorParts parts_of(const CrossingCurve& curve, std::size_t factor) {
  if (auto named = parts_by_name(curve, factor)) {
    if (std::optional<Point>& direction = named->curve.direction) direction = shortened(*direction);
    return *std::move(named);
  }
  return {ConnectedParts(curve, factor), {0, SpaceCurveKind::general, {}, false, 1}};
}

}  // namespace

std::vector<SpaceCurve> named_curves(const CrossingCurve& curve) {
  std::map<std::size_t, FactorParts> parts;
  std::map<std::pair<std::size_t, int>, std::size_t> position;
  std::vector<SpaceCurve> curves;
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const CrossingArc& arc = curve.arcs[i];
    auto known = parts.find(arc.factor);
    if (known == parts.end()) known = parts.emplace(arc.factor, parts_of(curve, arc.factor)).first;
    const auto [at, is_new] = position.emplace(std::pair(arc.factor, known->second.part(arc)), curves.size());
    if (is_new) {
      curves.push_back(known->second.curve);
      curves.back().id = static_cast<int>(at->second);
      curves.back().multiplicity = arc.multiplicity;
    }
    curves[at->second].arcs.push_back(static_cast<int>(i));
  }
  return curves;
}

}  // namespace exsect
