// Points of a parameter line from its eliminant in balls, against the eliminant over the integers.
#include "line/enclosed_line_points.h"

#include <stdexcept>

#include "line/exact_line_points.h"
#include "line_shapes.h"
#include "support/line_checks.h"
#include "support/random_pairs.h"

namespace exsect::enclosed_line_points_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;

/// 1 if balls decide the line, and then its points are the exact ones; the number of these in `points`.
std::size_t check_line(const Pair& pair, const LineQuery& query, std::size_t& points) {
  CAPTURE(index(query.fixed), query.value);
  const auto enclosed = enclosed_line_points(pair.x, pair.y, query);
  if (!enclosed) return 0;
  line_checks::check_same_points(*enclosed, exact_line_points(pair.x, pair.y, query), -50);
  points += enclosed->points.size();
  return 1;
}

}  // namespace

TEST_CASE("line in balls: the exact points on random pairs, in every parameter", "[enclosed_line_points]") {
  const std::vector<Rational> values = {0, Rational(1, 3), Rational(1, 2), Rational(17, 1000), 1};
  std::size_t points = 0, decided = 0, lines = 0;
  for (std::uint64_t seed = 8300; seed < 8360; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = seed % 3 == 0   ? random_pairs::small_rationals(generator)
                      : seed % 3 == 1 ? random_pairs::doubles(generator)
                                      : random_pairs::loop(generator);
    for (const Parameter fixed : {Parameter::u, Parameter::v, Parameter::r, Parameter::s}) {
      decided += check_line(pair, {fixed, values[seed % values.size()]}, points);
      ++lines;
    }
  }
  CHECK(points >= 30);
  CHECK(decided >= lines * 9 / 10);
}

TEST_CASE("line in balls: what they do not decide is exact", "[enclosed_line_points]") {
  Generator generator(8100);
  const Pair pair = random_pairs::small_rationals(generator);
  INFO("a line on the other patch, a common corner, a folded or straight line, coordinates out of range");
  CHECK_FALSE(enclosed_line_points(pair.x, pair.x, {Parameter::u, 0}));
  CHECK_FALSE(enclosed_line_points(pair.x, pair.x.reversed_first(), {Parameter::v, Rational(1, 3)}));
  ControlNet net = pair.x.net();
  for (auto& row : net) row[1] = Rational(1, 2) * (row[0] + row[2]);
  CHECK_FALSE(enclosed_line_points(BezierPatch(net), pair.y, {Parameter::u, Rational(1, 3)}));
  for (auto& row : net) row[2] = row[0];
  CHECK_FALSE(enclosed_line_points(BezierPatch(net), pair.y, {Parameter::u, Rational(1, 3)}));
  ControlNet far = pair.y.net();
  for (auto& row : far)
    for (Point& p : row) p = Rational(power_of_two(400)) * p;
  CHECK_FALSE(enclosed_line_points(pair.x, BezierPatch(far), {Parameter::u, Rational(1, 2)}));
  CHECK(line_points(pair.x, BezierPatch(far), {Parameter::u, Rational(1, 2)}).points.size() ==
        exact_line_points(pair.x, BezierPatch(far), {Parameter::u, Rational(1, 2)}).points.size());
  CHECK_THROWS_AS(line_points(pair.x, pair.y, {Parameter::u, 2}), std::invalid_argument);
}

TEST_CASE("line in balls: a point on a side of the other patch is left to integers",
          "[enclosed_line_points]") {
  const PatchPair first = example("chapter9-first.json");
  std::size_t undecided = 0;
  for (int k = 0; k <= 8; ++k) {
    const LineQuery query{Parameter::u, Rational(k, 8)};
    const LinePoints exact = exact_line_points(first.x, first.y, query);
    for (const CertifiedPoint& point : exact.points) {
      // A piece of y whose side r = 0 passes the point at a distance below 2^-60.
      const Rational r = simplest_between(point.refined_to(power_of_two(-60)).box()[2].lower,
                                          point.refined_to(power_of_two(-60)).box()[2].upper);
      const BezierPatch piece = first.y.restricted_to(r, r + 1, 0, 1);
      undecided += enclosed_line_points(first.x, piece, query) ? 0 : 1;
    }
  }
  CHECK(undecided > 0);
}

}  // namespace exsect::enclosed_line_points_test
