// replay_degrees FAMILY FIRST COUNT: random pairs of bidegrees up to (3,3) with and without weights, each
// solved also with the patches exchanged, with u and v exchanged, after a projective map of space, with all
// weights multiplied by a constant, and elevated to (3,3): the graphs are equal up to the names. Reports how
// many end incomplete, by reason, and the times of the pairs themselves. Exit status 1 if two complete
// answers differ; the seed gives the pair again.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace {

using namespace exsect;
using random_nets::Generator;
using random_nets::Nets;
using random_pairs::integer;

constexpr double kCap = 20;  // seconds a pair

struct RationalPair {
  RationalPatch x;
  RationalPatch y;
};

random_nets::Net small_net(Generator& generator, int degree) {
  random_nets::Net net(static_cast<std::size_t>(degree) + 1);
  for (auto& row : net) {
    for (int j = 0; j <= degree; ++j) {
      const long a = integer(generator, -2, 2);
      const long b = integer(generator, -2, 2);
      row.push_back({Rational(a), Rational(b), Rational(integer(generator, -2, 2))});
    }
  }
  return net;
}

/// Seed by seed 53-bit doubles, multiples of 1/16, and crumpled patches; a small family has {-2..2} only.
RationalPair pair_of(const std::string& family, std::uint64_t seed) {
  Generator generator(seed);
  const bool weighted = family.find("weighted") != std::string::npos;
  const int degree = family.find("bicubic") != std::string::npos ? 3 : 2;
  std::array<int, 4> degrees = {degree, degree, degree, degree};
  if (family == "mixed")
    for (int& d : degrees) d = static_cast<int>(integer(generator, 1, 3));
  Nets nets;
  if (family.starts_with("small-")) {
    nets.x = small_net(generator, degree);
    nets.y = small_net(generator, degree);
  } else if (seed % 4 == 3) {
    nets = random_nets::scattered(generator, degrees);
  } else {
    nets = random_nets::crossing(generator, degrees, seed % 2 == 0);
  }
  if (!weighted) return {nets.first(), nets.second()};
  const RationalPatch x = random_nets::weighted(generator, nets.x);
  return {x, random_nets::weighted(generator, nets.y)};
}

template <class Map>
RationalPatch mapped(const RationalPatch& patch, const Map& map) {
  std::vector<std::vector<HomogeneousPoint>> net(static_cast<std::size_t>(patch.degree_u()) + 1);
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
      net[static_cast<std::size_t>(i)].push_back(map(patch.homogeneous(i, j)));
  return RationalPatch::from_homogeneous(net);
}

HomogeneousPoint projective(const HomogeneousPoint& p) {
  return {p[0] + p[1] / 3, p[1] - p[2] / 5, p[2] + p[3], p[3] + (p[0] + p[1] - p[2]) / 16};
}

HomogeneousPoint multiplied(const HomogeneousPoint& p) { return {7 * p[0], 7 * p[1], 7 * p[2], 7 * p[3]}; }

struct Variant {
  std::string name;
  RationalPair pair;
  Renaming renaming;
};

std::vector<Variant> variants(const RationalPair& pair) {
  const auto& [x, y] = pair;
  return {{"patches exchanged", {y, x}, {{2, 3, 0, 1}, {}}},
          {"u and v exchanged", {x.transposed(), y}, {{1, 0, 2, 3}, {}}},
          {"projective map", {mapped(x, projective), mapped(y, projective)}, {}},
          {"weights times 7", {mapped(x, multiplied), y}, {}},
          {"elevated", {x.elevated(3, 3), y.elevated(3, 3)}, {}}};
}

struct DegreeTally {
  std::uint64_t complete = 0;
  std::uint64_t wrong = 0;
  std::uint64_t compared = 0;
  std::uint64_t halves = 0;  // variants of which one only is complete
  std::uint64_t over = 0;
  std::vector<double> seconds;
  std::map<std::string, std::pair<int, std::uint64_t>> reasons;  // how often, an example's seed
};

double seconds_of(const std::chrono::steady_clock::time_point& start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void check(const std::string& family, std::uint64_t seed, DegreeTally& tally) {
  const RationalPair pair = pair_of(family, seed);
  const auto start = std::chrono::steady_clock::now();
  const IntersectResult result = intersect(pair.x, pair.y);
  tally.seconds.push_back(seconds_of(start));
  if (tally.seconds.back() > kCap) ++tally.over;
  const bool complete = result.status == Status::complete;
  if (complete) {
    ++tally.complete;
  } else {
    ++tally.reasons.try_emplace(name(result.incomplete.at(0).reason), 0, seed).first->second.first;
  }
  for (const Variant& variant : variants(pair)) {
    const IntersectResult other = intersect(variant.pair.x, variant.pair.y);
    const bool other_complete = other.status == Status::complete;
    if (complete != other_complete) ++tally.halves;
    if (!complete || !other_complete) continue;
    ++tally.compared;
    const std::string difference = exsect::difference(result.graph, other.graph, variant.renaming);
    if (difference.empty()) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ", " << variant.name << ": " << difference << std::endl;
  }
}

int run(const std::string& family, std::uint64_t first, std::uint64_t count) {
  DegreeTally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      check(family, seed, tally);
    } catch (const PatchError&) {
      ++tally.reasons.try_emplace("no patch", 0, seed).first->second.first;
    }
  }
  std::sort(tally.seconds.begin(), tally.seconds.end());
  std::cout << family << ": " << count << " pairs, " << tally.complete << " complete, " << tally.wrong
            << " of " << tally.compared << " comparisons differ, " << tally.halves
            << " complete one way only, " << tally.over << " over the cap";
  if (!tally.seconds.empty())
    std::cout << "; median " << 1000 * tally.seconds[tally.seconds.size() / 2] << " ms, slowest "
              << tally.seconds.back() << " s";
  std::cout << "\n";
  for (const auto& [reason, entry] : tally.reasons)
    std::cout << "  " << entry.first << " incomplete: " << reason << " (seed " << entry.second << ")\n";
  return tally.wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> families = {"bicubic", "weighted",      "weighted-bicubic",
                                             "mixed",   "small-bicubic", "small-weighted"};
  if (argc != 4 || std::find(families.begin(), families.end(), argv[1]) == families.end())
    throw std::invalid_argument(
        "usage: exsect_replay_degrees bicubic|weighted|weighted-bicubic|mixed|"
        "small-bicubic|small-weighted FIRST COUNT");
  return run(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
