#include "support/exact_oracle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "support/exact_tensor.h"

namespace exsect::exact_oracle {
namespace {

struct Doubt : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct Contradiction : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr int most_cells = 6000;
constexpr int deepest = 60;     // halvings of a cell, in turn
constexpr int refinement = 60;  // halvings of a box with one solution

using Box = std::array<RationalInterval, 3>;

struct Cell {
  System system;
  Box box;
  int depth;
};

bool inside(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i].lower < b[i].lower || a[i].upper > b[i].upper) return false;
  return true;
}

bool disjoint(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i].upper < b[i].lower || b[i].upper < a[i].lower) return true;
  return false;
}

Cell half(const Cell& cell, int end) {
  Cell result = cell;
  const auto axis = static_cast<std::size_t>(cell.depth % 3);
  for (Tensor& tensor : result.system) tensor = tensor.cut(axis, 1, 2, end);
  (end == 0 ? result.box[axis].upper : result.box[axis].lower) = cell.box[axis].midpoint();
  ++result.depth;
  return result;
}

Cell widened(const Cell& cell) {
  Cell result = cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (Tensor& tensor : result.system) tensor = tensor.widened(axis);
    const Rational more = cell.box[axis].width() / 2;
    result.box[axis] = {cell.box[axis].lower - more, cell.box[axis].upper + more};
  }
  return result;
}

/// A smaller box around the only zero in the cell, whose functions are nearly its coordinates.
Box refined(Cell cell) {
  cell.depth = 0;
  std::vector<Cell> kept = {cell};
  for (int level = 0; level < refinement; ++level) {
    std::vector<Cell> next;
    for (const Cell& parent : kept)
      for (const int end : {0, 1}) {
        const Cell child = half(parent, end);
        if (!has_no_zero(child.system)) next.push_back(child);
      }
    if (next.empty() || next.size() > 64) throw Doubt("a solution that is not enclosed");
    kept = next;
  }
  Box result = kept.front().box;
  for (const Cell& part : kept)
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = {std::min(result[i].lower, part.box[i].lower),
                   std::max(result[i].upper, part.box[i].upper)};
  return result;
}

struct Zero {
  Box alone;  // no other zero is here
  Box box;
};

void enter(const Zero& zero, std::vector<Zero>& found) {
  const Box domain = {RationalInterval{0, 1}, {0, 1}, {0, 1}};
  if (disjoint(zero.box, domain)) return;
  if (!inside(zero.box, domain)) throw Doubt("a solution next to a side");
  for (const RationalInterval& at : zero.box)
    if (at.lower <= 0 || at.upper >= 1) throw Doubt("a solution next to a side");
  for (const Zero& other : found) {
    if (inside(zero.box, other.alone) || inside(other.box, zero.alone)) return;
    if (!disjoint(zero.box, other.box)) throw Doubt("two solutions that are not told apart");
  }
  found.push_back(zero);
}

std::vector<Zero> zeros(const System& system) {
  std::vector<Zero> found;
  std::vector<Cell> stack = {{system, {RationalInterval{0, 1}, {0, 1}, {0, 1}}, 0}};
  for (int count = 0; !stack.empty(); ++count) {
    const Cell cell = stack.back();
    stack.pop_back();
    if (has_no_zero(cell.system)) continue;
    const auto matrix = preconditioner(cell.system);
    if (has_no_zero(combined(matrix, cell.system))) continue;
    if (count > most_cells || cell.depth > deepest) throw Doubt("a line that touches, or nearly");
    if (cell.depth >= 6) {
      Cell wide = widened(cell);
      wide.system = combined(matrix, wide.system);
      if (has_one_zero(wide.system)) {
        enter({wide.box, refined(wide)}, found);
        continue;
      }
    }
    stack.push_back(half(cell, 1));
    stack.push_back(half(cell, 0));
  }
  return found;
}

/// F_k = x_k w_y - y_k w_x on the line u = value: (v,r,s) are the variables.
System on_line(const RationalPatch& x, const RationalPatch& y, const Rational& value) {
  const auto n = static_cast<std::size_t>(x.degree_v());
  std::vector<HomogeneousPoint> curve;
  for (std::size_t j = 0; j <= n; ++j) {
    std::vector<HomogeneousPoint> row;
    for (int i = 0; i <= x.degree_u(); ++i) row.push_back(x.homogeneous(i, static_cast<int>(j)));
    for (std::size_t level = row.size() - 1; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i)
        for (std::size_t k = 0; k < 4; ++k) row[i][k] = (1 - value) * row[i][k] + value * row[i + 1][k];
    curve.push_back(row[0]);
  }
  System result;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Rational> values;
    Integer common = 1;
    for (const HomogeneousPoint& p : curve)
      for (int a = 0; a <= y.degree_u(); ++a)
        for (int b = 0; b <= y.degree_v(); ++b) {
          const HomogeneousPoint& q = y.homogeneous(a, b);
          values.push_back(p[k] * q[3] - q[k] * p[3]);
          common = lcm(common, denominator(values.back()));
        }
    result[k].degrees = {n, static_cast<std::size_t>(y.degree_u()), static_cast<std::size_t>(y.degree_v())};
    for (const Rational& q : values)
      result[k].coefficients.push_back(numerator(q) * (common / denominator(q)));
  }
  return result;
}

/// Bounds of d.x over the net, which is a hull if all weights are positive; otherwise none.
std::optional<RationalInterval> extent(const RationalPatch& patch, const Point& d) {
  std::optional<RationalInterval> result;
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      if (p[3] <= 0) return std::nullopt;
      const Rational at = (d[0] * p[0] + d[1] * p[1] + d[2] * p[2]) / p[3];
      result = result ? RationalInterval{std::min(result->lower, at), std::max(result->upper, at)}
                      : RationalInterval{at, at};
    }
  return result;
}

bool apart(const RationalPatch& x, const RationalPatch& y) {
  std::vector<Point> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const RationalPatch* patch : {&x, &y}) {
    const Point a = (*patch)(0, 0);
    directions.push_back(cross((*patch)(1, 0) - a, (*patch)(0, 1) - a));
  }
  return std::any_of(directions.begin(), directions.end(), [&](const Point& d) {
    const auto ex = extent(x, d), ey = extent(y, d);
    return ex && ey && (ex->upper < ey->lower || ey->upper < ex->lower);
  });
}

using Vector4 = std::array<double, 4>;

/// Clips the segment to the box around `centre`: whether anything is left.
bool meets(const Vector4& a, const Vector4& b, const Vector4& centre, double reach) {
  double from = 0, to = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const double low = centre[i] - reach - a[i], high = centre[i] + reach - a[i], d = b[i] - a[i];
    if (d == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    from = std::max(from, std::min(low / d, high / d));
    to = std::min(to, std::max(low / d, high / d));
  }
  return from <= to;
}

bool next_to(const IntersectionGraph& graph, const Vector4& centre, double reach) {
  for (const Node& node : graph.nodes)
    if (meets(node.approx, node.approx, centre, reach)) return true;
  for (const Arc& arc : graph.arcs)
    for (std::size_t k = 1; k < arc.polyline.size(); ++k)
      if (meets(arc.polyline[k - 1].parameters, arc.polyline[k].parameters, centre, reach)) return true;
  return false;
}

constexpr int first_depth = 3;  // of cells that may be explained by the graph
constexpr int last_depth = 7;

int unexplained(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph,
                const Vector4& corner, int depth) {
  if (apart(x, y)) return 0;
  const double width = std::ldexp(1.0, -depth);
  Vector4 centre = corner;
  for (double& c : centre) c += width / 2;
  if (depth >= first_depth && next_to(graph, centre, 1.5 * width)) return 0;
  if (depth == last_depth) return 1;
  std::vector<RationalPatch> parts[2];
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 4; ++i)
      parts[k].push_back((k == 0 ? x : y)
                             .restricted_to(Rational(i & 1, 2), Rational(1 + (i & 1), 2), Rational(i >> 1, 2),
                                            Rational(1 + (i >> 1), 2)));
  int result = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Vector4 at = {corner[0] + (i & 1) * width / 2, corner[1] + (i >> 1) * width / 2,
                          corner[2] + (j & 1) * width / 2, corner[3] + (j >> 1) * width / 2};
      result += unexplained(parts[0][static_cast<std::size_t>(i)], parts[1][static_cast<std::size_t>(j)],
                            graph, at, depth + 1);
    }
  return result;
}

void compare_line(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph,
                  std::size_t i, const Rational& value, Comparison& result) {
  const LinePoints line = line_points(x, y, i, value);
  if (!line.conclusive()) return;
  std::size_t arcs = 0;
  for (const Arc& arc : graph.arcs) {
    const RationalInterval& a = graph.nodes.at(static_cast<std::size_t>(arc.from)).box[i];
    const RationalInterval& b = graph.nodes.at(static_cast<std::size_t>(arc.to)).box[i];
    if ((a.upper < value && value < b.lower) || (b.upper < value && value < a.lower)) ++arcs;
  }
  ++result.lines;
  const std::string place = std::string(name(all_parameters[i])) + " = " + value.str();
  if (arcs != line.points.size())
    throw Contradiction(std::to_string(arcs) + " arcs for " + std::to_string(line.points.size()) +
                        " solutions at " + place);
  for (const ParameterBox& box : line.points) {
    Vector4 z{};
    for (std::size_t k = 0; k < 4; ++k) z[k] = to_double(box[k].midpoint());
    if (!next_to(graph, z, 0x1p-7)) throw Contradiction("no arc at a solution with " + place);
  }
}

void compare_vertices(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph,
                      Comparison& result) {
  for (const Arc& arc : graph.arcs)
    for (std::size_t k = 0; k < arc.polyline.size(); k += 1 + arc.polyline.size() / 4) {
      ParameterBox box;
      for (std::size_t i = 0; i < 4; ++i) {
        const Rational at = from_double(arc.polyline[k].parameters[i]), reach(1, 1 << 20);
        box[i] = {std::max<Rational>(0, at - reach), std::min<Rational>(1, at + reach)};
      }
      ++result.vertices;
      if (proved_apart(x, y, box))
        throw Contradiction("a vertex of arc " + std::to_string(arc.id) + " is on no curve");
    }
}

}  // namespace

LinePoints line_points(const RationalPatch& x, const RationalPatch& y, std::size_t i, const Rational& value) {
  LinePoints result;
  const RationalPatch& first = i < 2 ? x : y;
  const std::array<std::size_t, 4> names = {i, i ^ 1U, i < 2 ? 2U : 0U, i < 2 ? 3U : 1U};
  try {
    for (const Zero& zero : zeros(on_line(i % 2 == 0 ? first : first.transposed(), i < 2 ? y : x, value))) {
      ParameterBox box;
      box[names[0]] = {value, value};
      for (std::size_t k = 0; k < 3; ++k) box[names[k + 1]] = zero.box[k];
      result.points.push_back(box);
    }
  } catch (const Doubt& doubt) {
    result = {{}, doubt.what()};
  }
  return result;
}

bool proved_apart(const RationalPatch& x, const RationalPatch& y, const ParameterBox& box) {
  return apart(x.restricted_to(box[0].lower, box[0].upper, box[1].lower, box[1].upper),
               y.restricted_to(box[2].lower, box[2].upper, box[3].lower, box[3].upper));
}

Comparison compare(const RationalPatch& x, const RationalPatch& y, const IntersectionGraph& graph) {
  Comparison result;
  try {
    for (std::size_t i = 0; i < 4; ++i)
      for (const Rational& value : {Rational(23, 101), Rational(67, 103)})
        compare_line(x, y, graph, i, value, result);
    compare_vertices(x, y, graph, result);
    result.unsure = unexplained(x, y, graph, {0, 0, 0, 0}, 0);
  } catch (const Contradiction& contradiction) {
    result.difference = contradiction.what();
  }
  return result;
}

}  // namespace exsect::exact_oracle
