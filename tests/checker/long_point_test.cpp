// Places of nodes in long numbers, against their equations; certificates of such that are irrational.
#include "certificate/long_point.h"

#include <exsect/geometry/number.h>

#include "certificate_changes.h"
#include "support/graph_patches.h"

namespace exsect::long_point_test {
namespace {

using namespace certificates;
using testing::graph;
using testing::Terms;

constexpr int kBits = 1220;
const Rational kTiny = power_of_two(20 - kBits);

Rational q(long a, long b) { return Rational(a, b); }

Node node_near(const std::array<double, 4>& at, const std::vector<std::size_t>& exact = {}) {
  Node node = {};
  node.approx = at;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational middle = from_double(at[i]), radius = power_of_two(-40);
    node.box[i] = {middle - radius, middle + radius};
  }
  for (const std::size_t i : exact) node.box[i] = {from_double(at[i]), from_double(at[i])};
  return node;
}

/// (u, d + e u + f u^2, 0) + v (0, 1/3, 1 + u / 3), and (s, a + b s + c s^2, 0) + r (0, 1, 1/2), in
/// coordinates none of which is 0 on both sides v = 0 and r = 0: a curve goes inside where u = s is a root of
/// (c - f) t^2 + (b - e) t + a - d.
struct Corner {
  std::array<Rational, 3> x;
  std::array<Rational, 3> y;

  static Point turned(const Point& p) { return {p[0] + p[2], p[1] - p[2], p[1] + p[2]}; }
  static std::vector<Point> side(const std::array<Rational, 3>& c, const std::array<Rational, 3>& off) {
    const std::array<Rational, 3> heights = {c[0], c[0] + c[1] / 2, c[0] + c[1] + c[2]};
    std::vector<Point> result;
    for (long i = 0; i < 3; ++i)
      result.push_back(
          turned({q(i, 2), heights[static_cast<std::size_t>(i)] + off[0], off[1] + i * off[2] / 2}));
    return result;
  }
  RationalPatch first() const {
    const std::vector<Point> low = side(x, {}), high = side(x, {q(1, 3), 1, q(1, 3)});
    return RationalPatch({{low[0], high[0]}, {low[1], high[1]}, {low[2], high[2]}});
  }
  RationalPatch second() const { return RationalPatch({side(y, {}), side(y, {1, q(1, 2), 0})}); }
  /// The monic polynomial.
  std::array<Rational, 3> root() const {
    const Rational leading = y[2] - x[2];
    return {(y[0] - x[0]) / leading, (y[1] - x[1]) / leading, 1};
  }
};

Rational value(const std::array<Rational, 3>& f, const Rational& t) { return f[0] + t * (f[1] + t * f[2]); }

}  // namespace

TEST_CASE("a corner that is irrational is found to many digits") {
  const Corner corner = {{0, 0, 1}, {q(1, 2), 0, 0}};  // u^2 = 1/2
  const cli::ExactMap map = cli::equation_of({corner.first(), corner.second()});
  const auto place =
      cli::long_point(map, node_near({0.70710678118654752, 0, 0, 0.70710678118654752}, {1, 2}), kBits);
  REQUIRE(place);
  CHECK(abs(Rational((*place)[0] * (*place)[0] - q(1, 2))) < kTiny);
  CHECK(abs(Rational((*place)[3] - (*place)[0])) < kTiny);
  CHECK(((*place)[1] == 0 && (*place)[2] == 0));
  // Next to no solution, or to one outside of the box.
  CHECK(!cli::long_point(map, node_near({0.5, 0, 0, 0.5}, {1, 2}), kBits));
  CHECK(!cli::long_point(map, node_near({0.7071, 0, 0, 0.7071}, {1, 2}), kBits));
  // A curve of solutions is no point.
  CHECK(!cli::long_point(map, node_near({0.70710678118654752, 0, 0, 0.70710678118654752}, {}), kBits));
}

TEST_CASE("a point where the patches touch is found to many digits") {
  // The height (u + u v / 2 - 2/3)^2 + sign (v - 1/3)^2 is 0 in one point, or along two curves that cross
  // there.
  for (const int sign : {1, -1}) {
    const Terms line = {{{0, 1}, 1}, {{0, 0}, q(-1, 3)}},
                other = {{{1, 0}, 1}, {{1, 1}, q(1, 2)}, {{0, 0}, q(-2, 3)}};
    const Terms factor = {{{0, 0}, sign}};
    const BezierPatch x = graph(other * other + factor * line * line), y = graph({});
    const cli::ExactMap map = cli::equation_of({x, y});
    const auto place = cli::long_point(map, node_near({4.0 / 7, 1.0 / 3, 4.0 / 7, 1.0 / 3}), kBits);
    REQUIRE(place);
    for (const std::size_t i : {0, 2}) CHECK(abs(Rational((*place)[i] - q(4, 7))) < kTiny);
    for (const std::size_t i : {1, 3}) CHECK(abs(Rational((*place)[i] - q(1, 3))) < kTiny);
    // On a whole line of such points none is told from the others.
    const cli::ExactMap flat = cli::equation_of({graph(line * line), y});
    CHECK(!cli::long_point(flat, node_near({4.0 / 7, 1.0 / 3, 4.0 / 7, 1.0 / 3}), kBits));
  }
}

TEST_CASE("curves that end in an irrational corner have certificates with the polynomial of its parameters") {
  Generator generator(404);
  INFO("seed 404");
  int found = 0;
  for (int i = 0; i < 80 && found < 8; ++i) {
    const auto number = [&] { return q(random_pairs::integer(generator, -9, 9), 7); };
    const Corner corner = {{number(), number(), number()}, {number(), number(), number()}};
    if (corner.x[2] == corner.y[2]) continue;
    const auto f = corner.root();
    if (!(value(f, 0) * value(f, 1) < 0)) continue;  // one root inside
    const Rational discriminant = f[1] * f[1] - 4 * f[0];
    const auto square = [](const Integer& n) { return sqrt(n) * sqrt(n) == n; };
    if (square(numerator(discriminant)) && square(denominator(discriminant))) continue;
    const bool exchanged = found % 2 == 1;
    const std::string text = exchanged ? certificate(corner.second(), corner.first())
                                       : certificate(corner.first(), corner.second());
    INFO(i);
    const checker::Summary summary = check_certificate(text).summary;
    CHECK(summary.open == summary.components);
    const Json json = Json::parse(text);
    REQUIRE(json["stars"].size() == 1);
    CHECK(json["stars"][0]["modulus"] == Json({to_string(f[0]), to_string(f[1]), "1"}));
    // Nothing but the root itself.
    reason(text, "$.stars[0]", [](Json& j) { j["stars"][0]["modulus"][0] = "-1/97"; });
    ++found;
  }
  CHECK(found == 8);
}

}  // namespace exsect::long_point_test
