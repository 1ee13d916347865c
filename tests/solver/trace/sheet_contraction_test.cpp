#include "trace/sheet_contraction.h"

#include "support/known_curves.h"

namespace exsect::sheet_contraction_test {
namespace {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the known curves

SearchRegion around(const std::array<double, 4>& w, double reach) {
  SearchRegion region{};
  for (std::size_t j = 0; j < 4; ++j) {
    region.lower[j] = w[j] - reach;
    region.upper[j] = w[j] + reach;
  }
  return region;
}

/// (u + v^2 / 4, v + u v / 2, 0) and the plane (r, s, 0): r and s are these polynomials.
PairSystem<DoubleBall> curved_in_the_plane() {
  ControlNet c{};
  c[1][0] = {1, 0, 0};
  c[0][2] = {q(1, 4), 0, 0};
  c[0][1] = {0, 1, 0};
  c[1][1] = {0, q(1, 2), 0};
  return {BezierPatch::from_power_basis(c), plane_patch(), Point{0, 0, 0}, 0};
}

constexpr double kReach = 0x1p-5;
constexpr double kU = 0.25, kV = 0.5, kR = kU + kV * kV / 4, kS = kV + kU * kV / 2;

}  // namespace

TEST_CASE("sheet contraction: the derivatives of the sheet over a region", "[trace]") {
  const auto system = curved_in_the_plane();
  SheetContraction sheet(around({kU, kV, kR, kS}, kReach));
  REQUIRE(sheet.find_centre(system));
  CHECK(sheet.is_near());
  REQUIRE(sheet.contracts());
  CHECK(sheet.contraction() < 1e-9);  // y is affine: E is rounding alone
  CHECK(sheet.is_regular());
  CHECK_FALSE(sheet.leaves_region());
  CHECK(sheet.w0[0] == Approx(kR));
  CHECK(sheet.w0[1] == Approx(kS));
  const auto d = sheet.first_derivatives();
  for (const double a : {-kReach, 0.0, kReach})
    for (const double b : {-kReach, 0.25 * kReach, kReach}) {
      const double u = kU + a, v = kV + b;
      CHECK(encloses(d[0][0], q(1)));
      CHECK(encloses(d[0][1], from_double(v / 2)));
      CHECK(encloses(d[1][0], from_double(v / 2)));
      CHECK(encloses(d[1][1], from_double(1 + u / 2)));
      CHECK(std::fabs(u + v * v / 4 - sheet.w0[0]) <= sheet.image[0]);
      CHECK(std::fabs(v + u * v / 2 - sheet.w0[1]) <= sheet.image[1]);
    }
  CHECK(d[0][1].radius() < kReach);
}

TEST_CASE("sheet contraction: a sheet that leaves the region is seen to", "[trace]") {
  const auto system = curved_in_the_plane();
  // From r = 7/16, which is farther from the sheet over this region than the region is wide.
  SheetContraction sheet(around({kU, kV, kR + 0.125, kS}, kReach));
  REQUIRE(sheet.find_centre(system));
  REQUIRE(sheet.contracts());
  CHECK(sheet.leaves_region());
  const auto graph = sheet.graph();
  REQUIRE(graph);
  CHECK(graph->range[0].lower < from_double(kR));
  CHECK(from_double(kR) < graph->range[0].upper);
}

TEST_CASE("sheet contraction: none where y' is singular, and none for a wide curved y", "[trace]") {
  ControlNet c{};
  c[2][0][0] = 1;  // (r^2, s, 0)
  c[0][1][1] = 1;
  const PairSystem<DoubleBall> system(plane_patch(), BezierPatch::from_power_basis(c), Point{0, 0, 0}, 0);
  SheetContraction singular(around({0.0625, 0.5, 0, 0.5}, 0x1p-8));
  CHECK_FALSE(singular.find_centre(system));
  SheetContraction narrow(around({0.25, 0.5, 0.5, 0.5}, 0x1p-6));
  REQUIRE(narrow.find_centre(system));
  CHECK(narrow.contracts());
  CHECK(narrow.contraction() > 0);
  SheetContraction wide(around({0.25, 0.5, 0.5, 0.5}, 0.5));
  REQUIRE(wide.find_centre(system));
  CHECK_FALSE(wide.contracts());  // r = 0, where y is singular, is in the region
}

TEST_CASE("sheet contraction: where x folds in the direction of the sheet it is not regular", "[trace]") {
  ControlNet c{};
  c[2][0][0] = 1;  // (u^2, v, 0)
  c[0][1][1] = 1;
  const PairSystem<DoubleBall> system(BezierPatch::from_power_basis(c), plane_patch(), Point{0, 0, 0}, 0);
  for (const auto& [u, regular] : {std::pair(0.0, false), std::pair(0.5, true)}) {
    SheetContraction sheet(around({u, 0.5, u * u, 0.5}, 0x1p-6));
    REQUIRE(sheet.find_centre(system));
    REQUIRE(sheet.contracts());
    CHECK(sheet.is_regular() == regular);
  }
}

}  // namespace exsect::sheet_contraction_test
