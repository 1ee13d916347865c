#include "star/line_crossing.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "star_at_centre.h"
#include "support/families.h"

namespace exsect::line_crossing_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the star's support

/// The positive root of n t^2 = 1.
RealAlgebraic root_of(int n) { return real_roots(Polynomial({-1, 0, n}), 0, 1).front(); }

struct Crossings {
  std::size_t candidates = 0;
  std::vector<StarNeighbourhood> stars;

  Crossings(const BezierPatch& x, const BezierPatch& y, const RealAlgebraic& value) {
    ExactPair pair(x, y);
    const auto& turning = pair.turning(Parameter::u);
    const auto& along = pair.turning(Parameter::v);
    REQUIRE(turning);
    REQUIRE(along);
    const std::vector<CertifiedPoint> boundary = points_on_sides(x, y);
    const StarPlaces places = {boundary, Parameter::s, {}};
    const StarQuery query = {pair, places, *turning, 0x1p-6};
    for (const LineCrossing& crossing : line_crossings(x, y, Parameter::u, value, *along)) {
      ++candidates;
      if (auto star = line_crossing_star(query, crossing)) stars.push_back(*std::move(star));
    }
  }
};

}  // namespace

TEST_CASE("line crossing: two lines that cross in a point with irrational parameters", "[star]") {
  // (u^2 - 1/2)(v^2 - 1/3)
  const ExactCase c = families::irrational_lines(families::Plane::square);
  const Crossings found(c.x, c.y, root_of(2));
  REQUIRE(found.stars.size() == 1);
  const StarNeighbourhood& star = found.stars[0];
  CHECK(star.ports.size() == 4);
  CHECK(std::count_if(star.ports.begin(), star.ports.end(),
                      [](const Port& port) { return port.across == Parameter::u; }) == 2);
  for (const long bits : {20L, 100L, 180L}) {
    const Rational width = power_of_two(-bits);
    const ParameterBox at = star.centre.refined_to(width).box();
    for (const std::size_t j : {0U, 2U}) CHECK(is_in(root_of(2), at[j]));
    for (const std::size_t j : {1U, 3U}) CHECK(is_in(root_of(3), at[j]));
    for (const RationalInterval& range : at) CHECK(range.width() <= width);
  }
}

TEST_CASE("line crossing: on a line that nothing crosses there is none", "[star]") {
  // (u^2 - 1/2)(v^2 + 1): the second factor has no zero, and v no turning value that is a crossing.
  const Terms h = Terms{{{2, 0}, 1}, {{0, 0}, Rational(-1, 2)}} * Terms{{{0, 2}, 1}, {{0, 0}, 1}};
  CHECK(Crossings(graph(h), plane_patch(), root_of(2)).stars.empty());
}

TEST_CASE("line crossing: a curve crosses the line twice", "[star]") {
  // (2 u^2 - 1)(12 b^2 - 1): two lines in v cross the one in u.
  const ExactCase c = families::three_irrational_lines();
  const Crossings found(c.x, c.y, root_of(2));
  CHECK(found.stars.size() == 2);
  for (const StarNeighbourhood& star : found.stars) CHECK(star.ports.size() == 4);
}

}  // namespace exsect::line_crossing_test
