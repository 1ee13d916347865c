#include "sweep/search_window.h"

#include <cmath>
#include <random>

#include "support/known_curves.h"
#include "swept_pair.h"

namespace exsect::search_window_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

}  // namespace

TEST_CASE("search window: boxes and points of the slab, the others as they are") {
  for (const Parameter across : all_parameters) {
    const SearchWindow window = {across, {q(1, 3), q(1, 2)}};
    const SearchRegion seen = {{0, 0.25, 0.5, 0.125}, {0.25, 0.5, 1, 0.375}};
    const ParameterBox box = window.box(seen);
    const BallPoint<ArbBall<256>> point =
        window.point<ArbBall<256>>(ball_point<ArbBall<256>>({q(1, 4), q(1, 4), q(1, 4), q(1, 4)}));
    for (const Parameter p : all_parameters) {
      const std::size_t j = index(p);
      const Rational lower = from_double(seen.lower[j]), upper = from_double(seen.upper[j]);
      const bool in_slab = p == across;
      CHECK(box[j].lower == (in_slab ? q(1, 3) + lower / 6 : lower));
      CHECK(box[j].upper == (in_slab ? q(1, 3) + upper / 6 : upper));
      CHECK(encloses(point[j], in_slab ? q(1, 3) + q(1, 24) : q(1, 4)));
    }
    // c.(u', v') is the same form in the slab's parameters, of which u' or v' is a sixth.
    const std::array<double, 2> c = window.direction({6, 12});
    CHECK(c[0] == Approx(across == Parameter::u ? 1 : 6));
    CHECK(c[1] == Approx(across == Parameter::v ? 2 : 12));
  }
}

TEST_CASE("search window: around a turning value, far from what is over others") {
  // The circle turns over 1/6 and 5/6 in u and v; no point is on a side.
  SweptPair circle(graph_patch(kCircle), plane_patch());
  for (const TurningValue& turning : circle.data.turning->values) {
    const SearchWindow window = window_around(circle.data, turning.value);
    CHECK(window.across == circle.data.turning->sweep);
    CHECK(turning.value.compare(window.range.lower) > 0);
    CHECK(turning.value.compare(window.range.upper) < 0);
    CHECK(window.range.width() <= power_of_two(-23));
  }
  // Near a second turning value the window is narrower than their distance by the factor 32.
  SweepData& data = circle.data;
  const Rational e = power_of_two(-40);
  data.turning->values = {{RealAlgebraic(q(1, 2)), 2}, {RealAlgebraic(q(1, 2) + e), 1}};
  CHECK(window_around(data, data.turning->values[0].value).range.width() <= e / 32);
}

TEST_CASE("search window: boxes rounded outwards to doubles, and no further") {
  const unsigned seed = 5;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> any(0, 1000000);
  for (int round = 0; round < 200; ++round) {
    ParameterBox box;
    for (RationalInterval& side : box) {
      const Rational a(any(generator), 1000003), b(any(generator), 1000003);
      side = {std::min(a, b), std::max(a, b)};
    }
    const SearchRegion region = rounded_outwards(box);
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(from_double(region.lower[j]) <= box[j].lower);
      CHECK(from_double(std::nextafter(region.lower[j], 2.0)) > box[j].lower);
      CHECK(from_double(region.upper[j]) >= box[j].upper);
      CHECK(from_double(std::nextafter(region.upper[j], -1.0)) < box[j].upper);
    }
  }
}

}  // namespace exsect::search_window_test
