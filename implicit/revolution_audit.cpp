#include "revolution_audit.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/resultant.h>
#include <exsect/algebra/sturm.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "curve/plane_curve.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

void check(const BivariatePolynomial& f, const Rectangle& on, const char* where) {
  if (f.is_zero()) throw std::domain_error(std::string(where) + ": the zero polynomial");
  if (on.r.lower != 0 || on.r.upper <= 0 || on.s.width() <= 0)
    throw std::invalid_argument(std::string(where) + ": the region must be [0,b] x [c,d] with 0 < b, c < d");
}

/// f(a + w r, s) for every coefficient in s.
BivariatePolynomial substituted_s(const BivariatePolynomial& f, const RationalInterval& on) {
  std::vector<Polynomial> rows;
  for (int i = 0; i <= f.degree_r(); ++i)
    rows.push_back(f.coefficient(i).compose(Polynomial({on.lower, on.width()})));
  return BivariatePolynomial(std::move(rows));
}

/// f on the rectangle, mapped to the unit square.
BivariatePolynomial on_unit_square(const BivariatePolynomial& f, const Rectangle& on) {
  return substituted_s(substituted_s(f, on.s).exchanged(), on.r).exchanged();
}

RationalInterval mapped(const RationalInterval& unit, const RationalInterval& to) {
  return {to.lower + unit.lower * to.width(), to.lower + unit.upper * to.width()};
}

/// Interval of s, which refined_to leaves open or exact.
RationalInterval interval_of_s(const TriangularPoint& p) { return p.s().interval(); }

/// All real roots in the closed interval, each once.
void add_roots(std::vector<RealAlgebraic>& roots, const Polynomial& f, const RationalInterval& on) {
  if (f.degree() < 1) return;
  for (RealAlgebraic& root : real_roots(f, on.lower, on.upper))
    if (std::find(roots.begin(), roots.end(), root) == roots.end()) roots.push_back(std::move(root));
}

/// A rational number strictly between; a < b.
Rational sample_between(RealAlgebraic a, RealAlgebraic b) {
  for (Rational width = power_of_two(-8); a.interval().upper >= b.interval().lower; width *= width) {
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
  return simplest_between(a.interval().upper, b.interval().lower);
}

BranchCount count_at(const BivariatePolynomial& f, const Rational& z, const Rational& b, bool even) {
  const Polynomial in_r = f.at_s(z);
  BranchCount count{z, 0, 0};
  if (in_r.degree() < 1) return count;
  const SturmSequence sturm(in_r);
  count.own = sturm.count(0, b) - (in_r.sign_at(b) == 0 ? 1 : 0);
  if (!even) count.mirrored = sturm.count(-b, 0) - (in_r.sign_at(0) == 0 ? 1 : 0);
  return count;
}

}  // namespace

SingularRings singular_rings(const BivariatePolynomial& f, const Rectangle& on) {
  return in_nearest_rounding([&] {
    check(f, on, "singular rings");
    const ParityParts parts = parity_parts(f);
    const BivariatePolynomial common = gcd(parts.even, parts.odd);
    SingularRings result{{}, common.degree_r() > 0 || common.degree_s() > 0};
    const Rectangle in_squares = {{0, on.r.upper * on.r.upper}, on.s};
    const BivariatePolynomial even = on_unit_square(exact_quotient(parts.even, common), in_squares);
    const BivariatePolynomial odd = on_unit_square(exact_quotient(parts.odd, common), in_squares);
    for (const TriangularPoint& p : common_points(even, odd)) {
      if (sign_at(BivariatePolynomial::r(), p) == 0) continue;  // on the axis
      TriangularPoint fine = p.refined_to(power_of_two(-40));
      while (fine.r_interval().lower <= 0) fine = fine.refined_to(fine.r_interval().width() / 4);
      const RationalInterval squared = mapped(fine.r_interval(), in_squares.r);
      result.rings.push_back({{root_below(squared.lower), root_above(squared.upper)},
                              mapped(interval_of_s(fine), in_squares.s)});
    }
    return result;
  });
}

bool BranchAudit::has_unwanted() const {
  return std::any_of(gaps.begin(), gaps.end(),
                     [](const BranchCount& count) { return count.own > 1 || count.mirrored > 0; });
}

BranchAudit audit_branches(const BivariatePolynomial& f, const Rectangle& on) {
  return in_nearest_rounding([&] {
    check(f, on, "branch audit");
    const Rational& b = on.r.upper;
    const BivariatePolynomial simple = squarefree(f);
    std::vector<RealAlgebraic> ends;
    if (simple.degree_r() >= 1) {
      add_roots(ends, discriminant_r(simple), on.s);
      add_roots(ends, simple.coefficient(simple.degree_r()), on.s);
      for (const Rational& r : {Rational(0), b, Rational(-b)}) add_roots(ends, simple.at_r(r), on.s);
    }
    std::sort(ends.begin(), ends.end());
    BranchAudit result;
    for (RealAlgebraic& z : ends)
      if (z.compare(on.s.lower) > 0 && z.compare(on.s.upper) < 0) result.critical.push_back(std::move(z));
    const bool even = parity_parts(f).odd.is_zero();
    for (std::size_t i = 0; i <= result.critical.size(); ++i) {
      const RealAlgebraic from = i == 0 ? RealAlgebraic(on.s.lower) : result.critical[i - 1];
      const RealAlgebraic to = i == result.critical.size() ? RealAlgebraic(on.s.upper) : result.critical[i];
      result.gaps.push_back(count_at(f, sample_between(from, to), b, even));
    }
    return result;
  });
}

}  // namespace exsect
