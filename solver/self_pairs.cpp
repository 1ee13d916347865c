#include "self_pairs.h"

#include <algorithm>

#include "exact_line_points.h"
#include "line_system.h"
#include "parameter_box.h"
#include "special_cusps.h"

namespace exsect {
namespace {

/// f without its factors that vanish on the line.
BivariatePolynomial without(const BivariatePolynomial& line, BivariatePolynomial f) {
  while (!f.is_zero() && gcd(line, f) == line) f = exact_quotient(f, line);
  return f;
}

/// The equations of the line, without the line itself, vanish on no curve of pairs of different points. On a
/// line that is not folded such a curve is not the line again.
bool has_isolated_pairs(const BezierPatch& x, const LineQuery& query) {
  const LineAndPatch problem = line_and_patch(x, x, query);
  if (shape(problem.line) == LineShape::point) return false;
  const LineSystem system = line_system(problem);
  const BivariatePolynomial variable =
      index(query.fixed) % 2 == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s();
  const BivariatePolynomial line = variable - BivariatePolynomial::constant(query.value);
  BivariatePolynomial shared = gcd(exact_quotient(system.first, line), exact_quotient(system.second, line));
  if (shape(problem.line) != LineShape::folded)
    shared = without(gcd(line, BivariatePolynomial()), std::move(shared));
  return shared.degree_r() == 0 && shared.degree_s() == 0;
}

bool is_straight(const BezierPatch& x, const Rational& v) {
  return is_zero(cross(x.derivative_first(0, v), x.derivative_first(1, v)));
}

}  // namespace

std::optional<std::vector<CertifiedPoint>> pairs_in(const BezierPatch& x, const LineQuery& query,
                                                    const ParameterBox& region) {
  if (!has_isolated_pairs(x, query)) return std::nullopt;
  const LinePoints line = exact_line_points(x, x, query);
  if (line.incomplete) return std::nullopt;
  std::vector<CertifiedPoint> inside;
  for (CertifiedPoint point : line.points) {
    for (Rational width = power_of_two(-100); meet(point.box(), region) && !lies_in(point.box(), region);
         width *= width) {
      if (width < power_of_two(-2000)) return std::nullopt;
      point = point.refined_to(width);
    }
    if (meet(point.box(), region)) inside.push_back(std::move(point));
  }
  return inside;
}

bool has_folded_line(const BezierPatch& x, std::size_t fixed, const RationalInterval& range) {
  const BezierPatch lines = fixed == 1 ? x : x.exchanged();
  bool all_straight = true;  // the cross product of two tangents has degree 4
  for (const int v : {0, 1, 2, 3, 4}) all_straight = all_straight && is_straight(lines, v);
  if (all_straight) return true;
  return std::ranges::any_of(folded_lines(lines), [&](const FoldedLine& line) {
    const bool ends_in_turn = line.side[0].has_value();
    return !ends_in_turn && line.turn.s().compare(range.lower) >= 0 &&
           line.turn.s().compare(range.upper) <= 0;
  });
}

}  // namespace exsect
