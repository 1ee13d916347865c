#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "support/catch.h"
#include "support/self_locus.h"

namespace exsect::self_intersect_test {
using exsect::testing::polyline_crossings;
using exsect::testing::self_fibre;
using exsect::testing::self_locus;

namespace {

BezierPatch example(const std::string& file, std::size_t i) {
  return read_patches(std::string(EXSECT_EXAMPLES) + "/" + file).patches.at(i).patch;
}

/// Every node box, tiny as it is, holds a zero of Q; every vertex nearly is one.
void check_on_locus(const BezierPatch& x, const IntersectionGraph& graph) {
  const BivariatePolynomial q = self_locus(x);
  double scale = 0;
  for (int i = 0; i <= q.degree_r(); ++i)
    for (const Rational& c : q.coefficient(i).coefficients()) scale += std::fabs(to_double(c));
  for (const Node& node : graph.nodes) {
    for (const bool exchanged : {false, true}) {
      const RationalInterval u2 = node.box[exchanged ? 0 : 2];
      const RationalInterval v1 = node.box[exchanged ? 3 : 1];
      CHECK(u2.width() < Rational(1, 10000000));
      CHECK(enclose(q, FixedPointInterval(u2, 200), FixedPointInterval(v1, 200)).contains_zero());
    }
  }
  for (const Arc& arc : graph.arcs)
    for (const PolylineVertex& v : arc.polyline) {
      const Rational value = q(from_double(v.parameters[2]), from_double(v.parameters[1]));
      CHECK(std::fabs(to_double(value)) < 1e-12 * scale);
    }
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Vertices are pairs with one point of space, and both ends of an arc are its nodes.
void check_geometry(const BezierPatch& x, const IntersectionGraph& graph) {
  const auto at = [&](double u, double v) {
    const Point p = x(from_double(u), from_double(v));
    return std::array<double, 3>{to_double(p[0]), to_double(p[1]), to_double(p[2])};
  };
  for (const Arc& arc : graph.arcs) {
    for (const PolylineVertex& v : arc.polyline) {
      CHECK(distance(at(v.parameters[0], v.parameters[1]), v.point) < 1e-12);
      CHECK(distance(at(v.parameters[2], v.parameters[3]), v.point) < 1e-12);
    }
    const Node& from = graph.nodes[static_cast<std::size_t>(arc.from)];
    const Node& to = graph.nodes[static_cast<std::size_t>(arc.to)];
    CHECK(distance(from.point, arc.polyline.front().point) < 1e-12);
    CHECK(distance(to.point, arc.polyline.back().point) < 1e-12);
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(std::fabs(from.approx[j] - arc.polyline.front().parameters[j]) < 1e-7);
      CHECK(std::fabs(to.approx[j] - arc.polyline.back().parameters[j]) < 1e-7);
    }
  }
}

/// How far the point of the line u = value or v = value is from the polylines' crossings of the line.
double distance_at(const IntersectionGraph& graph, std::size_t parameter, const CertifiedPoint& point) {
  std::array<double, 4> p{};
  for (std::size_t j = 0; j < 4; ++j) p[j] = to_double(point.box()[j].midpoint());
  double best = 1;
  for (const Arc& arc : graph.arcs)
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i)
      for (const std::size_t shift : {0U, 2U}) {
        const auto& a = arc.polyline[i].parameters;
        const auto& b = arc.polyline[i + 1].parameters;
        const std::size_t k = parameter + shift;
        if ((a[k] < p[parameter]) == (b[k] < p[parameter])) continue;
        const double t = (p[parameter] - a[k]) / (b[k] - a[k]);
        double d = 0;
        for (std::size_t j = 0; j < 4; ++j) {
          const std::size_t l = (j + shift) % 4;
          d = std::max(d, std::fabs(a[l] + t * (b[l] - a[l]) - p[j]));
        }
        best = std::min(best, d);
      }
  return best;
}

/// At every sample the curves meet u = sample and v = sample as often as the exact fibre has points, and the
/// points lie near polylines.
void check_against_fibres(const BezierPatch& x, const IntersectionGraph& graph) {
  for (const std::size_t parameter : {0U, 1U})
    for (int k = 1; k < 12; ++k) {
      const Rational value(10 * k + 1, 120);
      CAPTURE(parameter, k);
      const auto fibre = self_fibre(x, parameter, value);
      CHECK(polyline_crossings(graph, parameter, to_double(value)) == static_cast<int>(fibre.size()));
      for (const CertifiedPoint& point : fibre) CHECK(distance_at(graph, parameter, point) < 0.02);
    }
}

void check_everything(const BezierPatch& x, const IntersectResult& result) {
  REQUIRE(result.status == Status::complete);
  check_on_locus(x, result.graph);
  check_geometry(x, result.graph);
  check_against_fibres(x, result.graph);
  for (const Arc& arc : result.graph.arcs) {
    CHECK(arc.error_bound > 0);
    CHECK(arc.error_bound <= 1e-6);
  }
}

bool is_at(const Node& node, const std::array<double, 4>& where) {
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational slack(1, 100000000000000);
    const Rational w = from_double(where[j]);
    if (node.box[j].lower > w + slack || node.box[j].upper < w - slack) return false;
  }
  return true;
}

int count_at(const IntersectionGraph& graph, NodeKind kind, const std::array<double, 4>& where) {
  return static_cast<int>(std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& node) {
    const std::array<double, 4> exchanged = {where[2], where[3], where[0], where[1]};
    return node.kinds.front() == kind && (is_at(node, where) || is_at(node, exchanged));
  }));
}

}  // namespace

TEST_CASE("self_intersect: no patch of the first example meets itself") {
  for (const std::size_t i : {0U, 1U}) {
    const auto result = self_intersect(example("chapter9-first.json", i));
    CHECK(result.status == Status::complete);
    CHECK(result.graph.nodes.empty());
    CHECK(result.graph.arcs.empty());
  }
}

TEST_CASE("self_intersect: one curve of the second example's x") {
  const BezierPatch x = example("chapter9-second.json", 0);
  const auto result = self_intersect(x);
  check_everything(x, result);
  CHECK(result.graph.components.size() == 1);
  CHECK(result.graph.count(ComponentShape::open) == 1);
  CHECK(result.graph.nodes.size() == 2);
  CHECK(count_at(result.graph, NodeKind::boundary,
                 {0.435436781509311, 0.743017458321801, 0.431265860133535, 0}) == 1);
  CHECK(count_at(result.graph, NodeKind::cusp,
                 {0.433004229933352, 0.371653919708524, 0.433004229933352, 0.371653919708524}) == 1);
}

TEST_CASE("self_intersect: three curves of the second example's y") {
  const BezierPatch y = example("chapter9-second.json", 1);
  const auto result = self_intersect(y);
  check_everything(y, result);
  CHECK(result.graph.components.size() == 3);
  CHECK(result.graph.count(ComponentShape::open) == 3);
  CHECK(result.graph.boundary_points() == 4);
  CHECK(count_at(result.graph, NodeKind::cusp,
                 {0.641586137419905, 0.766246599642083, 0.641586137419905, 0.766246599642083}) == 1);
  CHECK(count_at(result.graph, NodeKind::cusp,
                 {0.67726561881606, 0.713402751516765, 0.67726561881606, 0.713402751516765}) == 1);
}

TEST_CASE("self_intersect: degrees of the resultant form and of a line's eliminant") {
  for (const char* file : {"chapter9-first.json", "chapter9-second.json"})
    for (const std::size_t i : {0U, 1U}) {
      const BivariatePolynomial q = self_locus(example(file, i));
      CHECK(q.degree_r() == 10);
      CHECK(q.degree_s() == 10);
      CHECK(q.total_degree() == 14);
    }
}

TEST_CASE("self_intersect: options") {
  const BezierPatch y = example("chapter9-second.json", 1);
  IntersectOptions options;
  options.turning = {};
  options.tolerance = 1e-9;
  const auto result = self_intersect(y, options);
  CHECK(result.status == Status::complete);
  CHECK(result.graph.nodes.size() == 6);
  for (const Arc& arc : result.graph.arcs) CHECK(arc.error_bound <= 1e-9);
  options.tolerance = 1e-15;
  const auto coarse = self_intersect(y, options);
  CHECK(coarse.status == Status::complete);
  REQUIRE(coarse.coarse);
  CHECK(coarse.coarse->bound < 1e-10);
  options.tolerance = 0;
  CHECK_THROWS_AS(self_intersect(y, options), std::invalid_argument);
  options = {};
  options.max_seconds = 1e-9;
  const auto stopped = self_intersect(y, options);
  REQUIRE(stopped.status == Status::incomplete);
  CHECK(stopped.incomplete.front().why.find("work cap") != std::string::npos);
  options.max_seconds = -1;
  CHECK_THROWS_AS(self_intersect(y, options), std::invalid_argument);
}

TEST_CASE("a control point at -10^300: the cap is kept in the middle of long exact computations") {
  const BezierPatch x =
      read_patches(std::string(EXSECT_CASES) + "/found/corner-at-1e300.json").patches[0].patch;
  IntersectOptions options;
  options.tolerance = 0.1;
  options.max_seconds = 0.25;
  const std::clock_t begin = std::clock();
  const IntersectResult result = self_intersect(x, options);
  CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 5);
  CHECK(result.status == Status::incomplete);
}

}  // namespace exsect::self_intersect_test
