// Landmarks of curves whose turning points are known.
#include "lift/crossing_landmarks.h"

#include <algorithm>

#include "support/catch.h"

namespace exsect::crossing_landmarks_test {
namespace {

const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1),
                      z = SpacePolynomial::variable(2);
SpacePolynomial number(const Rational& c) { return SpacePolynomial::constant(c); }

CrossingLandmarks landmarks(const SpacePolynomial& f, const SpacePolynomial& g, int attempt = 0) {
  const auto projection = space_projection(f, g, general_frame(attempt));
  REQUIRE(projection);
  const auto branches = crossing_branches(f, g, *projection);
  REQUIRE(branches);
  return crossing_landmarks(*branches, {}, [](double extent) { return 1e-3 * extent; });
}

long count(const CrossingLandmarks& known, LandmarkKind kind) {
  return std::ranges::count(known.landmarks, kind, &CrossingLandmark::kind);
}

}  // namespace

TEST_CASE("crossing landmarks: a circle has a lowest and a highest point") {
  const SpacePolynomial ball = x * x + y * y + z * z - number(9), plane = x + Rational(2) * y - z;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const CrossingLandmarks known = landmarks(ball, plane, attempt);
    CHECK(known.obstacle.empty());
    REQUIRE(known.landmarks.size() == 2);
    CHECK(count(known, LandmarkKind::lowest) == 1);
    CHECK(count(known, LandmarkKind::highest) == 1);
    // They are opposite to each other, orthogonal to the direction of u within the plane.
    const Point sum = known.landmarks[0].zero.centre + known.landmarks[1].zero.centre;
    for (const Rational& c : sum) CHECK(abs(c) < power_of_two(-60));
    const Point p = known.landmarks[0].zero.centre, across = cross({1, 2, -1}, general_frame(attempt).height);
    CHECK(abs(dot(p, across)) < power_of_two(-60));
    CHECK(abs(dot(p, p) - 9) < power_of_two(-60));
  }
}

TEST_CASE("crossing landmarks: curves that go on, and components that are told apart") {
  const SpacePolynomial tube = x * x + y * y - number(1);
  const CrossingLandmarks rulings = landmarks(tube, x - Rational(1, 2) * y);
  CHECK(rulings.obstacle.empty());
  CHECK(count(rulings, LandmarkKind::entry) == 2);
  CHECK(count(rulings, LandmarkKind::exit) == 2);
  for (const CrossingLandmark& landmark : rulings.landmarks) {
    CHECK(landmark.upward != 0);
    CHECK(!landmark.star);
  }
  // Two circles in the planes z = 1 and z = 2 are two factors.
  const CrossingLandmarks circles = landmarks(tube, (z - number(1)) * (z - number(2)));
  CHECK(circles.obstacle.empty());
  REQUIRE(circles.landmarks.size() == 4);
  for (const CrossingLandmark& a : circles.landmarks)
    for (const CrossingLandmark& b : circles.landmarks)
      CHECK((a.branch == b.branch) == (abs(a.zero.centre[2] - b.zero.centre[2]) < Rational(1, 2)));
}

TEST_CASE("crossing landmarks: stars, and what a frame does not show") {
  const SpacePolynomial tube = x * x + y * y - number(1), across = z * z + y * y - number(1);
  const CrossingLandmarks known = landmarks(tube, across);
  CHECK(known.obstacle.empty());
  CHECK(known.stars.size() == 2);
  CHECK(std::ranges::count_if(known.landmarks, [](const auto& each) { return each.star.has_value(); }) == 8);
  // A frame along the plane x = -z of an ellipse, whose shadow is a line then, doubled.
  const SpaceFrame along = {{Point{-1, 0, 0}, Point{0, 1, 1}, Point{-1, 2, 1}}, {-1, -1, 1}};
  const auto projection = space_projection(tube, across, along);
  REQUIRE(projection);
  CHECK(turning_norm(*projection).is_zero());
  CHECK(!crossing_branches(tube, across, *projection));
  // Two cones with one apex.
  const CrossingLandmarks cones =
      landmarks(x * x + y * y - z * z, x * x + Rational(3) * z * z - Rational(5) * y * y);
  CHECK(!cones.obstacle.empty());
}

TEST_CASE("crossing landmarks: a ball that is wider than its bore by little") {
  // (x - e)^2 + y^2 + z^2 = (1 + e)^2 touches the cylinder in (-1,0,0) from outside, and crosses it about the
  // height z = +-sqrt(4e) at x = 1: landmarks lie where gradients are parallel but for a part e.
  for (const unsigned bits : {10U, 30U, 45U}) {
    INFO("2^-" << bits);
    const Rational e = 1 / Rational(pow(Integer(2), bits));
    const SpacePolynomial ball = x * x + y * y + z * z - Rational(2 * e) * x - number(1 + 2 * e);
    const CrossingLandmarks known = landmarks(x * x + y * y - number(1), ball);
    CHECK(known.obstacle.empty());
    CHECK(known.stars.size() == 1);
  }
}

}  // namespace exsect::crossing_landmarks_test
