#include "algebraic_value.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fixed_point_interval.h"
#include "real_field.h"
#include "resultant.h"

namespace exsect {
namespace {

/// The polynomial of degree below the number of nodes 0, 1, 2, ... with the given values there (Newton).
Polynomial interpolated(std::vector<Rational> values) {
  const std::size_t n = values.size();
  for (std::size_t k = 1; k < n; ++k)
    for (std::size_t i = n - 1; i >= k; --i) values[i] = (values[i] - values[i - 1]) / static_cast<int>(k);
  Polynomial result;
  for (std::size_t i = n; i-- > 0;)
    result = result * (Polynomial::variable() - Polynomial(static_cast<int>(i))) + Polynomial(values[i]);
  return result;
}

/// A polynomial in T with the root h(p)/w(p): Res_s(m, Res_r(g, h - T w)) over the minimal polynomial m of s.
/// m is irreducible, so the leading coefficient of g vanishes at no conjugate of s, and the resultant is up
/// to a nonzero constant the product of h(p') - T w(p') over all conjugate points p': it is zero only if h
/// and w have one of them in common, never for w = 1.
Polynomial annihilator(const BivariatePolynomial& h, const BivariatePolynomial& w, const TriangularPoint& p) {
  const Polynomial minimal = minimal_polynomial(p.s());
  // Monic: the degree in s of Res_r(g, h - T w) may drop at some T, and the resultant of the actual degrees
  // would lose a power of the leading coefficient there.
  const Polynomial m = minimal * Polynomial(Rational(1 / minimal.leading_coefficient()));
  const int degree = m.degree() * p.g().degree_r();
  // Where the degree in r drops, Res_r loses a power of the leading coefficient of g.
  const int degree_r = std::max(h.degree_r(), w.degree_r());
  const Polynomial leading = p.g().coefficient(p.g().degree_r());
  std::vector<Rational> values;
  for (int t = 0; t <= degree; ++t) {
    const BivariatePolynomial difference = h - BivariatePolynomial::constant(t) * w;
    if (difference.is_zero()) {
      values.emplace_back(0);
      continue;
    }
    Polynomial in_s = resultant_r(p.g(), difference);
    for (int i = difference.degree_r(); i < degree_r; ++i) in_s = in_s * leading;
    values.push_back(resultant(m, in_s));
  }
  return interpolated(std::move(values));
}

/// The root of f that is the value, which is enclosed as narrowly as is asked for.
template <class Enclosure>
RealAlgebraic enclosed_root(const Polynomial& f, const Enclosure& enclosure) {
  std::vector<RealAlgebraic> roots;
  Rational width = power_of_two(-20);
  do {
    const RationalInterval value = enclosure(width);
    roots = real_roots(f, value.lower, value.upper);
    if (roots.empty())
      throw std::logic_error("value_at: the annihilating polynomial has no root at the value");
    width *= power_of_two(-20);
  } while (roots.size() != 1);
  const Polynomial m = minimal_polynomial(roots.front());
  if (m.degree() == 1) return RealAlgebraic(-m.coefficient(0) / m.coefficient(1));
  return roots.front();
}

/// A closed interval with h(p)/w(p) inside, of width at most `width`.
RationalInterval enclosed_quotient(const BivariatePolynomial& h, const BivariatePolynomial& w,
                                   const TriangularPoint& p, const Rational& width) {
  for (Rational part = width;; part *= power_of_two(-20)) {
    const RationalInterval a = enclosure_at(h, p, part), b = enclosure_at(w, p, part);
    if (b.lower <= 0 && b.upper >= 0) continue;
    const std::array<Rational, 4> ends = {a.lower / b.lower, a.lower / b.upper, a.upper / b.lower,
                                          a.upper / b.upper};
    const auto [least, greatest] = std::minmax_element(ends.begin(), ends.end());
    if (*greatest - *least <= width / 2) return {*least - width / 4, *greatest + width / 4};
  }
}

}  // namespace

RationalInterval enclosure_at(const BivariatePolynomial& h, const TriangularPoint& p, const Rational& width) {
  TriangularPoint point = p;
  for (long bits = bits_below(width) + 8;; bits *= 2) {
    point = point.refined_to(power_of_two(-bits));
    const RationalInterval value = enclose(h, FixedPointInterval(point.r_interval(), bits),
                                           FixedPointInterval(point.s().interval(), bits))
                                       .interval();
    if (value.width() <= width) return value;
  }
}

RealAlgebraic value_at(const BivariatePolynomial& h, const TriangularPoint& p) {
  return enclosed_root(annihilator(h, BivariatePolynomial::constant(1), p),
                       [&](const Rational& width) { return enclosure_at(h, p, width); });
}

std::optional<RealAlgebraic> quotient_at(const BivariatePolynomial& h, const BivariatePolynomial& w,
                                         const TriangularPoint& p) {
  const Polynomial f = annihilator(h, w, p);
  if (f.is_zero()) return std::nullopt;
  return enclosed_root(f, [&](const Rational& width) { return enclosed_quotient(h, w, p, width); });
}

}  // namespace exsect
