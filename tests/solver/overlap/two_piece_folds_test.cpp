// Two pieces of a surface that meets itself along one folded parameter line only, the same answer in every
// position of the fold: inside, on a side, in a corner, outside of what both pieces cover.
#include <exsect/solver/intersect.h>

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/random_pairs.h"
#include "support/renaming_checks.h"

namespace exsect::two_piece_folds_test {
namespace {

Rational q(int a, int b) { return {a, b}; }

/// u from, u to, v from, v to.
using Piece = std::array<Rational, 4>;

/// With a = u - 1/2: (a² + v²/3 + a²v²/5, a v + (a/3 + a²) v², v + v²/2 + a²v/4). For v >= -1/2 the first and
/// the third coordinate determine a² and v (their Jacobian with respect to these has positive minors). The
/// second one of (a,v) less that of (-a,v) is 2 a v (1 + v/3). So x(u,0) = x(1-u,0) and nothing else.
BezierPatch piece(const Piece& p) {
  ControlNet c{};  // in a and v
  c[2][0] = {1, 0, 0};
  c[0][1] = {0, 0, 1};
  c[1][1] = {0, 1, 0};
  c[2][1] = {0, 0, q(1, 4)};
  c[0][2] = {q(1, 3), 0, q(1, 2)};
  c[1][2] = {0, q(1, 3), 0};
  c[2][2] = {q(1, 5), 1, 0};
  const Rational half = q(1, 2);
  return BezierPatch::from_power_basis(c).restricted_to(p[0] - half, p[1] - half, p[2], p[3]);
}

struct Fold {
  const char* name;
  Piece x;
  Piece y;
  std::vector<std::array<Rational, 2>> arcs;  // values of u at the ends
  bool on_side;
};

const Fold folds[] = {
    {"on a side of both",
     {0, 1, 0, 1},
     {q(1, 4), q(5, 4), 0, q(1, 2)},
     {{0, q(1, 2)}, {q(1, 2), q(3, 4)}},
     true},
    {"in a corner of one", {0, q(1, 2), 0, 1}, {q(1, 4), 1, 0, q(1, 2)}, {{0, q(1, 2)}}, true},
    {"in a corner of one and inside the other",
     {0, q(1, 2), 0, 1},
     {q(1, 4), 1, q(-1, 4), q(1, 2)},
     {{0, q(1, 2)}},
     true},
    {"outside of what both cover", {0, q(1, 3), 0, 1}, {q(1, 4), 1, 0, q(1, 2)}, {{0, q(1, 3)}}, true},
    {"inside",
     {0, 1, q(-1, 2), 1},
     {q(1, 4), q(5, 4), q(-1, 4), q(1, 2)},
     {{0, q(1, 2)}, {q(1, 2), q(3, 4)}},
     false}};

/// The parameter of the piece with this value.
double in_piece(const Piece& p, std::size_t j, double value) {
  const double from = to_double(p[2 * j]);
  return (value - from) / (to_double(p[2 * j + 1]) - from);
}

void check_arcs(const Fold& fold, const IntersectionGraph& graph) {
  REQUIRE(graph.arcs.size() == fold.arcs.size());
  CHECK(graph.overlaps.size() == 1);
  CHECK(graph.isolated_points.empty());
  std::vector<std::array<double, 2>> ends;
  for (const Arc& arc : graph.arcs) {
    CHECK(arc.contact == Contact::transversal);
    CHECK(arc.place == (fold.on_side ? ArcPlace::patch_boundary : ArcPlace::interior));
    std::array<double, 2> u{};
    for (const PolylineVertex& vertex : arc.polyline) {
      const double at = to_double(fold.x[0]) + vertex.parameters[0] * to_double(fold.x[1] - fold.x[0]);
      CHECK(vertex.parameters[1] == Approx(in_piece(fold.x, 1, 0)).margin(1e-9));
      CHECK(vertex.parameters[2] == Approx(in_piece(fold.y, 0, 1 - at)).margin(1e-9));
      CHECK(vertex.parameters[3] == Approx(in_piece(fold.y, 1, 0)).margin(1e-9));
      (&vertex == &arc.polyline.front() ? u[0] : u[1]) = at;
    }
    ends.push_back({std::min(u[0], u[1]), std::max(u[0], u[1])});
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (const std::size_t k : {0U, 1U}) CHECK(ends[i][k] == Approx(to_double(fold.arcs[i][k])).margin(1e-9));
}

IntersectResult without_turning_points(const BezierPatch& x, const BezierPatch& y) {
  IntersectOptions options;
  options.turning = {};
  return complete_intersection(x, y, options);
}

}  // namespace

TEST_CASE("two pieces: pairs on a folded line, wherever the fold is") {
  random_pairs::Generator generator(12);
  for (const Fold& fold : folds) {
    INFO("the fold is " << fold.name);
    const BezierPatch x = piece(fold.x);
    const BezierPatch y = piece(fold.y);
    const IntersectResult result = without_turning_points(x, y);
    check_arcs(fold, result.graph);
    const auto same = [&](const BezierPatch& a, const BezierPatch& b, const Renaming& change) {
      CHECK(difference(result.graph, without_turning_points(a, b).graph, change, 1e-3) == "");
    };
    same(y, x, {{2, 3, 0, 1}, {}});
    same(x.exchanged(), y.exchanged(), {{1, 0, 3, 2}, {}});
    same(x, y.exchanged(), {{0, 1, 3, 2}, {}});
    same(x.reversed_first(), y.reversed_second(), {{0, 1, 2, 3}, {true, false, false, true}});
    const random_pairs::AffineMap map = random_pairs::affine_map(generator);
    same(map(x), map(y), {{0, 1, 2, 3}, {}});
  }
}

}  // namespace exsect::two_piece_folds_test
