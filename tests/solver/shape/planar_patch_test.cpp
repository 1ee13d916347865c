#include "shape/planar_patch.h"

#include <exsect/solver/turning_eliminant.h>

#include "curve/curve_arcs.h"
#include "support/catch.h"
#include "support/family_checks.h"
#include "support/graph_patches.h"

namespace exsect::planar_patch_test {
using exsect::testing::graph_patch;
using exsect::testing::HeightCoefficients;
using families::Plane;

namespace {

Rational q(long numerator, long denominator = 1) { return Rational(numerator, denominator); }

const Polynomial kHalf({q(-1, 2), 1});  // u - 1/2

/// (a - b)² - a² b and a (a - b²) with a = u - 1/2, b = v - 1/2, in u and v.
const HeightCoefficients kCusp = {{{q(1, 8), q(-1, 4), 1}, {q(-1, 2), q(-1), 0}, {q(3, 2), q(-1), 0}}};
const HeightCoefficients kBranches = {{{q(3, 8), q(-1, 2), q(1, 2)}, {q(-5, 4), 1, q(-1)}, {1, 0, 0}}};

BezierPatch plane(Plane which) { return families::cap(0, which).y; }

HeightCoefficients lifted(HeightCoefficients h, const Rational& by) {
  h[0][0] += by;
  return h;
}

/// The numbers of open and closed components.
using Counts = std::array<int, 2>;

Counts counts_by_cells(const HeightCoefficients& h) {
  std::vector<Polynomial> rows;
  for (const auto& row : h) {
    rows.push_back(Polynomial({row[0], row[1], row[2]}));
  }
  const CurveArcs curve = curve_arcs(BivariatePolynomial(rows));
  Counts counts{};
  for (const CurveComponent& component : components(curve, std::vector<bool>(curve.arcs.size(), true))) {
    REQUIRE_FALSE(component.branched);
    ++counts[component.closed ? 1 : 0];
  }
  return counts;
}

/// As close to a singular curve as 10^-20, on either side, the curves of the plane come out.
void check_near_curve(const HeightCoefficients& h, Plane which) {
  for (const Rational& distance : distances()) {
    for (const int side : {-1, 1}) {
      INFO("distance " << side * distance << ", plane " << static_cast<int>(which));
      const HeightCoefficients near = lifted(h, side * distance);
      const IntersectResult result = intersect(graph_patch(near), plane(which), {});
      CHECK(result.status == Status::complete);
      const IntersectionGraph& graph = result.graph;
      CHECK(static_cast<int>(graph.components.size()) ==
            graph.count(ComponentShape::open) + graph.count(ComponentShape::closed));
      CHECK(Counts{graph.count(ComponentShape::open), graph.count(ComponentShape::closed)} ==
            counts_by_cells(near));
    }
  }
}

}  // namespace

TEST_CASE("planar_patch: the plane of a patch") {
  const auto image = [](const std::array<Point, 3>& rows) {
    return random_pairs::AffineMap{rows, Point{1, 2, 3}}(plane(Plane::quadratic));
  };
  const BezierPatch tilted = image({Point{1, 0, 0}, Point{0, 1, 0}, Point{1, -2, 0}});
  const auto found = plane_of(tilted);
  REQUIRE(found);
  for (const auto& row : tilted.net()) {
    for (const Point& p : row) {
      CHECK((*found)(p) == 0);
    }
  }
  CHECK_FALSE(plane_of(graph_patch(kCusp)));
  CHECK_FALSE(plane_of(image({Point{1, 0, 0}, Point{1, 0, 0}, Point{1, 0, 0}})));
}

TEST_CASE("planar_patch: folds, also in a corner only") {
  CHECK_FALSE(planar_patch_folds(plane(Plane::quadratic)));
  const auto folded = [](const Rational& at) {  // ((u - at)², v, 0)
    ControlNet c{};
    c[0][0][0] = at * at;
    c[1][0][0] = -2 * at;
    c[2][0][0] = 1;
    c[0][1][1] = 1;
    return BezierPatch::from_power_basis(c);
  };
  CHECK(planar_patch_folds(folded(q(1, 2))));
  CHECK(planar_patch_folds(folded(1)));
  CHECK_FALSE(planar_patch_folds(folded(q(1001, 1000))));
  CHECK_FALSE(planar_turning_eliminant(graph_patch(kCusp), folded(q(1, 2))));
}

TEST_CASE("planar_patch: turning values are roots of the eliminant of the fibres") {
  const std::uint64_t seed = GENERATE(1, 2, 3, 4, 5, 6, 7, 8);
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  HeightCoefficients h;
  for (auto& row : h) {
    for (Rational& c : row) {
      c = Rational(random_pairs::integer(generator, -12, 12), 4);
    }
  }
  for (const Plane which : families::regular_planes) {
    const auto planar = planar_turning_eliminant(graph_patch(h), plane(which));
    REQUIRE(planar);
    const TurningEliminant general = turning_eliminant(graph_patch(h), plane(which));
    REQUIRE(general.polynomial);
    const Polynomial roots = squarefree_part(*planar);
    CHECK(gcd(roots, *general.polynomial).degree() == roots.degree());
  }
}

TEST_CASE("planar_patch: singular points lie over multiple turning values, turning points over simple ones") {
  for (const HeightCoefficients& h : {kCusp, kBranches}) {
    for (const Plane which : families::regular_planes) {
      const auto d = planar_turning_eliminant(graph_patch(h), plane(which));
      REQUIRE(d);
      CHECK(gcd(*d, kHalf * kHalf).degree() == 2);
      const auto near = planar_turning_eliminant(graph_patch(lifted(h, q(1, 1000000))), plane(which));
      REQUIRE(near);
      CHECK(is_squarefree(*near));
    }
  }
  const ExactCase touching = families::tangent_curve(q(1, 3), Plane::square);
  CHECK_FALSE(planar_turning_eliminant(touching.x, touching.y));
  CHECK_FALSE(planar_turning_eliminant(touching.y, touching.x));
}

TEST_CASE("planar_patch: near a cusp, and near branches that touch") {
  check_near_curve(kCusp, Plane::bilinear);
  check_near_curve(kCusp, Plane::quadratic);
  check_near_curve(kBranches, Plane::square);
  check_near_curve(kBranches, Plane::quadratic);
}

TEST_CASE("planar patch: the complement of a line is spanned by vectors other than zero") {
  for (const Point& along :
       {Point{2, 0, 0}, Point{0, -1, 0}, Point{0, 0, 3}, Point{1, -2, 0}, Point{1, 2, 3}}) {
    const std::vector<Point> normals = orthogonal_complement({along, -3 * along});
    REQUIRE(normals.size() >= 2);
    for (const Point& n : normals) {
      CHECK_FALSE(is_zero(n));
      CHECK(dot(n, along) == 0);
    }
    CHECK_FALSE(is_zero(cross(normals.front(), normals.back())));
  }
}

}  // namespace exsect::planar_patch_test
