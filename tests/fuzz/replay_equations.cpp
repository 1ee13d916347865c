// replay_equations FIRST COUNT [near|boxes]: random pairs of planes, cylinders, cones, spheres and tori with
// small integers, where contact, common lines and circles, and singular points are common
// (tests/fuzz/README.md). Their images under maps that keep the intersection must have the same topology: the
// surfaces exchanged, moved, scaled, given as polynomials without a name, and solved by exact methods alone;
// and bounded curves the points on planes that resultants count. `near`: the second surface moved by 10^-3 to
// 10^-20. `boxes`: the surfaces in boxes, and what the boxes leave of the whole answer. Exit status 1 if
// there is a difference.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "box_oracle.h"
#include "reasons.h"
#include "support/surface_moves.h"
#include "tiny_boxes.h"
#include "tiny_surfaces.h"

namespace {

using namespace exsect;
using random_pairs::Generator;
using S = ImplicitSurface;
using tiny_boxes::Face;
using tiny_boxes::written;
using tiny_surfaces::tiny_surface, tiny_surfaces::vector_of;

constexpr double kTolerance = 1e-4;

/// The topology of an answer, the same for every drawing of it: of each connected part its ends and branching
/// nodes, how many independent loops it has, and the orders of contact; and the isolated points.
std::string topology(const SurfaceIntersection& result) {
  if (result.is_same) return "same surface";
  std::vector<std::size_t> parent(result.nodes.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::size_t a) {
    while (parent[a] != a) a = parent[a];
    return a;
  };
  std::vector<int> degree(result.nodes.size(), 0);
  for (const SpaceArc& arc : result.arcs) {
    const auto from = static_cast<std::size_t>(arc.from), to = static_cast<std::size_t>(arc.to);
    ++degree[from];
    ++degree[to];
    parent[root(from)] = root(to);
  }
  struct Part {
    int loops = 1;
    int orders = 0;  // as bits
    std::vector<int> degrees = {};
  };
  std::map<std::size_t, Part> parts;
  for (std::size_t k = 0; k < result.nodes.size(); ++k) {
    Part& part = parts[root(k)];
    --part.loops;
    if (degree[k] != 2) part.degrees.push_back(degree[k]);
  }
  for (const SpaceArc& arc : result.arcs) {
    Part& part = parts[root(static_cast<std::size_t>(arc.from))];
    ++part.loops;
    part.orders |= 1 << arc.multiplicity;
  }
  std::vector<std::string> texts;
  for (auto& [number, part] : parts) {
    std::sort(part.degrees.begin(), part.degrees.end());
    std::ostringstream text;
    text << part.loops << " loops";
    if (part.orders != 2) text << " orders " << part.orders;
    for (const int d : part.degrees) text << ' ' << d;
    texts.push_back(text.str());
  }
  std::sort(texts.begin(), texts.end());
  std::string all;
  for (const std::string& text : texts) all += "[" + text + "] ";
  return all;
}

struct Variant {
  std::string name;
  S first;
  S second;
  bool exact = false;
};

std::vector<Variant> variants(const Face& first, const Face& second) {
  const S one = first.surface(), other = second.surface();
  std::vector<Variant> result = {{"exchanged", other, one}, {"exact", one, other, true}};
  for (const auto& [name, motion] : surface_moves::motions())
    result.push_back({name, moved(motion, first).surface(), moved(motion, second).surface()});
  // A polynomial has both nappes.
  if (!one.bound()) result.push_back({"first unnamed", first.unnamed(), other});
  if (!other.bound()) result.push_back({"second unnamed", one, second.unnamed()});
  if (!one.bound() && !other.bound()) result.push_back({"both unnamed", first.unnamed(), second.unnamed()});
  return result;
}

struct EquationTally {
  std::uint64_t complete = 0;
  std::uint64_t compared = 0;
  std::uint64_t wrong = 0;
  std::uint64_t halves = 0;  // variants of which one only is complete
  std::uint64_t planes = 0;
  std::uint64_t cut = 0;  // whole answers that were cut by boxes
  Reasons reasons;
};

SurfaceIntersection solved(const S& first, const S& second, bool exact = false) {
  IntersectOptions options;
  options.exact = exact;
  options.tolerance = kTolerance;
  options.max_seconds = 60;
  return intersect(first, second, options);
}

void check_planes(Generator& generator, const S& first, const S& second, const SurfaceIntersection& result,
                  std::uint64_t seed, EquationTally& tally) {
  if (result.is_same || result.count(SpaceNodeKind::cut) > 0 || first.bound() || second.bound()) return;
  for (int k = 0; k < 3; ++k) {
    const Point o = Rational(1, 7) * vector_of(generator, 9), a = vector_of(generator, 999),
                b = vector_of(generator, 999);
    if (is_zero(cross(a, b))) continue;
    const auto counts = surface_moves::plane_counts(first, second, result, {o, a, b});
    if (!counts) continue;
    ++tally.planes;
    if (counts->by_polylines == counts->by_resultant) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ", " << tiny_surfaces::written(first) << ", "
              << tiny_surfaces::written(second) << ": " << counts->by_polylines << " points on a plane, not "
              << counts->by_resultant << std::endl;
  }
}

/// The surface moved by 10^-3 to 10^-20.
S moved_a_little(Generator& generator, const S& surface) {
  Rational length = Rational(1, 1000);
  for (std::size_t k = generator() % 18; k > 0; --k) length /= 10;
  return surface.seen_from(length * vector_of(generator, 9), 1);
}

void check_boxes(const Face& first, const Face& second, const SurfaceIntersection& result, std::uint64_t seed,
                 EquationTally& tally) {
  const SurfaceIntersection whole = solved(first.whole, second.whole);
  if (whole.status != Status::complete) return;
  ++tally.cut;
  const std::string difference = box_oracle::difference(first, second, whole, result);
  if (difference.empty()) return;
  ++tally.wrong;
  std::cout << "seed " << seed << ", " << written(first) << ", " << written(second) << ": " << difference
            << std::endl;
}

/// How pairs are made of seeds.
enum class Pairs { whole, near, boxes };

std::array<Face, 2> pair_of(std::uint64_t seed, Pairs pairs) {
  Generator generator(seed);
  if (pairs == Pairs::boxes) {
    const Face first = tiny_boxes::tiny_face(generator);
    return {first, tiny_boxes::tiny_face(generator)};
  }
  const S first = tiny_surface(generator), second = tiny_surface(generator);
  return {Face{first, {}}, Face{pairs == Pairs::near ? moved_a_little(generator, second) : second, {}}};
}

void check_variants(const Face& first, const Face& second, const SurfaceIntersection& result,
                    std::uint64_t seed, EquationTally& tally) {
  const bool complete = result.status == Status::complete;
  for (const Variant& variant : variants(first, second)) {
    const SurfaceIntersection other = solved(variant.first, variant.second, variant.exact);
    const bool other_complete = other.status == Status::complete;
    if (complete != other_complete) ++tally.halves;
    if (complete && !other_complete)
      tally.reasons.add(variant.name + ": " + other.incomplete.at(0).why, seed);
    if (!complete || !other_complete) continue;
    ++tally.compared;
    const std::string expected = topology(result), found = topology(other);
    if (expected == found) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ", " << written(first) << ", " << written(second) << ", " << variant.name
              << ": " << expected << "but " << found << std::endl;
  }
}

void check(std::uint64_t seed, Pairs pairs, EquationTally& tally) {
  const auto [first, second] = pair_of(seed, pairs);
  const SurfaceIntersection result = solved(first.surface(), second.surface());
  const bool complete = result.status == Status::complete;
  if (complete) ++tally.complete;
  if (!complete) tally.reasons.add(result.incomplete.at(0).why, seed);
  Generator planes(seed);
  if (complete && pairs != Pairs::boxes) check_planes(planes, first.whole, second.whole, result, seed, tally);
  if (complete && pairs == Pairs::boxes) check_boxes(first, second, result, seed, tally);
  check_variants(first, second, result, seed, tally);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::map<std::string, Pairs> kinds = {{"near", Pairs::near}, {"boxes", Pairs::boxes}};
  if (argc != 3 && !(argc == 4 && kinds.contains(argv[3]))) {
    std::cerr << "usage: exsect_replay_equations FIRST COUNT [near|boxes]\n";
    return 2;
  }
  const Pairs pairs = argc == 4 ? kinds.at(argv[3]) : Pairs::whole;
  const std::uint64_t first = std::stoull(argv[1]), count = std::stoull(argv[2]);
  EquationTally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) check(seed, pairs, tally);
  if (count == 1) {
    const auto [one, other] = pair_of(first, pairs);
    std::cout << written(one) << ", " << written(other) << '\n';
  }
  std::cout << count << " pairs, " << tally.complete << " complete, " << tally.wrong << " of "
            << tally.compared << " comparisons, " << tally.planes << " planes and " << tally.cut
            << " boxes differ, " << tally.halves << " complete one way only\n";
  std::cout << tally.reasons;
  return tally.wrong == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
