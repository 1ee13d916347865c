// replay_degrees FAMILY FIRST COUNT: random pairs of bidegrees up to (3,3) with and without weights, and
// their images under maps that keep the intersection or change it in a known way (tests/fuzz/README.md): the
// graphs are equal up to the names. Reports how many end incomplete, by reason, and the times of the pairs
// themselves. With --oracle, complete answers are compared with support/exact_oracle.h instead. Exit status 1
// if there is a difference; the pair is written to a file, and the seed gives it again.
#include <exsect/geometry/rational_patch_file.h>
#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/exact_oracle.h"
#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace {

using namespace exsect;
using random_nets::Generator;
using random_nets::Nets;
using random_pairs::integer;

constexpr double kCap = 20;  // seconds a pair
const Rational kMoebius(7, 5);

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

/// Weights of 53 bits in [1/2,2).
RationalPatch weighted_by_doubles(Generator& generator, const random_nets::Net& net) {
  random_nets::Weights weights;
  for (const auto& row : net) {
    weights.emplace_back();
    for (std::size_t j = 0; j < row.size(); ++j)
      weights.back().push_back(from_double(0.5 + 1.5 * (static_cast<double>(generator() >> 11U) * 0x1p-53)));
  }
  return RationalPatch(net, weights);
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
  if (family == "weighted-doubles") {
    const RationalPatch x = weighted_by_doubles(generator, nets.x);
    return {x, weighted_by_doubles(generator, nets.y)};
  }
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

/// u = k t / (1 + (k - 1) t), k > 0: the control points are multiplied by k^i.
RationalPatch reparametrised(const RationalPatch& patch, const Rational& k) {
  std::vector<std::vector<HomogeneousPoint>> net;
  Rational factor = 1;
  for (int i = 0; i <= patch.degree_u(); ++i, factor *= k) {
    net.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) {
      HomogeneousPoint p = patch.homogeneous(i, j);
      for (Rational& c : p) c *= factor;
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

/// The graph in the parameter t of reparametrised(), parameter i being u; boxes exactly. Turning points are
/// the same, as t(u) is monotone.
IntersectionGraph reparametrised(IntersectionGraph graph, std::size_t i, const Rational& k) {
  const auto map = [&](const auto& u) { return u / (k + (1 - k) * u); };
  const double kd = to_double(k);
  const auto map_double = [&](double& u) { u = u / (kd + (1 - kd) * u); };
  for (Node& node : graph.nodes) {
    node.box[i] = {map(node.box[i].lower), map(node.box[i].upper)};
    map_double(node.approx[i]);
  }
  const auto map_arc = [&](Arc& arc) {
    for (PolylineVertex& vertex : arc.polyline) map_double(vertex.parameters[i]);
  };
  for (Arc& arc : graph.arcs) map_arc(arc);
  for (Overlap& overlap : graph.overlaps)
    for (auto& chain : overlap.chains)
      for (Arc& arc : chain) map_arc(arc);
  return graph;
}

/// A rotation by the rational quaternion 1 + 2i - j + 3k, of determinant 1.
HomogeneousPoint rotated(const HomogeneousPoint& p) {
  return {(-5 * p[0] - 10 * p[1] + 10 * p[2]) / 15, (2 * p[0] - 11 * p[1] - 10 * p[2]) / 15,
          (14 * p[0] - 2 * p[1] + 5 * p[2]) / 15, p[3]};
}

HomogeneousPoint in_millimetres(const HomogeneousPoint& p) {
  const Rational inch(254, 10);
  return {inch * p[0], inch * p[1], inch * p[2], p[3]};
}

HomogeneousPoint far(const HomogeneousPoint& p) {
  return {p[0] + 100000000 * p[3], p[1] - 100000000 * p[3], p[2] + 100000000 * p[3], p[3]};
}

struct Variant {
  std::string name;
  RationalPair pair;
  Renaming renaming = {};
  std::optional<std::size_t> parameter = {};  // the one that reparametrised() changes, by kMoebius
};

std::vector<Variant> variants(const RationalPair& pair) {
  const auto& [x, y] = pair;
  return {{"patches exchanged", {y, x}, {{2, 3, 0, 1}, {}}},
          {"u and v exchanged", {x.transposed(), y}, {{1, 0, 2, 3}, {}}},
          {"projective map", {mapped(x, projective), mapped(y, projective)}, {}},
          {"weights times 7", {mapped(x, multiplied), y}, {}},
          {"elevated", {x.elevated(3, 3), y.elevated(3, 3)}, {}},
          {"u reparametrised", {reparametrised(x, kMoebius), y}, {}, 0},
          {"v reparametrised", {reparametrised(x.transposed(), kMoebius).transposed(), y}, {}, 1},
          {"s reparametrised", {x, reparametrised(y.transposed(), kMoebius).transposed()}, {}, 3},
          {"r and s exchanged", {x, y.transposed()}, {{0, 1, 3, 2}, {}}},
          {"rotated", {mapped(x, rotated), mapped(y, rotated)}, {}},
          {"times 25.4", {mapped(x, in_millimetres), mapped(y, in_millimetres)}, {}},
          {"moved to 1e8", {mapped(x, far), mapped(y, far)}, {}}};
}

/// Writes the pair beside other temporary files and says where.
std::string written(const std::string& family, std::uint64_t seed, const RationalPair& pair) {
  const auto path = std::filesystem::temp_directory_path() / (family + "-" + std::to_string(seed) + ".json");
  try {
    write_patches({family + ", seed " + std::to_string(seed), "", {{"x", pair.x}, {"y", pair.y}}},
                  path.string());
  } catch (const std::invalid_argument& error) {
    return std::string("not written: ") + error.what();
  }
  return "written to " + path.string();
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
    const IntersectionGraph graph =
        variant.parameter ? reparametrised(result.graph, *variant.parameter, kMoebius) : result.graph;
    const std::string difference = exsect::difference(graph, other.graph, variant.renaming);
    if (difference.empty()) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ", " << variant.name << ": " << difference << "; "
              << written(family, seed, variant.pair) << std::endl;
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
  const std::vector<std::string> families = {"bicubic",       "weighted",       "weighted-bicubic", "mixed",
                                             "small-bicubic", "small-weighted", "weighted-doubles"};
  const bool exactly = argc == 5 && std::string(argv[4]) == "--oracle";
  if ((argc != 4 && !exactly) || std::find(families.begin(), families.end(), argv[1]) == families.end())
    throw std::invalid_argument(
        "usage: exsect_replay_degrees bicubic|weighted|weighted-bicubic|mixed|"
        "small-bicubic|small-weighted|weighted-doubles FIRST COUNT [--oracle]");
  if (exactly) return run_exactly(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
  return run(argv[1], std::stoull(argv[2]), std::stoull(argv[3]));
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
