// A closed curve that touches a side of one patch where a parameter of the other one turns.
#include <exsect/solver/intersect_rational.h>

#include "support/catch.h"
#include "support/graph_isomorphism.h"

namespace exsect::touched_side_test {

TEST_CASE("touched side: a node on a side is no turning point, yet a parameter turns there") {
  // An octant of the unit sphere, and a quarter of an oblique round piece that touches its side u = 1 at v =
  // 1/3 from inside, r = s = 1/2, where s is least along u = 1.
  const RationalPatch octant({{{-1, 0, 0}, {-1, 0, 1}, {0, 0, 1}},
                              {{-1, -1, 0}, {-1, -1, 1}, {0, 0, 1}},
                              {{0, -1, 0}, {0, -1, 1}, {0, 0, 1}}},
                             {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}});
  const auto q = [](int a, int b) { return Rational(a, b); };
  const RationalPatch piece({{{q(-12, 17), q(-158, 85), q(-9, 85)},
                              {q(3, 68), q(-158, 85), q(-9, 85)},
                              {q(42, 85), q(-158, 85), q(42, 85)}},
                             {{q(-12, 17), q(-61, 170), q(-9, 85)},
                              {q(3, 68), q(-61, 170), q(-9, 85)},
                              {q(42, 85), q(-163, 170), q(42, 85)}},
                             {{q(-12, 17), q(-61, 170), q(237, 170)},
                              {q(3, 68), q(-61, 170), q(237, 170)},
                              {q(42, 85), q(-163, 170), q(237, 170)}}},
                            {{2, 2, q(5, 2)}, {2, 2, q(5, 2)}, {4, 4, 5}});
  const IntersectResult result = intersect(octant, piece);
  REQUIRE(result.status == Status::complete);
  CHECK(result.graph.count(ComponentShape::closed) == 1);
  CHECK(result.graph.components.size() == 1);
  REQUIRE(result.graph.boundary_points() == 1);
  CHECK(result.graph.turning_points(Parameter::u) == 1);  // the other one is on the side
  CHECK(difference(result.graph, intersect(piece, octant).graph, {{2, 3, 0, 1}, {}}) == "");
}

}  // namespace exsect::touched_side_test
