#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::intersect_test {
using exsect::testing::graph_patch;
using exsect::testing::HeightCoefficients;
using exsect::testing::plane_patch;

namespace {

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

Pair example(const std::string& name) {
  const PatchFile file = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name);
  return {file.patches.at(0).patch, file.patches.at(1).patch};
}

IntersectResult intersect(const Pair& pair, const IntersectOptions& options = {}) {
  return exsect::intersect(pair.x, pair.y, options);
}

/// e - (u-1/2)^2 - (v-1/2)^2.
Pair cap(const Rational& e) {
  return {graph_patch({{{e - Rational(1, 2), 1, -1}, {1, 0, 0}, {-1, 0, 0}}}), plane_patch()};
}

/// (u-1/2)^2 - (v-1/2)^2 - e.
Pair crossing(const Rational& e) {
  return {graph_patch({{{-e, 1, -1}, {-1, 0, 0}, {1, 0, 0}}}), plane_patch()};
}

/// True if the node's box holds a point within 1e-13 of the given one and is smaller than 1e-9.
bool is_at(const Node& node, const std::array<double, 4>& where) {
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational w = from_double(where[j]);
    const Rational slack(1, 10000000000000);
    if (node.box[j].lower > w + slack || node.box[j].upper < w - slack ||
        node.box[j].width() > Rational(1, 1000000000)) {
      return false;
    }
  }
  return true;
}

bool has_node(const IntersectionGraph& graph, const std::array<double, 4>& where, NodeKind kind,
              const std::vector<Parameter>& wrt, const std::vector<Side>& on) {
  return std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& n) {
           return is_at(n, where) && n.kinds.front() == kind && n.wrt == wrt && n.on == on;
         }) == 1;
}

double distance_to_polyline(const std::array<double, 3>& p, const std::vector<PolylineVertex>& line) {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    double length2 = 0;
    double along = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double e = line[i + 1].point[c] - line[i].point[c];
      length2 += e * e;
      along += e * (p[c] - line[i].point[c]);
    }
    const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
    double d2 = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = line[i].point[c] + t * (line[i + 1].point[c] - line[i].point[c]) - p[c];
      d2 += d * d;
    }
    best = std::min(best, d2);
  }
  return std::sqrt(best);
}

/// Near the polyline of some arc: the order of the arcs depends on the way they are found.
bool is_near(const std::array<double, 3>& p, double error_bound, const IntersectionGraph& graph) {
  return std::any_of(graph.arcs.begin(), graph.arcs.end(), [&](const Arc& arc) {
    return distance_to_polyline(p, arc.polyline) <= arc.error_bound + error_bound;
  });
}

void check_polylines(const Pair& pair) {
  IntersectOptions coarse;
  coarse.exact = true;
  coarse.tolerance = 1e-3;
  IntersectOptions fine;
  fine.exact = true;
  fine.tolerance = 1e-9;
  const IntersectResult a = intersect(pair, coarse);
  const IntersectResult b = intersect(pair, fine);
  REQUIRE(a.graph.arcs.size() == b.graph.arcs.size());
  for (std::size_t i = 0; i < a.graph.arcs.size(); ++i) {
    const Arc& rough = a.graph.arcs[i];
    const Arc& exact = b.graph.arcs[i];
    CHECK(rough.error_bound <= 1e-3);
    CHECK(exact.error_bound <= 1e-9);
    for (std::size_t k = 0; k < exact.polyline.size(); k += 7) {
      REQUIRE(is_near(exact.polyline[k].point, exact.error_bound, a.graph));
    }
    for (const PolylineVertex& v : rough.polyline) {
      REQUIRE(is_near(v.point, rough.error_bound, b.graph));
      // A vertex is the same point of both patches, up to rounding.
      const Point px = pair.x(from_double(v.parameters[0]), from_double(v.parameters[1]));
      const Point py = pair.y(from_double(v.parameters[2]), from_double(v.parameters[3]));
      for (std::size_t c = 0; c < 3; ++c) {
        REQUIRE(std::fabs(to_double(px[c] - py[c])) < 1e-12);
        REQUIRE(std::fabs(to_double(px[c]) - v.point[c]) < 1e-12);
      }
    }
    CHECK(rough.polyline.front().parameters == a.graph.nodes[static_cast<std::size_t>(rough.from)].approx);
    CHECK(rough.polyline.back().parameters == a.graph.nodes[static_cast<std::size_t>(rough.to)].approx);
  }
}

}  // namespace

TEST_CASE("first example of the chapter: one closed and one open component", "[intersect]") {
  const IntersectResult result = intersect(example("chapter9-first.json"));
  for (const Incomplete& i : result.incomplete) {
    UNSCOPED_INFO(i.why);
  }
  REQUIRE(result.status == Status::complete);
  const IntersectionGraph& g = result.graph;
  CHECK(g.components.size() == 2);
  CHECK(g.count(ComponentShape::closed) == 1);
  CHECK(g.count(ComponentShape::open) == 1);
  CHECK(g.turning_points(Parameter::u) == 2);
  CHECK(g.turning_points(Parameter::v) == 3);
  CHECK(g.turning_points(Parameter::r) == 3);
  CHECK(g.turning_points(Parameter::s) == 2);
  CHECK(g.boundary_points() == 2);
  CHECK(g.isolated_points.empty());

  using enum Parameter;
  const auto turning = [&](Parameter p, const std::array<double, 4>& where) {
    INFO("turning point in " << name(p));
    CHECK(has_node(g, where, NodeKind::turning, {p}, {}));
  };
  turning(s, {0.50274284209197, 0.1219944750244, 0.510664437510169, 0.144948514635496});
  turning(v, {0.554986813616605, 0.118295149600328, 0.567123264565883, 0.148865278942587});
  turning(u, {0.732810238336817, 0.282067083536022, 0.805767624848316, 0.353807001508294});
  turning(r, {0.714896850135267, 0.381923606211247, 0.821721169754102, 0.464325026505513});
  turning(s, {0.21729467977862, 0.600210942862417, 0.332198021004425, 0.732093249358009});
  turning(v, {0.107217946025555, 0.637948116019918, 0.185535119331772, 0.714892383778707});
  turning(u, {0.0856693722358927, 0.601788781979229, 0.151810337525682, 0.656310070135593});
  turning(r, {0.0871746539836133, 0.577325486366148, 0.150500421589621, 0.626812403123345});
  turning(r, {0.0549667696844367, 0.823481699131865, 0.109671004270749, 0.878809832340835});
  turning(v, {0.023418011207592, 0.728742308011041, 0.0733949007017909, 0.759269426173552});
  CHECK(has_node(g, {0.0753529119328255, 0.953884419355198, 0.104442005262723, 1.0}, NodeKind::boundary, {},
                 {Side{s, 1}}));
  CHECK(has_node(g, {0, 0.734303721558761, 0.041334560673668, 0.7477094010264}, NodeKind::boundary, {},
                 {Side{u, 0}}));
}

TEST_CASE("second example of the chapter: three open components", "[intersect]") {
  const IntersectResult result = intersect(example("chapter9-second.json"));
  CHECK(result.status == Status::complete);
  CHECK(result.graph.components.size() == 3);
  CHECK(result.graph.count(ComponentShape::open) == 3);
  CHECK(result.graph.boundary_points() == 6);
}

TEST_CASE("polylines keep their proved distance", "[intersect]") {
  check_polylines(example("chapter9-first.json"));
  check_polylines(example("chapter9-second.json"));
  check_polylines(cap(Rational(1, 50)));
}

TEST_CASE("a cap above a plane: a loop, or nothing", "[intersect]") {
  for (const Rational& e : {Rational(1, 10), Rational(1, 1000), Rational(1, 1000000000000)}) {
    const IntersectResult result = intersect(cap(e));
    CHECK(result.status == Status::complete);
    CHECK(result.graph.components.size() == 1);
    CHECK(result.graph.count(ComponentShape::closed) == 1);
    for (const Parameter p : all_parameters) {
      CHECK(result.graph.turning_points(p) == 2);
    }
    const IntersectResult none = intersect(cap(-e));
    CHECK(none.status == Status::complete);
    CHECK(none.graph.nodes.empty());
    CHECK(none.graph.arcs.empty());
  }
}

TEST_CASE("isolated singular points are nodes of their kind", "[intersect]") {
  const IntersectResult touch = intersect(cap(0));
  CHECK(touch.status == Status::complete);
  CHECK(touch.graph.arcs.empty());
  REQUIRE(touch.graph.isolated_points.size() == 1);
  CHECK(touch.graph.nodes[0].kinds == std::vector{NodeKind::touch});
  const IntersectResult cross = intersect(crossing(0));
  CHECK(cross.status == Status::complete);
  CHECK(cross.graph.arcs.size() == 4);
  CHECK(cross.graph.count(ComponentShape::branched) == 1);
  CHECK(std::count_if(cross.graph.nodes.begin(), cross.graph.nodes.end(),
                      [](const Node& node) { return node.kinds == std::vector{NodeKind::crossing}; }) == 1);
  check_polylines(crossing(0));
}

namespace {

BezierPatch patch_of(const std::array<long, 27>& c) {
  ControlNet net;
  for (std::size_t i = 0; i < 27; ++i) net[i / 9][i / 3 % 3][i % 3] = c[i];
  return BezierPatch(net);
}

}  // namespace

TEST_CASE("two curves that end in one boundary point are told apart next to it", "[intersect]") {
  const BezierPatch x =
      patch_of({-1, 0, -1, 0, -1, 1, -1, 0, 1, 0, 1, 0, 1, 0, 1, 0, -1, -1, 1, -1, -1, -1, -1, -1, -1, 1, 1});
  const BezierPatch y =
      patch_of({-1, 1, 1, 0, 0, 1, -1, -1, -1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, -1, 0, -1, -1, 0, -1});
  for (const bool exact : {false, true}) {
    IntersectOptions options;
    options.exact = exact;
    CHECK(intersect(x, y, options).status == Status::complete);
    CHECK(intersect(y, x, options).status == Status::complete);
  }
}

TEST_CASE("u and v turn together where a plane patch folds", "[intersect]") {
  const BezierPatch x =
      patch_of({2, -2, 1, 2, -1, 0, 0, 2, 1, 2, 0, -1, -1, 1, 1, 0, 2, -2, 1, 0, 0, 0, 2, -2, -2, -2, 2});
  const BezierPatch y =
      patch_of({-2, 0, 0, 0, -1, 0, -1, -2, 0, 0, 0, 0, -1, 1, 0, -2, 2, 0, -1, 1, 0, 0, 1, 0, 1, -1, 0});
  const IntersectResult result = intersect(x, y);
  CHECK(result.status == Status::complete);
  int folds = 0;
  for (const Node& node : result.graph.nodes) {
    if (node.wrt == std::vector{Parameter::u, Parameter::v}) {
      ++folds;
      const Point normal =
          cross(y.derivative_first(from_double(node.approx[2]), from_double(node.approx[3])),
                y.derivative_second(from_double(node.approx[2]), from_double(node.approx[3])));
      CHECK(std::fabs(to_double(normal[2])) < 1e-10);
    }
  }
  CHECK(folds == 2);
}

TEST_CASE("a curve that touches a side goes on behind it", "[intersect]") {
  // The curve touches the side v = 1 from inside at u = 1/2, where r and s are irrational.
  const BezierPatch x = patch_of(
      {0, -2, -2, 0, 2, -2, 1, 0, 2, -1, 1, 2, -2, 0, -1, -1, -1, -2, -1, -2, -1, 1, -2, 0, -2, -1, 2});
  const BezierPatch y =
      patch_of({-2, -1, 0, 0, 0, 0, 0, 2, 0, 2, 0, 0, -2, -2, 0, 2, -2, 0, 1, -2, 0, 0, 2, 0, -2, -2, 0});
  for (const Pair& pair : {Pair{x, y}, Pair{y, x}}) {
    const IntersectResult result = intersect(pair);
    CHECK(result.status == Status::complete);
    const auto is_touch = [&](int id) {
      const Node& node = result.graph.nodes[static_cast<std::size_t>(id)];
      return !node.on.empty() && (node.approx[0] == 0.5 || node.approx[2] == 0.5) &&
             node.on.front().value == 1;
    };
    const auto ends =
        std::accumulate(result.graph.arcs.begin(), result.graph.arcs.end(), 0,
                        [&](int sum, const Arc& arc) { return sum + is_touch(arc.from) + is_touch(arc.to); });
    CHECK(ends == 2);
  }
}

TEST_CASE("a curve from a cuspidal corner on an irrational point of a side", "[intersect]") {
  // x = (u + u², v, 0); y = (1/2 + p², b p², p² - q) or with p and q exchanged, p = 1 - r, q = 1 - s: y_r = 0
  // in the corner p = q = 0, on the side v = 0. Of the curve q = p² all but the corner has v = b p².
  ControlNet line{};
  line[1][0] = line[2][0] = {1, 0, 0};
  line[0][1] = {0, 1, 0};
  const BezierPatch x = BezierPatch::from_power_basis(line);
  for (const int b : {1, -1}) {
    ControlNet c{};
    c[0][0] = {Rational(1, 2), 0, 0};
    c[2][0] = {1, b, 1};
    c[0][1] = {0, 0, -1};
    const BezierPatch y = BezierPatch::from_power_basis(c).reversed_first().reversed_second();
    for (const BezierPatch& second : {y, y.exchanged()}) {
      const auto result = exsect::intersect(x, second);
      CHECK(result.status == Status::complete);
      CHECK(result.graph.count(ComponentShape::open) == (b > 0 ? 1 : 0));
      CHECK(result.graph.isolated_points.size() == (b > 0 ? 0 : 1));
      CHECK(std::any_of(result.graph.nodes.begin(), result.graph.nodes.end(), [](const Node& node) {
        return std::fabs(node.approx[0] - (std::sqrt(3) - 1) / 2) < 1e-9 && node.approx[2] == 1 &&
               node.approx[3] == 1;
      }));
    }
  }
}

TEST_CASE("an arc leaves a common side in an irrational point", "[intersect]") {
  // (u, v, u (2 v² - 1 - u/2)/4) and (r, s, 0): the side u = 0, and v² = 1/2 + u/4 from it.
  ControlNet net;
  net[1][0] = {1, 0, Rational(-1, 4)};
  net[0][1] = {0, 1, 0};
  net[2][0] = {0, 0, Rational(-1, 8)};
  net[1][2] = {0, 0, Rational(1, 2)};
  ControlNet plane;
  plane[1][0] = {1, 0, 0};
  plane[0][1] = {0, 1, 0};
  const Pair pair = {BezierPatch::from_power_basis(net), BezierPatch::from_power_basis(plane)};
  const IntersectResult result = intersect(pair);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.arcs.size() == 3);
  CHECK(result.graph.count(ComponentShape::branched) == 1);
  const auto node = std::find_if(result.graph.nodes.begin(), result.graph.nodes.end(), [](const Node& n) {
    return std::count(n.kinds.begin(), n.kinds.end(), NodeKind::crossing) > 0;
  });
  REQUIRE(node != result.graph.nodes.end());
  CHECK(node->on == std::vector<Side>{{Parameter::u, 0}, {Parameter::r, 0}});
  CHECK(2 * node->box[1].lower * node->box[1].lower <= 1);
  CHECK(2 * node->box[1].upper * node->box[1].upper >= 1);
  CHECK(node->box[1].width() < power_of_two(-40));
  check_polylines(pair);
}

TEST_CASE("a near crossing is two open arcs", "[intersect]") {
  for (const Rational& e : {Rational(1, 1000), Rational(1, 1000000), Rational(1, 1000000000)}) {
    const IntersectResult result = intersect(crossing(e));
    CHECK(result.status == Status::complete);
    CHECK(result.graph.count(ComponentShape::open) == 2);
  }
}

TEST_CASE("options are checked and obeyed", "[intersect]") {
  const Pair pair = example("chapter9-first.json");
  IntersectOptions options;
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    options.tolerance = bad;
    CHECK_THROWS_AS(intersect(pair, options), std::invalid_argument);
  }
  options.tolerance = 1e-30;  // below what doubles can express: said, not hidden
  const IntersectResult coarse = intersect(pair, options);
  CHECK(coarse.status == Status::complete);
  REQUIRE(coarse.coarse);
  CHECK(coarse.coarse->tolerance > 0);
  CHECK(coarse.coarse->tolerance < 1e-29);
  CHECK(coarse.coarse->bound > 1e-16);
  CHECK(coarse.coarse->bound < 1e-10);
  options.tolerance = 1e-6;
  options.exact = true;
  options.max_seconds = 1e-9;
  const IntersectResult capped = intersect(pair, options);
  CHECK(capped.status == Status::incomplete);
  CHECK_FALSE(capped.incomplete.empty());
  options.max_seconds = std::nullopt;
  options.turning = {Parameter::v};
  const IntersectResult only_v = intersect(pair, options);
  CHECK(only_v.status == Status::complete);
  CHECK(only_v.graph.turning_points(Parameter::v) == 3);
  CHECK(only_v.graph.turning_points(Parameter::u) == 0);
  options.turning = {};
  const IntersectResult none = intersect(pair, options);
  CHECK(none.graph.components.size() == 2);
  int calls = 0;
  options.progress = [&](double fraction, const char*) {
    ++calls;
    CHECK(fraction >= 0);
    CHECK(fraction <= 1);
  };
  intersect(pair, options);
  CHECK(calls > 0);
}

}  // namespace exsect::intersect_test
