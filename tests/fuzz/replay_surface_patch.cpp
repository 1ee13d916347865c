// replay_surface_patch tiny|round FIRST COUNT: random surfaces given by their equations with patches
// (tests/fuzz/README.md): of bidegree (1,1) to (3,3), small integers, every second one with weights 1 and 2;
// or round pieces (round_pieces.h), which have their axes and radii in common with many of them. The images
// under maps that keep the parameters, or change them in a known way, have the same graphs, and so has the
// exact answer; and on parameter lines there are as many arcs as the equation has zeros by Sturm's count.
// Exit status 1 if there is a difference; the patch is written to a file.
#include <exsect/algebra/sturm.h>
#include <exsect/solver/intersect_surface.h>

#include <iostream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "known_images.h"
#include "reasons.h"
#include "round_pieces.h"
#include "support/graph_isomorphism.h"
#include "support/surface_moves.h"
#include "tiny_surfaces.h"

namespace {

using namespace exsect;
using random_nets::Generator;
using random_pairs::integer;
using surface_moves::Motion;
using tiny_surfaces::tiny_surface, tiny_surfaces::unnamed, tiny_surfaces::written;
using S = ImplicitSurface;

struct SurfacePatch {
  S surface;
  RationalPatch patch;
};

SurfacePatch pair_of(const std::string& family, std::uint64_t seed) {
  Generator generator(seed);
  const S surface = tiny_surface(generator);
  if (family == "round") return {surface, round_pieces::round_piece(generator)};
  const auto degree = [&] { return static_cast<int>(integer(generator, 1, 3)); };
  const int m = degree(), n = degree();
  const random_nets::Net net = random_nets::tiny(generator, m, n);
  return {surface, seed % 2 == 0 ? random_nets::weighted_by_one_or_two(generator, net) : RationalPatch(net)};
}

RationalPatch moved(const RationalPatch& patch, const Motion& motion) {
  const Point o = motion({0, 0, 0});
  const std::array<Point, 3> columns = {motion({1, 0, 0}) - o, motion({0, 1, 0}) - o, motion({0, 0, 1}) - o};
  random_nets::ProjectiveMap rows;
  for (std::size_t k = 0; k < 3; ++k) rows[k] = {columns[0][k], columns[1][k], columns[2][k], o[k]};
  rows[3] = {0, 0, 0, 1};
  return random_nets::image(patch, rows);
}

using Variant = known_images::Image<SurfacePatch>;

std::vector<Variant> variants(const SurfacePatch& pair) {
  using known_images::reparametrised;
  const auto& [f, x] = pair;
  std::vector<Variant> result = {
      {"u reversed", {f, known_images::reversed(x)}, {{0, 1, 2, 3}, {true, false, false, false}}},
      {"weights times 7", {f, known_images::multiplied(x)}},
      {"elevated", {f, x.elevated(3, 3)}},
      {"u reparametrised", {f, reparametrised(x)}, {}, 0},
      {"v reparametrised", {f, reparametrised(x.transposed()).transposed()}, {}, 1}};
  if (!f.bound()) result.push_back({"unnamed", {unnamed(f), x}});
  for (const auto& [name, motion] : surface_moves::motions())
    result.push_back({name, {motion(f), moved(x, motion)}});
  return result;
}

struct SurfacePatchTally {
  std::uint64_t complete = 0;
  std::uint64_t in_doubles = 0;
  std::uint64_t compared = 0;
  std::uint64_t lines = 0;
  std::uint64_t wrong = 0;
  Reasons reasons;
};

/// F(x(u, v)) as a polynomial in v, times a power of the denominator.
Polynomial on_line(const S& surface, const RationalPatch& x, const Rational& u) {
  const Polynomial v = Polynomial::variable();
  const auto bernstein = [](int n, int i, const auto& t) {
    auto result = std::decay_t<decltype(t)>(1);
    for (int k = 1; k <= i; ++k) result = result * Rational(n - k + 1, k);  // The binomial coefficient.
    for (int k = 0; k < n; ++k) result = result * (k < i ? t : std::decay_t<decltype(t)>(1) - t);
    return result;
  };
  std::array<Polynomial, 4> point;
  for (int i = 0; i <= x.degree_u(); ++i)
    for (int j = 0; j <= x.degree_v(); ++j)
      for (std::size_t k = 0; k < 4; ++k)
        point[k] += bernstein(x.degree_v(), j, v) *
                    Polynomial(Rational(bernstein(x.degree_u(), i, u) * x.homogeneous(i, j)[k]));
  int degree = 0;
  for (const auto& [e, c] : surface.equation().terms()) degree = std::max(degree, e[0] + e[1] + e[2]);
  Polynomial sum;
  for (const auto& [e, c] : surface.equation().terms()) {
    Polynomial term(c);
    const std::array<int, 4> powers = {e[0], e[1], e[2], degree - e[0] - e[1] - e[2]};
    for (std::size_t k = 0; k < 4; ++k)
      for (int p = 0; p < powers[k]; ++p) term = term * point[k];
    sum += term;
  }
  return sum;
}

/// Arcs run along one direction of u, as turning points are nodes.
void check_lines(const SurfacePatch& pair, const IntersectResult& result, std::uint64_t seed,
                 SurfacePatchTally& tally) {
  if (pair.surface.bound() || !result.graph.overlaps.empty()) return;
  for (const Rational& u : {Rational(1009, 9973), Rational(4999, 9973), Rational(8009, 9973)}) {
    const Polynomial f = on_line(pair.surface, pair.patch, u);
    if (f.degree() < 0) continue;
    const int expected = f.degree() < 1 ? 0 : SturmSequence(f).count_closed(0, 1);
    int found = 0;
    for (const Arc& arc : result.graph.arcs) {
      const RationalInterval &from = result.graph.nodes[static_cast<std::size_t>(arc.from)].box[0],
                             &to = result.graph.nodes[static_cast<std::size_t>(arc.to)].box[0];
      if ((from.upper < u && u < to.lower) || (to.upper < u && u < from.lower)) ++found;
    }
    ++tally.lines;
    if (found == expected) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ": " << found << " arcs over u = " << u << ", not " << expected
              << std::endl;
  }
}

void check(const std::string& family, std::uint64_t seed, SurfacePatchTally& tally) {
  const SurfacePatch pair = pair_of(family, seed);
  const IntersectResult result = intersect(pair.surface, pair.patch);
  if (result.status != Status::complete) return tally.reasons.add(result.incomplete.at(0).why, seed);
  ++tally.complete;
  check_lines(pair, result, seed, tally);
  if (result.work.steps.contains("filtered")) ++tally.in_doubles;
  IntersectOptions exactly;
  exactly.exact = true;
  std::vector<Variant> all = variants(pair);
  all.insert(all.begin(), {"exact", pair});
  for (const Variant& variant : all) {
    const IntersectResult other = intersect(variant.of.surface, variant.of.patch,
                                            variant.name == "exact" ? exactly : IntersectOptions{});
    if (other.status != Status::complete) {
      tally.reasons.add(variant.name + ": " + other.incomplete.at(0).why, seed);
      continue;
    }
    ++tally.compared;
    const std::string difference = variant.difference(result.graph, other.graph);
    if (difference.empty()) continue;
    ++tally.wrong;
    std::cout << "seed " << seed << ", " << variant.name << ": " << difference << std::endl;
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string family = argc == 4 ? argv[1] : "";
  if (family != "tiny" && family != "round") {
    std::cerr << "usage: exsect_replay_surface_patch tiny|round FIRST COUNT\n";
    return 2;
  }
  const std::uint64_t first = std::stoull(argv[2]), number = std::stoull(argv[3]);
  SurfacePatchTally tally;
  for (std::uint64_t seed = first; seed < first + number; ++seed) {
    try {
      check(family, seed, tally);
    } catch (const PatchError&) {
      tally.reasons.add("no patch", seed);
    }
  }
  if (number == 1) {
    const SurfacePatch pair = pair_of(family, first);
    std::cout << written(pair.surface) << ", "
              << known_images::written("surface-patch-" + family + std::to_string(first), {{"x", pair.patch}})
              << '\n';
  }
  std::cout << family << ": " << number << " pairs, " << tally.complete << " complete, " << tally.in_doubles
            << " of them in doubles, " << tally.wrong << " of " << tally.compared << " comparisons and "
            << tally.lines << " lines differ\n";
  std::cout << tally.reasons;
  return tally.wrong == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
