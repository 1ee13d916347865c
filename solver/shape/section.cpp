#include "shape/section.h"

#include <exsect/algebra/rational_matrix.h>
#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <vector>

#include "curve/plane_curve.h"

namespace exsect {

namespace {

using Components = std::array<BivariatePolynomial, 4>;

Components components(const RationalPatch& x) {
  return {x.component(0), x.component(1), x.component(2), x.component(3)};
}

BivariatePolynomial times(const Rational& c, const BivariatePolynomial& f) {
  return BivariatePolynomial::constant(c) * f;
}

/// The monomials of one degree in the components, 4 or 10.
std::vector<BivariatePolynomial> monomials(const Components& x, int degree) {
  if (degree == 1) return {x.begin(), x.end()};
  std::vector<BivariatePolynomial> result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) result.push_back(x[i] * x[j]);
  return result;
}

BivariatePolynomial combined(const std::vector<Integer>& form, const std::vector<BivariatePolynomial>& terms,
                             std::size_t first = 0) {
  BivariatePolynomial result;
  for (std::size_t k = 0; k < terms.size(); ++k) result += times(Rational(form[first + k]), terms[k]);
  return result;
}

/// All relations with constant coefficients between polynomials.
std::vector<std::vector<Integer>> relations(const std::vector<BivariatePolynomial>& terms) {
  int m = 0;
  int n = 0;
  for (const BivariatePolynomial& t : terms) {
    m = std::max(m, t.degree_r());
    n = std::max(n, t.degree_s());
  }
  RationalMatrix coefficients(static_cast<std::size_t>(m + 1) * static_cast<std::size_t>(n + 1),
                              terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k)
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j)
        coefficients(static_cast<std::size_t>(i * (n + 1) + j), k) = terms[k].coefficient(i, j);
  return null_space(coefficients);
}

/// Linear forms N and D of space with p = N/D for a parameter p of the patch.
struct Quotient {
  std::vector<Integer> forms;  // of N, then of D
};

/// From all relations N(Y) = p D(Y) the first one with a D that does not vanish on the patch.
std::optional<Quotient> parameter_quotient(const Components& y, const BivariatePolynomial& parameter) {
  std::vector<BivariatePolynomial> terms(y.begin(), y.end());
  for (const BivariatePolynomial& c : y) terms.push_back(times(-1, parameter * c));
  const std::vector<BivariatePolynomial> of_y(y.begin(), y.end());
  for (std::vector<Integer>& relation : relations(terms))
    if (!combined(relation, of_y, 4).is_zero()) return Quotient{std::move(relation)};
  return std::nullopt;
}

/// D² times the derivative of N/D along the curve f = 0.
BivariatePolynomial rate_along(const BivariatePolynomial& f, const BivariatePolynomial& numerator,
                               const BivariatePolynomial& denominator) {
  const BivariatePolynomial by_r =
      numerator.derivative_r() * denominator - numerator * denominator.derivative_r();
  const BivariatePolynomial by_s =
      numerator.derivative_s() * denominator - numerator * denominator.derivative_s();
  return by_r * f.derivative_s() - by_s * f.derivative_r();
}

/// F(X) for the plane or the quadric of y, every factor once.
std::optional<BivariatePolynomial> pulled_back_equation(const Components& x, const Components& y) {
  for (const int degree : {1, 2}) {
    const auto equations = relations(monomials(y, degree));
    if (equations.empty()) continue;
    const BivariatePolynomial f = combined(equations.front(), monomials(x, degree));
    if (equations.size() > 1 || f.is_zero()) return std::nullopt;
    return squarefree(f);
  }
  return std::nullopt;
}

std::optional<Section> section_of(const RationalPatch& x, const RationalPatch& y, std::size_t first) {
  const Components of_x = components(x.reduced());
  const Components of_y = components(y.reduced());
  const auto f = pulled_back_equation(of_x, of_y);
  if (!f) return std::nullopt;
  const BivariatePolynomial one = BivariatePolynomial::constant(1);
  Section result{first, *f, {}};
  result.turning[first] = {f->derivative_s(), one};
  result.turning[first + 1] = {f->derivative_r(), one};
  const std::vector<BivariatePolynomial> terms(of_x.begin(), of_x.end());
  for (const std::size_t p : {0U, 1U}) {
    const auto quotient =
        parameter_quotient(of_y, p == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s());
    if (!quotient) continue;
    const BivariatePolynomial denominator = combined(quotient->forms, terms, 4);
    if (!denominator.is_zero())
      result.turning[2 - first + p] = {rate_along(*f, combined(quotient->forms, terms), denominator),
                                       denominator};
  }
  return result;
}

}  // namespace

std::vector<Section> sections(const RationalPatch& x, const RationalPatch& y) {
  std::vector<Section> result;
  if (auto section = section_of(x, y, 0)) result.push_back(*std::move(section));
  if (auto section = section_of(y, x, 2)) result.push_back(*std::move(section));
  return result;
}

bool is_constant_in(const Section& section, std::size_t parameter, const std::vector<Rectangle>& boxes) {
  const auto& turning = section.turning[parameter];
  if (!turning) return false;
  const BivariatePolynomial common = gcd(section.f, turning->rate);
  if (common.total_degree() <= 0) return false;
  const BivariatePolynomial rest = exact_quotient(section.f, common) * turning->valid;
  return std::ranges::all_of(boxes, [&](const Rectangle& box) {
    const RationalInterval values = range_bound(rest, box);
    return values.lower > 0 || values.upper < 0;
  });
}

bool turns_on_side(const Section& section, std::size_t parameter, const Side& side,
                   const RationalInterval& other) {
  const std::size_t across = index(side.parameter) - section.first;
  const auto& turning = section.turning[parameter];
  if (!turning || across > 1) return false;
  const auto on_side = [&](const BivariatePolynomial& g) {
    return across == 0 ? g.at_r(side.value) : g.at_s(side.value);
  };
  const auto roots = [&](const Polynomial& p) { return real_roots(p, other.lower, other.upper).size(); };
  const Polynomial f = on_side(section.f);
  if (f.is_zero() || roots(f) != 1) return false;
  const Polynomial singular =
      gcd(gcd(f, on_side(section.f.derivative_r())), on_side(section.f.derivative_s()));
  return roots(singular) == 0 && roots(gcd(f, on_side(turning->valid))) == 0 &&
         roots(gcd(f, on_side(turning->rate))) == 1;
}

}  // namespace exsect
