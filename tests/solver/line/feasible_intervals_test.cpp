#include <exsect/solver/feasible_intervals.h>

#include <algorithm>

#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::feasible_intervals_test {

namespace {

BivariatePolynomial in_r_and_s(const std::vector<Polynomial>& coefficients) {
  return BivariatePolynomial(coefficients);
}

BivariatePolynomial constant(const Rational& c) { return BivariatePolynomial::constant(c); }

/// A pull-back whose line parameter is t = l.
PullBack with_plane(const BivariatePolynomial& plane, const BivariatePolynomial& l) {
  return {plane, constant(1), l, constant(0)};
}

bool is_feasible(const FeasibleBranch& branch, const Rational& s) {
  return std::ranges::any_of(branch.intervals,
                             [&](const auto& i) { return in_interval(i, RealAlgebraic(s)); });
}

/// Second route at a rational s: isolate the roots of P(.,s), name the branch by the sign of the derivative,
/// ask the signs of l and u - l at the roots.
bool expected_at(const PullBack& p, int branch, const Rational& s) {
  const Polynomial plane = p.plane.at_s(s);
  if (plane.is_zero()) return true;
  if (plane.degree() == 0) return false;
  const Polynomial u = p.u.at_s(s);
  const Polynomial l = p.l.at_s(s) * u;
  const Polynomial above = u * u - l;
  const bool linear_throughout = p.plane.degree_r() == 1;
  for (const RealAlgebraic& r : real_roots(plane, 0, 1)) {
    const int slope = sign_at(plane.derivative(), r);
    const bool named = linear_throughout ? branch == 1 : slope == 0 || (branch == 1) == (slope < 0);
    if (named && sign_at(l, r) >= 0 && sign_at(above, r) >= 0) return true;
  }
  return false;
}

void check_grid(const PullBack& p, int steps) {
  for (const FeasibleBranch& branch : feasible_intervals(p)) {
    for (std::size_t i = 0; i + 1 < branch.intervals.size(); ++i) {
      const FeasibleInterval& a = branch.intervals[i];
      const FeasibleInterval& b = branch.intervals[i + 1];
      CHECK((a.to < b.from || (a.to == b.from && !a.to_closed && !b.from_closed)));
    }
    for (int i = 0; i <= steps; ++i) {
      const Rational s(i, steps);
      INFO("branch " << branch.branch << " at s = " << s);
      CHECK(is_feasible(branch, s) == expected_at(p, branch.branch, s));
    }
  }
}

const Polynomial s = Polynomial::variable();
const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial half_way = constant(Rational(1, 2));

}  // namespace

TEST_CASE("feasible intervals: a circle") {
  // (r - 1/2)^2 + (s - 1/2)^2 = 1/16: both branches over [1/4, 3/4].
  const Polynomial c =
      (s - Polynomial(Rational(1, 2))) * (s - Polynomial(Rational(1, 2))) + Polynomial(Rational(3, 16));
  const PullBack p = with_plane(in_r_and_s({c, Polynomial(-1), Polynomial(1)}), half_way);
  for (const FeasibleBranch& branch : feasible_intervals(p)) {
    REQUIRE(branch.intervals.size() == 1);
    CHECK(branch.intervals[0].from == RealAlgebraic(Rational(1, 4)));
    CHECK(branch.intervals[0].to == RealAlgebraic(Rational(3, 4)));
    CHECK(branch.intervals[0].from_closed);
    CHECK(branch.intervals[0].to_closed);
  }
  check_grid(p, 16);
}

TEST_CASE("feasible intervals: an isolated point") {
  // The same circle of radius 0.
  const Polynomial c =
      (s - Polynomial(Rational(1, 2))) * (s - Polynomial(Rational(1, 2))) + Polynomial(Rational(1, 4));
  for (const FeasibleBranch& branch :
       feasible_intervals(with_plane(in_r_and_s({c, Polynomial(-1), Polynomial(1)}), half_way))) {
    REQUIRE(branch.intervals.size() == 1);
    CHECK(branch.intervals[0].from == RealAlgebraic(Rational(1, 2)));
    CHECK(branch.intervals[0].to == RealAlgebraic(Rational(1, 2)));
  }
}

TEST_CASE("feasible intervals: the leading coefficient vanishes on the way") {
  // (s - 1/2) r^2 + r - 1/2: D = 1 + 2(s - 1/2) = 2s; branch 2 is finite at s = 1/2 (r = 1/2), branch 1 is
  // not.
  const Polynomial a = s - Polynomial(Rational(1, 2));
  const PullBack p = with_plane(in_r_and_s({Polynomial(Rational(-1, 2)), Polynomial(1), a}), half_way);
  const auto branches = feasible_intervals(p);
  REQUIRE(branches.size() == 2);
  CHECK(branches[1].branch == 2);
  REQUIRE(branches[1].intervals.size() == 1);
  CHECK(branches[1].intervals[0].from == RealAlgebraic(0));
  CHECK(branches[1].intervals[0].to == RealAlgebraic(1));
  check_grid(p, 12);
  INFO("mirrored: branch 1 continues");
  check_grid(with_plane(in_r_and_s({Polynomial(Rational(1, 2)), Polynomial(-1), a}), half_way), 12);
}

TEST_CASE("feasible intervals: open end where a branch has no finite limit") {
  // A = (s - 1/2)^2, B = 0, C = -(s - 1/2)^2 (1/4) + ...: r^2 = 1/4 for s != 1/2 is handled by the content
  // rule; (s - 1/2) (r^2 - r) + (s - 1/2)/8 has content s - 1/2, where every r solves the plane's equation.
  const Polynomial a = s - Polynomial(Rational(1, 2));
  const PullBack p = with_plane(in_r_and_s({a * Polynomial(Rational(1, 8)), -a, a}), half_way);
  for (const FeasibleBranch& branch : feasible_intervals(p)) {
    REQUIRE(branch.intervals.size() == 1);
    CHECK(branch.intervals[0].from == RealAlgebraic(0));
    CHECK(branch.intervals[0].to == RealAlgebraic(1));
  }
  check_grid(p, 8);
}

TEST_CASE("feasible intervals: linear and constant in r") {
  // (s - 1/2) r + 1/8 - s/4 = 0: r = 1/4 for s != 1/2, everything at s = 1/2.
  const Polynomial b = s - Polynomial(Rational(1, 2));
  check_grid(with_plane(in_r_and_s({b * Polynomial(Rational(-1, 4)), b}), half_way), 8);
  INFO("B r + C with a pole: r = 1/(8 s - 4)");
  const PullBack pole = with_plane(in_r_and_s({Polynomial(Rational(-1, 8)), b}), r);
  const auto branches = feasible_intervals(pole);
  REQUIRE(branches.size() == 1);
  REQUIRE(branches[0].intervals.size() == 1);
  CHECK(branches[0].intervals[0].from == RealAlgebraic(Rational(5, 8)));
  check_grid(pole, 16);
  INFO("constant in r: the lines s = 1/3 are free");
  const auto free = feasible_intervals(with_plane(in_r_and_s({s - Polynomial(Rational(1, 3))}), half_way));
  REQUIRE(free.size() == 1);
  REQUIRE(free[0].intervals.size() == 1);
  CHECK(free[0].intervals[0].from == RealAlgebraic(Rational(1, 3)));
  CHECK(free[0].intervals[0].to == RealAlgebraic(Rational(1, 3)));
  CHECK(feasible_intervals(with_plane(in_r_and_s({s - Polynomial(Rational(1, 3))}), constant(2)))[0]
            .intervals.empty());
}

TEST_CASE("feasible intervals: t = 0 all along one branch") {
  // (r - 1/4)(r - s): l = r - 1/4 vanishes on the first factor, and t = s - 1/4 on the second.
  const BivariatePolynomial first = r - constant(Rational(1, 4));
  const PullBack p = with_plane(first * (r - BivariatePolynomial::s()), first);
  check_grid(p, 16);
}

TEST_CASE("feasible intervals: the plane is identically zero") {
  CHECK_THROWS_AS(feasible_intervals(with_plane(BivariatePolynomial(), half_way)), std::domain_error);
}

TEST_CASE("feasible intervals of the first example and of random pairs") {
  const auto [x, y] = example("chapter9-first.json");
  check_grid(pull_back(orthogonal_forms(line_at_first(x, Rational(1, 2))), y), 40);
  const unsigned seed = 911;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 8; ++i) {
    const auto [a, b] = random_pair(random, 3);
    check_grid(pull_back(axis_forms(line_at_second(a, Rational(i, 7))), b), 15);
  }
}

}  // namespace exsect::feasible_intervals_test
