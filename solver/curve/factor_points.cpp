#include "curve/factor_points.h"

#include <algorithm>
#include <compare>
#include <utility>

#include "curve/curve_values.h"
#include "curve/no_zero.h"
#include "curve/plane_curve.h"

namespace exsect {
namespace {

bool has_variables(const BivariatePolynomial& f) { return f.degree_r() > 0 || f.degree_s() > 0; }

/// Of points over the same u: a is below b, above it, or the same.
std::strong_ordering order_over(TriangularPoint a, TriangularPoint b) {
  for (Rational width = power_of_two(-10);; width *= width) {
    a = a.refined_to(width);
    b = b.refined_to(width);
    const RationalInterval &p = a.r_interval(), &q = b.r_interval();
    if (p.upper < q.lower) return std::strong_ordering::less;
    if (q.upper < p.lower) return std::strong_ordering::greater;
    if (width == power_of_two(-40) && same_point(a, b)) return std::strong_ordering::equal;
  }
}

/// Refines a below b until their closed intervals are disjoint.
void make_disjoint(TriangularPoint& a, TriangularPoint& b) {
  for (Rational width = power_of_two(-10); a.r_interval().upper >= b.r_interval().lower; width *= width) {
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
}

}  // namespace

std::vector<BivariatePolynomial> coprime_factors(const std::vector<BivariatePolynomial>& polynomials) {
  std::vector<BivariatePolynomial> result;
  for (const BivariatePolynomial& f : polynomials) {
    BivariatePolynomial rest = squarefree(f);
    for (const BivariatePolynomial& known : result) rest = without_factors_of(known, std::move(rest));
    if (has_variables(rest)) result.push_back(std::move(rest));
  }
  return result;
}

std::vector<FactorRoot> roots_over(const std::vector<BivariatePolynomial>& factors, const Rational& u) {
  std::vector<FactorRoot> result;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Polynomial in_v = factors[i].at_r(u);
    if (in_v.degree() < 1) continue;
    for (const RealAlgebraic& v : real_roots(in_v, 0, 1)) result.push_back({v, i});
  }
  if (factors.size() > 1)
    std::ranges::sort(result, [](const FactorRoot& a, const FactorRoot& b) { return a.v < b.v; });
  return result;
}

std::vector<FactorPoint> points_over(const std::vector<BivariatePolynomial>& factors,
                                     const RealAlgebraic& u) {
  std::vector<FactorPoint> result;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i].degree_r() < 1) continue;
    auto next = result.begin();
    for (const TriangularPoint& point : roots_at(factors[i], u, 0, 1)) {
      std::strong_ordering order = std::strong_ordering::less;
      while (next != result.end() && (order = order_over(point, next->at)) > 0) ++next;
      if (next != result.end() && order == 0)
        next->factors.push_back(i);
      else
        next = result.insert(next, {point, {i}}) + 1;
    }
  }
  for (std::size_t k = 0; k + 1 < result.size(); ++k) make_disjoint(result[k].at, result[k + 1].at);
  return result;
}

bool has_no_zero_along(const std::vector<BivariatePolynomial>& factors, const Rational& v,
                       const RationalInterval& u) {
  return std::ranges::all_of(factors,
                             [&](const BivariatePolynomial& f) { return has_no_zero(f.at_s(v), u); });
}

}  // namespace exsect
