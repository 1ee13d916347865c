// Quadratic maps of [0,1] onto itself: their inverses, and the parameters they do not tell apart.
#include "special/unit_map.h"

#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::unit_map_test {
namespace {

Rational mapped(const UnitMap& map, const Rational& p) {
  const Rational a = (1 - p) * (1 + map.start * p), b = p * (1 + map.end * (1 - p));
  return b / (a + b);
}

std::vector<UnitMap> maps() {
  std::vector<UnitMap> result = {{0, 0}, {-1, 0}, {0, -1}, {-1, -1}, {3, Rational(-1, 2)}, {50, 7}};
  random_nets::Generator generator(5);
  for (int i = 0; i < 10; ++i)
    result.push_back({Rational(static_cast<int>(generator() % 40), 7) - 1,
                      Rational(static_cast<int>(generator() % 40), 7) - 1});
  return result;
}

}  // namespace

TEST_CASE("unit map: the inverse of increasing maps of the interval onto itself") {
  for (const UnitMap& map : maps()) {
    INFO("start " << map.start << ", end " << map.end);
    CHECK(mapped(map, 0) == 0);
    CHECK(mapped(map, 1) == 1);
    for (int i = 0; i <= 12; ++i) {
      const Rational p(i, 12), w = mapped(map, p);
      if (i > 0) CHECK(mapped(map, Rational(i - 1, 12)) < w);
      const RationalInterval at = preimage(map, {w, w}, 100);
      CHECK((at.lower <= p && p <= at.upper));
      CHECK(at.upper - at.lower <= power_of_two(-99));
      CHECK(std::abs(approximate_preimage(map, to_double(w)) - i / 12.0) < 1e-6);
    }
  }
}

TEST_CASE("unit map: the other parameter with the same value") {
  for (const UnitMap& map : maps()) {
    const auto [k0, k1, k2, k3] = conjugation(map);
    INFO("start " << map.start << ", end " << map.end);
    for (int i = 0; i <= 12; ++i) {
      const Rational p(i, 12), under = k2 + k3 * p;
      if (map.is_identity()) {
        CHECK(under == 0);
        continue;
      }
      if (under == 0) continue;
      const Rational q = (k0 + k1 * p) / under;
      const Rational a = (1 - q) * (1 + map.start * q), b = q * (1 + map.end * (1 - q));
      CHECK(b * (1 - mapped(map, p)) == a * mapped(map, p));
      if (k0 * k3 != k1 * k2) CHECK(k0 + k1 * q == p * (k2 + k3 * q));
    }
  }
}

TEST_CASE("unit map: patches at the other parameter") {
  random_nets::Generator generator(3);
  const RationalPatch y =
      random_nets::weighted(generator, random_nets::crossing(generator, {3, 2, 1, 1}, false).x);
  const UnitMap map{3, Rational(-1, 2)};
  const Conjugation other = conjugation(map);
  const VectorPolynomial at = at_conjugate(other, components(y));
  for (int i = 0; i <= 4; ++i) {
    const Rational p(i, 4), s(2, 7), under = other[2] + other[3] * p;
    const HomogeneousPoint x = y.homogeneous_at((other[0] + other[1] * p) / under, s);
    for (std::size_t k = 0; k < 4; ++k) CHECK(at[k](p, s) == under * under * under * x[k]);
  }
}

}  // namespace exsect::unit_map_test
