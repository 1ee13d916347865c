#include "line/feasible_intervals.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/quadratic_sign.h>
#include <exsect/algebra/resultant.h>
#include <exsect/algebra/triangular_point.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace exsect {
namespace {

/// A polynomial f whose sign is asked on the branches r_i = (-B -+ sqrt D)/(2A) (9.16):
/// 2 A^n f(r_i) = rational -+ irrational sqrt D.
struct BranchForm {
  BivariatePolynomial f;
  Polynomial rational;
  Polynomial irrational;
  int n;
};

/// The branches of P = A r^2 + B r + C = 0 with the conditions f(r_i(s), s) >= 0 on them.
struct Branches {
  Polynomial a, b, c;
  Polynomial d;                        // discriminant B^2 - 4AC
  Polynomial content;                  // gcd(A,B,C): at its roots r runs free
  BranchForm weight;                   // U != 0
  std::vector<BranchForm> conditions;  // r, 1-r, U L, U (U-L): all >= 0
};

/// f modulo P by Horner's rule: A^k times a partial sum is alpha + beta r, and A r^2 = -B r - C.
BranchForm branch_form(const BivariatePolynomial& f, const Polynomial& a, const Polynomial& b,
                       const Polynomial& c) {
  Polynomial alpha;
  Polynomial beta;
  Polynomial power(1);
  for (int i = f.degree_r(); i >= 0; --i) {
    power *= a;
    Polynomial next = f.coefficient(i) * power - beta * c;
    beta = alpha * a - beta * b;
    alpha = std::move(next);
  }
  return {f, Polynomial(2) * a * alpha - b * beta, beta, f.degree_r() + 2};
}

Branches branches_of(const PullBack& p) {
  if (p.plane.is_zero())
    throw std::domain_error("feasible intervals: the plane vanishes identically on the patch");
  if (p.plane.degree_r() > 2)
    throw std::domain_error("feasible intervals: the degree in r must be at most 2");
  const auto [a, b, c] = std::array{p.plane.coefficient(2), p.plane.coefficient(1), p.plane.coefficient(0)};
  Branches result{a, b, c, b * b - Polynomial(4) * a * c, gcd(gcd(a, b), c), branch_form(p.u, a, b, c), {}};
  const BivariatePolynomial r = BivariatePolynomial::r();
  for (const BivariatePolynomial& f : {r, BivariatePolynomial::constant(1) - r, p.u * p.l, p.u * (p.u - p.l)})
    result.conditions.push_back(branch_form(f, a, b, c));
  return result;
}

/// Real roots in [0,1] at which the sign of f on a branch may change: where f vanishes on the curve P = 0,
/// components on which it vanishes identically left out.
void add_events(std::vector<RealAlgebraic>& events, BivariatePolynomial plane, const BivariatePolynomial& f) {
  if (f.is_zero()) return;
  plane = exact_quotient(plane, gcd(plane, f));
  if (plane.degree_r() <= 0) return;
  const Polynomial r = resultant_r(plane, f);
  if (r.degree() <= 0) return;
  for (const RealAlgebraic& s : real_roots(r, 0, 1)) events.push_back(s);
}

/// 0, 1 and every s in [0,1] where feasibility of a branch may begin or end (2.3), ascending. Between
/// neighbours it does not change: the branches are continuous where A and D have no root.
std::vector<RealAlgebraic> all_events(const Branches& b, const PullBack& p) {
  std::vector<RealAlgebraic> events = {RealAlgebraic(0), RealAlgebraic(1)};
  // The leading coefficient in r, at whose roots a branch runs to infinity.
  for (const Polynomial& f : {b.d, b.a.is_zero() ? b.b : b.a, b.content})
    if (f.degree() > 0)
      for (const RealAlgebraic& s : real_roots(f, 0, 1)) events.push_back(s);
  const BivariatePolynomial r = BivariatePolynomial::r();
  for (const BivariatePolynomial& f : {r, BivariatePolynomial::constant(1) - r, p.l, p.u - p.l, p.u})
    add_events(events, p.plane, f);
  // Narrow enough that an enclosure settles nearly every order and sign.
  for (RealAlgebraic& event : events) event = event.refined_to(power_of_two(-40));
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  return events;
}

/// Sign of f at the root r = -C/B of B r + C, B != 0: B^n f = sum f_i (-C)^i B^(n-i), n = deg_r f made even.
template <class Sign>
int sign_on_line(const BivariatePolynomial& f, const Branches& b, const Sign& sign) {
  const int n = f.degree_r() + f.degree_r() % 2;
  Polynomial sum;
  Polynomial power(1);
  for (int i = n; i >= 0; --i) {
    sum = sum * -b.c + f.coefficient(i) * power;
    power *= b.b;
  }
  return sign(sum);
}

/// Where a sign is asked: at a rational or a real algebraic s.
struct At {
  const RealAlgebraic& s;
  int operator()(const Polynomial& f) const { return sign_at(f, s); }
  int quadratic(const Polynomial& alpha, const Polynomial& beta, const Polynomial& d) const {
    if (s.is_rational()) return quadratic_sign(alpha(s.rational()), beta(s.rational()), d(s.rational()));
    return quadratic_sign(alpha, beta, d, s);
  }
};

/// Sign of the form on branch 1 (e = -1) or 2 (e = +1), A != 0.
int sign_on_branch(const BranchForm& form, const Branches& b, int e, int sign_a, const At& at) {
  const int sign = at.quadratic(form.rational, Polynomial(e) * form.irrational, b.d);
  return form.n % 2 == 0 ? sign : sign * sign_a;
}

/// At a root of the content every r lies in the plane: some r in [0,1] must satisfy the conditions.
bool feasible_on_free_line(const Branches& b, const PullBack& p, const RealAlgebraic& s) {
  std::vector<TriangularPoint> candidates;
  for (const int r : {0, 1})
    candidates.emplace_back(s, BivariatePolynomial::r() - BivariatePolynomial::constant(r),
                            RationalInterval{r, r});
  for (const BivariatePolynomial& f : {p.l, p.u - p.l}) {
    if (reduced_at(f, s).is_zero()) continue;
    for (const TriangularPoint& point : roots_at(f, s, 0, 1)) candidates.push_back(point);
  }
  return std::ranges::any_of(candidates, [&](const TriangularPoint& point) {
    return sign_at(b.weight.f, point) != 0 &&
           std::ranges::all_of(b.conditions, [&](const auto& form) { return sign_at(form.f, point) >= 0; });
  });
}

/// Branch i is defined at s and all conditions hold.
bool feasible(const Branches& b, const PullBack& p, int branch, const RealAlgebraic& s) {
  const At at{s};
  if (at(b.content) == 0) return feasible_on_free_line(b, p, s);
  const auto holds = [&](const auto& sign_of) {
    return sign_of(b.weight) != 0 &&
           std::ranges::all_of(b.conditions, [&](const BranchForm& form) { return sign_of(form) >= 0; });
  };
  const int sign_a = at(b.a);
  if (sign_a != 0) {
    if (at(b.d) < 0) return false;
    return holds(
        [&](const BranchForm& form) { return sign_on_branch(form, b, branch == 1 ? -1 : 1, sign_a, at); });
  }
  const int sign_b = at(b.b);
  const int finite = b.a.is_zero() || sign_b < 0 ? 1 : 2;
  if (sign_b == 0 || branch != finite) return false;
  return holds([&](const BranchForm& form) { return sign_on_line(form.f, b, at); });
}

Rational rational_between(RealAlgebraic a, RealAlgebraic b) {
  for (Rational width = power_of_two(-8);; width *= width) {
    if (a.interval().upper < b.interval().lower)
      return simplest_between(a.interval().upper, b.interval().lower);
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
}

FeasibleBranch feasible_branch(const Branches& b, const PullBack& p, int branch,
                               const std::vector<RealAlgebraic>& events) {
  FeasibleBranch result{branch, {}};
  bool open_run = false;  // the cell before belongs to the last interval
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (feasible(b, p, branch, events[i])) {
      if (!open_run) result.intervals.push_back({events[i], events[i], true, true});
      result.intervals.back().to = events[i];
      result.intervals.back().to_closed = true;
      open_run = true;
    } else {
      open_run = false;
    }
    if (i + 1 == events.size()) break;
    if (feasible(b, p, branch, RealAlgebraic(rational_between(events[i], events[i + 1])))) {
      if (!open_run) result.intervals.push_back({events[i], events[i], false, false});
      result.intervals.back().to = events[i + 1];
      result.intervals.back().to_closed = false;
      open_run = true;
    } else {
      open_run = false;
    }
  }
  return result;
}

}  // namespace

std::vector<FeasibleBranch> feasible_intervals(const PullBack& pullback) {
  return in_nearest_rounding([&] {
    const Branches b = branches_of(pullback);
    const std::vector<RealAlgebraic> events = all_events(b, pullback);
    std::vector<FeasibleBranch> result = {feasible_branch(b, pullback, 1, events)};
    if (!b.a.is_zero()) result.push_back(feasible_branch(b, pullback, 2, events));
    return result;
  });
}

}  // namespace exsect
