#include <exsect/algebra/bernstein.h>
#include <exsect/geometry/bezier_curve.h>

#include "curve_specimens.h"
#include "support/catch.h"

namespace exsect::bezier_curve_test {

namespace {

using Points = std::vector<std::vector<Rational>>;

/// The sum of (0.1)'s kind for curves, by the Bernstein polynomials themselves.
std::vector<Rational> by_definition(const BezierCurve& curve, const Rational& t) {
  const int n = curve.degree();
  std::vector<Rational> sum(static_cast<std::size_t>(curve.dimension()), 0);
  Rational total = 0;
  for (int i = 0; i <= n; ++i) {
    Rational b = binomial(n, i);
    for (int k = 0; k < i; ++k) b *= t;
    for (int k = i; k < n; ++k) b *= 1 - t;
    b *= curve.weights()[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += b * curve.points()[static_cast<std::size_t>(i)][k];
    total += b;
  }
  for (Rational& coordinate : sum) coordinate /= total;
  return sum;
}

}  // namespace

TEST_CASE("curves that break the invariant are refused by name", "[bezier_curve]") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(BezierCurve(Points{{0, 0}}), Contains("degree must be at least 1"));
  CHECK_THROWS_WITH(BezierCurve(Points{}), Contains("degree"));
  CHECK_THROWS_WITH(BezierCurve(Points{{0}, {1}}), Contains("2 or 3 coordinates"));
  CHECK_THROWS_WITH(BezierCurve(Points{{0, 0}, {1, 0, 0}}), Contains("same number"));
  CHECK_THROWS_WITH(BezierCurve({{0, 0}, {1, 0}}, {1}), Contains("as many weights"));
  CHECK_THROWS_WITH(BezierCurve({{0, 0}, {1, 0}}, {1, 0}), Contains("must be > 0"));
}

TEST_CASE("curves with equal points or common factors", "[bezier_curve]") {
  CHECK(BezierCurve({{1, 2}, {1, 2}}, {1, 3}).is_point());
  CHECK_FALSE(profile_cubic().is_point());
  CHECK(profile_cubic().is_polynomial());
  CHECK(homogeneous(BezierCurve({{0, 0}, {1, 1}}, {2, 2})).denominator == Polynomial(1));
  // The segment of degree 2 with weights 1, 3/2, 2 is the segment of degree 1 times 1 + t.
  const BezierCurve raised({{0, 0}, {Rational(1, 3), 0}, {1, 0}}, {1, Rational(3, 2), 2});
  const HomogeneousCurve reduced = homogeneous(raised);
  CHECK(reduced.degree() == 1);
  CHECK(reduced.denominator == Polynomial(1));
  CHECK(reduced.numerators[0] == Polynomial::variable());
  const HomogeneousCurve circle = homogeneous(quarter_circle());
  CHECK(circle.denominator == Polynomial{1, 0, 1});
  CHECK(circle.numerators[0] == Polynomial{1, 0, -1});
  CHECK(circle.numerators[1] == Polynomial{0, 2});
}

TEST_CASE("values are those of the definition", "[bezier_curve]") {
  const auto seed = 51u;
  INFO("seed " << seed);
  Random random(seed);
  for (int round = 0; round < 12; ++round) {
    const BezierCurve curve = random_curve(random, 1 + round % 6, 2 + round % 2, round % 3 != 0);
    for (const Rational& t : {Rational(0), Rational(1), Rational(2, 7)}) {
      CHECK(curve(t) == by_definition(curve, t));
      CHECK(curve.reversed()(1 - t) == curve(t));
      const std::vector<Rational> value = curve(t);
      CHECK(curve.projected(1, 0)(t) == std::vector<Rational>{value[1], value[0]});
    }
    CHECK(homogeneous(curve).denominator(Rational(1, 2)) > 0);
  }
  CHECK_THROWS_AS(profile_cubic().projected(0, 2), std::invalid_argument);
}

}  // namespace exsect::bezier_curve_test
