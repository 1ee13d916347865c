#include "self/pairs.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "line/line_system.h"
#include "shape/injective_rectangle.h"
#include "shape/special_cusps.h"

namespace exsect {
namespace {

/// f without its factors that vanish on the line.
BivariatePolynomial without(const BivariatePolynomial& line, BivariatePolynomial f) {
  while (!f.is_zero() && gcd(line, f) == line) f = exact_quotient(f, line);
  return f;
}

/// r or s (fixed: 0 or 1) minus the value, normalised as a greatest common divisor.
BivariatePolynomial line_form(std::size_t fixed, const Rational& value) {
  return gcd((fixed == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s()) -
                 BivariatePolynomial::constant(value),
             BivariatePolynomial());
}

/// The equations of the line, without the line itself, vanish on no curve of pairs of different points, apart
/// from a side that is one point and outside of the region. On a line that is not folded such a curve is not
/// the line again.
bool has_isolated_pairs(const BezierPatch& x, const LineQuery& query, const ParameterBox& region) {
  const LineAndPatch problem = line_and_patch(x, x, query);
  if (shape(problem.line) == LineShape::point) return false;
  const LineSystem system = line_system(problem);
  const BivariatePolynomial line = line_form(index(query.fixed) % 2, query.value);
  BivariatePolynomial shared = gcd(exact_quotient(system.first, line), exact_quotient(system.second, line));
  if (shape(problem.line) != LineShape::folded) shared = without(line, std::move(shared));
  for (const std::size_t fixed : {0, 1})
    for (const int value : {0, 1})
      if (!meets_side(region, fixed, value) && is_collapsed_side(x, fixed, value))
        shared = without(line_form(fixed, value), std::move(shared));
  return shared.degree_r() == 0 && shared.degree_s() == 0;
}

bool is_straight(const BezierPatch& x, const Rational& v) {
  return is_zero(cross(x.derivative_first(0, v), x.derivative_first(1, v)));
}

}  // namespace

std::optional<std::vector<CertifiedPoint>> pairs_in(const BezierPatch& x, const LineQuery& query,
                                                    const ParameterBox& region) {
  if (!has_isolated_pairs(x, query, region)) return std::nullopt;
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

bool has_folded_line(const BezierPatch& x, std::size_t fixed, const RationalInterval& range,
                     const RationalInterval& along) {
  const BezierPatch lines = fixed == 1 ? x : x.exchanged();
  bool all_straight = true;  // the cross product of two tangents has degree 4
  for (const int v : {0, 1, 2, 3, 4}) all_straight = all_straight && is_straight(lines, v);
  if (all_straight) return true;
  return std::ranges::any_of(folded_lines(lines), [&](const FoldedLine& line) {
    const bool ends_in_turn = line.side[0].has_value();
    const auto turn_compared = [&](const Rational& value) {
      return sign_at(BivariatePolynomial::r() - BivariatePolynomial::constant(value), line.turn);
    };
    return !ends_in_turn && line.turn.s().compare(range.lower) >= 0 &&
           line.turn.s().compare(range.upper) <= 0 && turn_compared(along.lower) >= 0 &&
           turn_compared(along.upper) <= 0;
  });
}

}  // namespace exsect
