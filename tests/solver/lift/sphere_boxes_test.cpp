// One sphere in two boxes about different axes: octants and zones whose answer is known, and random boxes
// against points of the sphere.
#include "lift/sphere_boxes.h"

#include <exsect/geometry/surface_box.h>
#include <exsect/solver/intersect_equations.h>

#include <algorithm>
#include <random>

#include "solver/lift/shared_parts.h"
#include "support/catch.h"

namespace exsect::sphere_boxes_test {
namespace {

using S = ImplicitSurface;
using shared_parts::shared;
using shared_parts::Shared;

const Point x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
const S ball = S::sphere({0, 0, 0}, 3);

S zone(const Point& axis, int from, int to) {
  SurfaceBox box;
  box.axis = axis;
  box.height = HeightRange{from, to};
  return boxed(ball, box);
}

S slice(const Point& axis, const Point& from, const Point& to) {
  SurfaceBox box;
  box.axis = axis;
  box.sector = AxisSector{from, to};
  return boxed(ball, box);
}

const Point minus_x = {-1, 0, 0}, minus_y = {0, -1, 0}, minus_z = {0, 0, -1};

}  // namespace

TEST_CASE("sphere boxes: zones about two axes") {
  CHECK(shared(zone(z, 0, 3), zone(x, 0, 3)) == Shared{true, 0, 0});
  CHECK(shared(zone(z, 2, 3), zone(x, 2, 3)) == Shared{true, 0, 0});  // 8 < 9
  CHECK(shared(zone(z, 2, 3), zone({3, 0, -4}, 0, 1)) == Shared{false, 0, 0});
  CHECK(shared(zone(z, 0, 4), zone({0, 3, 4}, -1, 0)) == Shared{true, 0, 0});
  const S cap = zone(z, 2, 3);
  // The plane of the other one's upper rim touches the sphere in the pole of the cap.
  SurfaceBox box;
  box.axis = {1, 0, -1};
  box.height = HeightRange{Rational(-9, 2), Rational(-3, 2)};
  CHECK(shared(zone(z, 3, 4), boxed(ball, box)) == Shared{false, 0, 1});
  CHECK(shared(cap, zone({1, 0, 0}, -5, 5)) == Shared{true, 0, 0});
  CHECK(shared(cap, zone({1, 0, 0}, 4, 5)) == Shared{false, 0, 0});
  CHECK(shared(cap, zone({1, 0, 0}, 3, 5)) == Shared{false, 0, 0});
  CHECK(shared(zone(z, 0, 1), zone({1, 0, 0}, 3, 5)) == Shared{false, 0, 1});
}

TEST_CASE("sphere boxes: halves, octants and lunes from different axes") {
  const S above = zone(z, 0, 3), below = slice(x, minus_y, y), above_again = slice(x, y, minus_y);
  CHECK(shared(above, above_again) == Shared{true, 0, 0});
  const SurfaceIntersection rim = intersect(above, slice(x, minus_y, y));
  CHECK(rim.status == Status::complete);
  CHECK(shared(above, slice(x, minus_y, y)) == Shared{rim.is_same, static_cast<int>(rim.curves.size()), 0});
  // Octants x, y, z >= 0 of the axes z and x, and their neighbours.
  const auto octant_of_z = [](const Point& from, const Point& to, int low) {
    SurfaceBox box;
    box.axis = z;
    box.sector = AxisSector{from, to};
    box.height = HeightRange{low, low + 3};
    return boxed(ball, box);
  };
  const auto octant_of_x = [](const Point& from, const Point& to, int low) {
    SurfaceBox box;
    box.axis = x;
    box.sector = AxisSector{from, to};
    box.height = HeightRange{low, low + 3};
    return boxed(ball, box);
  };
  const S first = octant_of_z(x, y, 0);
  CHECK(shared(first, octant_of_x(y, z, 0)) == Shared{true, 0, 0});
  CHECK(shared(first, octant_of_x(y, z, -3)) == Shared{false, 1, 0});              // the side x = 0
  CHECK(shared(first, octant_of_x(minus_z, y, 0)) == Shared{false, 1, 0});         // the side z = 0
  CHECK(shared(first, octant_of_x(minus_z, y, -3)) == Shared{false, 0, 1});        // the corner on y
  CHECK(shared(first, octant_of_x(minus_y, minus_z, -3)) == Shared{false, 0, 0});  // the opposite one
  CHECK(shared(first, octant_of_x(z, minus_y, -3)) == Shared{false, 0, 1});        // the corner on z
  CHECK(shared(first, below) == Shared{false, 1, 0});
  // Three quarters about z, and the quarter y <= 0 <= z about x: half of that, and a quarter of y = 0.
  CHECK(shared(slice(z, x, minus_y), slice(x, z, minus_y)) == Shared{true, 1, 0});
  // An octant and what is on the other sides of its planes: all three sides, with three corners.
  const S outside = slice(x, z, y);
  const SurfaceIntersection two = intersect(octant_of_z(x, y, 0), outside);
  CHECK_FALSE(two.is_same);
  CHECK(two.curves.size() == 2);
  CHECK(two.count(SpaceNodeKind::singular) == 1);  // the corner on x, where two sides meet
  CHECK(two.count(SpaceNodeKind::end) == 2);
  // x, y >= 0 about x, and what is left of the sphere about z: two meridians that meet in both poles.
  SurfaceBox lune;
  lune.axis = x;
  lune.sector = AxisSector{minus_z, z};
  lune.height = HeightRange{0, 3};
  const SurfaceIntersection meridians = intersect(boxed(ball, lune), slice(z, y, x));
  CHECK_FALSE(meridians.is_same);
  CHECK(meridians.curves.size() == 2);
  CHECK(meridians.count(SpaceNodeKind::singular) == 2);
  CHECK(meridians.count(SpaceNodeKind::end) + meridians.count(SpaceNodeKind::touch) == 0);
}

TEST_CASE("sphere boxes: random boxes against points") {
  constexpr unsigned seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto number = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const auto direction = [&] {
    Point d = {number(-2, 2), number(-2, 2), number(-2, 2)};
    while (is_zero(d)) d = {number(-2, 2), number(-2, 2), number(-2, 2)};
    return d;
  };
  // Rational points of the unit sphere times 3, by stereographic projection.
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) {
    const Rational s(number(-40, 40), 13), t(number(-40, 40), 17), below = 1 + s * s + t * t;
    points.push_back({6 * s / below, 6 * t / below, 3 * (s * s + t * t - 1) / below});
  }
  int same = 0, other = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<S> parts;
    while (parts.size() < 2) {
      SurfaceBox box;
      box.axis = direction();
      if (number(0, 2) > 0) box.sector = AxisSector{direction(), direction()};
      if (!box.sector || number(0, 1) > 0) {
        const int low = number(-3, 2);
        box.height = HeightRange{low, low + number(1, 2)};
      }
      try {
        parts.push_back(boxed(ball, box));
      } catch (const SurfaceError&) {
        continue;  // a direction along the axis
      }
    }
    CAPTURE(i);
    const SurfaceIntersection found = intersect(parts[0], parts[1]);
    REQUIRE(found.status == Status::complete);
    const bool is_seen = std::ranges::any_of(points, [&](const Point& p) {
      return std::ranges::all_of(parts, [&](const S& part) {
        const SurfaceRegion& box = part.box();
        return std::ranges::all_of(box.clauses, [&](const std::vector<std::size_t>& clause) {
          return std::ranges::any_of(clause, [&](std::size_t k) { return box.bounds[k].form(p) > 0; });
        });
      });
    });
    if (is_seen) CHECK(found.is_same);
    for (const SpaceNode& node : found.nodes) {  // their middles are next to both boxes
      const Point p = {node.box[0].midpoint(), node.box[1].midpoint(), node.box[2].midpoint()};
      for (const S& part : parts) {
        const SurfaceRegion& box = part.box();
        CHECK(std::ranges::all_of(box.clauses, [&](const std::vector<std::size_t>& clause) {
          return std::ranges::any_of(
              clause, [&](std::size_t k) { return box.bounds[k].form(p) > -power_of_two(-40); });
        }));
      }
    }
    ++(is_seen ? same : other);
  }
  CHECK(same > 5);
  CHECK(other > 5);
}

}  // namespace exsect::sphere_boxes_test
