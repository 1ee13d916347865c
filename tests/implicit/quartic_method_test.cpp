#include <exsect/geometry/patch_file.h>
#include <exsect/implicit/quartic_method.h>

#include <algorithm>

#include "support/catch.h"

namespace exsect::quartic_method_test {
namespace {

struct Patches {
  BezierPatch x;
  BezierPatch y;
};
Patches first_example() {
  const PatchFile file = read_patches(EXSECT_EXAMPLES "/chapter9-first.json");
  return {file.patches[0].patch, file.patches[1].patch};
}

TEST_CASE("quartics: bad options", "[quartic_method]") {
  const auto [x, y] = first_example();
  CHECK_THROWS_AS(intersect_by_quartics(x, y, {PatchFit::conics, -1, 6}, {}), std::invalid_argument);
  CHECK_THROWS_AS(intersect_by_quartics(x, y, {PatchFit::conics, 4, 6}, {}), std::invalid_argument);
  CHECK_THROWS_AS(intersect_by_quartics(x, y, {PatchFit::conics, 1, 2}, {}), std::invalid_argument);
  CHECK_THROWS_AS(intersect_by_quartics(x, y, {PatchFit::conics, 1, 9}, {}), std::invalid_argument);
}

TEST_CASE("every exact point lies in a region of the quartics", "[quartic_method]") {
  const auto [x, y] = first_example();
  const std::vector<CheckLine> lines = check_lines(x, y, 12);
  for (const PatchFit fit : {PatchFit::dokken, PatchFit::conics}) {
    const int boxes = 5;
    // one quartic for the whole patch is far from the patch: its bound matters
    const bool whole = fit == PatchFit::conics;
    const QuarticMethod method = intersect_by_quartics(x, y, {fit, whole ? 0 : 1, boxes}, lines);
    CHECK(method.pieces.size() == (whole ? 1 : 4));
    CHECK(method.pieces[0].composed.degree_r() == 8);
    CHECK(method.pieces[0].composed.degree_s() == 8);
    const Rational size(1, 1 << boxes);
    for (const CheckLine& line : lines)
      for (const CertifiedPoint& point : line.points) {
        const Rational v = point.box()[index(Parameter::v)].midpoint();
        const bool covered =
            std::any_of(method.regions.begin(), method.regions.end(), [&](const QuarticRegion& region) {
              return !region.is_phantom &&
                     std::any_of(region.boxes.begin(), region.boxes.end(),
                                 [&](const std::array<int, 2>& box) {
                                   return box[0] * size <= line.u && line.u <= (box[0] + 1) * size &&
                                          box[1] * size <= v && v <= (box[1] + 1) * size;
                                 });
            });
        CHECK(covered);
      }
    std::size_t exact = 0;
    for (const CheckLine& line : lines) exact += line.points.size();
    CHECK(method.check.points == exact);
    CHECK(method.check.missed <= exact);
  }
}

TEST_CASE("patches far apart leave no region", "[quartic_method]") {
  const auto [x, y] = first_example();
  ControlNet net = y.net();
  for (auto& row : net)
    for (Point& p : row) p[2] += 5;
  const QuarticMethod method = intersect_by_quartics(x, BezierPatch(net), {PatchFit::dokken, 0, 4}, {});
  CHECK(method.regions.empty());
}

}  // namespace
}  // namespace exsect::quartic_method_test
