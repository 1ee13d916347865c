// Places of double points as numbers of a field: against points that are known, of spheres in radicals and of
// heights over a quadratic map.
#include "filter/exact_place.h"

#include <cmath>

#include "filter/exact_patch.h"
#include "filter/local_forms.h"
#include "support/catch.h"
#include "support/height_pairs.h"
#include "support/random_nets.h"

namespace exsect::exact_place_test {
namespace {

using filter::ExactPatch;
using height_pairs::linear;
using height_pairs::times;
using testing::Terms;

struct Pair {
  RationalPatch x;
  RationalPatch y;
};

/// Over (1/2,1/2), where X = r² on the second patch.
Pair over_a_square_root(int sign, const Rational& moved = 0) {
  const Terms a = linear(Rational(-1, 2), 1, 0);
  const Terms b = linear(Rational(-1, 2), 0, 1);
  Terms h = a * a + times(Rational(sign, 2), b * b) + times(Rational(1, 4), a * a * a);
  h[{0, 0}] += moved;
  return {testing::power_patch({linear(0, 1, 0), linear(0, 0, 1), h}, 3),
          testing::power_patch({Terms{{{2, 0}, 1}}, linear(0, 0, 1), {}}, 2)};
}

template <class K>
std::optional<std::array<FieldNumber, 4>> found(const Pair& pair, const filter::Vec4& w) {
  return filter::exact_place<K>(filter::elevated<K>(pair.x), filter::elevated<K>(pair.y), w);
}
template <class K>
bool is_double_point(const Pair& pair, const std::array<FieldNumber, 4>& at) {
  return filter::local_forms<K>(filter::elevated<K>(pair.x), filter::elevated<K>(pair.y), at).has_value();
}

constexpr filter::Vec4 kNear = {0, 0, std::sqrt(0.5) - 0.5, 0};

template <class K>
void check_square_root() {
  for (const int sign : {1, -1}) {
    const Pair pair = over_a_square_root(sign);
    const auto at = found<K>(pair, kNear);
    REQUIRE(at);
    CHECK((*at)[0] == FieldNumber(Rational(1, 2)));
    CHECK((*at)[1] == FieldNumber(Rational(1, 2)));
    CHECK((*at)[2] * (*at)[2] == FieldNumber(Rational(1, 2)));
    CHECK((*at)[3] == FieldNumber(Rational(1, 2)));
    CHECK(is_double_point<K>(pair, *at));
    // The conjugate is one as well, exactly; a number next to it is not.
    CHECK(is_double_point<K>(pair, {(*at)[0], (*at)[1], -(*at)[2], (*at)[3]}));
    CHECK_FALSE(is_double_point<K>(pair, {(*at)[0], (*at)[1], (*at)[2] + power_of_two(-300), (*at)[3]}));
  }
}

}  // namespace

TEST_CASE("filter exact place: a square root, in all kinds that have it") {
  check_square_root<filter::Bicubic>();
  check_square_root<filter::WeightedBicubic>();
}

TEST_CASE("filter exact place: patches that are apart by less than doubles show") {
  for (const int bits : {60, 100, 140}) {
    INFO("2^-" << bits);
    CHECK_FALSE(found<filter::Bicubic>(over_a_square_root(1, power_of_two(-bits)), kNear));
    CHECK_FALSE(found<filter::Bicubic>(over_a_square_root(-1, -power_of_two(-bits)), kNear));
  }
  // Nothing that is seen at 320 bits, but no double point.
  const Pair pair = over_a_square_root(1, power_of_two(-400));
  const auto at = found<filter::Bicubic>(pair, kNear);
  CHECK_FALSE((at && is_double_point<filter::Bicubic>(pair, *at)));
}

TEST_CASE("filter exact place: projective images have the same place") {
  height_pairs::Generator generator(3);
  for (int i = 0; i < 3; ++i) {
    const auto map = random_nets::projective_map(generator);
    Pair pair = over_a_square_root(i % 2 == 0 ? 1 : -1);
    pair = {random_nets::image(pair.x, map), random_nets::image(pair.y, map)};
    const auto at = found<filter::WeightedBicubic>(pair, kNear);
    REQUIRE(at);
    CHECK((*at)[2] * (*at)[2] == FieldNumber(Rational(1, 2)));
    CHECK(is_double_point<filter::WeightedBicubic>(pair, *at));
  }
}

}  // namespace exsect::exact_place_test
