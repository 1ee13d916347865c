// Circles of Villarceau in common that are conjugate to each other, and tori that share none.
#include "lift/villarceau_circles.h"

#include <exsect/solver/intersect_equations.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/catch.h"

namespace exsect::villarceau_circles_test {
namespace {

using S = ImplicitSurface;

const Point origin = {0, 0, 0}, up = {0, 0, 1};

IntersectOptions coarse() {
  IntersectOptions options;
  options.tolerance = 1e-3;
  return options;
}

std::vector<Point> planes(const S& first, const S& second) {
  return shared_bitangent_planes(*first.data(), *second.data());
}

std::vector<SpaceCurve> circles(const SurfaceIntersection& result) {
  REQUIRE(result.status == Status::complete);
  std::vector<SpaceCurve> found;
  for (const SpaceCurve& curve : result.curves)
    if (curve.kind == SpaceCurveKind::circle) found.push_back(curve);
  return found;
}

/// All vertices of the circle are at the distance R from one of the two points c +- r e in the plane, the
/// same for all: 1 or -1.
int which_centre(const SurfaceIntersection& result, const SpaceCurve& circle, const S& torus) {
  const SurfaceData& data = *torus.data();
  const Point across = cross(data.axis, *circle.direction);
  const double share = std::sqrt(to_double(data.minor_squared / dot(across, across)));
  const double radius = std::sqrt(to_double(data.squared));
  std::array<bool, 2> fits = {true, true};
  for (const int id : circle.arcs) {
    const SpaceArc& arc = result.arcs[static_cast<std::size_t>(id)];
    for (const auto& p : arc.polyline)
      for (const int side : {1, -1}) {
        std::array<double, 3> off{};
        for (std::size_t k = 0; k < 3; ++k)
          off[k] = p[k] - to_double(data.point[k]) - side * share * to_double(across[k]);
        if (std::fabs(std::hypot(off[0], off[1], off[2]) - radius) > 2 * arc.error_bound + 1e-12)
          fits[side > 0 ? 0 : 1] = false;
      }
  }
  REQUIRE(fits[0] != fits[1]);
  const int side = fits[0] ? 1 : -1;
  if (circle.point) CHECK(sign(dot(across, *circle.point - data.point)) == side);
  return side;
}

void check_pair(const S& first, const S& second, std::size_t others) {
  const SurfaceIntersection result = intersect(first, second, coarse());
  const std::vector<SpaceCurve> found = circles(result);
  REQUIRE(found.size() == 2);
  CHECK(result.curves.size() == 2 + others);
  CHECK(which_centre(result, found[0], first) == -which_centre(result, found[1], first));
  for (const SpaceCurve& circle : found) {
    CHECK(circle.is_closed);
    CHECK(*circle.radius_squared == first.data()->squared);
    for (const S* torus : {&first, &second}) {
      const Rational along = dot(*circle.direction, torus->data()->axis);
      const SurfaceData& data = *torus->data();
      CHECK(along * along * data.squared == (data.squared - data.minor_squared) * dot(data.axis, data.axis) *
                                                dot(*circle.direction, *circle.direction));
    }
    for (const int arc : circle.arcs) CHECK(result.arcs[static_cast<std::size_t>(arc)].curve == circle.id);
  }
}

}  // namespace

TEST_CASE("villarceau: planes that touch both tori twice") {
  const S torus = S::torus(origin, up, 3, 2);
  CHECK(planes(torus, S::torus(origin, {8, 4, 1}, 3, 2)).size() == 1);
  CHECK(planes(torus, S::torus(origin, {-8, -4, -1}, 3, 2)).size() == 1);  // the other bisector
  CHECK(planes(torus, S::torus(origin, {8, 4, 1}, 3, 1)).empty());
  CHECK(planes(torus, S::torus({0, 0, 1}, {8, 4, 1}, 3, 2)).empty());
  CHECK(planes(torus, S::torus(origin, {0, 0, 2}, 3, 2)).empty());
  CHECK(planes(torus, S::torus(origin, {8, 4, 2}, 3, 2)).empty());
  CHECK(planes(torus, S::torus(origin, {1, 1, 1}, 3, 2)).empty());
  // Both bisectors of orthogonal axes, at 45 degrees.
  const S wide = S::torus(origin, up, Length::of_squared(2), 1);
  CHECK(planes(wide, S::torus(origin, {3, 4, 0}, Length::of_squared(2), 1)).size() == 2);
}

TEST_CASE("villarceau: conjugate circles that two tori share are named") {
  check_pair(S::torus(origin, up, 3, 2), S::torus(origin, {8, 4, 1}, 3, 2), 2);
  check_pair(S::torus({1, 2, 3}, {-8, -4, -1}, 3, 2), S::torus({1, 2, 3}, {0, 0, 5}, 3, 2), 2);
  // Without a rational radius: the axis up mirrored in the plane with the normal (3,0,4).
  const Length major = Length::of_squared(50), minor = Length::of_squared(18);
  check_pair(S::torus(origin, up, major, minor), S::torus(origin, {24, 0, 7}, major, minor), 2);
  const S first = S::torus(origin, up, major, minor);
  CHECK(circles(intersect(first, S::torus({0, 0, power_of_two(-60)}, {24, 0, 7}, major, minor), coarse()))
            .empty());
}

TEST_CASE("villarceau: four circles, two by two") {
  const Length major = Length::of_squared(2);
  const SurfaceIntersection result =
      intersect(S::torus(origin, up, major, 1), S::torus(origin, {1, 0, 0}, major, 1), coarse());
  REQUIRE(circles(result).size() == 4);
  for (const SpaceCurve& circle : circles(result)) {
    CHECK(dot(*circle.point, *circle.point) == 1);
    CHECK(circle.is_closed);
    CHECK(*circle.radius_squared == 2);
  }
  CHECK(result.count(SpaceCurveKind::general) == 0);
}

}  // namespace exsect::villarceau_circles_test
