// Curves of round surfaces in doubles against the exact route, and against both equations.
#include "filter/round_intersection.h"

#include <exsect/solver/intersect_equations.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::round_intersection_test {
namespace {

using S = ImplicitSurface;
const Point up = {0, 0, 1};

std::function<double(double)> relative(double tolerance) {
  return [tolerance](double extent) { return tolerance * extent; };
}

SurfaceIntersection exactly(const S& first, const S& second) {
  IntersectOptions options;
  options.exact = true;
  options.tolerance = 1e-4;
  return intersect(first, second, options);
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], std::hypot(a[1] - b[1], a[2] - b[2]));
}

/// From the point to the chords, and so the greatest of one polyline's vertices to the other polylines.
double distance_to(const SurfaceIntersection& result, const std::array<double, 3>& p) {
  double least = INFINITY;
  for (const SpaceArc& arc : result.arcs)
    for (std::size_t k = 0; k + 1 < arc.polyline.size(); ++k) {
      const auto &a = arc.polyline[k], &b = arc.polyline[k + 1];
      double along = 0, squared = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        along += (p[i] - a[i]) * (b[i] - a[i]);
        squared += (b[i] - a[i]) * (b[i] - a[i]);
      }
      const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
      least = std::min(
          least, distance(p, {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])}));
    }
  return least;
}

double bound_of(const SurfaceIntersection& result) {
  double bound = 0;
  for (const SpaceArc& arc : result.arcs) bound = std::max(bound, arc.error_bound);
  return bound;
}

void check_near(const SurfaceIntersection& a, const SurfaceIntersection& b) {
  const double allowed = bound_of(a) + bound_of(b);
  for (const SpaceArc& arc : a.arcs)
    for (std::size_t k = 0; k < arc.polyline.size(); k += 7)
      CHECK(distance_to(b, arc.polyline[k]) <= allowed);
}

/// Every node is in its box, has two ends of arcs, and is the end of their polylines.
void check_graph(const SurfaceIntersection& result) {
  std::vector<int> ends(result.nodes.size(), 0);
  for (const SpaceArc& arc : result.arcs)
    for (const bool is_end : {false, true}) {
      const SpaceNode& node = result.nodes[static_cast<std::size_t>(is_end ? arc.to : arc.from)];
      ++ends[static_cast<std::size_t>(node.id)];
      CHECK(distance(node.approx, is_end ? arc.polyline.back() : arc.polyline.front()) < 1e-10);
      CHECK(arc.multiplicity == 1);
    }
  for (const SpaceNode& node : result.nodes) {
    CHECK(node.kind == SpaceNodeKind::joint);
    CHECK(ends[static_cast<std::size_t>(node.id)] == 2);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(to_double(node.box[k].width()) < 1e-9);
      CHECK(node.box[k].lower <= from_double(node.approx[k]));
      CHECK(from_double(node.approx[k]) <= node.box[k].upper);
    }
  }
}

std::array<double, 3> gradient(const S& surface, const std::array<double, 3>& p) {
  std::array<double, 3> n{};
  for (std::size_t k = 0; k < 3; ++k)
    n[k] = to_double(
        surface.equation().derivative(k)({from_double(p[0]), from_double(p[1]), from_double(p[2])}));
  return n;
}

/// (17.28) in the middle of each arc.
void check_sides(const S& first, const S& second, const SurfaceIntersection& result) {
  for (const SpaceArc& arc : result.arcs) {
    const auto &p = arc.polyline[arc.polyline.size() / 2], &q = arc.polyline[arc.polyline.size() / 2 + 1];
    const auto a = gradient(first, p), b = gradient(second, p);
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k)
      along += (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) * (q[k] - p[k]);
    CHECK(arc.beside.value().right == (along > 0 ? 1 : -1));
    CHECK(arc.beside.value().left == (along > 0 ? -1 : 1));
  }
}

}  // namespace

TEST_CASE("round intersection: as many curves as the exact route, at the same places") {
  const S torus = S::torus({0, 0, 0}, {1, 2, 3}, 3, 1),
          narrow = S::cylinder({Rational(1, 5), 0, 0}, {1, 1, 0}, 1);
  const std::vector<std::pair<S, S>> pairs = {
      {S::cylinder({0, 0, 0}, up, 2), narrow},
      {torus, narrow},
      {torus, S::torus({2, 0, 0}, up, 2, Rational(3, 4))},
      {torus, S::sphere({2, 1, 0}, 2)},
      {torus, S::plane({0, 0, Rational(1, 2)}, {1, 0, 4})},
      {torus, S::cone({0, 0, -4}, {0, 1, 5}, Rational(1, 2))},
      {S::cone({0, 0, 4}, {0, 0, -1}, Rational(1, 3)), narrow},
      {S::cone({0, 0, 4}, {0, 0, -1}, Rational(1, 3)), S::sphere({Rational(1, 2), 1, 0}, 2)},
      {S::cone({0, 0, 4}, {0, 0, -1}, Rational(1, 3), 2),
       S::cone({3, Rational(1, 4), 1}, {-1, 0, 0}, Rational(1, 4))},
      {narrow, S::sphere({1, 0, 0}, Length::of_squared(2))}};
  for (const auto& [a, b] : pairs)
    for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
      INFO(name(first.kind()) << ' ' << name(second.kind()));
      const auto found = round_intersection(first, second, relative(1e-5));
      REQUIRE(found);
      const SurfaceIntersection exact = exactly(first, second);
      CHECK(found->curves.size() == exact.curves.size());
      CHECK_FALSE(found->curves.empty());
      check_graph(*found);
      check_sides(first, second, *found);
      check_near(*found, exact);
      check_near(exact, *found);
    }
}

TEST_CASE("round intersection: polylines keep the tolerance, and vertices are on both surfaces") {
  const S torus = S::torus({0, 0, 0}, {1, 2, 3}, 3, 1),
          other = S::cylinder({1, 0, 0}, {1, 1, 0}, Rational(3, 2));
  const auto fine = round_intersection(torus, other, relative(1e-7)).value();
  for (const double tolerance : {1e-3, 1e-5}) {
    const auto found = round_intersection(torus, other, relative(tolerance)).value();
    CHECK(bound_of(found) <= 8 * tolerance);
    check_near(fine, found);
    for (const SpaceArc& arc : found.arcs)
      for (const auto& p : arc.polyline)
        for (const S& s : {torus, other})
          CHECK(std::fabs(to_double(s.equation()(
                    {from_double(p[0]), from_double(p[1]), from_double(p[2])}))) < 300 * tolerance);
  }
  CHECK_FALSE(round_intersection(torus, other, relative(1e-17)));
  // Vertices are on the curve also where chords are far from it: it is in no plane.
  for (const double tolerance : {0.03, 0.06, 0.1})
    CHECK(round_intersection(torus, other, relative(tolerance)));
}

TEST_CASE("round intersection: conics, contact and boxes are left to others") {
  const S torus = S::torus({0, 0, 0}, up, 3, 1), cylinder = S::cylinder({0, 0, 0}, up, 1);
  CHECK_FALSE(round_intersection(torus, S::plane({0, 0, 0}, {1, 0, 0}), relative(1e-4)));  // two circles
  CHECK_FALSE(round_intersection(torus, S::plane({0, 0, 0}, up), relative(1e-4)));
  CHECK_FALSE(round_intersection(cylinder, S::sphere({0, 0, 0}, 2), relative(1e-4)));
  // Two ellipses that cross.
  CHECK_FALSE(round_intersection(cylinder, S::cylinder({0, 0, 0}, {0, 1, 1}, 1), relative(1e-4)));
  // A sphere about a point of the torus's circle: a circle of the torus.
  CHECK_FALSE(round_intersection(torus, S::sphere({3, 0, 0}, 1), relative(1e-4)));
  CHECK(round_intersection(cylinder, S::sphere({9, 0, 0}, 2), relative(1e-4))->nodes.empty());
}

TEST_CASE("round intersection: nearly touching pairs are answered as by the exact route, or not at all") {
  int decided = 0;
  for (const int digits : {1, 3, 7, 20})
    for (const int sign : {-1, 1}) {
      Rational gap = sign;
      for (int k = 0; k < digits; ++k) gap /= 10;
      for (const auto& [a, b] :
           {std::pair(S::cylinder({0, 0, 0}, up, 1), S::cylinder({2 + gap, 0, 0}, {0, 3, 1}, 1)),
            std::pair(S::torus({0, 0, 0}, up, 3, 1), S::sphere({5 + gap, 0, 0}, 1)),
            std::pair(S::torus({0, 0, 0}, up, 3, 1), S::cylinder({2 + gap, 0, 0}, {0, 1, 2}, 1)),
            std::pair(S::cylinder({0, 0, 0}, up, 1), S::cylinder({0, gap, 0}, {1, 0, 0}, 1))}) {
        const auto found = round_intersection(a, b, relative(1e-3));
        if (!found) continue;
        ++decided;
        CHECK(found->curves.size() == exactly(a, b).curves.size());
      }
    }
  CHECK(decided > 10);
}

}  // namespace exsect::round_intersection_test
