// The exact points of random lines against a search in doubles: subdivision by control polygons, then Newton.
#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::line_oracle_test {

namespace {

using Vector = std::array<double, 3>;

Vector mid(const Vector& a, const Vector& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

using Arc = std::array<Vector, 3>;
using Net = std::array<Arc, 3>;

std::pair<Arc, Arc> halves(const Arc& p) {
  const Vector a = mid(p[0], p[1]);
  const Vector b = mid(p[1], p[2]);
  const Vector c = mid(a, b);
  return {{p[0], a, c}, {c, b, p[2]}};
}

Net transposed(const Net& n) {
  Net t;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) t[j][i] = n[i][j];
  return t;
}

/// Halves along the second parameter.
std::pair<Net, Net> column_halves(const Net& n) {
  std::pair<Net, Net> result;
  for (std::size_t i = 0; i < 3; ++i) std::tie(result.first[i], result.second[i]) = halves(n[i]);
  return result;
}

struct Cell {
  Arc arc;
  Net net;
  double t, r, s, size;
};

Vector value(const Arc& p, double t) {
  Vector v;
  for (std::size_t k = 0; k < 3; ++k)
    v[k] = p[0][k] * (1 - t) * (1 - t) + 2 * p[1][k] * t * (1 - t) + p[2][k] * t * t;
  return v;
}

Vector slope(const Arc& p, double t) {
  Vector v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = 2 * ((p[1][k] - p[0][k]) * (1 - t) + (p[2][k] - p[1][k]) * t);
  return v;
}

double det(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

class Search {
 public:
  Search(const Arc& arc, const Net& net) : arc_(arc), net_(net) { descend({arc, net, 0, 0, 0, 1}); }
  std::vector<Vector> roots;  // (t,r,s) clearly inside
  bool doubtful = false;      // a root near the boundary, or Newton failed: no verdict

 private:
  static bool apart(const Cell& cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      double a0 = 1e9, a1 = -1e9, b0 = 1e9, b1 = -1e9;
      for (const Vector& p : cell.arc) a0 = std::min(a0, p[k]), a1 = std::max(a1, p[k]);
      for (const Arc& row : cell.net)
        for (const Vector& p : row) b0 = std::min(b0, p[k]), b1 = std::max(b1, p[k]);
      if (a1 < b0 - 1e-9 || b1 < a0 - 1e-9) return true;
    }
    return false;
  }

  void descend(const Cell& c) {
    if (apart(c)) return;
    if (c.size < 1.0 / 40) {
      newton(c.t + c.size / 2, c.r + c.size / 2, c.s + c.size / 2);
      return;
    }
    const double h = c.size / 2;
    const auto [left, right] = halves(c.arc);
    const auto [low_s, high_s] = column_halves(c.net);
    for (int i = 0; i < 8; ++i) {
      const auto [low, high] = column_halves(transposed((i & 1) != 0 ? high_s : low_s));
      descend({(i & 4) != 0 ? right : left, transposed((i & 2) != 0 ? high : low),
               c.t + ((i & 4) != 0 ? h : 0), c.r + ((i & 2) != 0 ? h : 0), c.s + ((i & 1) != 0 ? h : 0), h});
    }
  }

  void newton(double t, double r, double s) {
    for (int i = 0; i < 40; ++i) {
      const Net columns = transposed(net_);
      const Arc along_r = {value(net_[0], s), value(net_[1], s), value(net_[2], s)};
      const Arc along_s = {value(columns[0], r), value(columns[1], r), value(columns[2], r)};
      const Vector p = value(arc_, t);
      const Vector q = value(along_r, r);
      const Vector f = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      const Vector pt = slope(arc_, t);
      Vector qr = slope(along_r, r);
      Vector qs = slope(along_s, s);
      for (std::size_t k = 0; k < 3; ++k) qr[k] = -qr[k], qs[k] = -qs[k];
      const double d = det(pt, qr, qs);
      if (std::fabs(d) < 1e-7) break;
      const double dt = det(f, qr, qs) / d;
      const double dr = det(pt, f, qs) / d;
      const double ds = det(pt, qr, f) / d;
      t -= dt, r -= dr, s -= ds;
      if (std::fabs(t) + std::fabs(r) + std::fabs(s) > 20) return;
      if (std::fabs(dt) + std::fabs(dr) + std::fabs(ds) < 1e-13) return accept({t, r, s});
    }
    doubtful = true;
  }

  void accept(const Vector& root) {
    bool inside = true;
    for (const double x : root) {
      if (std::fabs(x) < 1e-9 || std::fabs(x - 1) < 1e-9) doubtful = true;
      inside = inside && x > 0 && x < 1;
    }
    if (!inside) return;
    for (const Vector& known : roots) {
      double distance = 0;
      for (std::size_t k = 0; k < 3; ++k) distance = std::max(distance, std::fabs(known[k] - root[k]));
      if (distance < 1e-9) return;
    }
    roots.push_back(root);
  }

  Arc arc_;
  Net net_;
};

Vector to_doubles(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

Search search_line(const BezierPatch& x, const BezierPatch& y, const Rational& u) {
  const ParameterLine p = line_at_first(x, u);
  const auto& [a0, a1, a2] = p.a;
  Net net;
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t n = 0; n < 3; ++n) net[m][n] = to_doubles(y.net()[m][n]);
  return {{to_doubles(a0), to_doubles(a0 + Rational(1, 2) * a1), to_doubles(a0 + a1 + a2)}, net};
}

struct Tally {
  int decided = 0;
  std::size_t points = 0;
};

void compare(const BezierPatch& x, const BezierPatch& y, const Rational& u, Tally& tally) {
  const LineIntersection line = intersect_line(x, y, {Parameter::u, u});
  CHECK(!line.solution.incomplete);
  for (const CertifiedPoint& q : line.solution.points) check_point(x, y, q);
  check_feasibility(line);
  const Search search = search_line(x, y, u);
  if (search.doubtful || !line.solution.on_patch.empty()) return;
  ++tally.decided;
  tally.points += search.roots.size();
  CHECK(line.solution.points.size() == search.roots.size());
  for (const Vector& root : search.roots)
    CHECK(std::ranges::any_of(line.solution.points, [&](const CertifiedPoint& q) {
      double distance = 0;
      for (std::size_t k = 0; k < 3; ++k)
        distance = std::max(distance, std::fabs(to_double(q.box()[k + 1].midpoint()) - root[k]));
      return distance < 1e-8;
    }));
}

using Rows = std::vector<std::vector<Point>>;

/// A patch of lower bidegree, elevated: the control points of a random one at the right distance.
BezierPatch random_of_degree(std::mt19937& random, std::size_t m, std::size_t n, int denominator) {
  const ControlNet net = random_patch(random, denominator).net();
  Rows rows;
  for (std::size_t i = 0; i <= m; ++i) {
    rows.emplace_back();
    for (std::size_t j = 0; j <= n; ++j) rows.back().push_back(net[m == 1 ? 2 * i : i][n == 1 ? 2 * j : j]);
  }
  return BezierPatch::elevated(rows);
}

/// Over (u,v) itself, up to the height.
BezierPatch random_height_field(std::mt19937& random, int denominator) {
  ControlNet net = random_patch(random, denominator).net();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {Rational(static_cast<int>(i), 2), Rational(static_cast<int>(j), 2), net[i][j][2]};
  return BezierPatch(net);
}

/// In the plane 3 z = x - y + 1/4.
BezierPatch random_planar(std::mt19937& random, int denominator) {
  ControlNet net = random_patch(random, denominator).net();
  for (auto& row : net)
    for (Point& p : row) p[2] = (p[0] - p[1] + Rational(1, 4)) / 3;
  return BezierPatch(net);
}

BezierPatch random_shape(std::mt19937& random, int kind, int denominator) {
  switch (kind) {
    case 0:
      return random_patch(random, denominator);
    case 1:
      return random_of_degree(random, 2, 1, denominator);
    case 2:
      return random_of_degree(random, 1, 2, denominator);
    case 3:
      return random_of_degree(random, 1, 1, denominator);
    case 4:
      return random_height_field(random, denominator);
    default:
      return random_planar(random, denominator);
  }
}

}  // namespace

TEST_CASE("the points of random lines are those a search in doubles finds") {
  const unsigned seed = 4711;
  std::mt19937 random(seed);
  Tally tally;
  for (int i = 0; i < 50; ++i) {
    INFO("seed " << seed << ", pair " << i);
    const auto [x, y] = random_pair(random, 7);
    compare(x, y, Rational(i % 11, 10), tally);
  }
  CHECK(tally.decided > 40);
  CHECK(tally.points > 20);
}

TEST_CASE("the points of lines on special shapes are those a search in doubles finds") {
  const unsigned seed = 815;
  std::mt19937 random(seed);
  Tally tally;
  for (int first = 0; first < 6; ++first)
    for (int second = 0; second < 6; ++second) {
      INFO("seed " << seed << ", shapes " << first << " and " << second);
      // Denominator 1: many coincidences; 5: few.
      for (const int denominator : {1, 5}) {
        const BezierPatch x = random_shape(random, first, denominator);
        compare(x, random_shape(random, second, denominator), Rational(2, 5), tally);
      }
    }
  CHECK(tally.decided > 30);
  CHECK(tally.points > 15);
}

}  // namespace exsect::line_oracle_test
