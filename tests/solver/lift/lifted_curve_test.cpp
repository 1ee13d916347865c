#include "lift/lifted_curve.h"

#include <algorithm>

#include "lift/pair_region.h"
#include "support/catch.h"

namespace exsect::lifted_curve_test {
namespace {

const Point origin = {0, 0, 0}, up = {0, 0, 1};

/// Arcs, nodes of degree 0 (touch), and above 2 (crossing); ends; -1 for one surface.
using Shape = std::array<long, 4>;

Shape shape(const ImplicitSurface& surface, const ImplicitSurface& other) {
  const LiftedCurve curve = lifted_curve(surface, other, pair_region(surface, other).all).value();
  const auto count = [&](auto&& test) { return std::count_if(curve.nodes.begin(), curve.nodes.end(), test); };
  if (curve.is_same) return {-1, -1, -1, -1};
  return {static_cast<long>(curve.arcs.size()), count([](const LiftedNode& n) { return n.degree == 0; }),
          count([](const LiftedNode& n) { return n.degree > 2; }),
          count([](const LiftedNode& n) { return n.degree == 1; })};
}

}  // namespace

TEST_CASE("Viviani's curve has one node, where four arcs meet") {
  const LiftedCurve curve =
      lifted_curve(ImplicitSurface::cylinder({1, 0, 0}, up, 1), ImplicitSurface::sphere(origin, 2), {})
          .value();
  CHECK(shape(ImplicitSurface::cylinder({1, 0, 0}, up, 1), ImplicitSurface::sphere(origin, 2))[2] == 1);
  CHECK(shape(ImplicitSurface::sphere(origin, 2), ImplicitSurface::cylinder({1, 0, 0}, up, 1))[2] == 1);
}

TEST_CASE("shapes") {
  using S = ImplicitSurface;
  CHECK(shape(S::cylinder(origin, up, 1), S::cylinder(origin, {1, 0, 0}, 1)) == Shape{8, 0, 2, 0});
  CHECK(shape(S::cylinder(origin, {1, 1, 1}, 1), S::cylinder(origin, {1, 0, 0}, 1)) == Shape{8, 0, 2, 0});
  CHECK(shape(S::cylinder(origin, up, 1), S::sphere(origin, 1)) == Shape{2, 0, 0, 0});
  CHECK(shape(S::cylinder(origin, up, 1), S::cylinder({2, 0, 0}, up, 1)) == Shape{1, 0, 0, 2});
  CHECK(shape(S::cylinder(origin, up, 1), S::cylinder({1, 0, 0}, up, 1)) == Shape{2, 0, 0, 4});
  CHECK(shape(S::cylinder(origin, up, 1), S::cylinder({3, 0, 0}, up, 1)) == Shape{0, 0, 0, 0});
  CHECK(shape(S::cone(origin, up, 1), S::plane(origin, up)) == Shape{0, 1, 0, 0});
  CHECK(shape(S::cone(origin, up, 1), S::plane(origin, {1, 0, 1})) == Shape{1, 0, 0, 2});
  CHECK(shape(S::cone(origin, up, 1, 2), S::plane({1, 0, 0}, {1, 0, 0})) == Shape{4, 0, 0, 4});
  CHECK(shape(S::cone(origin, up, 1), S::plane({1, 0, 0}, {1, 0, 0})) == Shape{2, 0, 0, 2});
  CHECK(shape(S::cone(origin, up, 1), S::plane({0, 0, 1}, {0, 0, 1})) == Shape{2, 0, 0, 0});
  CHECK(shape(S::plane(origin, up), S::torus(origin, up, 2, 1)) == Shape{8, 0, 0, 0});
}

}  // namespace exsect::lifted_curve_test
