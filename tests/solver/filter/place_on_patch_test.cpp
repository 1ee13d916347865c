#include "filter/place_on_patch.h"

#include <cmath>

#include "filter/polynomial.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::place_on_patch_test {
namespace {

using namespace filter;

}  // namespace

TEST_CASE("places: the coordinates of the nearest vector of a plane", "[filter]") {
  const Vec3 p = {1, 2, 2}, q = {-1, 1, 0.5};
  for (const double off : {0.0, 3.0}) {
    // The normal p x q does not matter.
    const Vec3 v = {2 * p[0] - 0.5 * q[0] - off, 2 * p[1] - 0.5 * q[1] - 2.5 * off,
                    2 * p[2] - 0.5 * q[2] + 3 * off};
    const Place at = coordinates(p, q, v);
    CHECK(at[0] == Approx(2));
    CHECK(at[1] == Approx(-0.5));
  }
}

TEST_CASE("places: found again from nearby, also outside of the square", "[filter]") {
  random_pairs::Generator generator(20280);
  for (int round = 0; round < 20; ++round) {
    const auto p = random_pairs::doubles(generator);
    const Pair pair = make_pair(p.x, p.y).value();
    const Place place = {0.625 - 0.0625 * static_cast<double>(round % 20), 0.25};
    const Vec3 point = value_at<Biquadratic>(pair.x.power, place[0], place[1]);
    Place at = {place[0] + 0.03, place[1] - 0.02};
    REQUIRE(improve_place(pair.x, at, point));
    CHECK(at[0] == Approx(place[0]).margin(1e-10));
    CHECK(at[1] == Approx(place[1]).margin(1e-10));
    // A point beside the surface is on no place of it.
    Place beside = place;
    CHECK_FALSE(improve_place(pair.x, beside, Vec3{point[0], point[1], point[2] + 0.05}));
  }
}

}  // namespace exsect::place_on_patch_test
