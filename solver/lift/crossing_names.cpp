#include "lift/crossing_names.h"

#include <exsect/algebra/bivariate_value.h>

#include <functional>
#include <map>
#include <utility>

#include "lift/conjugate_conics.h"
#include "lift/connected_parts.h"

namespace exsect {
namespace {

/// Curves of one factor: arcs with equal numbers are one.
struct FactorParts {
  std::function<int(const CrossingArc&)> part;
  std::function<SpaceCurve(int)> curve;
};

FactorParts all_of_factor(SpaceCurve curve) {
  return {[](const CrossingArc&) { return 0; }, [curve = std::move(curve)](int) { return curve; }};
}

/// The frame's coordinates, as those of a chart.
SurfaceChart coordinates(const SpaceFrame& frame) {
  return {{0, 0, 0}, frame.columns[0], frame.columns[1], frame.columns[2], {}};
}

/// Along y as a polynomial of space.
SpacePolynomial in_space(const BivariatePolynomial& f, const SpaceFrame& frame) {
  const auto form = [](const Point& p) {
    SpacePolynomial sum;
    for (std::size_t k = 0; k < 3; ++k) sum += p[k] * SpacePolynomial::variable(k);
    return sum;
  };
  const SpacePolynomial u = form(frame.height), v = form(cross(frame.columns[2], frame.columns[0]));
  return value_in(f, u, v, [](const Rational& c) { return SpacePolynomial::constant(c); });
}

/// Two curves with the shadows x = c z and x = -c z: the number of an arc is 1 or -1. Empty if the beginning
/// of one does not tell.
std::optional<std::function<int(const CrossingArc&)>> sides(const CrossingCurve& curve, std::size_t factor,
                                                            const BivariatePolynomial& x,
                                                            const BivariatePolynomial& z) {
  const SpaceFrame& frame = curve.projection->frame;
  const auto side = [x = in_space(x, frame), z = in_space(z, frame)](const CrossingArc& arc) {
    return sign_on(x, arc.begin) * sign_on(z, arc.begin);
  };
  for (const CrossingArc& arc : curve.arcs)
    if (arc.factor == factor && side(arc) == 0) return std::nullopt;
  return side;
}

/// Of an irreducible factor above which y is a function of u and v: a line or a conic, or two that are
/// conjugate. Empty for others.
std::optional<FactorParts> parts_by_name(const CrossingCurve& curve, std::size_t factor) {
  const SpaceProjection& seen = *curve.projection;
  const BivariatePolynomial& g = curve.factors[factor];
  const SurfaceChart chart = coordinates(seen.frame);
  const SheetFunction y = {seen.offset, seen.slope};
  if (g.total_degree() == 2 && PlaneConic(g).is_degenerate()) {
    const ConjugateLines lines = conjugate_lines(g);
    auto part = sides(curve, factor, lines.x, lines.z);
    if (!part) return std::nullopt;
    return FactorParts{*part, [](int) { return SpaceCurve{0, SpaceCurveKind::line, {}, false, 1}; }};
  }
  if (g.total_degree() <= 2) {
    const std::optional<PlaneAbove> plane = plane_through(y, g);
    if (!plane) return std::nullopt;
    return all_of_factor(g.total_degree() == 1 ? line_in_plane(chart, g, *plane)
                                               : conic_in_plane(chart, PlaneConic(g), *plane));
  }
  const std::optional<ConjugateConics> pair = conjugate_conics(g);
  if (!pair) return std::nullopt;
  const auto first = conic_above(chart, *pair, 1, y), second = conic_above(chart, *pair, -1, y);
  auto part = sides(curve, factor, pair->n, pair->m);
  if (!first || !second || !part) return std::nullopt;
  return FactorParts{*part, [one = *first, other = *second](int side) { return side > 0 ? one : other; }};
}

FactorParts parts_of(const CrossingCurve& curve, std::size_t factor) {
  if (auto named = parts_by_name(curve, factor)) return *std::move(named);
  return {ConnectedParts(curve, factor), [](int) {
            return SpaceCurve{0, SpaceCurveKind::general, {}, false, 1};
          }};
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
    const int part = known->second.part(arc);
    const auto [at, is_new] = position.emplace(std::pair(arc.factor, part), curves.size());
    if (is_new) {
      curves.push_back(known->second.curve(part));
      if (std::optional<Point>& direction = curves.back().direction) direction = shortened(*direction);
      curves.back().id = static_cast<int>(at->second);
      curves.back().multiplicity = arc.multiplicity;
    }
    curves[at->second].arcs.push_back(static_cast<int>(i));
  }
  return curves;
}

}  // namespace exsect
