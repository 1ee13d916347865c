// Every family of special positions under a projective map of space and Moebius maps of parameters, written
// as patches of bidegree (2,2) and (3,3): the graph stays the same.
#include <exsect/solver/intersect_rational.h>

#include <cmath>
#include <utility>

#include "answer/parameter_names.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::images_of_families_test {
namespace {

using random_nets::image;
using random_nets::reparametrised;

const Rational first_ratio(5, 7);
const Rational last_ratio(3, 2);

struct Image {
  RationalPatch x;
  RationalPatch y;
};

Image image_of(const ExactCase& c) {
  const Rational small(1, 16);
  const random_nets::ProjectiveMap map = {
      {{1, Rational(1, 3), 0, 0}, {0, 1, Rational(-1, 5), 0}, {0, 0, 1, 1}, {small, small, -small, 1}}};
  return {reparametrised(image(c.x, map), first_ratio),
          reparametrised(image(c.y, map).transposed(), last_ratio).transposed()};
}

/// Each vertex of each arc is on x, by its parameters, within its bound.
void check_vertices(const IntersectionGraph& graph, const RationalPatch& x) {
  for (const Arc& arc : graph.arcs)
    for (const auto& [w, point] : arc.polyline) {
      const Point p = x(from_double(w[0]), from_double(w[1]));
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(std::fabs(to_double(p[c]) - point[c]) <= 2 * arc.error_bound + 1e-12);
    }
}

void check_image(const ExactCase& c) {
  INFO(c.name);
  IntersectOptions options;
  options.turning = c.turning;
  const IntersectResult expected = intersect(c.x, c.y, options);
  REQUIRE(expected.status == Status::complete);
  const auto [x, y] = image_of(c);
  REQUIRE_FALSE(x.is_polynomial());
  for (const Image& pair : {Image{x, y}, Image{x.elevated(3, 3), y.elevated(3, 3)}}) {
    IntersectResult result = intersect(pair.x, pair.y, options);
    REQUIRE(result.status == Status::complete);
    check_vertices(result.graph, pair.x);
    change_parameter(result, Parameter::u, first_ratio);
    change_parameter(result, Parameter::s, last_ratio);
    CHECK(difference(expected.graph, result.graph, {}) == "");
  }
}

}  // namespace

TEST_CASE("images of families: one of each") {
  for (const ExactCase& c : families::specimens()) check_image(c);
}

TEST_CASE("images of families: near misses of contact are none") {
  for (const int digits : {3, 6, 9, 12, 20}) {
    const Rational e = 1 / Rational(pow(Integer(10), static_cast<unsigned>(digits)));
    check_image(families::near_sheets(e, families::Plane::bilinear));
    check_image(families::parted_sheets(e, families::Plane::quadratic));
    check_image(families::turned_side(e));
  }
}

}  // namespace exsect::images_of_families_test
