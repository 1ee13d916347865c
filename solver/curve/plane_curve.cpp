#include "curve/plane_curve.h"

#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

void append(std::vector<TriangularPoint>& to, const std::vector<TriangularPoint>& points) {
  to.insert(to.end(), points.begin(), points.end());
}

bool is_constant(const BivariatePolynomial& f) { return f.degree_r() <= 0 && f.degree_s() <= 0; }

BivariatePolynomial in_s(const Polynomial& c) { return BivariatePolynomial(std::vector<Polynomial>{c}); }

}  // namespace

ContentAndPart split_content(const BivariatePolynomial& f) {
  if (f.is_zero()) throw std::domain_error("split_content: the zero polynomial has no content");
  Polynomial content;
  for (int i = 0; i <= f.degree_r(); ++i) content = gcd(content, f.coefficient(i));
  return {content, exact_quotient(f, in_s(content))};
}

BivariatePolynomial squarefree(const BivariatePolynomial& f) {
  const ContentAndPart parts = split_content(f);
  BivariatePolynomial result = parts.primitive;
  if (result.degree_r() > 0) result = exact_quotient(result, gcd(result, result.derivative_r()));
  return parts.content.degree() > 0 ? result * squarefree_part(parts.content) : result;
}

BivariatePolynomial jacobian(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  return f.derivative_r() * g.derivative_s() - f.derivative_s() * g.derivative_r();
}

std::vector<TriangularPoint> common_points(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  if (is_constant(f) || is_constant(g)) {
    const bool coprime = (is_constant(f) && !f.is_zero()) || (is_constant(g) && !g.is_zero());
    if (!coprime) throw std::domain_error("common_points: the polynomials have a common factor");
    return {};
  }
  const Polynomial eliminant = resultant_r(f, g);
  if (eliminant.is_zero()) throw std::domain_error("common_points: the polynomials have a common factor");
  std::vector<TriangularPoint> points;
  if (eliminant.degree() == 0) return points;
  for (const RealAlgebraic& s : real_roots(eliminant, 0, 1)) {
    const BivariatePolynomial common = gcd_at(f, g, s);
    if (common.is_zero()) throw std::domain_error("common_points: the polynomials have a common factor");
    if (common.degree_r() > 0) append(points, roots_at(common, s, 0, 1));
  }
  return points;
}

std::vector<TriangularPoint> side_points(const BivariatePolynomial& f) {
  std::vector<TriangularPoint> points;
  for (const int side : {0, 1}) {
    const Polynomial on_r = f.at_r(side);
    if (on_r.degree() > 0)
      for (const RealAlgebraic& s : real_roots(on_r, 0, 1))
        points.emplace_back(s, BivariatePolynomial::r() - BivariatePolynomial::constant(side),
                            RationalInterval{side, side});
    if (f.at_s(side).degree() > 0) append(points, roots_at(f, RealAlgebraic(side), 0, 1));
  }
  return points;
}

std::vector<TriangularPoint> component_points(const BivariatePolynomial& f) {
  // A component inside the open square is compact and has a point of least s, where f_r = 0; the others meet
  // a side, where their first point is isolated unless the whole side belongs to them: then it is a corner.
  std::vector<TriangularPoint> points = side_points(f);
  for (const int r : {0, 1})
    for (const int s : {0, 1})
      if (f(r, s) == 0)
        points.emplace_back(RealAlgebraic(s), BivariatePolynomial::r() - BivariatePolynomial::constant(r),
                            RationalInterval{r, r});
  const BivariatePolynomial part = split_content(f).primitive;
  if (part.degree_r() > 0) append(points, common_points(part, part.derivative_r()));
  return points;
}

bool same_point(const TriangularPoint& p, const TriangularPoint& q) {
  // q is a root of p.g over the same s, and p the only one in its interval.
  if (p.s() != q.s() || sign_at(p.g(), q) != 0) return false;
  const auto side = [&](const Rational& end) {
    return sign_at(BivariatePolynomial::r() - BivariatePolynomial::constant(end), q);
  };
  const auto [lower, upper] = p.r_interval();
  return lower == upper ? side(lower) == 0 : side(lower) > 0 && side(upper) < 0;
}

CommonZeros common_zeros(const std::vector<BivariatePolynomial>& polynomials) {
  // Invariant: the common zeros of those seen are {curve = 0} and `points`.
  BivariatePolynomial curve;
  std::vector<TriangularPoint> points;
  for (const BivariatePolynomial& f : polynomials) {
    if (f.is_zero()) continue;
    std::erase_if(points, [&](const TriangularPoint& p) { return sign_at(f, p) != 0; });
    if (curve.is_zero()) {
      curve = f;
      continue;
    }
    const BivariatePolynomial common = gcd(curve, f);
    append(points, common_points(exact_quotient(curve, common), exact_quotient(f, common)));
    curve = common;
  }
  CommonZeros result{curve, {}};
  for (const TriangularPoint& p : points) {
    const auto same = [&](const TriangularPoint& q) { return same_point(p, q); };
    if (sign_at(curve, p) != 0 && std::none_of(result.points.begin(), result.points.end(), same))
      result.points.push_back(p);
  }
  return result;
}

bool have_common_zero(const std::vector<BivariatePolynomial>& polynomials) {
  const CommonZeros zeros = common_zeros(polynomials);
  return zeros.curve.is_zero() || !zeros.points.empty() || !component_points(squarefree(zeros.curve)).empty();
}

}  // namespace exsect
