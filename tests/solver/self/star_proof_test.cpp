#include "self/star_proof.h"

#include <algorithm>

#include "answer/parameter_box.h"
#include "self/boundary.h"
#include "shape/injective_rectangle.h"
#include "support/catch.h"
#include "support/self_checks.h"

namespace exsect::star_proof_test {
using exsect::testing::checked;
using exsect::testing::degrees;
using exsect::testing::patch;
using exsect::testing::random_patch;
using exsect::testing::self_fibre;

namespace {

// x(0,t) = x(t,0) in all of them. Both tangent planes agree in the corners (0,1) and (1,0), at t = 1/2, where
// another curve is tangent to the sides, and at t = 1/2.
const std::vector<int> kSingularCorner = {1,  0, -1, 0, 0, -1, 1, -1, 1, 0, 0, -1, 0, 1,
                                          -1, 1, -1, 1, 1, -1, 1, -1, 0, 0, 0, 0,  -1};
const std::vector<int> kTangentToSides = {1,  -1, 1, 1, -1, 0, 0, 0, 0, 1, -1, 0, 0, 0,
                                          -1, 1,  1, 0, 0,  0, 0, 0, 0, 1, 1,  0, 1};

/// x = (a, b (a - c) + b^2, b (v - u)) with a = u + v and b = u v.
BezierPatch symmetric_patch(const Rational& c) {
  ControlNet power{};
  power[1][0] = power[0][1] = {1, 0, 0};
  power[1][1] = {0, -c, 0};
  power[2][1] = {0, 1, -1};
  power[1][2] = {0, 1, 1};
  power[2][2] = {0, 1, 0};
  return BezierPatch::from_power_basis(power);
}

std::vector<SelfStar> stars_of(const BezierPatch& x) {
  const SelfBoundary boundary = self_boundary(x, injective_rectangles(x));
  const SelfValues values = self_values(x);
  const std::vector<ParameterBox> everywhere = {{{{0, 1}, {0, 1}, {0, 1}, {0, 1}}}};
  const std::vector<SelfCentre> centres = self_star_centres(x, boundary.points, everywhere, values);
  return self_stars({x, boundary.points, centres, values, 1e-3, {}});
}

/// Pairs over the value of the star's sweep parameter in a box, by the line itself.
std::ptrdiff_t pairs_over(const BezierPatch& x, const SelfStar& star, const ParameterBox& box,
                          const Rational& value) {
  const std::size_t sweep = index(star.star.sweep);
  const std::vector<CertifiedPoint> points = self_fibre(x, sweep, value);
  return std::ranges::count_if(points,
                               [&](const CertifiedPoint& point) { return lies_in(point.box(), box); });
}

}  // namespace

TEST_CASE("star proof: no pairs around a star but the arcs that leave it") {
  int larger = 0;
  const auto check = [&larger](const BezierPatch& x) {
    for (const SelfStar& star : stars_of(x)) {
      const std::size_t sweep = index(star.star.sweep);
      CHECK(lies_in(star.star.box, star.surroundings));
      larger += lies_in(star.surroundings, star.star.box) ? 0 : 1;
      const RationalInterval centre = star.star.centre.box()[sweep];
      for (const int side : {-1, 1}) {
        const Rational end = side < 0 ? star.surroundings[sweep].lower : star.surroundings[sweep].upper;
        if (end == centre.lower || end == centre.upper) continue;
        const Rational inner = side < 0 ? star.star.box[sweep].lower : star.star.box[sweep].upper;
        const std::ptrdiff_t arcs = pairs_over(x, star, star.star.box, inner);
        // Of a cuspidal centre's arcs both orders are in the box, but the ports are those of one.
        CHECK((star.cuspidal || arcs == std::ranges::count(star.star.ports, side, &Port::side)));
        for (const Rational& part : {Rational(1, 5), Rational(3, 7), Rational(19, 20)}) {
          const Rational value = centre.midpoint() + part * (end - centre.midpoint());
          CHECK(pairs_over(x, star, star.surroundings, value) == arcs);
        }
      }
    }
  };
  for (const BezierPatch& x :
       {patch(kTangentToSides), patch(kSingularCorner), symmetric_patch(Rational(3, 4))})
    check(x);
  for (unsigned seed = 1; seed < 13; ++seed) {
    CAPTURE(seed);
    std::mt19937 generator(seed);
    check(random_patch(generator, 1));
  }
  CHECK(larger >= 12);
}

TEST_CASE("star proof: glued sides, both tangent planes agree at a rational pair") {
  // With b_1, b_2 of two points: the same a, and b_1 = b_2 or b_1 + b_2 = c - a. In the first case they are
  // (u,v) and (v,u) with u v = 0; in the second (v - u) b is the same too, which gives two curves from u v =
  // a^2/6, a^2/3 = c - a, cuspidal, to a^2/4 = c - a, where one point is on a side and u = v at the other
  // one.
  const IntersectionGraph graph = checked(symmetric_patch(Rational(3, 4)));
  CHECK(graph.isolated_points.empty());
  CHECK(std::ranges::count(graph.arcs, ArcPlace::patch_boundary, &Arc::place) == 2);
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{2});
  CHECK(degrees(graph, NodeKind::cusp) == std::vector{1, 1, 1});
  CHECK(graph.components.size() == 3);
  const double at_cusp = 1.5 * (std::sqrt(2.0) - 1);
  const double at_side = std::sqrt(7.0) - 2;
  for (const Node& node : graph.nodes) {
    CAPTURE(node.approx);
    const auto [u, v, r, s] = node.approx;
    if (!node.wrt.empty()) continue;
    if (node.on.empty()) {
      CHECK(u + v == Approx(at_cusp));
      CHECK(u * v == Approx(at_cusp * at_cusp / 6));
    } else if (node.on.size() == 1) {
      CHECK(u + v == Approx(at_side));
      CHECK(std::max(u * v, r * s) == Approx(at_side * at_side / 4));
    } else {
      CHECK((node.approx == std::array<double, 4>{0, 0, 0, 0} || u + v == 1 || u + v == 0.75));
    }
  }
}

TEST_CASE("star proof: a curve tangent to glued sides") {
  const IntersectionGraph graph = checked(patch(kTangentToSides));
  CHECK(std::ranges::count(graph.arcs, ArcPlace::patch_boundary, &Arc::place) == 2);
  CHECK(degrees(graph, NodeKind::crossing) == std::vector{4});
}

TEST_CASE("star proof: glued sides that end in corners with one tangent plane") {
  const IntersectionGraph graph = checked(patch(kSingularCorner));
  CHECK(std::ranges::count(graph.arcs, ArcPlace::patch_boundary, &Arc::place) == 1);
}

}  // namespace exsect::star_proof_test
