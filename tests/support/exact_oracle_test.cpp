#include "support/exact_oracle.h"

#include <exsect/solver/intersect_rational.h>

#include "support/catch.h"
#include "support/exact_tensor.h"

namespace exsect::exact_oracle_test {
namespace {

using namespace exact_oracle;

RationalPatch flat(const Point& a, const Point& b, const Point& c) {
  return RationalPatch({{a, c}, {b, b + c - a}});
}

/// A quarter of x^2 + y^2 = 1, 0 <= z <= 1: u runs around it from (1,0), z = v.
RationalPatch quarter_cylinder() {
  const std::vector<Rational> w = {1, 1};
  return RationalPatch({{{1, 0, 0}, {1, 0, 1}}, {{1, 1, 0}, {1, 1, 1}}, {{0, 1, 0}, {0, 1, 1}}},
                       {w, w, {2, 2}});
}

bool holds(const RationalInterval& at, const Rational& value) {
  return at.lower <= value && value <= at.upper;
}

TEST_CASE("exact oracle: known points on lines") {
  // x = 3/5 cuts the quarter circle ((1-u^2), 2u)/(1+u^2) at u = 1/2, y = 4/5.
  const RationalPatch plane = flat({Rational(3, 5), -1, Rational(-1, 7)},
                                   {Rational(3, 5), 2, Rational(-1, 7)}, {Rational(3, 5), -1, 2});
  const LinePoints found = line_points(quarter_cylinder(), plane, 1, Rational(1, 3));
  REQUIRE(found.doubt.empty());
  REQUIRE(found.points.size() == 1);
  CHECK(holds(found.points[0][0], Rational(1, 2)));
  CHECK(holds(found.points[0][1], Rational(1, 3)));
  CHECK(holds(found.points[0][2], Rational(3, 5)));
  CHECK(holds(found.points[0][3], Rational(2, 9)));  // (1/3 + 1/7) / (15/7)
  for (const RationalInterval& at : found.points[0]) CHECK(at.width() <= Rational(1, 1 << 18));

  const LinePoints on_plane = line_points(quarter_cylinder(), plane, 3, Rational(2, 9));
  REQUIRE(on_plane.conclusive());
  REQUIRE(on_plane.points.size() == 1);
  CHECK(holds(on_plane.points[0][1], Rational(1, 3)));
  CHECK(line_points(quarter_cylinder(), plane, 0, Rational(2, 3)).points.empty());
}

TEST_CASE("exact oracle: in doubt where a line touches") {
  // z = 1 + (2u - 1)^2 in the line v = 1/2, and the plane z = 1 or one that is 2^-40 away.
  const RationalPatch bowl(
      {{{0, 0, 2}, {0, 1, 2}}, {{Rational(1, 2), 0, 0}, {Rational(1, 2), 1, 0}}, {{1, 0, 2}, {1, 1, 2}}});
  const auto count = [&](const Rational& z) {
    return line_points(bowl, flat({-1, -1, z}, {3, -1, z}, {-1, 4, z}), 1, Rational(1, 2));
  };
  CHECK_FALSE(count(1).conclusive());
  const LinePoints above = count(1 + power_of_two(-20));
  CHECK(above.conclusive());
  CHECK(above.points.size() == 2);
  const LinePoints below = count(1 - power_of_two(-20));
  CHECK(below.conclusive());
  CHECK(below.points.empty());
}

TEST_CASE("exact oracle: tensors over parts have the signs of the polynomial") {
  // (x - 1/3)(y + 1) + z, degrees 1: coefficients at the corners, times 3.
  Tensor t = {{1, 1, 1}, {}};
  for (int i = 0; i < 8; ++i)
    t.coefficients.push_back((3 * (i >> 2 & 1) - 1) * ((i >> 1 & 1) + 1) + 3 * (i & 1));
  const Tensor wide = t.widened(0);                              // x = -1/2 and 3/2
  CHECK(wide.coefficients[0] * 7 == wide.coefficients[4] * -5);  // -5/6 and 7/6 at y = z = 0
  const Tensor right = t.cut(1, 1, 2, 1);                        // y from 1/2
  CHECK(right.coefficients[0] * 2 == right.coefficients[2] * Rational(3, 2));
  CHECK(t.derivative(2).coefficients == std::vector<Integer>{3, 3, 3, 3});
  CHECK(t.face(2, 0) == std::vector<Integer>{-1, -2, 2, 4});
}

TEST_CASE("exact oracle: compares graphs, and sees what is missing or in the wrong place") {
  const RationalPatch x = quarter_cylinder();
  const RationalPatch y = flat({-1, -1, Rational(1, 5)}, {2, -1, Rational(2, 5)}, {-1, 2, Rational(4, 7)});
  const IntersectResult result = intersect(x, y);
  REQUIRE(result.status == Status::complete);
  const Comparison same = compare(x, y, result.graph);
  CHECK(same.difference.empty());
  CHECK(same.lines >= 6);
  CHECK(same.vertices > 0);
  CHECK(same.unsure == 0);

  IntersectionGraph less = result.graph;
  less.arcs.pop_back();
  CHECK_FALSE(compare(x, y, less).difference.empty());

  IntersectionGraph moved = result.graph;
  for (PolylineVertex& vertex : moved.arcs.at(0).polyline) vertex.parameters[1] = 1 - vertex.parameters[1];
  CHECK_FALSE(compare(x, y, moved).difference.empty());
  CHECK(compare(x, y, IntersectionGraph{}).difference != "");
}

TEST_CASE("exact oracle: parts that are proved apart") {
  const RationalPatch x = quarter_cylinder();
  const RationalPatch plane =
      flat({Rational(3, 5), -1, -1}, {Rational(3, 5), 2, -1}, {Rational(3, 5), -1, 2});
  const auto box = [](const Rational& low, const Rational& high) {
    return ParameterBox{RationalInterval{low, high}, {0, 1}, {0, 1}, {0, 1}};
  };
  CHECK_FALSE(proved_apart(x, plane, box(Rational(1, 2), Rational(1, 2))));
  CHECK_FALSE(proved_apart(x, plane, box(Rational(2, 5), Rational(3, 5))));
  CHECK(proved_apart(x, plane, box(Rational(11, 20), 1)));
  CHECK(proved_apart(x, plane, box(0, Rational(9, 20))));
}

}  // namespace
}  // namespace exsect::exact_oracle_test
