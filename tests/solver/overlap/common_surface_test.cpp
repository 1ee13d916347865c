// When two patches lie on one surface, and where a common sheet is certified.
#include "overlap/common_surface.h"

#include <algorithm>

#include "overlap/common_sheet.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::common_surface_test {
namespace {

Rational q(int a, int b) { return {a, b}; }

SearchRegion region(const std::array<double, 4>& centre, const std::array<double, 4>& half) {
  SearchRegion result{};
  for (std::size_t j = 0; j < 4; ++j) {
    result.lower[j] = centre[j] - half[j];
    result.upper[j] = centre[j] + half[j];
  }
  return result;
}

TEST_CASE("random patches have no surface in common, pieces of one patch do") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    const random_pairs::Pair pair = random_pairs::scattered(generator);
    CHECK(!CommonSurface::of(pair.x, pair.y));
    const BezierPatch piece = pair.x.restricted_to(q(1, 5), q(6, 5), q(-1, 3), q(1, 2));
    for (const BezierPatch& y : {piece, piece.exchanged(), piece.reversed_first()}) {
      const auto surface = CommonSurface::of(pair.x, y);
      REQUIRE(surface);
      CHECK(!surface->planar());
      CHECK(CommonSurface::of(y, pair.x));
    }
  }
}

TEST_CASE("points of the common surface correspond exactly") {
  random_pairs::Generator generator(3);
  const BezierPatch x = random_pairs::scattered(generator).x;
  // u = 1/5 + r, v = -1/3 + 5/6 s.
  const auto surface = CommonSurface::of(x, x.restricted_to(q(1, 5), q(6, 5), q(-1, 3), q(1, 2)));
  REQUIRE(surface);
  const Rational e = power_of_two(-20);
  const Rational v = q(-1, 3) + q(5, 6) * q(3, 4);
  CHECK(surface->has_point(q(1, 2), q(3, 4), {q(3, 10) - e, q(3, 10) + e}, {v - e, v + e}));
  CHECK(!surface->has_point(q(1, 2), q(3, 4), {q(3, 10) + e, q(3, 10) + 2 * e}, {v - e, v + e}));
  CHECK(!surface->has_point(q(1, 2), q(3, 4), {q(3, 10) - e, q(3, 10) + e}, {v + e, v + 2 * e}));
  // r = u - 1/5 for every s on this line: r given, s is any, v follows.
  CHECK(surface->has_point_at_r(q(1, 2), q(3, 10) + e, {q(3, 4) - e, q(3, 4) + e}, {v - e, v + e}) == false);
}

TEST_CASE("collapsed sides at one point are no common surface") {
  // u (1, v, u) and r (1, 2 s, -r): both sides u = 0, r = 0 are the origin.
  ControlNet a;
  ControlNet b;
  for (auto* net : {&a, &b})
    for (auto& row : *net) row.fill(Point{0, 0, 0});
  a[1][0] = {1, 0, 0};
  a[1][1] = {0, 1, 0};
  a[2][0] = {0, 0, 1};
  b[1][0] = {1, 0, 0};
  b[1][1] = {0, 2, 0};
  b[2][0] = {0, 0, -1};
  CHECK(!CommonSurface::of(BezierPatch::from_power_basis(a), BezierPatch::from_power_basis(b)));
}

TEST_CASE("a sheet is certified where the patches are one, and its derivatives are those of the map") {
  random_pairs::Generator generator(4);
  const BezierPatch x = random_pairs::small_rationals(generator).x;
  const BezierPatch y = x.restricted_to(q(1, 4), q(5, 4), q(-1, 4), q(1, 4));  // r = u - 1/4, s = 2 v + 1/2
  const ModelScale scale = model_scale(x, y);
  const CommonSheets sheets(x, y, scale, *CommonSurface::of(x, y));
  const double h = 1.0 / 256;
  const auto sheet = sheets.certify(region({0.5, 0.125, 0.25, 0.75}, {h, h, h, 2 * h}));
  REQUIRE(sheet);
  const double expected[2][2] = {{1, 0}, {0, 2}};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t l = 0; l < 2; ++l) {
      const DoubleBall difference = sheet->derivative[k][l] - DoubleBall(expected[k][l]);
      CHECK(difference.certain_sign() == 0);
      CHECK(difference.upper_magnitude() < 0.5);
    }
  CHECK(sheets.settles(region({0.5, 0.125, 0.25, 0.75}, {h, h, h, 2 * h})));
  // The other patch moved by 2^-40: no common surface; the sheets of the first pair are none of the second.
  ControlNet moved = y.net();
  for (auto& row : moved)
    for (Point& p : row) p[2] += power_of_two(-40);
  const CommonSheets wrong(x, BezierPatch(moved), scale, *CommonSurface::of(x, y));
  CHECK(!CommonSurface::of(x, BezierPatch(moved)));
}

TEST_CASE("two parts of a folded side are no common sheet") {
  // The line u = 0 is straight and turns back at v = 1: x(0,v) = x(0,2-v), but no sheet contains such pairs.
  ControlNet net;
  net[0] = {Point{0, -2, 2}, Point{-2, 1, -2}, Point{-2, 1, -2}};
  net[1] = {Point{-1, -2, 1}, Point{1, 1, 1}, Point{-2, 2, 0}};
  net[2] = {Point{1, -1, -1}, Point{1, 1, 2}, Point{1, 2, -2}};
  const BezierPatch x(net);
  const BezierPatch y = x.restricted_to(0, 1, q(1, 2), q(3, 2));  // r = u, s = v - 1/2
  const CommonSheets sheets(x, y, model_scale(x, y), *CommonSurface::of(x, y));
  for (const double v : {0.625, 0.75}) {
    for (const double h : {0x1p-6, 0x1p-9, 0x1p-13}) {
      CHECK(sheets.certify(region({0, v, 0, v - 0.5}, {h, h, h, h})));
      CHECK_FALSE(sheets.certify(region({0, v, 0, 1.5 - v}, {h, h, h, h})));
    }
  }
}

TEST_CASE("a graph over a rectangle holds the points over it, well inside") {
  // (u, v, u v) and (r, s (1 + r), 0): r = u, s = v / (1 + u) where the first two coordinates agree.
  ControlNet a{}, b{};
  for (ControlNet* net : {&a, &b}) (*net)[1][0][0] = (*net)[0][1][1] = 1;
  a[1][1][2] = b[1][1][1] = 1;
  const BezierPatch x = BezierPatch::from_power_basis(a);
  const BezierPatch y = BezierPatch::from_power_basis(b);
  const PairSystem<DoubleBall> system(x, y, {0, 0, 0}, 0);
  const std::array<double, 4> centre = {0.5, 0.25, 0.5, 0.16};
  for (const double half : {0.0625, 0x1p-10, 0x1p-30}) {
    const auto graph = graph_over(system, region(centre, {half, half, 0, 0}));
    REQUIRE(graph);
    const Rational size = from_double(half);
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1}) {
        const std::array<Rational, 2> at = {q(1, 2) + i * size, q(1, 4) + j * size};
        const std::array<Rational, 2> image = {at[0], at[1] / (1 + at[0])};
        for (std::size_t k = 0; k < 2; ++k) {
          CHECK(graph->range[k].lower < image[k] - size / 64);
          CHECK(image[k] + size / 64 < graph->range[k].upper);
          CHECK(graph->range[k].width() < 16 * size + power_of_two(-5));
        }
        // b -> b + C(x - y(b)) brings the centre of the range nearer to the image, as is promised.
        const std::array<Rational, 2> start = {graph->range[0].midpoint(), graph->range[1].midpoint()};
        const Point d = x(at[0], at[1]) - y(start[0], start[1]);
        Rational before = 0, after = 0;
        for (std::size_t k = 0; k < 2; ++k) {
          Rational step = 0;
          for (std::size_t l = 0; l < 3; ++l) step += from_double(graph->combination[k][l]) * d[l];
          const Rational width = from_double(graph->width[k]);
          before = std::max<Rational>(before, abs(start[k] - image[k]) / width);
          after = std::max<Rational>(after, abs(start[k] + step - image[k]) / width);
        }
        CHECK(after <= from_double(graph->contraction) * before);
      }
  }
  CHECK_FALSE(graph_over(system, region({0.5, 0.25, 0.5, 0.16}, {4, 4, 0, 0})));
}

}  // namespace
}  // namespace exsect::common_surface_test
