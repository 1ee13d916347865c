// The solution in doubles where products underflow: the same graph as with exact arithmetic, or none.
#include "filter/error_bounds.h"

#include <exsect/geometry/patch_file.h>

#include <array>
#include <cmath>

#include "filter/filter.h"
#include "filter/local_forms.h"
#include "filter/pieces.h"
#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/families.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::error_bounds_test {
namespace {

using random_pairs::Generator;
using random_pairs::integer;
using random_pairs::Pair;

/// Every coordinate of every control point times its factor.
BezierPatch scaled(const BezierPatch& patch, const std::array<Rational, 3>& by) {
  ControlNet net = patch.net();
  for (auto& row : net) {
    for (Point& p : row) {
      for (std::size_t c = 0; c < 3; ++c) p[c] *= by[c];
    }
  }
  return BezierPatch(net);
}
Pair scaled(const Pair& pair, const std::array<Rational, 3>& by) {
  return {scaled(pair.x, by), scaled(pair.y, by)};
}
std::array<Rational, 3> everywhere(long exponent) {
  return {power_of_two(exponent), power_of_two(exponent), power_of_two(exponent)};
}

/// x with one control point times 2^exponent.
Pair with_one_scaled(const Pair& pair, std::size_t point, long exponent) {
  ControlNet net = pair.x.net();
  for (Rational& a : net[point / 3][point % 3]) a *= power_of_two(exponent);
  return {BezierPatch(net), pair.y};
}

/// What doubles say of the pair is complete and has this graph. True if they say anything.
bool keeps(const Pair& pair, const IntersectionGraph& graph) {
  const auto filtered = intersect_filtered(pair.x, pair.y, {});
  if (!filtered) return false;
  CHECK(filtered->status == Status::complete);
  CHECK(difference(filtered->graph, graph, {}) == "");
  return true;
}
/// The same against exact arithmetic, as far as that decides it within half a second.
bool agrees_with_exact(const Pair& pair) {
  const auto filtered = intersect_filtered(pair.x, pair.y, {});
  if (!filtered) return false;
  IntersectOptions options;
  options.max_seconds = 0.5;
  const IntersectResult exact = intersect_exactly(pair.x, pair.y, options);
  if (exact.status != Status::complete) return false;
  CHECK(difference(filtered->graph, exact.graph, {}) == "");
  return true;
}

/// A patch like a bag, its corners at zero but for (1,-1,0) and (0,0,1), times small numbers, from one to the
/// opposite one; and a piece of the plane x + y = 1/10. The normal of the diagonals is a multiple of (1,1,0).
/// If its components are 2^-1074, products with coordinates below 1/2 vanish and others do not: the sums of
/// those of the bag, whose coordinates are at most 9/20, are 0 and less, those of the other patch 2^-1074.
struct Bag {
  ControlNet x{};
  ControlNet y;

  Pair pair(const Rational& first, const Rational& second) const {
    ControlNet net = x;
    net[2][2] = {first, -first, 0};
    net[0][2] = {0, 0, -second};
    net[2][0] = {0, 0, second};
    return {BezierPatch(net), BezierPatch(y)};
  }
};
Bag bag(Generator& generator) {
  const auto twentieths = [&](long least, long most) {
    return Rational(integer(generator, least, most), 20);
  };
  Bag result;
  for (const std::size_t k : {1U, 3U, 5U, 7U}) {
    result.x[k / 3][k % 3] = {twentieths(-11, 9), twentieths(-11, 9), twentieths(-8, 8)};
  }
  // The box around both has its middle at zero, so that nothing is moved.
  result.x[1][1] = {Rational(-3, 5), Rational(-3, 5), twentieths(-8, 8)};
  const Rational inner = Rational(integer(generator, 101, 119), 200);
  const Rational sum(1, 10);
  const std::array<Rational, 3> along = {Rational(3, 5), inner, sum - Rational(3, 5)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.y[i][j] = {along[i], sum - along[i], Rational(7 * (static_cast<long>(j) - 1), 10)};
    }
  }
  return result;
}
Pair bag_with_subnormal_normal(Generator& generator) {
  const Bag made = bag(generator);
  const long first = integer(generator, 60, 1000);
  return made.pair(power_of_two(-first), power_of_two(first - integer(generator, 1073, 1077)));
}

}  // namespace

TEST_CASE("filter error bounds: a closed curve on patches whose diagonals nearly vanish") {
  struct Expected {
    const char* file;
    int turning_in_s;
  };
  for (const auto& [file, turning_in_s] :
       {Expected{"underflow-none", 2}, Expected{"underflow-subnormal", 2}, Expected{"underflow-normal", 4}}) {
    INFO(file);
    const auto patches = read_patches(EXSECT_CASES "/found/" + std::string(file) + ".json").patches;
    const Pair pair = {patches[0].patch, patches[1].patch};
    const auto filtered = intersect_filtered(pair.x, pair.y, {});
    REQUIRE(filtered);
    CHECK(filtered->graph.count(ComponentShape::closed) == 1);
    CHECK(filtered->graph.turning_points(Parameter::r) == 2);
    CHECK(filtered->graph.turning_points(Parameter::s) == turning_in_s);
    CHECK(unsound(pair.x, pair.y, *filtered) == "");
    CHECK(agrees_with_exact(pair));
  }
}

// The reference is the same bag with all its corners in one point: no normal, no underflow.
TEST_CASE("filter error bounds: bags with diagonals whose product underflows") {
  int decided = 0;
  int curves = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Bag made = bag(generator);
    const Pair closed = made.pair(0, 0);
    const auto reference = intersect_filtered(closed.x, closed.y, {});
    if (!reference) continue;
    const long first = integer(generator, 60, 1000);
    const Pair pair = made.pair(power_of_two(-first), power_of_two(first - integer(generator, 1073, 1077)));
    decided += keeps(pair, reference->graph) ? 1 : 0;
    curves += reference->graph.components.empty() ? 0 : 1;
  }
  CHECK(decided >= 100);
  CHECK(curves >= 100);
}

TEST_CASE("filter error bounds: pairs scaled by 2^-1074 to 2^1000") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = seed % 4 == 0   ? bag_with_subnormal_normal(generator)
                      : seed % 4 == 1 ? random_pairs::loop(generator)
                                      : random_pairs::doubles(generator);
    const auto graph = intersect_filtered(pair.x, pair.y, {});
    if (!graph) continue;
    for (const long exponent :
         {-1074L, -1040L, -1022L, -900L, -537L, -310L, -290L, -100L, 100L, 290L, 310L, 600L, 900L, 1000L,
          -integer(generator, 0, 1074), integer(generator, 0, 1000)}) {
      INFO("2^" << exponent);
      const bool decided = keeps(scaled(pair, everywhere(exponent)), graph->graph);
      CHECK(decided == (std::labs(exponent) < 300));
    }
  }
}

TEST_CASE("filter error bounds: single coordinates scaled by 2^-1074 to 2^1000") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = seed % 2 == 0 ? random_pairs::loop(generator) : random_pairs::doubles(generator);
    const auto graph = intersect_filtered(pair.x, pair.y, {});
    if (!graph) continue;
    for (const long exponent : {-1074L, -600L, -530L, -150L, -16L, -10L, -5L, 5L, 10L, 16L, 150L, 500L, 1000L,
                                integer(generator, -1074, 1000)}) {
      INFO("2^" << exponent);
      std::array<Rational, 3> by = {1, 1, 1};
      by[static_cast<std::size_t>(integer(generator, 0, 2))] = power_of_two(exponent);
      decided += keeps(scaled(pair, by), graph->graph) ? 1 : 0;
    }
  }
  CHECK(decided >= 40);
}

TEST_CASE("filter error bounds: single control points scaled by 2^-1074 to 2^40") {
  int decided = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = seed % 2 == 0 ? random_pairs::scattered(generator) : random_pairs::doubles(generator);
    const auto point = static_cast<std::size_t>(integer(generator, 0, 8));
    const long exponent = seed % 4 == 3   ? integer(generator, 1, 40)
                          : seed % 8 == 1 ? -integer(generator, 4, 40)
                                          : -integer(generator, 20, 1074);
    const Pair changed = with_one_scaled(pair, point, exponent);
    const auto graph = intersect_filtered(changed.x, changed.y, {});
    if (!graph) continue;
    ++decided;
    // At scales at which the small coordinates are subnormal, and at which they are not.
    CHECK(keeps(scaled(changed, everywhere(-200)), graph->graph));
    CHECK(keeps(scaled(changed, everywhere(200)), graph->graph));
    if (seed % 8 == 1) agrees_with_exact(changed);
  }
  CHECK(decided >= 8);
}

TEST_CASE("filter error bounds: double points of surfaces scaled in one coordinate") {
  const std::array<ExactCase, 3> cases = {families::cap(0, families::Plane::larger),
                                          families::crossing(families::Plane::larger),
                                          families::crossing(families::Plane::bilinear)};
  for (const ExactCase& c : cases) {
    const auto graph = intersect_filtered(c.x, c.y, {});
    if (!graph) continue;
    for (const long exponent : {-1074L, -700L, -500L, -300L, -60L, -10L, 10L, 60L, 300L, 500L, 1000L}) {
      INFO(c.name << ", 2^" << exponent);
      const Pair pair = scaled({c.x, c.y}, {1, 1, power_of_two(exponent)});
      keeps(pair, graph->graph);
      // The form is of size one, whatever the scale is.
      const auto forms = filter::local_forms<filter::Biquadratic>(
          pair.x, pair.y, {Rational(1, 2), Rational(1, 2), Rational(1, 2), Rational(1, 2)});
      if (forms)
        CHECK(std::fabs(forms->normal_x[6]) + std::fabs(forms->normal_y[6]) < filter::kGreatestCoefficient);
    }
  }
}

TEST_CASE("filter error bounds: what one operation loses by rounding and by underflow") {
  using filter::kUnderflow;
  using filter::kUnit;
  Generator generator(23);
  const auto number = [&](int exponent) {
    return std::ldexp(static_cast<double>(integer(generator, (1L << 52) + 1, (1L << 53) - 1)), exponent);
  };
  // Within the bound; whether also without the term for underflow.
  const auto is_relative = [](const Rational& exact, double computed) {
    const Rational error = abs(exact - from_double(computed));
    const Rational rounding = from_double(kUnit) * abs(exact);
    CHECK(error <= rounding + from_double(kUnderflow));
    return error <= rounding;
  };
  // A tie: 2^-1075 is lost, half of the term.
  CHECK(!is_relative(power_of_two(-1075), 0x1p-537 * 0x1p-538));
  int beyond = 0;
  for (int exponent = -1130; exponent <= -1000; ++exponent) {
    // A product and a quotient of size 2^exponent, as far as they are doubles.
    const double a = number(-400), b = number(exponent + 296), c = number(-exponent - 400);
    beyond += !is_relative(from_double(a) * from_double(b), a * b);
    beyond += !is_relative(from_double(a) / from_double(c), a / c);
  }
  CHECK(beyond > 60);
}

TEST_CASE("filter error bounds: a normal that underflows separates nothing") {
  // The points of y are inside x's bag, the normal of which has components of 2^-1074: what is left of the
  // products is rounding alone.
  ControlNet x;
  ControlNet y;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational a(static_cast<long>(i) - 1), b(static_cast<long>(j) - 1);
      x[i][j] = i == 1 || j == 1 ? Point{a / 2, b / 2, (a + b) / 3} : Point{0, 0, 0};
      y[i][j] = {Rational(1, 20), a / 2, b / 2};
    }
  }
  x[2][2] = {power_of_two(-537), -power_of_two(-537), 0};
  x[2][0] = {0, power_of_two(-537), power_of_two(-537)};
  const BezierPatch first(x);
  const BezierPatch second(y);
  const auto pair = filter::make_pair(first, second);
  REQUIRE(pair);
  const filter::PatchTree tree(pair->x);
  const filter::PatchTree other(pair->y);
  CHECK(filter::largest(tree[0].normal) < 0x1p-1060);
  CHECK(tree[0].normal_size >= filter::kTiny);
  CHECK(!filter::separated(tree[0], other[0], pair->net_error));
}

}  // namespace exsect::error_bounds_test
