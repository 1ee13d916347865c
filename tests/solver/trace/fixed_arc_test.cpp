#include "trace/fixed_arc.h"

#include "support/known_curves.h"
#include "trace/tube.h"

namespace exsect::fixed_arc_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// (u, v, u^2 - u) and its image (s, r, r^2 - r) in the plane X = Y: they meet where u = s, v = r and
/// (u - v)(u + v - 1) = 0. The first of these lines is fixed, the other one is reversed.
struct Images {
  BezierPatch x = graph({{{2, 0}, 1}, {{1, 0}, -1}});
  BezierPatch y = image();
  PairSystem<DoubleBall> system = {x, y, Point{0, 0, 0}, 0};

  static BezierPatch image() {
    ControlNet net = graph({{{2, 0}, 1}, {{1, 0}, -1}}).net();
    for (auto& row : net)
      for (Point& p : row) std::swap(p[0], p[1]);
    return BezierPatch(net);
  }
  BallPoint<DoubleBall> at(const Rational& u, const Rational& v) const {
    return ball_point<DoubleBall>({u, v, v, u});
  }
};

}  // namespace

TEST_CASE("fixed arc: of two lines the one in the plane of symmetry", "[trace]") {
  const Images images;
  const auto symmetry = exchanging_symmetry(images.x, images.y);
  REQUIRE(symmetry);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    CAPTURE(axis);
    const auto fixed = certify_tube(images.system, images.at(q(1, 5), q(1, 5)), axis, 0x1p-5, 0);
    REQUIRE(fixed);
    CHECK(is_fixed(*symmetry, *fixed));
    const auto reversed = certify_tube(images.system, images.at(q(1, 5), q(4, 5)), axis, 0x1p-5, 0);
    REQUIRE(reversed);
    CHECK_FALSE(is_fixed(*symmetry, *reversed));
  }
}

TEST_CASE("fixed arc: a trace is fixed if one of its tubes is", "[trace]") {
  const Images images;
  const auto symmetry = exchanging_symmetry(images.x, images.y);
  REQUIRE(symmetry);
  const auto tube = [&](const Rational& u, const Rational& v) {
    const auto found = certify_tube(images.system, images.at(u, v), 0, 0x1p-5, 0);
    REQUIRE(found);
    return Piece<DoubleBall>{*found, {}};
  };
  Trace<DoubleBall> trace;
  CHECK_FALSE(is_fixed(*symmetry, trace));
  trace.pieces = {tube(q(1, 5), q(4, 5))};
  CHECK_FALSE(is_fixed(*symmetry, trace));
  trace.pieces.push_back(tube(q(1, 4), q(1, 4)));
  CHECK(is_fixed(*symmetry, trace));
}

TEST_CASE("fixed arc: mirror images in z = 0 meet in fixed points alone", "[trace]") {
  HeightCoefficients mirrored = kCircle;
  for (auto& row : mirrored)
    for (Rational& c : row) c = -c;
  const BezierPatch x = graph_patch(kCircle), y = graph_patch(mirrored);
  const auto symmetry = exchanging_symmetry(x, y);
  REQUIRE(symmetry);
  const PairSystem<DoubleBall> system(x, y, Point{0, 0, 0}, 0);
  const auto tube = certify_tube(system, on_diagonal(q(7, 10), q(23, 30)), 0, 0x1p-6, 0);
  REQUIRE(tube);
  CHECK(is_fixed(*symmetry, *tube));
}

}  // namespace exsect::fixed_arc_test
