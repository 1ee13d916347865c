#include "curve/curve_values.h"

#include <exsect/algebra/resultant.h>
#include <exsect/algebra/sturm.h>

#include <algorithm>
#include <utility>

#include "curve/turning_resultant.h"

namespace exsect {

bool are_apart(const RealAlgebraic& a, const RealAlgebraic& b) {
  return a.interval().upper < b.interval().lower;
}

namespace {

/// Ascending, each once, with disjoint closed intervals.
std::vector<CriticalValue> merged(std::vector<CriticalValue> values) {
  std::sort(values.begin(), values.end(),
            [](const CriticalValue& a, const CriticalValue& b) { return a.u < b.u; });
  std::vector<CriticalValue> result;
  for (const CriticalValue& value : values) {
    if (result.empty() || result.back().u != value.u) {
      result.push_back(value);
      continue;
    }
    CriticalValue& same = result.back();
    if (value.u.is_rational()) same.u = value.u;
    same.is_exact = true;
    same.is_vertical = same.is_vertical || value.is_vertical;
  }
  for (std::size_t i = 0; i + 1 < result.size(); ++i)
    for (Rational width = power_of_two(-20); !are_apart(result[i].u, result[i + 1].u); width *= width) {
      result[i].u = result[i].u.refined_to(width);
      result[i + 1].u = result[i + 1].u.refined_to(width);
    }
  return result;
}

}  // namespace

bool is_nowhere_real(const BivariatePolynomial& f) {
  const auto without_roots = [](const Polynomial& g) { return SturmSequence(g).count_all() == 0; };
  return (f.degree_s() == 0 && without_roots(f.at_s(0))) || (f.degree_r() == 0 && without_roots(f.at_r(0)));
}

BivariatePolynomial without_factors_of(const BivariatePolynomial& f, BivariatePolynomial h) {
  for (;;) {
    const BivariatePolynomial common = gcd(h, f);
    if (common.degree_r() < 1 && common.degree_s() < 1) return h;
    h = exact_quotient(h, common);
  }
}

std::vector<CriticalValue> curve_values(const std::vector<BivariatePolynomial>& factors,
                                        const Polynomial& lines,
                                        const std::vector<BivariatePolynomial>& bounds) {
  std::vector<CriticalValue> values = {{0, true, false, std::nullopt}, {1, true, false, std::nullopt}};
  const auto add = [&](const Polynomial& at, bool is_general, bool vertical, std::optional<int> side) {
    if (at.degree() < 1) return;
    for (const PolynomialPower& power : squarefree_factors(at))
      for (const RealAlgebraic& u : real_roots(power.factor, 0, 1))
        values.push_back({u, is_general || power.multiplicity > 1 || u.is_rational(), vertical, side});
  };
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const BivariatePolynomial& f = factors[i];
    add(turning_resultant(f), false, false, std::nullopt);
    for (std::size_t j = 0; j < i; ++j) add(resultant_s(factors[j], f), true, false, std::nullopt);
    for (const int side : {0, 1}) add(f.at_s(side), false, false, side);
    for (const BivariatePolynomial& h : bounds)
      if (!h.is_zero() && f.degree_s() > 0)
        add(resultant_s(f, without_factors_of(f, h)), true, false, std::nullopt);
  }
  for (const PolynomialPower& line : irreducible_factors(lines)) add(line.factor, true, true, std::nullopt);
  return merged(std::move(values));
}

}  // namespace exsect
