#include <exsect/algebra/resultant.h>
#include <exsect/algebra/triangular_point.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algebra/algebraic_specimens.h"
#include "support/catch.h"

namespace exsect::triangular_point_test {
using namespace exsect::test;

namespace {

const Polynomial t = Polynomial::variable();
const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial s = BivariatePolynomial::s();

BivariatePolynomial number(const Rational& c) { return BivariatePolynomial::constant(c); }
BivariatePolynomial in_s(const Polynomial& f) { return number(1) * f; }

/// sqrt 2 as a root of `multiple` (t^2 - 2).
RealAlgebraic root_two(const Polynomial& multiple = 1) { return QuadraticNumber{0, 1, 2}.number(multiple); }

BivariatePolynomial random_bivariate(Random& random, int degree_r, int degree_s, int size) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i <= degree_r; ++i) coefficients.push_back(random.polynomial(degree_s, size));
  return BivariatePolynomial(coefficients);
}

void check_invariant(const TriangularPoint& p) {
  const RationalInterval interval = p.r_interval();
  const int lower = sign_at(p.g().at_r(interval.lower), p.s());
  const int upper = sign_at(p.g().at_r(interval.upper), p.s());
  if (interval.lower == interval.upper)
    CHECK(lower == 0);
  else
    CHECK(lower * upper == -1);
  CHECK(reduced_at(p.g(), p.s()).degree_r() == p.g().degree_r());
  CHECK(gcd_at(p.g(), p.g().derivative_r(), p.s()).degree_r() <= 0);
}

void check_refinement(const TriangularPoint& p, const Rational& width) {
  const TriangularPoint fine = p.refined_to(width);
  check_invariant(fine);
  CHECK(fine.r_interval().width() <= width);
  CHECK(fine.s().interval().width() <= width);
  CHECK(fine.r_interval().lower >= p.r_interval().lower);
  CHECK(fine.r_interval().upper <= p.r_interval().upper);
  CHECK(fine.s() == p.s());
}

double middle(const TriangularPoint& p) {
  return to_double(p.refined_to(power_of_two(-60)).r_interval().midpoint());
}

}  // namespace

TEST_CASE("triangular point: preconditions are refused") {
  const RealAlgebraic two = root_two();
  CHECK_THROWS_AS(TriangularPoint(two, r - s, RationalInterval{2, 3}), std::invalid_argument);
  CHECK_THROWS_AS(TriangularPoint(two, r - s, RationalInterval{2, 1}), std::invalid_argument);
  CHECK_THROWS_AS(TriangularPoint(two, r - s, RationalInterval{1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(TriangularPoint(two, r, RationalInterval{0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(TriangularPoint(two, r - s, {1, 2}).refined_to(0), std::invalid_argument);
  CHECK_THROWS_AS(roots_at(in_s(t * t - Polynomial(2)) * t, two, 0, 1), std::domain_error);
  CHECK_THROWS_AS(roots_at(BivariatePolynomial(), two, 0, 1), std::domain_error);
  CHECK_THROWS_AS(roots_at(r - s, two, 1, 0), std::invalid_argument);
  CHECK(TriangularPoint(two, r, RationalInterval{0, 0}).r_interval().width() == 0);
}

TEST_CASE("triangular point: the true degree at s") {
  const Polynomial two = t * t - Polynomial(2), three = t * t - Polynomial(3);
  const BivariatePolynomial f = r * r * two + r - s;
  const RealAlgebraic at_two = root_two(three), at_three = QuadraticNumber{0, 1, 3}.number(two);
  CHECK(reduced_at(f, at_two).degree_r() == 1);
  CHECK(reduced_at(f, at_three).degree_r() == 2);
  CHECK(reduced_at(f, 5).at_s(0) == f.at_s(5));
  CHECK(reduced_at(in_s(two), at_two).is_zero());
  CHECK(reduced_at(in_s(two * t * t * t), root_two()).is_zero());
  CHECK(reduced_at(r * (t * t * t), root_two()).degree_s() == 1);
  CHECK(roots_at(f, at_two, -9, 9).size() == 1);
  CHECK(roots_at(f, at_three, -9, 9).size() == 2);
}

TEST_CASE("triangular point: gcd over Q(s)") {
  const Polynomial three = t * t - Polynomial(3);
  for (const RealAlgebraic& two :
       {root_two(), root_two(three), root_two(three * (t * t * t - Polynomial(5)))}) {
    const BivariatePolynomial f = (r - s) * (r - number(1));
    CHECK(gcd_at(f, (r - s) * (r + number(2)), two).degree_r() == 1);
    CHECK(gcd_at(f, (r - s) * (r + number(2)) * (r - number(1)), two).degree_r() == 2);
    // r^2 - 2 = (r - s)(r + s) at s = sqrt 2 only
    const BivariatePolynomial common = gcd_at(f, r * r - number(2), two);
    REQUIRE(common.degree_r() == 1);
    CHECK(sign_at(common.coefficient(0) + common.coefficient(1) * t, two) == 0);
    CHECK(gcd_at(f, r * r - number(3), two).degree_r() == 0);
    CHECK(gcd_at(f, f * (s + number(1)), two).degree_r() == 2);
    CHECK(gcd_at(f, f * (t * t - Polynomial(2)), two).degree_r() == 2);
    CHECK(gcd_at(BivariatePolynomial(), f, two).degree_r() == 2);
    CHECK(gcd_at(f, BivariatePolynomial(), two).degree_r() == 2);
    CHECK(gcd_at(f, s, two).degree_r() == 0);
    CHECK(gcd_at(in_s(t * t - Polynomial(2)), BivariatePolynomial(), two).is_zero());
  }
  CHECK(gcd_at((r - s) * r, (r - number(5)) * (r + s), 5).degree_r() == 1);
  CHECK(gcd_at((r - s) * r, (r - number(6)) * (r + s), 5).degree_r() == 0);
}

TEST_CASE("triangular point: roots known in advance") {
  for (const RealAlgebraic& two :
       {root_two(), root_two(t * t - Polynomial(3)), root_two(linear_factor(Rational(4, 3)))}) {
    // 0, 1/3, s - 1, s - 1 again, 1, and outside [0,1]: s, -s
    const BivariatePolynomial simple =
        r * (r * Rational(3) - number(1)) * (r - number(1)) * (r * r - number(2));
    const BivariatePolynomial line = r - s + number(1);
    const std::vector<TriangularPoint> points = roots_at(simple * line * line, two, 0, 1);
    REQUIRE(points.size() == 4);
    for (const TriangularPoint& p : points) {
      check_invariant(p);
      CHECK(p.s() == two);
      CHECK(sign_at(simple * line, p) == 0);
    }
    CHECK(points[0].r_interval().width() == 0);
    CHECK(sign_at(r, points[0]) == 0);
    CHECK(sign_at(r * Rational(3) - number(1), points[1]) == 0);
    CHECK(sign_at(line, points[2]) == 0);
    CHECK(sign_at(simple, points[2]) == 1);
    CHECK(sign_at(line, points[1]) == -1);
    CHECK(points[3].r_interval().lower == 1);
    CHECK(points[3].r_interval().upper == 1);
    for (const long bits : {3L, 64L, 100L, 1000L}) check_refinement(points[2], power_of_two(-bits));
    CHECK(roots_at(simple, two, Rational(1, 3), Rational(1, 3)).size() == 1);
    CHECK(roots_at(simple, two, Rational(1, 2), Rational(1, 2)).empty());
    CHECK(roots_at(r - r + number(7), two, 0, 1).empty());
  }
}

TEST_CASE("triangular point: fourth root of two") {
  const std::vector<TriangularPoint> points = roots_at(r * r - s, root_two(), -2, 2);
  REQUIRE(points.size() == 2);
  CHECK(middle(points[0]) == Approx(-std::pow(2, 0.25)).epsilon(1e-15));
  CHECK(middle(points[1]) == Approx(std::pow(2, 0.25)).epsilon(1e-15));
  const BivariatePolynomial fourth = r * r * r * r - number(2);
  CHECK(sign_at(fourth, points[1]) == 0);
  CHECK(sign_at(fourth + number(power_of_two(-500)), points[1]) == 1);
  CHECK(sign_at(fourth - number(power_of_two(-500)), points[1]) == -1);
  CHECK(sign_at(r * r * r - s * r + r, points[0]) == -1);
  CHECK(sign_at(r * s, points[0]) == -1);
  const Rational width = power_of_two(-1000);
  const RationalInterval fine = points[1].refined_to(width).r_interval();
  CHECK(fine.width() <= width);
  CHECK(pow(numerator(fine.lower), 4) < 2 * pow(denominator(fine.lower), 4));
  CHECK(pow(numerator(fine.upper), 4) > 2 * pow(denominator(fine.upper), 4));
}

TEST_CASE("triangular point: conjugates extremely close, and double roots") {
  const Rational tiny = Rational(1, pow(Integer(10), 60));
  const BivariatePolynomial line = r - s + number(1);
  const BivariatePolynomial close = line * line - number(tiny);
  std::vector<TriangularPoint> points = roots_at(close, root_two(), 0, 1);
  REQUIRE(points.size() == 2);
  CHECK(sign_at(line, points[0]) == -1);
  CHECK(sign_at(line, points[1]) == 1);
  for (const TriangularPoint& p : points) check_refinement(p, power_of_two(-300));
  CHECK(roots_at(line * line + number(tiny), root_two(), 0, 1).empty());
  CHECK(roots_at(line * line * (line + number(tiny)), root_two(), 0, 1).size() == 2);
  // three roots closer than the first precision
  points = roots_at(line * close, root_two(), 0, 1);
  REQUIRE(points.size() == 3);
  for (int k = 0; k < 3; ++k) CHECK(sign_at(line, points[static_cast<std::size_t>(k)]) == k - 1);
  // h and g share another root, and h is tiny here
  const TriangularPoint p(root_two(), line * (r - s), {0, 1});
  CHECK(sign_at((r - s) * (line + number(tiny)), p) == -1);
  CHECK(sign_at((r - s) * line, p) == 0);
  // a double root that is one only at sqrt 2
  points = roots_at(r * r - r * s * Rational(2) + number(2), root_two(t * t - Polynomial(3)), 0, 2);
  REQUIRE(points.size() == 1);
  CHECK(points[0].g().degree_r() == 1);
  CHECK(sign_at(r - s, points[0]) == 0);
}

TEST_CASE("triangular point: degree 16 in r") {
  BivariatePolynomial f = number(1);
  for (int k = 1; k <= 16; ++k) f = f * (r * Rational(k) - s);
  const std::vector<TriangularPoint> points = roots_at(f, root_two(), 0, 1);
  REQUIRE(points.size() == 15);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(sign_at(r * Rational(16 - static_cast<int>(i)) - s, points[i]) == 0);
    CHECK(sign_at(r * Rational(17 - static_cast<int>(i)) - s, points[i]) == 1);
  }
  // squares: the squarefree part has degree 8
  BivariatePolynomial g = number(1);
  for (int k = 1; k <= 8; ++k) g = g * (r * Rational(k) - s);
  CHECK(roots_at(g * g, root_two(), 0, 2).size() == 8);
}

TEST_CASE("triangular point: random signs in Q(sqrt 2)") {
  const std::uint64_t seed = 20250705;
  INFO("seed " << seed);
  Random random(seed);
  const QuadraticNumber two{0, 1, 2};
  for (int i = 0; i < 40; ++i) {
    // the point r = a + b s
    const Rational a = random.rational(3, 4), b = random.rational(3, 4);
    const BivariatePolynomial line = r - s * Polynomial(b) - number(a);
    const BivariatePolynomial other = random_bivariate(random, 2, 2, 3);
    const RealAlgebraic root = root_two(i % 2 == 0 ? Polynomial(1) : t * t - Polynomial(3));
    int found = 0;
    if (reduced_at(other, root).is_zero()) continue;
    for (const TriangularPoint& p : roots_at(line * other, root, -8, 8)) {
      if (sign_at(line, p) != 0) continue;
      ++found;
      const BivariatePolynomial h = random_bivariate(random, 3, 2, 3);
      // h(a + b s, s) is a polynomial in s
      Polynomial substituted;
      for (int k = h.degree_r(); k >= 0; --k)
        substituted = substituted * (t * Polynomial(b) + Polynomial(a)) + h.coefficient(k);
      const QuadraticNumber value = value_at(substituted, two);
      CHECK(sign_at(h, p) == sign_of_sum(value.a, value.b, value.c, 0, 0));
      CHECK(sign_at(h * line, p) == 0);
    }
    CHECK(found == 1);
  }
}

TEST_CASE("triangular point: all real points against the roots of the resultant") {
  const std::uint64_t seed = 20250706;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 12; ++i) {
    const Polynomial p = random.polynomial(random.integer(2, 5), 9);
    const BivariatePolynomial f = random_bivariate(random, random.integer(1, 4), 3, 9);
    if (p.degree() < 1 || f.degree_r() < 1) continue;
    // A real root r over a conjugate pair s would be a double root of the resultant.
    const Polynomial eliminant = resultant_s(in_s(p), f);
    if (squarefree_part(eliminant).degree() < eliminant.degree()) continue;
    const std::vector<RealAlgebraic> expected = real_roots(eliminant, -4, 4);
    std::vector<RealAlgebraic> found;
    for (const RealAlgebraic& root : real_roots(p, -1000, 1000))
      for (const TriangularPoint& point : roots_at(f, root, -4, 4)) {
        check_invariant(point);
        const RationalInterval interval = point.refined_to(power_of_two(-200)).r_interval();
        if (interval.lower == interval.upper)
          found.emplace_back(interval.lower);
        else
          found.push_back(RealAlgebraic::root_of(eliminant, interval));
      }
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
  }
}

TEST_CASE("triangular point: signs at one common root, at two, and next to one") {
  Random random(31);
  const RealAlgebraic cubic = real_roots(t * t * t + 3 * t - 2, 0, 1).front();
  int zeros = 0;
  for (int i = 0; i < 20; ++i) {
    INFO("case " << i);
    // Roots of f over the point: about 0.6 and 0.9 and those of a random polynomial.
    const BivariatePolynomial first = r - s, second = r - s * s - number(Rational(1, 2));
    const BivariatePolynomial f = first * second * (random_bivariate(random, 3, 2, 9) + number(100));
    const BivariatePolynomial rest = random_bivariate(random, 3, 3, 9) + number(1000);
    const BivariatePolynomial near = first - number(power_of_two(i % 2 == 0 ? -40 : -300));
    for (const TriangularPoint& p : roots_at(f, cubic, 0, 1))
      for (const auto& factors : {std::vector{first}, std::vector{first, second}, std::vector{near}}) {
        BivariatePolynomial h = rest;
        int expected = sign_at(rest, p);
        for (const BivariatePolynomial& factor : factors) {
          h = h * factor;
          expected *= sign_at(factor, p);
        }
        CHECK(sign_at(h, p) == expected);
        if (expected == 0) ++zeros;
      }
  }
  CHECK(zeros == 60);
}

TEST_CASE("triangular point: random fibres against Newton's iteration in doubles") {
  const std::uint64_t seed = 20250707;
  INFO("seed " << seed);
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const BivariatePolynomial f = random_bivariate(random, 4, 4, 50);
    for (const RealAlgebraic& root : real_roots(random.polynomial(8, 50), -2, 2)) {
      std::vector<double> c;
      for (int k = 0; k <= 4; ++k) {
        double value = 0;
        for (int j = 4; j >= 0; --j) value = value * root.to_double() + to_double(f.coefficient(k, j));
        c.push_back(value);
      }
      const auto value = [&](double x) { return (((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0]; };
      const auto slope = [&](double x) { return ((4 * c[4] * x + 3 * c[3]) * x + 2 * c[2]) * x + c[1]; };
      std::vector<double> expected;
      constexpr int steps = 4000;
      for (int k = 0; k < steps; ++k) {
        const double low = -1 + 2.0 * k / steps, high = -1 + 2.0 * (k + 1) / steps;
        if (value(low) * value(high) >= 0) continue;
        double x = (low + high) / 2;
        for (int n = 0; n < 8; ++n) x -= value(x) / slope(x);
        expected.push_back(x);
      }
      const std::vector<TriangularPoint> points = roots_at(f, root, -1, 1);
      REQUIRE(points.size() == expected.size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        CHECK(std::fabs(middle(points[k]) - expected[k]) < 1e-9);
        const double derivative = slope(expected[k]);
        CHECK(sign_at(f.derivative_r(), points[k]) == (derivative > 0 ? 1 : -1));
      }
    }
  }
}

}  // namespace exsect::triangular_point_test
