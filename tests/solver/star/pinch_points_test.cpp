#include "star/pinch_points.h"

#include "support/catch.h"
#include "support/families.h"
#include "support/random_pairs.h"

namespace exsect::pinch_points_test {

namespace {

const Rational half(1, 2);

/// sum c_ij (u - at_u)^i (v - at_v)^j.
BezierPatch around(const ControlNet& c, const Rational& at_u, const Rational& at_v) {
  const auto powers = [](const Rational& at) {  // of t - at: coefficients of t^0, t^1, t^2
    return std::array<std::array<Rational, 3>, 3>{{{1, 0, 0}, {-at, 1, 0}, {at * at, -2 * at, 1}}};
  };
  const auto u = powers(at_u);
  const auto v = powers(at_v);
  ControlNet sum{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) sum[k][l] = sum[k][l] + u[i][k] * v[j][l] * c[i][j];
  return BezierPatch::from_power_basis(sum);
}

}  // namespace

TEST_CASE("pinch points: inside, on sides, off the other patch, along a line", "[pinch]") {
  for (const bool on_side : {false, true}) {
    const ExactCase c = families::pinch_point_passed(on_side);
    const auto points = pinch_points(c.x, c.y);
    REQUIRE(points.size() == 1);
    CHECK((points[0].box()[0].lower == half && points[0].box()[0].upper == half));
    CHECK(points[0].on({Parameter::r, 0}) == on_side);
    CHECK(pinch_points(c.y, c.x).size() == 1);
    CHECK(pinch_points(c.x.exchanged(), c.y).size() == 1);
  }
  const ExactCase regular = families::crossing(families::Plane::square);
  CHECK(pinch_points(regular.x, regular.y).empty());
  ControlNet away{};  // (u, v, 1): the umbrella's pinch point is not on it
  away[0][0] = {0, 0, 1};
  away[1][0] = {1, 0, 0};
  away[0][1] = {0, 1, 0};
  CHECK(pinch_points(families::pinch_point().x, BezierPatch::from_power_basis(away)).empty());
  const ExactCase fold = families::double_cover();  // singular along u = 1/2
  CHECK(pinch_points(fold.x, fold.y).empty());
}

TEST_CASE("pinch points: random, both derivatives parallel there", "[pinch]") {
  const std::uint64_t seed = 20261;
  INFO("seed " << seed);
  std::mt19937_64 generator(seed);
  const auto number = [&] { return Rational(static_cast<int>(generator() % 9) - 4); };
  for (int i = 0; i < 20; ++i) {
    const auto place = [&] { return Rational(1 + static_cast<int>(generator() % 6), 7); };
    ControlNet x{};
    ControlNet y{};
    for (auto* net : {&x, &y})
      for (std::size_t j = 1; j < 9; ++j) (*net)[j / 3][j % 3] = {number(), number(), number()};
    x[0][1] = {1 + abs(number()), number(), number()};
    x[1][0] = Rational(i % 3 - 1) * x[0][1];
    const Rational u = place();
    const Rational v = place();
    const Rational r = place();
    const Rational s = place();
    const auto points = pinch_points(around(x, u, v), around(y, r, s));
    const auto is_here = [&](const CertifiedPoint& point) {
      const ParameterBox box = point.refined_to(power_of_two(-100)).box();
      const std::array<Rational, 4> at = {u, v, r, s};
      for (std::size_t j = 0; j < 4; ++j)
        if (at[j] < box[j].lower || box[j].upper < at[j]) return false;
      return true;
    };
    CHECK(std::any_of(points.begin(), points.end(), is_here));
  }
}

}  // namespace exsect::pinch_points_test
