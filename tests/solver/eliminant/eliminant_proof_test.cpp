// The second proof of completeness: known curves against the turning eliminant and fibres.
#include "eliminant/eliminant_proof.h"

#include <exsect/solver/intersect.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/turning_eliminant.h>

#include <algorithm>
#include <stdexcept>

#include "confirmed_curves.h"
#include "eliminant/ball_eliminant.h"
#include "eliminant/critical_values.h"
#include "filter/filter.h"
#include "intersect_exactly.h"
#include "support/catch.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"

namespace exsect::eliminant_proof_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;
using Family = Pair (*)(Generator&);

std::optional<IntersectResult> confirmed(const BezierPatch& x, const BezierPatch& y) {
  ExactPair pair(x, y);
  return confirmed_curves(x, y, {}, pair);
}

FibreCount exact_count(const Pair& pair, Parameter sweep) {
  return [&pair, sweep](const RationalInterval& at) -> std::optional<std::size_t> {
    const LinePoints line = line_points(pair.x, pair.y, {sweep, at.midpoint()});
    CHECK_FALSE(line.incomplete);
    return line.points.size();
  };
}

FibreCount always(std::size_t count) {
  return [count](const RationalInterval&) { return std::optional(count); };
}

std::vector<EliminantRoot> roots_at(const std::vector<Rational>& values) {
  std::vector<EliminantRoot> result;
  for (const Rational& value : values) result.push_back({{value, value}});
  return result;
}

Stations loop_between(const Rational& a, const Rational& b) {
  const Rational width(1, 1000);
  return {{{a - width, a + width}, {b - width, b + width}}, true};
}

/// The proof with curve k left out.
bool is_proved_without(std::size_t k, const Pair& pair, Parameter sweep,
                       const std::vector<EliminantRoot>& roots, std::vector<Stations> curves) {
  curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(k));
  return no_curve_is_missing(roots, curves, exact_count(pair, sweep));
}

/// Of the turning eliminant, from exact coefficients; empty where these are not all simple.
std::vector<EliminantRoot> exact_roots(const Pair& pair, Parameter sweep) {
  std::vector<EliminantRoot> roots;
  const auto turning = turning_values(pair.x, pair.y, sweep);
  REQUIRE(turning);
  for (const TurningValue& turn : turning->values) {
    REQUIRE(turn.multiplicity == 1);
    roots.push_back({turn.value.refined_to(power_of_two(-40)).interval()});
  }
  return roots;
}

/// The number of closed curves looked at.
std::size_t check_pair(const Pair& pair, Parameter sweep) {
  const auto found = filtered_curves(pair.x, pair.y, {});
  if (!found) return 0;
  const std::vector<Stations>& curves = found->stations[index(sweep)];
  const std::vector<EliminantRoot> roots = exact_roots(pair, sweep);
  CHECK(no_curve_is_missing(roots, curves, exact_count(pair, sweep)));
  std::size_t closed = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (!curves[k].closed) continue;
    ++closed;
    CHECK_THROWS_AS(is_proved_without(k, pair, sweep, roots, curves), std::logic_error);
  }
  return closed;
}

using Roots = std::optional<std::vector<RationalInterval>>;

Roots roots_by_leading_bits(const Pair& pair) {
  const auto enclosed = enclosed_turning_eliminant(pair.x, pair.y);
  return enclosed ? isolate_enclosed_roots(*enclosed) : std::nullopt;
}

Roots roots_by_values(const Pair& pair) { return turning_roots_in_balls(integer_pair(pair.x, pair.y)); }

/// The enclosed eliminant has the roots of the exact one.
bool check_enclosure(const Pair& pair, Roots (*enclosed_roots)(const Pair&)) {
  const Roots intervals = enclosed_roots(pair);
  if (!intervals) return false;
  const auto turning = turning_values(pair.x, pair.y, Parameter::u).value();
  REQUIRE(intervals->size() == turning.values.size());
  for (std::size_t i = 0; i < intervals->size(); ++i) {
    CHECK(turning.values[i].value.compare((*intervals)[i].lower) > 0);
    CHECK(turning.values[i].value.compare((*intervals)[i].upper) < 0);
  }
  return true;
}

/// The boxes of boundary points have width zero where those of the sweep do; their number.
std::size_t check_rational_values(const Pair& pair) {
  IntersectOptions options;
  options.exact = true;
  const IntersectResult a = intersect(pair.x, pair.y, options);
  const IntersectResult b = intersect_exactly(pair.x, pair.y, options);
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
  const FibreCount none = [&](const RationalInterval& sample) {
    samples.push_back(sample.lower);
    return std::optional<std::size_t>(0);
  };
  CHECK(no_curve_is_missing(roots_at({}), {}, none));
  CHECK(no_curve_is_missing(roots_at({half}), {}, none));
  CHECK(samples.empty());
  CHECK(no_curve_is_missing(roots_at({third, half, most}), {}, none));
  REQUIRE(samples.size() == 2);
  CHECK((third < samples[0] && samples[0] < half && half < samples[1] && samples[1] < most));
  CHECK_THROWS_AS(no_curve_is_missing(roots_at({third, half}), {}, always(2)), std::logic_error);
  CHECK_FALSE(no_curve_is_missing(roots_at({third, half}), {},
                                  [](const RationalInterval&) { return std::optional<std::size_t>(); }));
}

TEST_CASE("eliminant proof: turning points and roots one to one") {
  const Rational third(1, 3), half(1, 2), most(3, 4);
  CHECK(no_curve_is_missing(roots_at({third, most}), {loop_between(third, most)}, always(7)));
  CHECK(no_curve_is_missing(roots_at({third, half, most}), {loop_between(half, most)}, always(0)));
  // Free roots on both sides of one that is taken: the arc passes the wider gap twice.
  const Rational low(1, 10), high(4, 5);
  const std::vector<Stations> arc = {{{{0, 0}, {half - low / 100, half + low / 100}, {0, 0}}, false}};
  CHECK(no_curve_is_missing(roots_at({low, half, high}), arc, always(2)));
  for (const std::size_t count : {0, 1, 3}) {
    CHECK_THROWS_AS(no_curve_is_missing(roots_at({low, half, high}), arc, always(count)), std::logic_error);
  }
  CHECK_THROWS_AS(no_curve_is_missing(roots_at({third}), {loop_between(third, most)}, always(0)),
                  std::logic_error);
  CHECK_THROWS_AS(no_curve_is_missing(roots_at({third, most}),
                                      {loop_between(third, most), loop_between(third, most)}, always(0)),
                  std::logic_error);
}

TEST_CASE("eliminant proof: open intervals that share an end, and such that are too wide") {
  const Rational low(1, 4), half(1, 2), high(3, 4);
  std::vector<Rational> samples;
  const FibreCount none = [&](const RationalInterval& sample) {
    samples.push_back(sample.lower);
    return std::optional<std::size_t>(0);
  };
  const auto roots = simple_roots({{0, low}, {low, half}, {half, high}, {high, 1}});
  CHECK(no_curve_is_missing(roots, {}, none));
  CHECK(samples == std::vector<Rational>{low, half, high});
  samples.clear();
  CHECK(no_curve_is_missing(roots, {loop_between(Rational(3, 8), Rational(5, 8))}, none));
  CHECK((samples.size() == 1 && (samples[0] == low || samples[0] == high)));
  // An arc ends where the sample would be; a turning point over one of two roots.
  const std::vector<Stations> arc = {{{{half, half}, {0, 0}}, false}};
  CHECK_FALSE(no_curve_is_missing(simple_roots({{low, half}, {half, high}}), arc, none));
  CHECK_FALSE(no_curve_is_missing(simple_roots({{low, half}, {half, high}, {high, 1}}),
                                  {loop_between(half, Rational(7, 8))}, none));
}

TEST_CASE("eliminant proof: what lies over multiple roots explains their order") {
  const Rational low(1, 4), half(1, 2), high(3, 4);
  const auto proved = [&](int order, std::size_t turns, std::size_t points, bool is_known = false) {
    const FibreCount fibre = [&](const RationalInterval& at) {
      CHECK((at.lower == half && at.upper == half));
      return is_known ? std::optional<std::size_t>(1) : std::nullopt;
    };
    std::vector<Stations> curves;
    for (std::size_t k = 0; k < turns; ++k) curves.push_back({{{0, 0}, {half, half}, {0, 0}}, false});
    const std::vector<RationalInterval> singular(points, {half, half});
    return no_curve_is_missing({{{half, half}, order}}, curves, fibre, Parameter::u, singular);
  };
  // (14.110): k + 2 l >= m - 1.
  CHECK(proved(2, 0, 1));
  CHECK(proved(2, 1, 0));
  CHECK(proved(3, 0, 1));
  CHECK(proved(4, 2, 1));
  CHECK_FALSE(proved(2, 0, 0));
  CHECK_FALSE(proved(3, 1, 0));
  CHECK_FALSE(proved(4, 0, 1));
  // Simple points alone are over the root, but not where another one is known.
  CHECK(proved(2, 0, 0, true));
  CHECK_FALSE(proved(3, 1, 0, true));
  CHECK_THROWS_AS(proved(1, 0, 1), std::logic_error);
  CHECK_THROWS_AS(proved(2, 1, 1), std::logic_error);
  // A further curve may still turn over a root of an order that is not reached, but not over the others.
  std::size_t fibres = 0;
  const FibreCount counted = [&](const RationalInterval&) { return std::optional(fibres++ * 0); };
  const std::vector<EliminantRoot> roots = {{{low, low}, 1}, {{half, half}, 2}, {{high, high}, 1}};
  const std::vector<Stations> touch = {{{{half, half}, {half, half}}, false}};
  CHECK(no_curve_is_missing(roots, touch, counted, Parameter::u, {{half, half}}));
  CHECK(fibres == 1);
  CHECK(no_curve_is_missing({roots[0], {{half, half}, 3}, roots[2]}, touch, counted, Parameter::u,
                            {{half, half}}));
  CHECK(fibres == 3);
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

TEST_CASE("eliminant proof: enclosures show the roots of the exact eliminant") {
  int by_leading_bits = 0, by_values = 0;
  for (const Family family :
       {random_pairs::small_rationals, random_pairs::doubles, random_pairs::scattered}) {
    for (std::uint64_t seed = 600; seed < 608; ++seed) {
      INFO("seed " << seed);
      Generator generator(seed);
      const Pair pair = family(generator);
      by_leading_bits += check_enclosure(pair, roots_by_leading_bits) ? 1 : 0;
      by_values += check_enclosure(pair, roots_by_values) ? 1 : 0;
    }
  }
  CHECK(by_leading_bits >= 22);
  CHECK(by_values >= 22);
  Generator generator(1);
  const Pair graphs = random_pairs::loop(generator);  // (4.8) is not defined: two graphs over a plane
  CHECK_FALSE(check_enclosure(graphs, roots_by_leading_bits));
  CHECK_FALSE(check_enclosure(graphs, roots_by_values));
  CHECK_FALSE(enclosed_turning_roots(graphs.x, graphs.y));
}

TEST_CASE("eliminant proof: enclosed roots do not depend on the size of the coordinates") {
  Generator generator(3);
  const Pair pair = random_pairs::doubles(generator);
  const auto scaled = [](const BezierPatch& patch) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (Point& p : row) p = {p[0] * power_of_two(700), p[1] * power_of_two(-900), p[2] / 3};
    return BezierPatch(net);
  };
  const auto roots = roots_by_values(pair), same = roots_by_values({scaled(pair.x), scaled(pair.y)});
  REQUIRE(roots);
  REQUIRE(same);
  REQUIRE(roots->size() == same->size());
  for (std::size_t i = 0; i < roots->size(); ++i) {
    CHECK((*roots)[i].lower < (*same)[i].upper);
    CHECK((*same)[i].lower < (*roots)[i].upper);
  }
}

TEST_CASE(
    "eliminant proof: exact mode agrees with the sweep, also where it goes through exact coefficients") {
  for (const Family family : {random_pairs::small_rationals, random_pairs::scattered, random_pairs::loop}) {
    for (std::uint64_t seed = 700; seed < 704; ++seed) {
      INFO("seed " << seed);
      Generator generator(seed);
      const Pair pair = family(generator);
      const auto found = confirmed(pair.x, pair.y);
      if (!found) continue;
      CHECK(found->status == Status::complete);
      CHECK(difference(found->graph, intersect_exactly(pair.x, pair.y, {}).graph, {}) == "");
    }
  }
  Generator generator(700);
  const Pair pair = random_pairs::doubles(generator);
  CHECK(confirmed(pair.x, pair.y));
  CHECK_FALSE(confirmed(pair.x, pair.x));
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

}  // namespace exsect::eliminant_proof_test
