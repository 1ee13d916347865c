// Certificates with stars at regular solutions: the curve touches a side, or leaves both ways at a corner, or
// ends where the parameter of a side turns.
#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect_surface.h>

#include "certificate_changes.h"

namespace exsect::certificate_regular_test {
namespace {

using namespace certificates;

using Values = std::vector<Rational>;

Rational q(int a, int b) { return Rational(a, b); }

/// (u - a, v - b, 0).
RationalPatch floor_at(const Rational& a, const Rational& b) {
  return RationalPatch({{{-a, -b, 0}, {-a, 1 - b, 0}}, {{1 - a, -b, 0}, {1 - a, 1 - b, 0}}});
}
const RationalPatch ground = floor_at(0, 0);

/// (f, g, s - 1/3 + (r - 1/2) / 5), f and g polynomials in r by their control values, equally many: its curve
/// on the ground is u = f(r), v = g(r).
RationalPatch wall(const Values& f, const Values& g) {
  std::vector<std::vector<Point>> rows;
  const int degree = static_cast<int>(f.size()) - 1;
  for (int i = 0; i <= degree; ++i) {
    const Rational height = q(2 * i - degree, 10 * degree) - q(1, 3);
    const auto n = static_cast<std::size_t>(i);
    rows.push_back({{f[n], g[n], height}, {f[n], g[n], height + 1}});
  }
  return RationalPatch(rows);
}
const Values rising = {0, q(1, 2), 1};                 // r
const Values through = {q(-1, 2), 0, q(1, 2)};         // r - 1/2
const Values falling = {q(1, 2), 0, q(-1, 2)};         // 1/2 - r
const Values outside = {q(-1, 4), q(1, 4), q(-1, 4)};  // -(r - 1/2)^2
const Values inside = {q(1, 4), q(-1, 4), q(1, 4)};    // (r - 1/2)^2
const Values from_top = {1, 1, 0};                     // 1 - r^2

/// Accepted, with stars and nothing else at these points.
checker::Summary summary(const RationalPatch& x, const RationalPatch& y, std::size_t stars) {
  const checker::Summary result = check_certificate(certificate(x, y)).summary;
  CHECK(result.claims[1] == stars);
  return result;
}

void is_isolated(const RationalPatch& x, const RationalPatch& y) {
  const checker::Summary result = summary(x, y, 1);
  CHECK(result.isolated == 1);
  CHECK(result.components == 0);
}

}  // namespace

TEST_CASE("a curve that touches a side from outside has a certificate") {
  is_isolated(ground, wall(outside, rising));
  is_isolated(wall(outside, rising), ground);
  is_isolated(ground.transposed(), wall(outside, rising));
}

TEST_CASE("a curve that leaves both ways at a corner has a certificate") {
  is_isolated(ground, wall(through, falling));
  is_isolated(wall(through, falling), ground);
  // u = (r - 1/2)^3, v = 1/2 - r.
  const RationalPatch cubic =
      wall({q(-1, 8), q(1, 8), q(-1, 8), q(1, 8)}, {q(1, 2), q(1, 6), q(-1, 6), q(-1, 2)});
  is_isolated(ground, cubic);
  CHECK(Json::parse(certificate(ground, cubic))["stars"][0]["weights"] == Json({3, 1, 1, 1}));
  // At r = 0 a side of the other patch.
  is_isolated(ground, wall(rising, {0, q(-1, 2), -1}));
}

TEST_CASE("an arc that ends where the parameter of a side turns has a certificate") {
  const checker::Summary result = summary(ground, wall({q(1, 4), q(1, 2), q(3, 4)}, from_top), 1);
  CHECK(result.open == 1);
  CHECK(result.isolated == 0);
}

TEST_CASE("a curve that touches a side from inside has a certificate") {
  const checker::Summary result = summary(ground, wall(inside, rising), 1);
  CHECK(result.components == 1);
  CHECK(result.open == 1);
  CHECK(result.claims[4] == 2);
}

TEST_CASE("a curve along a side on which another parameter turns has a certificate") {
  // The patch is folded along u = 1/2, where s turns, and r = 0 all along.
  const auto patches = read_patches(EXSECT_CASES "/fold-where-arcs-begin.json").patches;
  const RationalPatch folded = patches[0].patch;
  const RationalPatch plane = patches[1].patch;
  for (const auto& [x, y] : {std::pair(folded, plane), std::pair(plane, folded),
                             std::pair(folded.transposed(), plane), std::pair(folded, plane.transposed())}) {
    const checker::Summary result = summary(x, y, 1);
    CHECK(result.open == 1);
    CHECK(result.claims[4] == 2);
  }
}

TEST_CASE("spheres that touch the sides of a square have certificates") {
  const auto of_sphere = [](const Point& centre) {
    const ImplicitSurface sphere = ImplicitSurface::sphere(centre, q(1, 2));
    const std::string text =
        cli::certificate_text(sphere, ground, names, intersect(sphere, ground, coarse()));
    return check_certificate(text).summary;
  };
  CHECK(of_sphere({q(-1, 2), q(1, 3), 0}).isolated == 1);
  CHECK(of_sphere({q(-3, 10), q(-2, 5), 0}).isolated == 1);  // through the corner (0,0)
  const checker::Summary all = of_sphere({q(1, 2), q(1, 2), 0});
  CHECK(all.closed == 1);
  CHECK(all.claims[1] == 4);
}

TEST_CASE("a regular point is no end of a curve without a reason") {
  const std::string corner = certificate(ground, wall(through, falling));
  const std::string touch = certificate(ground, wall(outside, rising));
  // The same curves further inside: nothing but the places differs.
  const auto moved = [](Json& j, const RationalPatch& x, const RationalPatch& y) {
    const Json inside_it = Json::parse(certificate(x, y));
    for (const char* key : {"first", "factors"}) j[key] = inside_it[key];
  };
  reason(corner, "$.stars[0]: an arc may run through its point", [&](Json& j) {
    moved(j, floor_at(q(1, 2), q(1, 2)), wall(through, falling));
    j["stars"][0]["at"][0] = j["stars"][0]["at"][1] = "1/2";
  });
  reason(touch, "$.tubes[0]: no arc runs through it", [&](Json& j) {
    moved(j, floor_at(q(1, 2), 0), wall(outside, rising));
    j["stars"][0]["at"][0] = "1/2";
  });
  for (const std::string& text : {corner, touch}) {
    reason(text, "$.stars[0]: its last row is not normal", [](Json& j) { j["tubes"].erase(1); });
    reason(text, "$.", [](Json& j) { j["stars"] = Json::array(); });
    reason(text, "$.stars[0].charts", [](Json& j) { std::swap(j["tubes"][0], j["tubes"][1]); });
    reason(text, "$.", [](Json& j) { j["stars"][0]["weights"] = {2, 2, 2, 2}; });
    reason(text, "$.stars[0]", [](Json& j) { j["stars"][0]["at"][3] = "1/4"; });
    Generator generator(71);
    INFO("seed 71");
    reject_changes(text, generator, 40);
    CHECK(rejected_forgeries(text, {"stars", "tubes"}, generator, 40) > 15);
  }
}

}  // namespace exsect::certificate_regular_test
