// Landmarks of curves on round surfaces whose turning points are known.
#include "filter/round_landmarks.h"

#include <algorithm>
#include <cmath>

#include "support/catch.h"

namespace exsect::round_landmarks_test {
namespace {

using S = ImplicitSurface;
const Point up = {0, 0, 1};

std::optional<std::vector<RoundBox>> landmarks(const S& first, const S& second) {
  const auto chart = RoundChart::of(first, second);
  REQUIRE(chart);
  return round_landmarks(*chart);
}

}  // namespace

TEST_CASE("round landmarks: the turning points of a cylinder on a cylinder") {
  const S wide = S::cylinder({0, 0, 0}, up, 2), narrow = S::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  // On the wide one, z = +-1 at y = 0, x = +-2; z = 0 is a turning point of none.
  const auto chart = RoundChart::of(wide, narrow).value();
  const auto found = round_landmarks(chart).value();
  CHECK(found.size() == 4);
  for (const RoundBox& box : found) {
    const auto p = chart.position(box);
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = std::fabs(p[k].approximation()), expected = k == 0 ? 2 : k == 1 ? 0 : 1;
      CHECK(std::fabs(at - expected) <= p[k].radius() + 1e-15);
    }
    CHECK(std::max(box.reach[0], box.reach[1]) < 1e-11);
  }
  // Along the narrow one's x = +-sqrt(4 - y^2) turn at y = 0, z = +-1 and at y = +-1, z = 0.
  CHECK(round_landmarks(RoundChart::of(narrow, wide).value()).value().size() == 8);
}

TEST_CASE("round landmarks: none without common points, also at small distances") {
  for (const Rational& gap : {Rational(1), Rational(1, 1000), Rational(1, 1000000)}) {
    CHECK(landmarks(S::cylinder({0, 0, 0}, up, 1), S::cylinder({2 + gap, 0, 0}, {0, 1, 0}, 1))->empty());
    CHECK(landmarks(S::torus({0, 0, 0}, up, 2, 1), S::sphere({4 + gap, 0, 0}, 1))->empty());
  }
}

TEST_CASE("round landmarks: contact, crossings and circles are not decided") {
  CHECK_FALSE(landmarks(S::cylinder({0, 0, 0}, up, 1), S::cylinder({2, 0, 0}, {0, 1, 0}, 1)));
  CHECK_FALSE(landmarks(S::cylinder({0, 0, 0}, up, 1), S::cylinder({0, 0, 0}, {0, 1, 0}, 1)));
  CHECK_FALSE(landmarks(S::torus({0, 0, 0}, up, 2, 1), S::sphere({0, 0, 0}, 2)));
  CHECK_FALSE(landmarks(S::torus({0, 0, 0}, up, 2, 1),
                        S::sphere({4 + Rational(1, Integer("1000000000000000000")), 0, 0}, 1)));
}

TEST_CASE("round landmarks: a curve around a torus without turning points, and nappes") {
  // A cylinder about another axis through the hole meets each circle about the torus's axis.
  const auto around = landmarks(S::torus({0, 0, 0}, up, 4, 1),
                                S::plane({Rational(1, 7), 0, 0}, {1, Rational(1, 3), Rational(1, 50)}));
  REQUIRE(around);
  CHECK(around->size() >= 4);
  const S sphere = S::sphere({0, Rational(1, 2), 3}, 1);
  CHECK(landmarks(S::cone({0, 0, 0}, up, Rational(1, 3)), sphere)->size() >= 2);
  CHECK(landmarks(S::cone({0, 0, 0}, {0, 0, -1}, Rational(1, 3)), sphere)->empty());
}

TEST_CASE("round landmarks: curves that are circles about the axis but for 10^-8 to 10^-16") {
  Rational tilt = 1;
  for (int digits = 1; digits <= 16; ++digits) {
    tilt /= 10;
    if (digits < 8) continue;
    // An inner and an outer curve, with two turning points each, at y = 0.
    const auto found =
        landmarks(S::torus({0, 0, 0}, up, 3, 1), S::plane({0, 0, Rational(1, 3)}, {tilt, 0, 1}));
    REQUIRE(found);
    CHECK(found->size() == 4);
    for (const RoundBox& box : *found) CHECK(std::max(box.reach[0], box.reach[1]) < 0x1p-40);
  }
}

}  // namespace exsect::round_landmarks_test
