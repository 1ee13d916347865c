#include "filter/injectivity.h"

#include <cmath>

#include "support/catch.h"
#include "support/graph_patches.h"
#include "support/random_pairs.h"

namespace exsect::injectivity_test {
namespace {

using namespace exsect::filter;

double in(random_pairs::Generator& generator, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(random_pairs::integer(generator, 0, 64)) / 64;
}

}  // namespace

TEST_CASE("injectivity: a folded patch is injective on either side of the fold alone", "[filter]") {
  // ((u - 1/2)^2, v, u/8): the plane's points come in pairs but for the height, which is small.
  ControlNet power{};
  power[2][0] = {1, 0, 0};
  power[1][0] = {-1, 0, 0};
  power[0][1] = {0, 1, 0};
  const BezierPatch fold = BezierPatch::from_power_basis(power);
  const Pair pair = make_pair(fold, testing::plane_patch()).value();
  const double error = 2 * pair.total_error;
  CHECK_FALSE(is_injective<Biquadratic>(pair.x, error, {{-0.5, -0.5}, {0.5, 0.5}}));
  CHECK_FALSE(is_injective<Biquadratic>(pair.x, error, {{-0.125, -0.5}, {0.0625, 0.5}}));
  CHECK(is_injective<Biquadratic>(pair.x, error, {{-0.5, -0.5}, {-0.125, 0.5}}));
  CHECK(is_injective<Biquadratic>(pair.x, error, {{0.125, -0.5}, {0.5, 0.5}}));
  // A flat graph over its square is, all of it; no bound of the error, no proof.
  CHECK(is_injective<Biquadratic>(pair.y, error, {{-0.5, -0.5}, {0.5, 0.5}}));
  CHECK_FALSE(is_injective<Biquadratic>(pair.y, std::nan(""), {{-0.5, -0.5}, {0.5, 0.5}}));
}

TEST_CASE("injectivity: never where two points of the rectangle have one value", "[filter]") {
  // x and y of a random map of the plane that takes one value at two given places.
  const unsigned seed = 9;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  int proved = 0;
  for (int round = 0; round < 100; ++round) {
    BezierPatch x = random_pairs::scattered(generator).x;
    const std::array<double, 2> p = {in(generator, -0.5, 0.5), in(generator, -0.5, 0.5)},
                                q = {in(generator, -0.5, 0.5), in(generator, -0.5, 0.5)};
    if (p[0] == q[0]) continue;
    const auto at = [&](const std::array<double, 2>& w) {
      return x(from_double(w[0]) + Rational(1, 2), from_double(w[1]) + Rational(1, 2));
    };
    // Minus the difference times (u - p)/(q - p).
    const Point slope = Rational(1 / (from_double(q[0]) - from_double(p[0]))) * (at(q) - at(p));
    ControlNet net = x.net();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) net[i][j] = net[i][j] - Rational(static_cast<int>(i), 2) * slope;
    x = BezierPatch(net);
    REQUIRE(at(p) == at(q));
    const Pair pair = make_pair(x, testing::plane_patch()).value();
    const filter::Rectangle around = {{std::min(p[0], q[0]), std::min(p[1], q[1])},
                                      {std::max(p[0], q[0]), std::max(p[1], q[1])}};
    CHECK_FALSE(is_injective<Biquadratic>(pair.x, 2 * pair.total_error, around));
    const double small = 0x1p-6;
    proved += is_injective<Biquadratic>(pair.x, 2 * pair.total_error,
                                        {p, {std::min(p[0] + small, 0.5), std::min(p[1] + small, 0.5)}})
                  ? 1
                  : 0;
  }
  CHECK(proved > 50);
}

}  // namespace exsect::injectivity_test
