#include <exsect/geometry/integer_pull_back.h>

#include "awkward_lines.h"
#include "support/catch.h"

using namespace exsect;

namespace {

/// The patch in coordinates multiplied by scale.
BezierPatch scaled(const BezierPatch& x, const Point& scale) {
  ControlNet net = x.net();
  for (auto& row : net)
    for (Point& p : row)
      for (std::size_t k = 0; k < 3; ++k) p[k] *= scale[k];
  return BezierPatch(net);
}

bool is_power_basis_of(const IntegerNet& net, const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        if (net[i][j][k] != c[i][j][k]) return false;
  return true;
}

bool is_integral(const BivariatePolynomial& f) {
  for (int i = 0; i <= f.degree_r(); ++i)
    for (int j = 0; j <= f.degree_s(); ++j)
      if (denominator(f.coefficient(i, j)) != 1) return false;
  return true;
}

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

std::vector<Pair> test_pairs(Random& random) {
  std::vector<Pair> pairs;
  // Dyadic coordinates of very different size, coordinates all zero, and a common factor to divide out.
  ControlNet dyadic = random_net(random);
  ControlNet flat = random_net(random);
  ControlNet even = random_net(random);
  for (auto* net : {&dyadic, &flat, &even}) {
    for (auto& row : *net) {
      for (Point& p : row) {
        if (net == &dyadic) p = {from_double(0.1) * p[0], power_of_two(-300) * p[1], power_of_two(70) * p[2]};
        if (net == &flat) p[1] = 0;
        if (net == &even) p = {Rational(6 * numerator(p[0])), Rational(10 * numerator(p[1])), p[2]};
      }
    }
  }
  pairs.push_back({BezierPatch(dyadic), random_patch(random)});
  pairs.push_back({random_patch(random), BezierPatch(dyadic)});
  pairs.push_back({BezierPatch(flat), BezierPatch(flat)});
  pairs.push_back({BezierPatch(even), BezierPatch(even)});
  for (int i = 0; i < 10; ++i) {
    const BezierPatch x = random_patch(random);
    pairs.push_back({x, random_patch(random)});
  }
  return pairs;
}

}  // namespace

TEST_CASE("the integer pair is both power bases in common coordinates", "[integer_pull_back]") {
  const auto seed = 33u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : test_pairs(random)) {
    const IntegerPair pair = integer_pair(x, y);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(pair.scale[k] > 0);
      Integer content = 0;
      for (const IntegerNet* net : {&pair.first, &pair.second})
        for (const auto& row : *net)
          for (const IntegerVector& c : row) content = gcd(content, c[k]);
      CHECK(content <= 1);
    }
    CHECK(is_power_basis_of(pair.first, scaled(x, pair.scale)));
    CHECK(is_power_basis_of(pair.second, scaled(y, pair.scale)));
    CHECK(is_power_basis_of(exchanged(pair.first), scaled(x.exchanged(), pair.scale)));
  }
  const BezierPatch origin = BezierPatch(ControlNet{});
  CHECK(integer_pair(origin, origin).scale == std::array<Rational, 3>{1, 1, 1});
}

TEST_CASE("the integer pull-back is the rational one up to positive factors", "[integer_pull_back]") {
  const auto seed = 34u;
  INFO("seed " << seed);
  Random random(seed);
  for (const auto& [x, y] : test_pairs(random)) {
    const IntegerPair pair = integer_pair(x, y);
    for (const Rational& u0 :
         {Rational(0), Rational(1), Rational(3, 7), Rational(-2, 5), random_rational(random)}) {
      const IntegerLine line = line_at_first(pair.first, u0);
      const ParameterLine expected_line = line_at_first(scaled(x, pair.scale), u0);
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(Rational(line.a[j][k], line.weight) == expected_line.a[j][k]);
      const bool conic = shape(expected_line) == LineShape::conic;
      CHECK(is_conic(line) == conic);
      if (!conic) {
        CHECK_THROWS_AS(axis_pull_back(line, pair.second), std::domain_error);
        continue;
      }
      const PullBack pulled = axis_pull_back(line, pair.second);
      const PullBack expected = pull_back(axis_forms(expected_line), scaled(y, pair.scale));
      const Polynomial w2 = Rational(line.weight * line.weight);
      const Polynomial w3 = Rational(line.weight * line.weight * line.weight);
      CHECK(pulled.plane == expected.plane * w3);
      CHECK(pulled.u == expected.u * w2);
      CHECK(pulled.l == expected.l * w2);
      CHECK(pulled.m == expected.m * w2);
      for (const BivariatePolynomial* f : {&pulled.plane, &pulled.u, &pulled.l, &pulled.m})
        CHECK(is_integral(*f));
    }
  }
}
