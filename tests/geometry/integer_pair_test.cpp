#include <exsect/geometry/integer_pair.h>
#include <exsect/geometry/parameter_line.h>

#include "random_shapes.h"
#include "support/catch.h"

namespace exsect::integer_pair_test {

namespace {

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

/// Dyadic coordinates of very different size, a coordinate that is constant, one with a common factor,
/// straight and collapsed lines; then random pairs.
std::vector<Pair> test_pairs(Random& random) {
  ControlNet dyadic = random_net(random);
  ControlNet flat = random_net(random);
  ControlNet even = random_net(random);
  ControlNet straight = random_net(random);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Point& p = dyadic[i][j];
      p = {from_double(0.1) * p[0], power_of_two(-300) * p[1], power_of_two(70) * p[2]};
      flat[i][j][1] = Rational(2, 3);
      even[i][j][0] = 6 * numerator(even[i][j][0]);
    }
    straight[i][1] = Rational(1, 2) * (straight[i][0] + straight[i][2]);
    straight[0][i] = {1, 2, 3};
  }
  std::vector<Pair> pairs = {{BezierPatch(dyadic), random_patch(random)},
                             {random_patch(random), BezierPatch(dyadic)},
                             {BezierPatch(flat), BezierPatch(flat)},
                             {BezierPatch(even), BezierPatch(even)},
                             {BezierPatch(straight), random_patch(random)}};
  while (pairs.size() < 15) {
    const BezierPatch x = random_patch(random);
    pairs.push_back({x, random_patch(random)});
  }
  return pairs;
}

/// net = scale (c - origin) in coordinate k.
bool is_image(const IntegerNet& net, const ControlNet& c, std::size_t k, const Rational& origin,
              const Rational& scale) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (net[i][j][k] != scale * (i + j == 0 ? c[i][j][k] - origin : c[i][j][k])) return false;
  return true;
}

}  // namespace

TEST_CASE("the integer pair is a scaled translate without common factors", "[integer_pair]") {
  const auto seed = 33u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : test_pairs(random)) {
    const IntegerPair pair = integer_pair(x, y);
    const ControlNet cx = x.power_basis();
    const ControlNet cy = y.power_basis();
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(pair.x[0][0][k] == 0);
      // The scale, read off any coefficient that is not zero.
      Rational scale = 1;
      Integer content = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          content = gcd(content, gcd(pair.x[i][j][k], pair.y[i][j][k]));
          if (i + j > 0 && !cx[i][j][k].is_zero()) scale = pair.x[i][j][k] / cx[i][j][k];
        }
      }
      CHECK(content <= 1);
      CHECK(scale > 0);
      CHECK(is_image(pair.x, cx, k, cx[0][0][k], scale));
      CHECK(is_image(pair.y, cy, k, cx[0][0][k], scale));
    }
  }
  const BezierPatch origin = BezierPatch(ControlNet{});
  CHECK(integer_pair(origin, origin).y[2][2] == IntegerVector{0, 0, 0});
}

TEST_CASE("integer lines are the parameter lines of the scaled patch", "[integer_pair]") {
  const auto seed = 34u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : test_pairs(random)) {
    const IntegerPair pair = integer_pair(x, y);
    ControlNet c;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) c[i][j][k] = pair.x[i][j][k];
    const BezierPatch scaled = BezierPatch::from_power_basis(c);
    for (const Rational& fixed :
         {Rational(0), Rational(1), Rational(3, 7), Rational(-2, 5), random_rational(random)}) {
      const auto check = [](const IntegerLine& line, const ParameterLine& expected) {
        CHECK(line.weight > 0);
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k) CHECK(Rational(line.a[j][k], line.weight) == expected.a[j][k]);
        CHECK(is_conic(line) == (shape(expected) == LineShape::conic));
      };
      check(line_at_first(pair.x, fixed), line_at_first(scaled, fixed));
      check(line_at_first(exchanged(pair.x), fixed), line_at_second(scaled, fixed));
    }
  }
}

}  // namespace exsect::integer_pair_test
