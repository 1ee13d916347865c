#include "curve/surface_curve.h"

#include <exsect/geometry/surface_pull_back.h>

#include <utility>

namespace exsect {
namespace {

/// Whether the curve f = 0 has a part, real or not, along which h = 0.
bool have_common_part(const BivariatePolynomial& h, const BivariatePolynomial& f) {
  const BivariatePolynomial common = gcd(h, f);
  return common.degree_r() > 0 || common.degree_s() > 0;
}

/// Region and bounds, without curve.
SurfaceCurve bounded_part(const SurfaceRegion& region, const RationalPatch& patch) {
  SurfaceCurve result;
  for (const SurfaceBound& bound : region.bounds) {
    result.region.bounds.push_back(pull_back(bound.form, patch));
    result.bounds.push_back({bound.name, pull_back(bound.where, patch)});
  }
  result.region.clauses = region.clauses;
  return result;
}

}  // namespace

SurfaceCurve curve_in(const SurfaceRegion& region, BivariatePolynomial section,
                      const RationalPatch& reduced) {
  SurfaceCurve result = bounded_part(region, reduced);
  result.section = std::move(section);
  for (std::size_t i = 0; i < region.bounds.size(); ++i)
    if (have_common_part(result.region.bounds[i], result.section))
      result.region.bounds.push_back(result.bounds[i].where);
  result.graph = curve_graph(result.section, result.region);
  return result;
}

SurfaceCurve surface_curve(const ImplicitSurface& surface, const RationalPatch& x) {
  const RationalPatch& patch = x.reduced();
  BivariatePolynomial section = pull_back(surface.equation(), patch);
  if (!section.is_zero()) return curve_in(surface.region(), std::move(section), patch);
  SurfaceCurve result = bounded_part(surface.region(), patch);
  result.contains_patch = true;
  return result;
}

std::vector<std::size_t> bound_positions_at(const SurfaceCurve& curve, std::size_t node) {
  const CurveGraph& graph = curve.graph;
  const TriangularPoint* at = graph.nodes[node].exact ? &*graph.nodes[node].exact : nullptr;
  if (at == nullptr)  // a bound is 0 here only if it is on the arcs, and `where` has one sign along them
    for (const CurveBranch& arc : graph.arcs)
      if (arc.from == node || arc.to == node) at = &arc.inside;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; at != nullptr && i < curve.bounds.size(); ++i)
    if (!curve.bounds[i].name.empty() && sign_at(curve.region.bounds[i].exchanged(), *at) == 0 &&
        sign_at(curve.bounds[i].where.exchanged(), *at) >= 0)
      positions.push_back(i);
  return positions;
}

std::vector<std::string> bounds_at(const SurfaceCurve& curve, std::size_t node) {
  std::vector<std::string> names;
  for (const std::size_t i : bound_positions_at(curve, node)) names.push_back(curve.bounds[i].name);
  return names;
}

}  // namespace exsect
