#include "filter/tube_newton.h"

#include <cmath>

#include "known_curve.h"

namespace exsect::tube_newton_test {
namespace {

using testing::KnownCurve;
using namespace filter;  // NOLINT(google-build-using-namespace): kinds and vectors

}  // namespace

TEST_CASE("filter newton: F, its columns and the tangent on the hyperbola", "[filter]") {
  const KnownCurve curve(testing::kHyperbola);
  for (const double u : {0.3, 0.5, 0.9}) {
    const double v = 1 / (4 * u);
    const auto here = linearise<Biquadratic>(curve.pair, KnownCurve::centred(u, v));
    CHECK(largest(here.value) < 1e-14);
    // The tangent is a multiple of (1, v', r', s'), v' = -1/(4 u^2), r = (4 u + 1)/6.
    const double slope = -1 / (4 * u * u);
    CHECK(here.tangent[1] / here.tangent[0] == Approx(slope));
    CHECK(here.tangent[2] / here.tangent[0] == Approx(2.0 / 3));
    CHECK(here.tangent[3] / here.tangent[0] == Approx(2.0 / 3 * slope));
    Vec3 along = {0, 0, 0};
    for (std::size_t j = 0; j < 4; ++j) along = along + here.tangent[j] * here.column[j];
    CHECK(largest(along) < 1e-14);
  }
}

TEST_CASE("filter newton: quadratic convergence from beside the curve, with the axis kept", "[filter]") {
  const KnownCurve curve(testing::kHyperbola);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const Vec4 on_it = KnownCurve::centred(0.4, 0.625);
    Vec4 at = on_it;
    for (std::size_t j = 0; j < 4; ++j)
      if (j != axis) at[j] += 0.01 * (j % 2 == 0 ? 1 : -1);
    const double kept = at[axis];
    REQUIRE(improve<Biquadratic>(curve.pair, at, axis, 6));
    CHECK(at[axis] == kept);
    for (std::size_t j = 0; j < 4; ++j) CHECK(at[j] == Approx(on_it[j]).margin(1e-12));
  }
  Vec4 away = {-0.74, 0.5, 0.5, 0.5};  // v = 1/(4u) is negative there
  CHECK_FALSE(improve<Biquadratic>(curve.pair, away, 0, 20));
}

TEST_CASE("filter newton: the steepest component, each by its weight", "[filter]") {
  CHECK(steepest({1, -4, 2, 3}) == 1);
  CHECK(steepest({1, -4, 2, 3}, {0.125, 1, 1, 1}) == 0);
  CHECK(steepest({0, 0, 0, -1}) == 3);
}

TEST_CASE("filter newton: the scale of weighted patches is the quotient of their weights", "[filter]") {
  // The same point written with the weights 2 and 3 on y: x_4 = kScaleUnit w y_4.
  const auto with_weights = [](const BezierPatch& patch, const Rational& weight) {
    ElevatedPatch<WeightedBiquadratic> result;
    using exsect::operator*;
    for (std::size_t k = 0; k < 9; ++k) {
      result.points[k] = weight * control_point(patch, k);
      result.weights[k] = weight;
    }
    return result;
  };
  const BezierPatch x = testing::graph_patch(testing::kHyperbola), y = testing::larger_plane();
  const Vec4 place = KnownCurve::centred(0.5, 0.5);
  const auto pair = make_pair_of<WeightedBiquadratic>(with_weights(x, 1), with_weights(y, testing::q(1, 2)));
  REQUIRE(pair);
  const auto at = with_scale(*pair, place);
  for (std::size_t j = 0; j < 4; ++j) CHECK(at[j] == place[j]);
  CHECK(kScaleUnit * at[4] == Approx(2));
}

}  // namespace exsect::tube_newton_test
