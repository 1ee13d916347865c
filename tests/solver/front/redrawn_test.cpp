// Results that are drawn again: the same answer at every tolerance, without solving.
#include <exsect/geometry/number.h>
#include <exsect/geometry/rational_patch_file.h>
#include <exsect/solver/intersect_rational.h>
#include <exsect/solver/intersect_surface.h>
#include <exsect/solver/redrawn.h>
#include <exsect/solver/self_intersect.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <sstream>
#include <string>

#include "support/catch.h"
#include "support/families.h"
#include "support/random_nets.h"

namespace exsect::redrawn_test {

namespace {

using Generator = random_pairs::Generator;
using Question = std::function<IntersectResult(const IntersectOptions&)>;

void write(std::ostream& out, const Arc& arc, bool drawn) {
  out << "arc " << arc.id << ' ' << arc.component << ' ' << arc.from << ' ' << arc.to << ' '
      << name(arc.place) << ' ' << name(arc.contact);
  for (const Parameter p : arc.free) out << " free " << index(p);
  if (arc.beside) out << " beside " << arc.beside->left << ' ' << arc.beside->right;
  if (drawn) {
    out << ' ' << arc.error_bound;
    for (const PolylineVertex& vertex : arc.polyline) {
      for (const double p : vertex.parameters) out << ' ' << p;
      for (const double c : vertex.point) out << ' ' << c;
    }
  }
  out << '\n';
}

/// Every number of the graph, with or without those that depend on the tolerance.
std::string written(const IntersectionGraph& graph, bool drawn) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Node& node : graph.nodes) {
    out << "node " << node.id;
    for (const NodeKind kind : node.kinds) out << ' ' << name(kind);
    for (const Side& side : node.on) out << " on " << index(side.parameter) << '=' << side.value;
    for (const Parameter p : node.wrt) out << " wrt " << index(p);
    for (const Parameter p : node.free) out << " free " << index(p);
    for (const std::string& bound : node.bounds) out << ' ' << bound;
    if (node.around) out << " around " << *node.around;
    for (const RationalInterval& at : node.box)
      out << " [" << to_string(at.lower) << ',' << to_string(at.upper);
    for (const double p : node.approx) out << ' ' << p;
    for (const double c : node.point) out << ' ' << c;
    out << '\n';
  }
  for (const Arc& arc : graph.arcs) write(out, arc, drawn);
  for (const Component& component : graph.components) {
    out << "component " << component.id << ' ' << name(component.shape);
    for (const int arc : component.arcs) out << ' ' << arc;
    out << '\n';
  }
  for (const int node : graph.isolated_points) out << "isolated " << node << '\n';
  for (const Overlap& overlap : graph.overlaps)
    for (const auto& chain : overlap.chains) {
      out << "chain of " << overlap.id << '\n';
      for (const Arc& arc : chain) write(out, arc, drawn);
    }
  return out.str();
}

/// What a difference of texts is, in few words.
std::string first_difference(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  std::string x, y;
  while (std::getline(left, x) && std::getline(right, y))
    if (x != y) return x.substr(0, 300) + " | " + y.substr(0, 300);
  return a == b ? "" : "one is longer";
}

std::string difference(const IntersectResult& a, const IntersectResult& b, bool drawn) {
  if (a.status != b.status) return "status";
  if (a.incomplete.size() != b.incomplete.size()) return "incomplete";
  if (drawn && a.coarse.has_value() != b.coarse.has_value()) return "coarse";
  if (drawn && a.coarse && (a.coarse->bound != b.coarse->bound || a.coarse->tolerance != b.coarse->tolerance))
    return "bounds of coarse drawings";
  return first_difference(written(a.graph, drawn), written(b.graph, drawn));
}

/// Nothing was decided again.
bool is_only_drawn(const IntersectResult& result) {
  const auto& steps = result.work.steps;
  return steps.count("drawing ms") == 1 && steps.count("filtered") == 0 &&
         steps.count("turning eliminant ms") == 0 && steps.count("tracing ms") == 0;
}

std::array<std::size_t, 5> counts(const IntersectionGraph& graph) {
  return {graph.nodes.size(), graph.arcs.size(), graph.components.size(), graph.isolated_points.size(),
          graph.overlaps.size()};
}

enum class Kept { everything, may_solve_again };

/// Drawn at the tolerance of the call it is the same, number for number; at others as if it were solved
/// there, if all is kept, and else the same graph.
void check(const Question& question, Kept kept, bool exact = false) {
  IntersectOptions options;
  options.exact = exact;
  const IntersectResult first = question(options);
  const IntersectResult same = redrawn(first, {options.tolerance});
  CHECK(difference(first, same, true) == "");
  for (const double tolerance : {1e-8, 1e-4}) {
    if (kept == Kept::may_solve_again && tolerance > 1e-6) break;
    INFO("tolerance " << tolerance << (exact ? ", exact" : ""));
    options.tolerance = tolerance;
    const IntersectResult other = redrawn(first, {tolerance});
    if (kept == Kept::everything) {
      CHECK(is_only_drawn(other));
      CHECK(difference(other, question(options), true) == "");
      CHECK(difference(redrawn(other, {1e-6}), first, true) == "");
    }
    CHECK(other.status == first.status);
    CHECK(counts(other.graph) == counts(first.graph));
    if (is_only_drawn(other)) CHECK(difference(other, first, false) == "");
  }
}

Question pair(const RationalPatch& x, const RationalPatch& y) {
  return [=](const IntersectOptions& options) { return intersect(x, y, options); };
}

BezierPatch moved(const BezierPatch& patch, const Rational& scale, const Point& shift) {
  ControlNet net = patch.net();
  for (auto& row : net)
    for (Point& p : row) p = scale * p + shift;
  return BezierPatch(net);
}

}  // namespace

TEST_CASE("redrawn: random pairs, in doubles and exactly") {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair nets = seed % 4 == 0   ? random_pairs::loop(generator)
                                    : seed % 4 == 1 ? random_pairs::doubles(generator)
                                    : seed % 4 == 2 ? random_pairs::small_rationals(generator)
                                                    : random_pairs::scattered(generator);
    check(pair(nets.x, nets.y), Kept::everything);
    if (seed <= 8) check(pair(nets.y, nets.x), Kept::everything, true);
  }
}

TEST_CASE("redrawn: pairs far away, in millimetres, large and small") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair nets = random_pairs::doubles(generator);
    const Rational scale = seed % 4 == 0   ? Rational(127, 5)
                           : seed % 4 == 1 ? power_of_two(100)
                           : seed % 4 == 2 ? power_of_two(-100)
                                           : Rational(1);
    const Point shift = {scale * 100000000, scale * seed, 0};
    check(pair(moved(nets.x, scale, shift), moved(nets.y, scale, shift)), Kept::everything, seed % 2 == 0);
  }
}

TEST_CASE("redrawn: patches with weights and of degree three") {
  constexpr std::array<std::array<int, 4>, 4> degrees = {
      {{2, 2, 2, 2}, {3, 3, 3, 3}, {3, 2, 1, 3}, {1, 1, 2, 3}}};
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const auto nets = random_nets::crossing(generator, degrees[seed % 4], seed % 3 > 0);
    const bool weighted = seed % 2 == 0;
    check(pair(weighted ? random_nets::weighted(generator, nets.x) : nets.first(),
               weighted ? random_nets::weighted(generator, nets.y) : nets.second()),
          Kept::everything);
  }
}

TEST_CASE("redrawn: patches that touch, cross, share sides and overlap") {
  using families::Plane;
  for (const ExactCase& c :
       {families::cap(0, Plane::bilinear), families::crossing(Plane::square), families::side_and_arc(),
        families::tangent_curve(Rational(1, 4), Plane::square), families::shifted_copy(),
        families::same_patch(), families::curve_cusp(Plane::larger), families::quarter_circle(Plane::squares),
        families::coplanar_squares(), families::irrational_lines(Plane::bilinear),
        families::tangent_branches(Plane::quadratic)}) {
    INFO(c.name);
    check(pair(c.x, c.y), Kept::may_solve_again, true);
    check(pair(c.x, c.y), Kept::may_solve_again);
  }
}

TEST_CASE("redrawn: every pair of the cases") {
  for (const std::string& folder : {std::string(EXSECT_CASES), EXSECT_CASES + std::string("/found")}) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      const std::string path = file.path().string();
      const std::string name = file.path().filename().string();
      const bool is_slow = name == "corner-at-1e300.json";
      const bool is_pair = name.ends_with(".json") && name.find('.') == name.rfind('.') && name[0] != 'h';
      if (!is_pair || is_slow) continue;
      INFO(path);
      const auto patches = read_rational_patches(path).patches;
      if (patches.size() == 2) check(pair(patches[0].patch, patches[1].patch), Kept::may_solve_again);
    }
  }
}

TEST_CASE("redrawn: self-intersections") {
  const auto patches = read_rational_patches(std::string(EXSECT_EXAMPLES) + "/chapter9-second.json").patches;
  for (const auto& named : patches) {
    INFO(named.name);
    check([&](const IntersectOptions& options) { return self_intersect(named.patch, options); },
          Kept::may_solve_again);
  }
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const BezierPatch x = random_pairs::scattered(generator).x;
    check([&](const IntersectOptions& options) { return self_intersect(x, options); }, Kept::may_solve_again);
  }
}

TEST_CASE("redrawn: a surface by its equation and a patch") {
  const ImplicitSurface sphere = ImplicitSurface::sphere({0, 0, 0}, Rational(1));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const BezierPatch x = moved(random_pairs::scattered(generator).x, 2, {-1, -1, -1});
    check([&](const IntersectOptions& options) { return intersect(sphere, x, options); },
          Kept::may_solve_again);
  }
}

TEST_CASE("redrawn: it outlives the patches and the first result, and is copied") {
  Generator generator(5);
  auto nets = std::make_unique<random_pairs::Pair>(random_pairs::doubles(generator));
  auto first = std::make_unique<IntersectResult>(intersect(nets->x, nets->y));
  const std::string skeleton = written(first->graph, false);
  nets.reset();
  const IntersectResult copy = *first;
  first.reset();
  CHECK(written(redrawn(copy, {1e-9}).graph, false) == skeleton);
}

TEST_CASE("redrawn: what is asked wrongly") {
  Generator generator(7);
  const random_pairs::Pair nets = random_pairs::doubles(generator);
  const IntersectResult result = intersect(nets.x, nets.y);
  for (const double tolerance :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(redrawn(result, {tolerance}), std::invalid_argument);
  CHECK_THROWS_AS(redrawn(result, {1e-6, 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(redrawn(IntersectResult{}, {1e-6}), std::invalid_argument);
}

}  // namespace exsect::redrawn_test
