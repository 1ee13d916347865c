#include "sweep/entering_directions.h"

#include "support/known_curves.h"
#include "swept_pair.h"

namespace exsect::entering_directions_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

/// Of the landmark with these (u,v); empty: unknown.
std::optional<std::vector<int>> directions_at(const HeightCoefficients& h, const Rational& u,
                                              const Rational& v) {
  SweptPair pair(graph_patch(h), plane_patch());
  for (std::size_t i = 0; i < pair.landmarks.size(); ++i) {
    const ParameterBox box = pair.data.landmarks[i].point.box();
    if (box[0].lower <= u && u <= box[0].upper && box[1].lower <= v && v <= box[1].upper)
      return entering_directions(pair.system, pair.landmarks, pair.data, i);
  }
  FAIL("no such landmark");
  return std::nullopt;
}

}  // namespace

TEST_CASE("entering directions: one at a point where the curve crosses the side") {
  // T = (h_v, -h_u, ...): along the parabola, h_v = 1, u rises with T.
  CHECK(directions_at(kParabola, 0, q(13, 36)) == std::vector{1});
  CHECK(directions_at(kParabola, 1, q(25, 36)) == std::vector{-1});
}

TEST_CASE("entering directions: two or none where it is tangent to the side, by its bend") {
  // (u -+ 1/4)^2 + (v - 1/2)^2 = 1/16 inside, outside of u = 0.
  const HeightCoefficients inside = {{{q(1, 4), -1, 1}, {q(-1, 2), 0, 0}, {1, 0, 0}}};
  const HeightCoefficients outside = {{{q(1, 4), -1, 1}, {q(1, 2), 0, 0}, {1, 0, 0}}};
  CHECK(directions_at(inside, 0, q(1, 2)) == std::vector{1, -1});
  CHECK(directions_at(outside, 0, q(1, 2)) == std::vector<int>{});
}

TEST_CASE("entering directions: into a corner, and past it") {
  const auto line = [](const Rational& slope) {  // v = slope u through the corner (0, 0)
    return HeightCoefficients{{{0, 1, 0}, {-slope, 0, 0}, {0, 0, 0}}};
  };
  CHECK(directions_at(line(q(1, 2)), 0, 0) == std::vector{1});
  CHECK(directions_at(line(q(-1, 2)), 0, 0) == std::vector<int>{});
}

}  // namespace exsect::entering_directions_test
