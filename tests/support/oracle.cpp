// Subdivision: cells of parameter space are dropped when F cannot vanish in them and halved until F = 0 is
// provably (up to rounding) a single graph over one parameter there; one point of each such graph is
// computed. The same with one parameter fixed gives the boundary points. Every component of the intersection
// has a boundary point or is a closed curve through one of the points found; all are followed in small steps.
#include "support/oracle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/oracle_system.h"

namespace exsect::oracle {
namespace {

constexpr double same = 1e-8;          // points closer than this are one
constexpr double near_edge = 1e-7;     // boundary points this near to an edge are in doubt
constexpr double longest_step = 0.01;  // of a trace
constexpr std::size_t most_cells = 400000;
constexpr std::size_t most_cells_on_line = 20000;
constexpr int deepest = 22;

struct Doubt : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// |z - centre|_i <= half_i; half is zero for a fixed parameter.
struct Cell {
  Vector4 centre;
  Vector4 half;
  int depth;
};

enum class Verdict { empty, split, graph };

/// Whether F has no zero in the cell: |d . F| exceeds what the cell can change of it, for an axis or a normal
/// d.
bool excluded(const Expansion& e, const Cell& cell, double size) {
  const Vector3 rest = e.remainder(cell.half);
  const std::array<Vector3, 5> directions = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1},
                                             cross(e.column[0], e.column[1]),
                                             cross(e.column[2], e.column[3])};
  return std::any_of(directions.begin(), directions.end(), [&](const Vector3& d) {
    double reach = 0;
    for (std::size_t i = 0; i < 4; ++i) reach += std::abs(dot(d, e.column[i])) * cell.half[i];
    for (std::size_t k = 0; k < 3; ++k) reach += std::abs(d[k]) * (rest[k] + 1e-13 * size);
    return std::abs(dot(d, e.value)) > reach;
  });
}

/// |m| a by components.
Vector3 absolute_product(const Matrix3& m, const Vector3& a) {
  Vector3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i] += std::abs(m[i][k]) * a[k];
  }
  return result;
}

/// graph: in the cell three times as large F = 0 is a graph over parameter t, of slope at most 2 in the other
/// three, so that an arc that meets the cell has its point over the centre in the larger cell. For a fixed t:
/// at most one zero. The contraction is that of z -> z - A F with A the inverse of the Jacobian at the
/// centre.
Verdict classify(const Expansion& e, const Cell& cell, std::size_t t) {
  std::array<std::size_t, 3> others{};
  for (std::size_t i = 0, k = 0; i < 4; ++i) {
    if (i != t) others[k++] = i;
  }
  const auto a = inverse_of_columns(e.column[others[0]], e.column[others[1]], e.column[others[2]]);
  if (!a) return Verdict::split;
  Vector4 wide = cell.half;
  for (double& w : wide) w *= 3;
  Vector3 contraction{};
  for (const std::size_t i : others) {
    const Vector3 part = absolute_product(*a, e.deviation(i, wide));
    for (std::size_t k = 0; k < 3; ++k) contraction[k] += part[k];
  }
  const double q = *std::max_element(contraction.begin(), contraction.end());
  if (!(q < 0.5)) return Verdict::split;
  const double reach = wide[others[0]];
  const Vector3 change = absolute_product(*a, e.deviation(t, wide));
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(dot((*a)[k], e.value)) > reach * (1 + q)) return Verdict::empty;
    const double slope = (std::abs(dot((*a)[k], e.column[t])) + change[k]) / (1 - q);
    if (cell.half[t] > 0 && slope > 2) return Verdict::split;
  }
  return Verdict::graph;
}

void push_children(std::vector<Cell>& stack, const Cell& cell) {
  for (unsigned corner = 0; corner < 16; ++corner) {
    Cell child = cell;
    ++child.depth;
    bool skip = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool upper = (corner >> i & 1U) != 0;
      skip = skip || (cell.half[i] == 0 && upper);
      child.half[i] = cell.half[i] / 2;
      child.centre[i] += upper ? child.half[i] : -child.half[i];
    }
    if (!skip) stack.push_back(child);
  }
}

/// A point of every graph met; zeros of F with parameter `fixed` held if given (then all of them).
std::vector<Vector4> points_in(const System& system, Cell start, std::optional<std::size_t> fixed,
                               std::size_t most = most_cells) {
  std::vector<Vector4> found;
  std::vector<Cell> stack = {start};
  for (std::size_t cells = 0; !stack.empty(); ++cells) {
    const Cell cell = stack.back();
    stack.pop_back();
    const Expansion e = system.at(cell.centre);
    if (excluded(e, cell, system.size())) continue;
    if (cells > most || cell.depth > deepest) throw Doubt("a nearly singular point");
    std::size_t t = fixed.value_or(0);
    if (const auto tangent = fixed ? std::nullopt : system.tangent(cell.centre)) {
      const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
      t = static_cast<std::size_t>(std::max_element(tangent->begin(), tangent->end(), less) -
                                   tangent->begin());
    }
    const Verdict verdict = classify(e, cell, t);
    if (verdict == Verdict::split) push_children(stack, cell);
    if (verdict != Verdict::graph) continue;
    const auto z = system.newton(cell.centre, axis(t));
    const double reach = 3 * *std::max_element(cell.half.begin(), cell.half.end());
    if (!z || distance(*z, cell.centre) > reach) continue;
    const auto known = [&](const Vector4& other) { return distance(other, *z) < same; };
    if (std::none_of(found.begin(), found.end(), known)) found.push_back(*z);
  }
  return found;
}

bool in_domain(const Vector4& z) {
  return std::all_of(z.begin(), z.end(), [](double a) { return a >= 0 && a <= 1; });
}

struct BoundaryPoint {
  Vector4 z;
  Vector4 tangent;
  double inward;  // 1 or -1: the orientation of the tangent that leads into the domain
  bool used = false;
};

std::vector<BoundaryPoint> boundary_points(const System& system) {
  std::vector<BoundaryPoint> result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const double value : {0.0, 1.0}) {
      Cell face = {{0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, 0};
      face.centre[i] = value;
      face.half[i] = 0;
      for (const Vector4& z : points_in(system, face, i)) {
        double inside = 1;  // distance to the other sides, negative outside
        for (std::size_t j = 0; j < 4; ++j) {
          if (j != i) inside = std::min({inside, z[j], 1 - z[j]});
        }
        if (inside < -near_edge) continue;
        const auto tangent = system.tangent(z);
        if (inside < near_edge) throw Doubt("a boundary point at a corner");
        if (!tangent || std::abs((*tangent)[i]) < 1e-4) throw Doubt("a curve tangent to the boundary");
        const bool forward = ((*tangent)[i] > 0) == (value == 0);
        result.push_back({z, *tangent, forward ? 1.0 : -1.0});
      }
    }
  }
  return result;
}

/// Where a trace is and where it goes: `ahead` is the unit tangent times `orientation`, which never changes.
struct Position {
  Vector4 z;
  Vector4 ahead;
  double orientation;
};

/// One step of length at most h along the curve; h becomes the length taken.
Position advance(const System& system, const Position& from, double& h) {
  for (; h > 1e-7; h /= 2) {
    const Vector4 predicted = along(from.z, h, from.ahead);
    const auto corrected = system.newton(predicted, from.ahead);
    if (!corrected || distance(*corrected, predicted) > 0.1 * h) continue;
    const auto tangent = system.tangent(*corrected);
    if (!tangent) continue;
    const Position next = {*corrected, along({}, from.orientation, *tangent), from.orientation};
    if (dot(next.ahead, from.ahead) > 0.995) return next;
  }
  throw Doubt("a curve that cannot be followed");
}

/// The first boundary point on the way from z to the next point, which is outside the domain.
std::size_t crossing(const System& system, const Vector4& z, const Vector4& next, const Vector4& ahead,
                     const std::vector<BoundaryPoint>& ends) {
  double first = 2 * longest_step;
  std::size_t result = ends.size();
  for (std::size_t i = 0; i < 4; ++i) {
    if (next[i] >= 0 && next[i] <= 1) continue;
    const double value = next[i] < 0 ? 0 : 1;
    const double fraction = (value - z[i]) / (next[i] - z[i]);
    Vector4 guess = along(z, fraction, along(next, -1, z));
    guess[i] = value;
    const auto hit = system.newton(guess, axis(i));
    if (!hit) throw Doubt("a crossing of the boundary that is not found");
    const double way = dot(along(*hit, -1, z), ahead);
    if (way >= first) continue;
    first = way;
    result = ends.size();
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (distance(ends[k].z, *hit) < same) result = k;
    }
  }
  if (result == ends.size()) throw Doubt("a crossing of the boundary that is no boundary point");
  return result;
}

/// Whether the step from z to next passes the point `start` of the same curve.
bool passes(const Vector4& z, const Vector4& next, const Vector4& start, const Vector4& direction) {
  const double before = dot(along(z, -1, start), direction);
  const double after = dot(along(next, -1, start), direction);
  if (before >= 0 || after < 0) return false;
  const Vector4 meeting = along(z, before / (before - after), along(next, -1, z));
  return distance(meeting, start) < 0.1 * distance(z, next);
}

/// Follows the curve from `start` along `orientation` times its tangent until it closes or meets a boundary
/// point, which is then used.
Curve follow(const System& system, const Vector4& start, const Vector4& tangent, double orientation,
             std::vector<BoundaryPoint>& ends) {
  Curve curve = {false, {start}};
  const Vector4 direction = along({}, orientation, tangent);
  Position position = {start, direction, orientation};
  double h = longest_step;
  while (curve.points.size() < 100000) {
    h = std::min(2 * h, longest_step);
    const Position next = advance(system, position, h);
    if (!in_domain(next.z)) {
      BoundaryPoint& end = ends[crossing(system, position.z, next.z, position.ahead, ends)];
      if (end.used) throw Doubt("two curves that end in one boundary point");
      end.used = true;
      curve.points.push_back(end.z);
      return curve;
    }
    if (curve.points.size() > 3 && passes(position.z, next.z, start, direction)) {
      curve.points.push_back(start);
      curve.closed = true;
      return curve;
    }
    curve.points.push_back(next.z);
    position = next;
  }
  throw Doubt("an endless curve");
}

/// Whether the curve passes through z, a zero of F: Newton's method leads there from a neighbouring vertex.
bool contains(const System& system, const Curve& curve, const Vector4& z) {
  return std::any_of(curve.points.begin(), curve.points.end(), [&](const Vector4& vertex) {
    if (distance(vertex, z) > longest_step) return false;
    if (distance(vertex, z) < same) return true;
    const auto tangent = system.tangent(vertex);
    if (!tangent) return false;
    const Vector4 foot = along(vertex, dot(along(z, -1, vertex), *tangent), *tangent);
    if (distance(foot, z) > 0.1 * distance(vertex, z)) return false;
    const auto reached = system.newton(foot, *tangent);
    return reached && distance(*reached, z) < same;
  });
}

void find_curves(const System& system, Intersection& result) {
  std::vector<BoundaryPoint> ends = boundary_points(system);
  for (const BoundaryPoint& end : ends) result.boundary_points.push_back(end.z);
  for (BoundaryPoint& end : ends) {
    if (end.used) continue;
    end.used = true;
    result.curves.push_back(follow(system, end.z, end.tangent, end.inward, ends));
  }
  for (const Vector4& z : points_in(system, {{0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, 0}, std::nullopt)) {
    const auto through = [&](const Curve& curve) { return contains(system, curve, z); };
    if (!in_domain(z) || std::any_of(result.curves.begin(), result.curves.end(), through)) continue;
    const auto tangent = system.tangent(z);
    if (!tangent) throw Doubt("a singular point");
    result.curves.push_back(follow(system, z, *tangent, 1, ends));
    if (!result.curves.back().closed) throw Doubt("an open curve that no boundary point leads to");
  }
}

}  // namespace

int Intersection::closed() const {
  return static_cast<int>(
      std::count_if(curves.begin(), curves.end(), [](const Curve& c) { return c.closed; }));
}

int Intersection::open() const { return static_cast<int>(curves.size()) - closed(); }

Intersection intersect(const RationalPatch& x, const RationalPatch& y) {
  Intersection result;
  try {
    find_curves(System(x, y), result);
  } catch (const Doubt& doubt) {
    result.doubt = doubt.what();
  }
  return result;
}

LinePoints line_points(const RationalPatch& x, const RationalPatch& y, std::size_t i, double value) {
  LinePoints result;
  try {
    Cell line = {{0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, 0};
    line.centre[i] = value;
    line.half[i] = 0;
    for (const Vector4& z : points_in(System(x, y), line, i, most_cells_on_line)) {
      double inside = 1;
      for (std::size_t j = 0; j < 4; ++j) {
        if (j != i) inside = std::min({inside, z[j], 1 - z[j]});
      }
      if (std::abs(inside) < near_edge) throw Doubt("a solution close to an edge");
      if (inside > 0) result.points.push_back(z);
    }
  } catch (const Doubt& doubt) {
    result.doubt = doubt.what();
  }
  return result;
}

}  // namespace exsect::oracle
