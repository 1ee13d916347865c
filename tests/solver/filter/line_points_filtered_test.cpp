// Points of a parameter line decided in doubles against the exact ones.
#include <exsect/solver/line_patch.h>

#include "filter/line.h"
#include "line/exact_line_points.h"
#include "support/catch.h"
#include "support/line_checks.h"
#include "support/random_pairs.h"

namespace exsect::line_points_filtered_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;

void check_same_points(const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
  CAPTURE(index(query.fixed), query.value);
  line_checks::check_same_points(line_points_filtered(x, y, query), exact_line_points(x, y, query), -28);
}

/// Whether doubles decide the line u = value, given to them with this error.
bool decided(const Pair& pair, double value, double error) {
  const auto doubles = filter::make_pair(pair.x, pair.y);
  REQUIRE(doubles);
  filter::PatchTree tree(doubles->y);
  long boxes = 0;
  return filter::points_on_line(*doubles, {0, value - 0.5, error}, {}, tree, boxes).has_value();
}

}  // namespace

TEST_CASE("line in doubles: the exact points on random pairs, in every parameter", "[filter]") {
  const std::vector<Rational> values = {0, Rational(1, 3), Rational(1, 2), Rational(17, 1000), 1};
  std::size_t points = 0, decided_lines = 0;
  for (std::uint64_t seed = 8000; seed < 8040; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair =
        seed % 2 == 0 ? random_pairs::small_rationals(generator) : random_pairs::scattered(generator);
    for (const Parameter fixed : {Parameter::u, Parameter::v, Parameter::r, Parameter::s})
      check_same_points(pair.x, pair.y, {fixed, values[seed % values.size()]});
    points += line_points_filtered(pair.x, pair.y, {Parameter::u, Rational(1, 3)}).points.size();
    decided_lines += decided(pair, 1.0 / 3, 0x1p-54) ? 1 : 0;
  }
  CHECK(points >= 10);
  CHECK(decided_lines >= 38);
}

TEST_CASE("line in doubles: balls hold the points of all lines within the error", "[filter]") {
  constexpr double error = 0x1p-36;
  std::size_t found = 0;
  for (std::uint64_t seed = 8200; seed < 8220; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = random_pairs::small_rationals(generator);
    const auto doubles = filter::make_pair(pair.x, pair.y);
    REQUIRE(doubles);
    for (const double value : {-0.25, 0.3125}) {
      filter::PatchTree tree(doubles->y);
      long boxes = 0;
      const auto balls = filter::points_on_line(*doubles, {0, value, error}, {}, tree, boxes);
      if (!balls) continue;
      for (const double shift : {-error, error}) {
        const LineQuery query = {Parameter::u, from_double(value + 0.5 + shift)};
        const LinePoints exact = line_points(pair.x, pair.y, query);
        CHECK(exact.points.size() == balls->size());
        for (const CertifiedPoint& point : exact.points) {
          const bool inside = std::ranges::any_of(*balls, [&](const filter::Ball& ball) {
            return std::ranges::all_of(std::array<std::size_t, 3>{1, 2, 3}, [&](std::size_t j) {
              const Rational middle = from_double(ball.middle[j] + 0.5);
              const Rational radius = from_double(ball.radius) + power_of_two(-50);
              return point.box()[j].lower >= middle - radius && point.box()[j].upper <= middle + radius;
            });
          });
          CHECK(inside);
          ++found;
        }
      }
    }
  }
  CHECK(found >= 20);
}

TEST_CASE("line in doubles: what they do not decide is exact", "[filter]") {
  Generator generator(8100);
  const Pair pair = random_pairs::small_rationals(generator);
  // A line on the other patch, a common corner, a line outside the patch's tree of doubles.
  check_same_points(pair.x, pair.x, {Parameter::u, 0});
  check_same_points(pair.x, pair.x.reversed_first(), {Parameter::v, Rational(1, 3)});
  ControlNet far = pair.y.net();
  for (auto& row : far)
    for (Point& p : row) p = Rational(power_of_two(400)) * p;
  check_same_points(pair.x, BezierPatch(far), {Parameter::u, Rational(1, 2)});
  CHECK_THROWS_AS(line_points_filtered(pair.x, pair.y, {Parameter::u, 2}), std::invalid_argument);
}

}  // namespace exsect::line_points_filtered_test
