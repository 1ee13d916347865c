// Pairs in special position: their exact answers, under exchanges and affine maps as well.
#include "support/families.h"

#include <exsect/geometry/patch_file.h>

#include <fstream>
#include <iterator>

#include "support/case_file.h"
#include "support/catch.h"
#include "support/family_checks.h"

namespace exsect::families_test {
namespace {

using families::Plane;

constexpr std::array<Plane, 3> affine_or_bilinear = {Plane::square, Plane::larger, Plane::bilinear};

}  // namespace

TEST_CASE("family: cap above and below the plane") {
  for (const Plane plane : affine_or_bilinear) {
    check_images(families::cap(Rational(1, 10), plane));
    check(families::cap(Rational(-1, 100), plane));
  }
}

TEST_CASE("family: nearly crossing") {
  for (const Plane plane : affine_or_bilinear) check_images(families::near_crossing(Rational(1, 100), plane));
}

TEST_CASE("family: a curve that turns where it meets a side") {
  for (const Plane plane : families::all_planes) check_images(families::quarter_circle(plane));
}

TEST_CASE("family: parted sheets") {
  for (const Plane plane : families::all_planes) check(families::parted_sheets(Rational(1, 100), plane));
}

TEST_CASE("family: nearly a touch point is a small loop or nothing") {
  for (const Plane plane : affine_or_bilinear) {
    check_near([=](const Rational& e) { return families::cap(e, plane); });
    check_near([=](const Rational& e) { return families::cap(-e, plane); });
  }
}

TEST_CASE("family: nearly a crossing is two arcs") {
  for (const Plane plane : affine_or_bilinear) {
    check_near([=](const Rational& e) { return families::near_crossing(e, plane); }, 4);
  }
}

TEST_CASE("family: nearly a tangent curve is nothing on one side") {
  for (const Plane plane : families::all_planes) {
    check_near([=](const Rational& e) { return families::parted_sheets(e, plane); });
  }
}

TEST_CASE("family: nearly a tangent curve is two arcs on the other side") {
  for (const Plane plane : families::all_planes) {
    check_near([=](const Rational& e) { return families::near_sheets(e, plane); });
  }
  check_images(families::near_sheets(Rational(1, Integer(1000000000000)), Plane::bilinear));
}

TEST_CASE("family: touch point") {
  for (const Plane plane : families::all_planes) check_images(families::cap(0, plane));
}

TEST_CASE("family: crossing") {
  for (const Plane plane : families::all_planes) check_images(families::crossing(plane));
}

TEST_CASE("family: lines that cross in irrational numbers") {
  check_images(families::irrational_lines(Plane::bilinear));
  for (const Plane plane : families::all_planes) check(families::irrational_lines(plane));
  check_images(families::three_irrational_lines());
}

TEST_CASE("family: two near sheets") {
  for (const Plane plane : families::all_planes) check_images(families::near_sheets(Rational(1, 100), plane));
}

TEST_CASE("family: tangent and transversal") {
  for (const Plane plane : families::all_planes) check_images(families::tangent_and_transversal(plane));
}

TEST_CASE("family: two tangent lines") {
  check_images(families::tangent_lines(Plane::squares));
  for (const Plane plane : families::all_planes) check(families::tangent_lines(plane));
}

TEST_CASE("family: cusp of the curve") {
  check_images(families::curve_cusp(Plane::square));
  for (const Plane plane : families::all_planes) check(families::curve_cusp(plane));
}

TEST_CASE("family: two branches tangent to each other") {
  check_images(families::tangent_branches(Plane::square));
  for (const Plane plane : families::all_planes) check(families::tangent_branches(plane));
}

TEST_CASE("family: an arc crosses a line of both patches") { check_images(families::line_and_arc()); }

TEST_CASE("family: parameters that turn together") {
  for (const Plane plane : {Plane::quadratic, Plane::squares}) {
    check_images(families::cap(Rational(1, 10), plane));
    check_images(families::near_crossing(Rational(1, 100), plane));
  }
}

TEST_CASE("family: tangent curve") {
  for (const Plane plane : families::all_planes) {
    check_images(families::tangent_curve(Rational(1, 3), plane));
    check_images(families::tangent_curve(0, plane));
  }
}

TEST_CASE("family: touching curve of two bent patches") {
  const auto pair = read_patches(std::string(EXSECT_EXAMPLES) + "/touching-curve.json").patches;
  check_images(families::touching_curve(pair[0].patch, pair[1].patch));
}

TEST_CASE("family: nearly a touching curve of two bent patches") {
  const auto pair = read_patches(std::string(EXSECT_EXAMPLES) + "/touching-curve.json").patches;
  struct Direction {
    std::size_t axis;
    std::size_t distances;
    int open;
    int closed;
  };
  for (const Direction& d : {Direction{2, 4, 2, 0}, Direction{0, 3, 0, 1}}) {
    for (std::size_t k = 0; k < d.distances; ++k) {
      INFO("along axis " << d.axis << " by -" << distances()[k]);
      ControlNet net = pair[1].patch.net();
      for (auto& row : net) {
        for (Point& p : row) p[d.axis] -= distances()[k];
      }
      const IntersectResult result = intersect(pair[0].patch, BezierPatch(net), {});
      CHECK(result.status == Status::complete);
      CHECK(result.graph.count(ComponentShape::open) == d.open);
      CHECK(result.graph.count(ComponentShape::closed) == d.closed);
      CHECK(result.graph.count(ComponentShape::branched) == 0);
      CHECK(result.graph.isolated_points.empty());
    }
  }
}

TEST_CASE("family: double cover") { check_images(families::double_cover()); }

TEST_CASE("family: shared sides") {
  const Rational half(1, 2);
  for (const families::Neighbour& n :
       {families::Neighbour{}, families::Neighbour{1, 0, 0},
        families::Neighbour{Rational(3, 4), Rational(1, 4), 0},
        families::Neighbour{Rational(-1, 4), Rational(5, 4), 0}, families::Neighbour{half, Rational(3, 2), 1},
        families::Neighbour{0, 1, half}, families::Neighbour{Rational(2, 3), Rational(1, 5), Rational(1, 3)}})
    check_images(families::shared_side(n));
  check_images(families::smooth_neighbour(1));
  check_images(families::side_on_interior_line());
  check_images(families::side_at_two_speeds());
}

TEST_CASE("family: an arc leaves a side") {
  check_images(families::side_and_arc());
  check_images(families::side_and_arc_from_its_end());
}

TEST_CASE("family: overlaps") {
  check_images(families::shifted_copy());
  check_images(families::same_patch());
  check_images(families::coplanar_squares());
}

TEST_CASE("family: two pieces of one surface that have a side in common do not overlap") {
  check_images(families::smooth_neighbour(0));
}

TEST_CASE("family: collapsed side") { check_images(families::collapsed_side()); }

TEST_CASE("family: an arc through a pinch point") {
  check_images(families::pinch_point());
  for (const bool on_side : {false, true}) check_images(families::pinch_point_passed(on_side));
}

TEST_CASE("family: a common pole") {
  using families::PoleNeighbour;
  for (const PoleNeighbour which : {PoleNeighbour::smooth, PoleNeighbour::sharp, PoleNeighbour::opposite})
    check_images(families::common_pole(which));
}

TEST_CASE("two adjacent sides at a common pole") {
  const ExactCase c = families::common_pole(families::PoleNeighbour::sharp);
  ControlNet net = c.x.net();
  for (std::size_t i = 0; i < 3; ++i) net[i][0] = net[0][0];
  const IntersectResult result = intersect(BezierPatch(net), c.y);
  REQUIRE(result.status == Status::incomplete);
  CHECK(std::any_of(result.incomplete.begin(), result.incomplete.end(), [](const Incomplete& region) {
    return region.why == "two adjacent sides of a patch and a side of the other one are the same point";
  }));
}

TEST_CASE("family: a common apex") {
  check_images(families::common_apex(false));
  check_images(families::common_apex(true));
}

TEST_CASE("family: crossing tubes") { check_images(families::crossing_tubes()); }

TEST_CASE("family: two parameters turn in one point") { check_images(families::symmetric_turns()); }

TEST_CASE("family: mirror images") { check_images(families::mirror_images()); }

TEST_CASE("family: an arc leaves a collapsed side") { check_images(families::arc_from_collapsed_side()); }

TEST_CASE("family: nearly an overlap is nothing, or one arc") {
  check_images(families::lifted_copy(Rational(1, 1000)));
  check_near(families::lifted_copy);
  for (const Rational& e : distances()) check(families::tilted_copy(e));
}

TEST_CASE("family: nearly a shared side is one arc") {
  check_images(families::turned_side(Rational(1, 7)));
  check_near(families::turned_side, 4);
}

TEST_CASE("family: the cases are what the families give") {
  int files = 0;
  for (const ExactCase& c : families::specimens()) {
    const std::string stem = std::string(EXSECT_CASES) + "/" + case_stem(c);
    std::ifstream patches(stem + ".json");
    if (!patches) continue;
    ++files;
    INFO(stem);
    std::ifstream expected(stem + ".expected.json");
    CHECK(std::string(std::istreambuf_iterator<char>(patches), {}) == patches_text(c));
    CHECK(std::string(std::istreambuf_iterator<char>(expected), {}) == expected_text(c));
  }
  CHECK(files > 0);
}

TEST_CASE("family: coordinates mapped by dyadic numbers are doubles") {
  random_pairs::Generator generator(3);
  const auto image = [&](const ExactCase& c) { return case_changes().back().apply(c, generator); };
  CHECK(in_doubles(image(families::cap(Rational(1, 16), Plane::square))));
  CHECK(in_doubles(image(families::crossing(Plane::bilinear))));
  CHECK(in_doubles(image(families::tangent_curve(Rational(1, 4), Plane::quadratic))));
  CHECK_FALSE(in_doubles(families::tangent_curve(Rational(1, 3), Plane::square)));
}

}  // namespace exsect::families_test
