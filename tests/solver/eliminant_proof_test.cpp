// The second proof of completeness: known curves against the turning eliminant and fibres.
#include "../../solver/eliminant_proof.h"

#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <stdexcept>

#include "../../solver/filter.h"
#include "../../solver/intersect_by_sweep.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;
using Family = Pair (*)(Generator&);

FibreCount exact_count(const Pair& pair, Parameter sweep) {
  return [&pair, sweep](const Rational& sample) -> std::optional<std::size_t> {
    const LinePoints line = line_points(pair.x, pair.y, {sweep, sample});
    CHECK_FALSE(line.incomplete);
    return line.points.size();
  };
}

FibreCount always(std::size_t count) {
  return [count](const Rational&) { return std::optional(count); };
}

TurningValues simple_roots(const std::vector<Rational>& values) {
  TurningValues result{Parameter::u, {}};
  for (const Rational& value : values) result.values.push_back({value, 1});
  return result;
}

Stations loop_between(const Rational& a, const Rational& b) {
  const Rational width(1, 1000);
  return {{{a - width, a + width}, {b - width, b + width}}, true};
}

/// The proof with curve k left out.
bool is_proved_without(std::size_t k, const Pair& pair, const TurningValues& turning,
                       std::vector<Stations> curves) {
  curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(k));
  return no_curve_is_missing(turning, curves, exact_count(pair, turning.sweep));
}

/// The number of closed curves looked at.
std::size_t check_pair(const Pair& pair, Parameter sweep) {
  const auto found = filtered_curves(pair.x, pair.y, {});
  const auto turning = turning_values(pair.x, pair.y, sweep);
  if (!found || !turning) return 0;
  const std::vector<Stations>& curves = found->stations[index(sweep)];
  CHECK(no_curve_is_missing(*turning, curves, exact_count(pair, sweep)));
  std::size_t closed = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (!curves[k].closed) continue;
    ++closed;
    CHECK_THROWS_AS(is_proved_without(k, pair, *turning, curves), std::logic_error);
  }
  return closed;
}

/// The boxes of boundary points have width zero where those of the sweep do; their number.
std::size_t check_rational_values(const Pair& pair) {
  IntersectOptions options;
  options.exact = true;
  const IntersectResult a = intersect(pair.x, pair.y, options);
  const IntersectResult b = intersect_by_sweep(pair.x, pair.y, options);
  CHECK(difference(a.graph, b.graph, {}) == "");
  std::size_t count = 0;
  for (const Node& node : b.graph.nodes) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (node.on.empty() || node.box[j].width() != 0 || index(node.on.front().parameter) == j) continue;
      ++count;
      CHECK(std::any_of(a.graph.nodes.begin(), a.graph.nodes.end(), [&](const Node& other) {
        return other.on == node.on && other.box[j].lower == node.box[j].lower && other.box[j].width() == 0;
      }));
    }
  }
  return count;
}

}  // namespace

TEST_CASE("eliminant proof: samples between roots that belong to no known curve") {
  const Rational third(1, 3), half(1, 2), most(3, 4);
  std::vector<Rational> samples;
  const FibreCount none = [&](const Rational& sample) {
    samples.push_back(sample);
    return std::optional<std::size_t>(0);
  };
  CHECK(no_curve_is_missing(simple_roots({}), {}, none));
  CHECK(no_curve_is_missing(simple_roots({half}), {}, none));
  CHECK(samples.empty());
  CHECK(no_curve_is_missing(simple_roots({third, half, most}), {}, none));
  REQUIRE(samples.size() == 2);
  CHECK((third < samples[0] && samples[0] < half && half < samples[1] && samples[1] < most));
  CHECK_THROWS_AS(no_curve_is_missing(simple_roots({third, half}), {}, always(2)), std::logic_error);
  CHECK_FALSE(no_curve_is_missing(simple_roots({third, half}), {},
                                  [](const Rational&) { return std::optional<std::size_t>(); }));
}

TEST_CASE("eliminant proof: turning points and roots one to one") {
  const Rational third(1, 3), half(1, 2), most(3, 4);
  CHECK(no_curve_is_missing(simple_roots({third, most}), {loop_between(third, most)}, always(7)));
  CHECK(no_curve_is_missing(simple_roots({third, half, most}), {loop_between(half, most)}, always(0)));
  // Free roots on both sides of one that is taken: the arc passes the wider gap twice.
  const Rational low(1, 10), high(4, 5);
  const std::vector<Stations> arc = {{{{0, 0}, {half - low / 100, half + low / 100}, {0, 0}}, false}};
  CHECK(no_curve_is_missing(simple_roots({low, half, high}), arc, always(2)));
  for (const std::size_t count : {0, 1, 3}) {
    CHECK_THROWS_AS(no_curve_is_missing(simple_roots({low, half, high}), arc, always(count)),
                    std::logic_error);
  }
  CHECK_THROWS_AS(no_curve_is_missing(simple_roots({third}), {loop_between(third, most)}, always(0)),
                  std::logic_error);
  CHECK_THROWS_AS(no_curve_is_missing(simple_roots({third, most}),
                                      {loop_between(third, most), loop_between(third, most)}, always(0)),
                  std::logic_error);
}

TEST_CASE("eliminant proof: what it leaves to the sweep") {
  const Rational third(1, 3), most(3, 4);
  TurningValues twice = simple_roots({third, most});
  twice.values[0].multiplicity = 2;
  CHECK_FALSE(no_curve_is_missing(twice, {}, always(0)));
  TurningValues touching = simple_roots({});
  touching.touching = true;
  CHECK_FALSE(no_curve_is_missing(touching, {}, always(0)));
  // Two roots in the enclosure of one turning point.
  const Rational close = third + power_of_two(-20);
  CHECK_FALSE(
      no_curve_is_missing(simple_roots({third, close, most}), {loop_between(third, most)}, always(0)));
}

TEST_CASE("eliminant proof: random pairs along all parameters, and with a closed curve left out") {
  std::size_t closed = 0;
  for (const Family family :
       {random_pairs::small_rationals, random_pairs::doubles, random_pairs::scattered, random_pairs::loop}) {
    for (std::uint64_t seed = 500; seed < 504; ++seed) {
      INFO("seed " << seed);
      Generator generator(seed);
      const Pair pair = family(generator);
      for (const Parameter sweep : all_parameters) closed += check_pair(pair, sweep);
    }
  }
  CHECK(closed >= 12);
}

TEST_CASE("eliminant proof: rational boundary points are known as such") {
  std::size_t rational = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair = random_pairs::small_rationals(generator);
    const Point to = pair.x(0, Rational(1, 2)), from = pair.y(Rational(1, 2), Rational(1, 4));
    random_pairs::AffineMap shift{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}};
    for (std::size_t c = 0; c < 3; ++c) shift.translation[c] = to[c] - from[c];
    rational += check_rational_values({pair.x, shift(pair.y)});
  }
  CHECK(rational >= 3);
}

}  // namespace exsect
