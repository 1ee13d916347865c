// replay_self FAMILY FIRST COUNT: random patches of bidegrees up to (3,3) with and without weights against
// themselves, and their images under maps that keep the pairs of parameters or change them in a known way
// (tests/fuzz/README.md): the graphs are equal up to the names and the order of each pair. Polynomial
// biquadratic patches have the exact answer, their images with weights that of the solution in doubles. With
// --oracle, complete answers are compared with support/exact_oracle.h. Exit status 1 if there is a
// difference; the patch is written to a file, and the seed gives it again.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "known_images.h"
#include "reasons.h"
#include "support/exact_oracle.h"
#include "support/graph_isomorphism.h"
#include "support/self_orders.h"

namespace {

using namespace exsect;
using random_nets::Generator;
using random_nets::Net;
using random_pairs::integer;

constexpr double kCap = 60;  // seconds a patch
/// Of the images of a patch one in so many is solved, others for the next seeds.
constexpr std::size_t kStride = 5;

/// The plane cubic (0,0), (3,2), (-2,2), (1,0), which crosses itself, moved along a curve of degree n; every
/// control point is moved at random.
Net swept_loop(Generator& generator, int n) {
  constexpr std::array<std::array<int, 2>, 4> loop = {{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}};
  const auto move = [&] { return Rational(integer(generator, -4, 4), 16); };
  Net net(4);
  for (std::size_t i = 0; i < 4; ++i)
    for (int j = 0; j <= n; ++j) {
      const Rational a = loop[i][0] + move(), b = loop[i][1] + move();
      net[i].push_back({a, b, 2 * j + move()});
    }
  return net;
}

/// Seed by seed 53-bit doubles, multiples of 1/16, and of degree 3 swept loops; a small family has {-2..2}.
Net net_of(Generator& generator, const std::string& family, std::uint64_t seed) {
  const int degree = family.find("bicubic") != std::string::npos ? 3 : 2;
  std::array<int, 2> degrees = {degree, degree};
  if (family == "mixed")
    for (int& d : degrees) d = static_cast<int>(integer(generator, 1, 3));
  if (family.starts_with("small-")) return random_nets::small(generator, degrees[0], degrees[1]);
  if (seed % 3 == 0 && degrees[0] == 3) return swept_loop(generator, degrees[1]);
  if (seed % 3 == 1) return random_nets::scattered(generator, {degrees[0], degrees[1], 1, 1}).x;
  return random_nets::doubles(generator, degrees[0], degrees[1]);
}

RationalPatch patch_of(const std::string& family, std::uint64_t seed) {
  Generator generator(seed);
  const Net net = net_of(generator, family, seed);
  if (family.find("weighted") == std::string::npos) return RationalPatch(net);
  return seed % 2 == 0 ? random_nets::weighted(generator, net)
                       : random_nets::weighted_by_doubles(generator, net);
}

using Variant = known_images::Image<RationalPatch>;

std::vector<Variant> variants(const RationalPatch& x) {
  using known_images::reparametrised;
  std::vector<Variant> result = {
      {"u and v exchanged", x.transposed(), {{1, 0, 3, 2}, {}}},
      {"u reversed", known_images::reversed(x), {{0, 1, 2, 3}, {true, false, true, false}}},
      {"weights times 7", known_images::multiplied(x)},
      {"elevated", x.elevated(3, 3)},
      {"u reparametrised", reparametrised(x), {}, 0},
      {"v reparametrised", reparametrised(x.transposed()).transposed(), {}, 1}};
  for (const auto& [name, map] : known_images::space_maps())
    result.push_back({name, random_nets::image(x, map)});
  return result;
}

struct SelfTally {
  std::uint64_t complete = 0;
  std::uint64_t with_curves = 0;
  std::uint64_t wrong = 0;
  std::uint64_t compared = 0;
  std::uint64_t halves = 0;  // variants of which one only is complete
  std::uint64_t over = 0;
  std::uint64_t no_patches = 0;
  std::vector<double> seconds;
  Reasons reasons;
};

IntersectResult capped(const RationalPatch& x) {
  IntersectOptions options;
  options.tolerance = 1e-4;
  options.max_seconds = kCap;
  return self_intersect(x, options);
}

std::string difference_between(const IntersectionGraph& graph, const IntersectionGraph& other,
                               const Variant& variant) {
  if (graph.overlaps.size() != other.overlaps.size()) return "different numbers of overlaps";
  IntersectionGraph known = testing::in_both_orders(graph), image = testing::in_both_orders(other);
  known.overlaps.clear();
  image.overlaps.clear();
  if (!variant.parameter) return difference(known, image, variant.renaming);
  for (const std::size_t i : {*variant.parameter, *variant.parameter + 2})
    known = known_images::reparametrised(std::move(known), i);
  return difference(known, image, variant.renaming, known_images::kBentChord);
}

void report(const std::string& family, std::uint64_t seed, const RationalPatch& patch,
            const std::string& difference) {
  std::cout << "seed " << seed << ", " << difference << "; "
            << known_images::written(family + "-self-" + std::to_string(seed), {{"x", patch}}) << std::endl;
}

void check(const std::string& family, std::uint64_t seed, SelfTally& tally) {
  const RationalPatch x = patch_of(family, seed);
  const auto start = std::chrono::steady_clock::now();
  const IntersectResult result = capped(x);
  tally.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  if (tally.seconds.back() > kCap) ++tally.over;
  const bool complete = result.status == Status::complete;
  if (complete) {
    ++tally.complete;
    if (!result.graph.nodes.empty()) ++tally.with_curves;
  } else {
    tally.reasons.add(result.incomplete.at(0).why, seed);
  }
  const std::vector<Variant> images = variants(x);
  for (std::size_t i = seed % kStride; i < images.size(); i += kStride) {
    const Variant& variant = images[i];
    const IntersectResult other = capped(variant.of);
    const bool other_complete = other.status == Status::complete;
    if (complete != other_complete) ++tally.halves;
    if (!complete || !other_complete) continue;
    ++tally.compared;
    const std::string difference = difference_between(result.graph, other.graph, variant);
    if (difference.empty()) continue;
    ++tally.wrong;
    report(family, seed, variant.of, variant.name + ": " + difference);
  }
}

int run(const std::string& family, std::uint64_t first, std::uint64_t count) {
  SelfTally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      check(family, seed, tally);
    } catch (const PatchError&) {
      ++tally.no_patches;
    }
  }
  std::sort(tally.seconds.begin(), tally.seconds.end());
  std::cout << family << ": " << count << " patches, " << tally.complete << " complete, " << tally.with_curves
            << " of these meet themselves, " << tally.wrong << " of " << tally.compared
            << " comparisons differ, " << tally.halves << " complete one way only, " << tally.over
            << " over the cap";
  if (!tally.seconds.empty())
    std::cout << "; median " << 1000 * tally.seconds[tally.seconds.size() / 2] << " ms, slowest "
              << tally.seconds.back() << " s";
  std::cout << "\n";
  tally.reasons.print(std::cout, [&](std::uint64_t seed) {
    return ", " +
           known_images::written(family + "-self-" + std::to_string(seed), {{"x", patch_of(family, seed)}});
  });
  return tally.wrong == 0 ? 0 : 1;
}

/// The pairs with the first parameter of the one point on a line, the other one's at least `gap` away from
/// it, on one side.
struct LinePart {
  Rational value;
  RationalInterval others;
};

/// How many solutions on the line are near one of the graph's, or a contradiction.
struct SelfComparison {
  std::string difference;
  int lines = 0;
  int points = 0;
};

/// Where polylines of the graph, in both orders, cross parameter 0 = value.
std::vector<std::array<double, 4>> crossings(const IntersectionGraph& graph, double value) {
  std::vector<std::array<double, 4>> result;
  for (const Arc& arc : graph.arcs)
    for (std::size_t k = 1; k < arc.polyline.size(); ++k) {
      const auto &a = arc.polyline[k - 1].parameters, &b = arc.polyline[k].parameters;
      if ((a[0] < value) == (b[0] < value)) continue;
      std::array<double, 4> at = a;
      for (std::size_t j = 0; j < 4; ++j) at[j] += (value - a[0]) / (b[0] - a[0]) * (b[j] - a[j]);
      result.push_back(at);
    }
  return result;
}

/// The oracle's solutions and the graph's correspond, one to one, but for those next to the ends of the part.
void compare_part(const RationalPatch& x, const IntersectionGraph& graph, const LinePart& part,
                  SelfComparison& result) {
  constexpr double reach = 1e-2;
  const RationalPatch piece = x.restricted_to(part.others.lower, part.others.upper, 0, 1);
  const exact_oracle::LinePoints line = exact_oracle::line_points(x, piece, 0, part.value);
  if (!line.conclusive()) return;
  ++result.lines;
  const double lower = to_double(part.others.lower), upper = to_double(part.others.upper);
  std::vector<std::array<double, 4>> known = crossings(graph, to_double(part.value));
  for (const ParameterBox& box : line.points) {
    std::array<double, 4> at{};
    for (std::size_t j = 0; j < 4; ++j) at[j] = to_double(box[j].midpoint());
    at[2] = lower + at[2] * (upper - lower);
    const auto distance = [&](const std::array<double, 4>& other) {
      double most = 0;
      for (std::size_t j = 0; j < 4; ++j) most = std::max(most, std::fabs(at[j] - other[j]));
      return most;
    };
    const auto nearest = std::ranges::min_element(known, {}, distance);
    ++result.points;
    if (nearest == known.end() || distance(*nearest) > reach) {
      result.difference = "no arc at a solution with parameter = " + part.value.str();
      return;
    }
    known.erase(nearest);
  }
  const auto is_inside = [&](const std::array<double, 4>& at) {
    return at[2] > lower + reach && at[2] < upper - reach;
  };
  if (std::ranges::any_of(known, is_inside))
    result.difference = "an arc where no solution is, at parameter = " + part.value.str();
}

SelfComparison compared(const RationalPatch& x, const IntersectionGraph& graph) {
  SelfComparison result;
  const Rational gap(1, 32);
  for (const bool exchanged : {false, true}) {
    IntersectionGraph both = testing::in_both_orders(graph);
    if (exchanged)
      for (Arc& arc : both.arcs)
        for (PolylineVertex& v : arc.polyline)
          v.parameters = {v.parameters[1], v.parameters[0], v.parameters[3], v.parameters[2]};
    for (const Rational& value : {Rational(23, 101), Rational(48, 97), Rational(67, 103)})
      for (const RationalInterval& others :
           {RationalInterval{0, value - gap}, RationalInterval{value + gap, 1}})
        if (result.difference.empty())
          compare_part(exchanged ? x.transposed() : x, both, {value, others}, result);
  }
  return result;
}

/// Compares complete answers with exact_oracle.h.
int run_exactly(const std::string& family, std::uint64_t first, std::uint64_t count) {
  int patches = 0, wrong = 0, lines = 0, points = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      const RationalPatch x = patch_of(family, seed);
      const IntersectResult result = capped(x);
      if (result.status != Status::complete || !result.graph.overlaps.empty()) continue;
      const SelfComparison comparison = compared(x, result.graph);
      ++patches;
      lines += comparison.lines;
      points += comparison.points;
      if (comparison.difference.empty()) continue;
      ++wrong;
      report(family, seed, x, comparison.difference);
    } catch (const PatchError&) {  // no patch
    }
  }
  std::cout << family << ": " << patches << " patches compared, " << wrong << " differ; " << lines << " of "
            << 12 * patches << " parts of lines decided, with " << points << " solutions\n";
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> families = {"biquadratic",      "bicubic",       "weighted",
                                             "weighted-bicubic", "mixed",         "small-biquadratic",
                                             "small-bicubic",    "small-weighted"};
  const bool exactly = argc == 5 && std::string(argv[4]) == "--oracle";
  if ((argc != 4 && !exactly) || std::ranges::count(families, argv[1]) == 0)
    throw std::invalid_argument(
        "usage: exsect_replay_self biquadratic|bicubic|weighted|weighted-bicubic|mixed|small-biquadratic|"
        "small-bicubic|small-weighted FIRST COUNT [--oracle]");
  return (exactly ? run_exactly : run)(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
