// replay_degrees FAMILY FIRST COUNT: random pairs of bidegrees up to (3,3) with and without weights, and
// their images under maps that keep the intersection or change it in a known way (tests/fuzz/README.md): the
// graphs are equal up to the names. Reports how many end incomplete, by reason, and the times of the pairs
// themselves; one pair alone is written to a file. With --oracle, complete answers are compared with
// support/exact_oracle.h instead; with --cut, with the parts of patches that are cut (glued_parts.h); with
// --exact, with those of exact arithmetic, of which it counts by reason which are incomplete alone. With
// --certificates it counts which complete pairs have a certificate, and by reason those that have none. Exit
// status 1 if there is a difference; the pair is written to a file, and the seed gives it again.
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certificate/certificate_text.h"
#include "glued_parts.h"
#include "known_images.h"
#include "reasons.h"
#include "round_pieces.h"
#include "support/exact_oracle.h"
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

/// Seed by seed 53-bit doubles, multiples of 1/16, and crumpled patches; a small family has {-2..2} only, a
/// tiny one {-1..1}, every second pair the control points of one of its patches only; the families
/// round and placed are those of round_pieces.h.
RationalPair pair_of(const std::string& family, std::uint64_t seed) {
  Generator generator(seed);
  if (family == "round" || family == "placed") {
    const auto [x, y] =
        family == "round" ? round_pieces::round_pair(generator) : round_pieces::placed_pair(generator);
    return {x, y};
  }
  const bool weighted = family.find("weighted") != std::string::npos;
  const int degree = family.find("bicubic") != std::string::npos ? 3 : 2;
  std::array<int, 4> degrees = {degree, degree, degree, degree};
  const bool tiny = family.starts_with("tiny");
  if (family == "mixed" || tiny)
    for (int& d : degrees) d = static_cast<int>(integer(generator, 1, 3));
  Nets nets;
  if (tiny) {
    nets.x = random_nets::tiny(generator, degrees[0], degrees[1]);
    nets.y = seed % 2 == 0 ? random_nets::tiny(generator, degrees[2], degrees[3])
                           : random_nets::chosen(generator, nets.x, degrees[2], degrees[3]);
  } else if (family.starts_with("small-")) {
    nets.x = random_nets::small(generator, degree, degree);
    nets.y = random_nets::small(generator, degree, degree);
  } else if (seed % 4 == 3) {
    nets = random_nets::scattered(generator, degrees);
  } else {
    nets = random_nets::crossing(generator, degrees, seed % 2 == 0);
  }
  if (!weighted) return {nets.first(), nets.second()};
  if (tiny) {
    const RationalPatch x = random_nets::weighted_by_one_or_two(generator, nets.x);
    return {x, random_nets::weighted_by_one_or_two(generator, nets.y)};
  }
  if (family == "weighted-doubles") {
    const RationalPatch x = random_nets::weighted_by_doubles(generator, nets.x);
    return {x, random_nets::weighted_by_doubles(generator, nets.y)};
  }
  const RationalPatch x = random_nets::weighted(generator, nets.x);
  return {x, random_nets::weighted(generator, nets.y)};
}

using Variant = known_images::Image<RationalPair>;

std::vector<Variant> variants(const RationalPair& pair) {
  using known_images::multiplied, known_images::reparametrised;
  const auto& [x, y] = pair;
  std::vector<Variant> result = {
      {"patches exchanged", {y, x}, {{2, 3, 0, 1}, {}}},
      {"u and v exchanged", {x.transposed(), y}, {{1, 0, 2, 3}, {}}},
      {"weights times 7", {multiplied(x), y}, {}},
      {"elevated", {x.elevated(3, 3), y.elevated(3, 3)}, {}},
      {"u reparametrised", {reparametrised(x), y}, {}, 0},
      {"v reparametrised", {reparametrised(x.transposed()).transposed(), y}, {}, 1},
      {"s reparametrised", {x, reparametrised(y.transposed()).transposed()}, {}, 3},
      {"r and s exchanged", {x, y.transposed()}, {{0, 1, 3, 2}, {}}}};
  for (const auto& [name, map] : known_images::space_maps())
    result.push_back({name, {random_nets::image(x, map), random_nets::image(y, map)}});
  return result;
}

/// Writes the pair to a file and says where.
std::string written(const std::string& family, std::uint64_t seed, const RationalPair& pair) {
  return known_images::written(family + "-" + std::to_string(seed), {{"x", pair.x}, {"y", pair.y}});
}

struct DegreeTally {
  std::uint64_t complete = 0;
  std::uint64_t wrong = 0;
  std::uint64_t compared = 0;
  std::uint64_t halves = 0;  // variants of which one only is complete
  std::uint64_t over = 0;
  std::vector<double> seconds;
  Reasons reasons;
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
    tally.reasons.add(name(result.incomplete.at(0).reason), seed);
  }
  for (const Variant& variant : variants(pair)) {
    const IntersectResult other = intersect(variant.of.x, variant.of.y);
    const bool other_complete = other.status == Status::complete;
    if (complete != other_complete) ++tally.halves;
    if (!complete || !other_complete) continue;
    ++tally.compared;
    const std::string difference = variant.difference(result.graph, other.graph);
    if (difference.empty()) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ", " << variant.name << ": " << difference << "; "
              << written(family, seed, variant.of) << std::endl;
  }
}

/// Compares complete answers with exact_oracle.h.
int run_exactly(const std::string& family, std::uint64_t first, std::uint64_t count) {
  int compared = 0;
  int wrong = 0;
  int lines = 0;
  int vertices = 0;
  int clear = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      const RationalPair pair = pair_of(family, seed);
      const IntersectResult result = intersect(pair.x, pair.y);
      if (result.status != Status::complete || !result.graph.overlaps.empty()) continue;
      const exact_oracle::Comparison comparison = exact_oracle::compare(pair.x, pair.y, result.graph);
      ++compared;
      lines += comparison.lines;
      vertices += comparison.vertices;
      if (comparison.unsure == 0) ++clear;
      if (comparison.difference.empty()) continue;
      ++wrong;
      std::cout << "seed " << seed << ": " << comparison.difference << "; " << written(family, seed, pair)
                << std::endl;
    } catch (const PatchError&) {  // no patch
    }
  }
  std::cout << family << ": " << compared << " pairs compared, " << wrong << " differ; lines decided "
            << lines << " of " << 8 * compared << ", " << vertices
            << " vertices; nothing away from the graph in " << clear << " pairs\n";
  return wrong == 0 ? 0 : 1;
}

/// Compares complete answers with their glued parts.
int run_cut(const std::string& family, std::uint64_t first, std::uint64_t count) {
  int compared = 0, wrong = 0, undecided = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      const RationalPair pair = pair_of(family, seed);
      const IntersectResult result = intersect(pair.x, pair.y);
      if (result.status != Status::complete || !result.graph.overlaps.empty()) continue;
      const auto difference =
          glued_parts::difference(pair.x, pair.y, result.graph, {Rational(37, 101), Rational(61, 103)});
      ++(difference ? compared : undecided);
      if (!difference || difference->empty()) continue;
      ++wrong;
      std::cout << "seed " << seed << ": " << *difference << "; " << written(family, seed, pair) << std::endl;
    } catch (const PatchError&) {  // no patch
    }
  }
  std::cout << family << ": " << compared << " pairs cut, " << wrong << " differ, " << undecided
            << " not compared\n";
  return wrong == 0 ? 0 : 1;
}

/// Compares complete answers with those of exact arithmetic.
int run_in_exact_mode(const std::string& family, std::uint64_t first, std::uint64_t count) {
  int complete = 0, compared = 0, wrong = 0;
  Reasons reasons;
  IntersectOptions exact;
  exact.exact = true;
  exact.max_seconds = kCap;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      const RationalPair pair = pair_of(family, seed);
      const IntersectResult result = intersect(pair.x, pair.y);
      if (result.status != Status::complete) continue;
      ++complete;
      const IntersectResult other = intersect(pair.x, pair.y, exact);
      if (other.status != Status::complete) {
        reasons.add(std::string(name(other.incomplete.at(0).reason)) + ", " + other.incomplete.at(0).why,
                    seed);
        continue;
      }
      ++compared;
      const std::string difference = Variant{"", pair, {}}.difference(result.graph, other.graph);
      if (difference.empty()) continue;
      ++wrong;
      std::cout << "seed " << seed << ": " << difference << "; " << written(family, seed, pair) << std::endl;
    } catch (const PatchError&) {  // no patch
    } catch (const NotSupported&) {
      reasons.add("not offered", seed);
    }
  }
  std::cout << family << ": " << complete << " pairs complete in doubles, " << compared
            << " of them exactly as well, " << wrong << " differ\n"
            << reasons;
  return wrong == 0 ? 0 : 1;
}

/// Counts the complete pairs that have a certificate, and by reason those that have none.
int run_certificates(const std::string& family, std::uint64_t first, std::uint64_t count) {
  int complete = 0, certified = 0;
  Reasons reasons;
  IntersectOptions options;
  options.tolerance = 1e-2;
  options.max_seconds = kCap;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      const RationalPair pair = pair_of(family, seed);
      const IntersectResult result = intersect(pair.x, pair.y, options);
      if (result.status != Status::complete) continue;
      ++complete;
      cli::certificate_text(pair.x, pair.y, {"x", "y"}, result);
      ++certified;
    } catch (const PatchError&) {  // no patch
    } catch (const cli::NoCertificate& reason) {
      reasons.add(reason.what(), seed);
    }
  }
  std::cout << family << ": " << complete << " pairs complete, " << certified << " have a certificate\n"
            << reasons;
  return 0;
}

int run(const std::string& family, std::uint64_t first, std::uint64_t count) {
  DegreeTally tally;
  if (count == 1) std::cout << written(family, first, pair_of(family, first)) << '\n';
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    try {
      check(family, seed, tally);
    } catch (const PatchError&) {
      tally.reasons.add("no patch", seed);
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
  std::cout << tally.reasons;
  return tally.wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> families = {
      "bicubic",          "weighted", "weighted-bicubic", "mixed", "small-bicubic", "small-weighted",
      "weighted-doubles", "tiny",     "tiny-weighted",    "round", "placed"};
  const bool exactly = argc == 5 && std::string(argv[4]) == "--oracle";
  const bool cut = argc == 5 && std::string(argv[4]) == "--cut";
  const bool in_exact_mode = argc == 5 && std::string(argv[4]) == "--exact";
  const bool certificates = argc == 5 && std::string(argv[4]) == "--certificates";
  if ((argc != 4 && !exactly && !cut && !in_exact_mode && !certificates) ||
      std::find(families.begin(), families.end(), argv[1]) == families.end())
    throw std::invalid_argument(
        "usage: exsect_replay_degrees bicubic|weighted|weighted-bicubic|mixed|"
        "small-bicubic|small-weighted|weighted-doubles|tiny|tiny-weighted|round|placed FIRST COUNT "
        "[--oracle|--cut|--exact|--certificates]");
  if (cut) return run_cut(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
  if (in_exact_mode) return run_in_exact_mode(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
  if (certificates) return run_certificates(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
  if (exactly) return run_exactly(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
  return run(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
