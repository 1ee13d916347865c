#include "filter/curve_series.h"

#include <cmath>

#include "support/catch.h"
#include "support/power_nets.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"

namespace exsect::curve_series_test {
namespace {

using namespace filter;  // NOLINT(google-build-using-namespace): kinds
using testing::Terms;

const std::array<FieldNumber, 4> kOrigin = {0, 0, 0, 0};

struct Pair {
  RationalPatch x, y;
};

/// (u, v, 0) and (r, a r s + b s^2, s - r^3): v = a u^4 + b u^6, r = u, s = u^3.
Pair power_curve(const Rational& a, const Rational& b) {
  const Terms r = {{{1, 0}, 1}}, s = {{{0, 1}, 1}};
  return {testing::power_patch({r, s, Terms{}}, 3),
          testing::power_patch({r, Terms{{{1, 1}, a}, {{0, 2}, b}}, Terms{{{0, 1}, 1}, {{3, 0}, -1}}}, 3)};
}

template <class K>
std::optional<CurveSeries> series_of(const Pair& pair, std::size_t axis) {
  return CurveSeries::about<K>(elevated<K>(pair.x), elevated<K>(pair.y), kOrigin, axis);
}

/// The series of such curves, and of their images under maps of space.
template <class K>
void check_orders(std::uint64_t seed) {
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 8; ++round) {
    const Rational a(random_pairs::integer(generator, -1, 1), 3);
    const Rational b(random_pairs::integer(generator, 1, 9), 4);
    Pair pair = power_curve(a, b);
    if (K::weighted) {
      const auto map = random_nets::projective_map(generator);
      pair = {random_nets::image(pair.x, map), random_nets::image(pair.y, map)};
    }
    for (const std::size_t axis : {0, 2}) {
      const auto series = series_of<K>(pair, axis);
      REQUIRE(series);
      const std::size_t expected = a == 0 ? 6 : 4;
      CHECK(series->order(0) == 1);
      CHECK(series->order(1) == expected);
      CHECK(series->order(2) == 1);
      CHECK(series->order(3) == 3);
      const std::array<double, 4> room = {0x1p-9, 0x1p-9, 0x1p-9, 0x1p-9};
      CHECK(series->sign_beside(room, 0x1p-10, 1) == (a < 0 ? -1 : 1));
      CHECK(series->sign_beside(room, 0x1p-10, 3) == 1);
    }
    CHECK_FALSE(series_of<K>(pair, 1));
    CHECK_FALSE(series_of<K>(pair, 3));
  }
}

}  // namespace

TEST_CASE("curve series: orders and signs of curves that are known, of every kind", "[filter]") {
  check_orders<Bicubic>(41201);
  check_orders<WeightedBicubic>(41202);
}

TEST_CASE("curve series: about an irrational point", "[filter]") {
  // (u, v, 0) and (r, r^2 s - s/2, s - r^2 + 1/2) meet in r = 1/√2, s = p, v = p s = p^2, p = r^2 - 1/2: with
  // u = r = 1/√2 + τ, p = √2 τ + τ².
  const Rational half(1, 2);
  const RationalPatch x = testing::power_patch({Terms{{{1, 0}, 1}}, Terms{{{0, 1}, 1}}, Terms{}}, 3);
  const RationalPatch y = testing::power_patch({Terms{{{1, 0}, 1}}, Terms{{{2, 1}, 1}, {{0, 1}, -half}},
                                                Terms{{{0, 1}, 1}, {{2, 0}, -1}, {{0, 0}, half}}},
                                               3);
  const RealField field(real_roots(Polynomial{-1, 0, 2}, 0, 1).front());
  const FieldNumber at(field, Polynomial{0, 1});
  const auto series =
      CurveSeries::about<Bicubic>(elevated<Bicubic>(x), elevated<Bicubic>(y), {at, 0, at, 0}, 0);
  REQUIRE(series);
  CHECK(series->order(0) == 1);
  CHECK(series->order(1) == 2);
  CHECK(series->order(2) == 1);
  CHECK(series->order(3) == 1);
  const std::array<double, 4> room = {0x1p-7, 0x1p-7, 0x1p-7, 0x1p-7};
  CHECK(series->sign_beside(room, 0x1p-9, 1) == 1);
  CHECK(series->sign_beside(room, 0x1p-9, 3) == 1);
}

TEST_CASE("curve series: no sign beyond a turning point", "[filter]") {
  // v = u^4 - b u^6 turns at u^2 = 2/(3 b).
  for (const int bits : {4, 6, 8}) {
    const Rational b = Rational(2, 3) * power_of_two(2 * bits);
    const auto series = series_of<Bicubic>(power_curve(1, -b), 0);
    REQUIRE(series);
    bool has_sign = false;
    for (int k = 1; k < 30; ++k) {
      const double reach = std::ldexp(1.0, -k);
      const int sign =
          series->sign_beside({2 * reach, 2 * reach, 2 * reach, 4 * reach * reach * reach}, reach, 1);
      CHECK((sign == 0 || (sign == 1 && k > bits)));
      has_sign = has_sign || sign != 0;
    }
    CHECK(has_sign);
  }
}

TEST_CASE("curve series: nothing where terms leave the box, or none is found", "[filter]") {
  const auto series = series_of<Bicubic>(power_curve(1, 0), 0);
  REQUIRE(series);
  CHECK(series->sign_beside({0x1p-10, 0x1p-9, 0x1p-9, 0x1p-9}, 0x1p-8, 1) == 0);
  // v = 0 all along.
  const auto on_side = series_of<Bicubic>(power_curve(0, 0), 0);
  REQUIRE(on_side);
  CHECK(on_side->order(1) == 0);
  CHECK(on_side->sign_beside({0x1p-9, 0x1p-9, 0x1p-9, 0x1p-9}, 0x1p-10, 1) == 0);
}

}  // namespace exsect::curve_series_test
