// Where plane curves cross the sides of the square and turn: circles and lines, and counted by the exact
// graph.
#include "filter/section_landmarks.h"

#include <exsect/solver/surface_curve.h>

#include <algorithm>
#include <cmath>

#include "curve/turning_in_v.h"
#include "square_section.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::section_landmarks_test {
namespace {

using S = ImplicitSurface;
using square_section::circle, square_section::form_of, square_section::square;

std::optional<std::vector<SectionLandmark>> found(const SquareForm& f, bool with_second = true) {
  return section_landmarks(f, with_second, {});
}

/// The only landmark of this kind whose box holds the point, to within what doubles round.
bool has_one(const std::vector<SectionLandmark>& landmarks, double p, double q, std::size_t coordinate,
             int side) {
  return 1 == std::ranges::count_if(landmarks, [&](const SectionLandmark& at) {
           return at.coordinate == coordinate && at.side == side &&
                  std::fabs(at.box.centre[0] - p) <= at.box.reach[0] + 1e-15 &&
                  std::fabs(at.box.centre[1] - q) <= at.box.reach[1] + 1e-15;
         });
}

}  // namespace

TEST_CASE("section landmarks: circles turn in four points, or cross the sides in eight") {
  for (const Rational& radius : {Rational(1, 2), Rational(1, 1000), Rational(999, 1000)}) {
    const double r = to_double(radius);
    const auto landmarks = found(circle(0, 0, radius)).value();
    CHECK(landmarks.size() == 4);
    for (const double sign : {-1.0, 1.0}) {
      CHECK(has_one(landmarks, sign * r, 0, 0, 0));
      CHECK(has_one(landmarks, 0, sign * r, 1, 0));
    }
    CHECK(found(circle(0, 0, radius), false)->size() == 2);
  }
  const auto landmarks = found(circle(0, 0, Rational(5, 4))).value();
  CHECK(landmarks.size() == 8);
  for (const int side : {-1, 1})
    for (const double at : {-0.75, 0.75}) {
      CHECK(has_one(landmarks, side, at, 0, side));
      CHECK(has_one(landmarks, at, side, 1, side));
    }
}

TEST_CASE("section landmarks: an empty curve has none, also next to the square") {
  CHECK(found(circle(0, 0, 2))->empty());
  CHECK(found(circle(3, 0, Rational(1, 2)))->empty());
  for (int k = 4; k <= 40; k += 4) CHECK(found(circle(2 + power_of_two(-k), 0, 1))->empty());
}

TEST_CASE("section landmarks: corners, touched sides, singular and isolated points are not decided") {
  CHECK_FALSE(found(circle(0, 1, 1)));                                // touches two sides
  CHECK_FALSE(found(circle(2, 0, 1)));                                // from outside
  CHECK_FALSE(found(form_of(S::plane({1, 1, 0}, {1, 2, 0}))));        // through a corner
  CHECK_FALSE(found(form_of(S::cone({0, 0, 0}, {1, 0, 0}, 1))));      // crossing lines
  CHECK_FALSE(found(form_of(S::sphere({Rational(1, 3), 0, 1}, 1))));  // an isolated point
  CHECK_FALSE(found(form_of(S::cylinder({0, 0, 1}, {1, 0, 0}, 1))));  // contact along a line
  const SpacePolynomial x = SpacePolynomial::variable(0), y = SpacePolynomial::variable(1);
  CHECK_FALSE(found(form_of(y * y - x * x * x)));  // a cusp
  // Contact but for 10^-k: decided, or left to others, but never another number of points.
  for (const int k : {3, 6, 9, 12, 15, 18, 21}) {
    Rational off = 1;
    for (int i = 0; i < k; ++i) off /= 10;
    for (const Rational& r : {Rational(1 - off), Rational(1 + off)}) {
      const auto beside = found(circle(2, 0, r)), inside = found(circle(0, 0, r));
      CHECK((k >= 15 || beside.has_value()));
      if (beside) CHECK(beside->size() == (r < 1 ? 0 : k > 0 ? 3 : 0));
      if (inside) CHECK(inside->size() == (r < 1 ? 4 : 8));
    }
  }
}

TEST_CASE("section landmarks: a line along a parameter turns nowhere, which is known where nobody asks") {
  const SquareForm line = form_of(S::plane({0, Rational(1, 3), 0}, {0, 1, 0}));
  CHECK_FALSE(found(line));
  CHECK(found(line, false)->size() == 2);
}

TEST_CASE("section landmarks: as many as the exact graph has nodes") {
  constexpr std::uint64_t seed = 2205;
  INFO("seed " << seed);
  random_nets::Generator generator(seed);
  int decided = 0;
  for (int round = 0; round < 40; ++round) {
    const int degree = round % 2 == 0 ? 2 : 3;
    const RationalPatch patch(random_nets::doubles(generator, degree, degree));
    const Point middle = patch(Rational(1, 2), Rational(1, 2));
    const S surface = round % 3 == 0   ? S::sphere(middle, Rational(1, 4))
                      : round % 3 == 1 ? S::torus(middle, {1, 2, 3}, Rational(1, 4), Rational(1, 8))
                                       : S::plane(middle, {3, 1, 2});
    const auto landmarks = found(section_forms(surface.equation(), patch)->section);
    if (!landmarks) continue;
    ++decided;
    CHECK(landmarks->size() == with_turning_in_v(surface_curve(surface, patch).graph).nodes.size());
  }
  CHECK(decided >= 36);
}

TEST_CASE("section landmarks: the search ends when it is told to") {
  CHECK_FALSE(section_landmarks(circle(0, 0, Rational(1, 2)), true, [] { return true; }));
}

}  // namespace exsect::section_landmarks_test
