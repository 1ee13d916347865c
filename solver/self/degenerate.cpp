#include "self/degenerate.h"

#include <algorithm>
#include <string>
#include <utility>

#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "self/collapsed.h"
#include "self/overlaps.h"
#include "self/self_intersect_within.h"
#include "self/symmetric_pairs.h"
#include "shape/folded_patch.h"
#include "shape/patch_shape.h"
#include "shape/planar_patch.h"
#include "side/boundary_lines.h"
#include "special/degenerate_patches.h"
#include "trace/landmark_node.h"

namespace exsect {
namespace {

/// x with the values of q in the place of each parameter in which it is folded.
struct Quotient {
  BezierPatch patch;
  std::array<std::optional<Rational>, 2> fold;
};

Quotient quotient_of(const BezierPatch& x) {
  Quotient result{x, {}};
  if (const auto folded = folded_patch(result.patch)) {
    result.fold[0] = folded->fold;
    result.patch = unfolded(*folded);
  }
  if (const auto folded = folded_patch(result.patch.exchanged())) {
    result.fold[1] = folded->fold;
    result.patch = unfolded(*folded).exchanged();
  }
  return result;
}

/// The line of the patch itself over a line of the quotient, which is a side if the patch is folded across
/// it; empty if there are two.
std::optional<Rational> line_over(const std::optional<Rational>& fold, const Rational& value) {
  if (!fold) return value;
  if (value != 0 && value != 1) return std::nullopt;
  if (*fold <= 0) return value;
  if (*fold >= 1) return 1 - value;
  return value == 0 ? fold : std::nullopt;
}

/// The lines of x that are one point, if all pairs of the quotient are on such lines of it.
std::optional<std::vector<Node>> collapsed_lines(const BezierPatch& x, const Quotient& quotient,
                                                 const Run& run) {
  const IntersectResult rest = self_intersect_within(run, quotient.patch);
  if (rest.status != Status::complete || rest.graph.nodes.size() != rest.graph.isolated_points.size())
    return std::nullopt;
  std::vector<Node> lines;
  for (const Node& node : rest.graph.nodes) {
    if (node.free.size() != 2) return std::nullopt;
    const std::size_t fixed = 1 - index(node.free[0]);
    const auto line = line_over(quotient.fold[fixed], node.box[fixed].lower);
    if (!line) return std::nullopt;
    lines.push_back(collapsed_line_node(x, fixed, *line));
  }
  return lines;
}

/// The overlaps, and the lines; without these the other pairs are not decided.
IntersectResult symmetric_result(const BezierPatch& x, const std::vector<Symmetry>& symmetries,
                                 std::optional<std::vector<Node>> lines, const Run& run) {
  SymmetricOverlaps result = symmetric_overlaps(x, symmetries, run);
  if (!lines) {
    result.incomplete.push_back({whole_domain(), covered_more_than_once(symmetries)});
  } else {
    for (Node& line : *lines) result.graph.add_isolated(result.graph.add_node(std::move(line)));
  }
  return finished(std::move(result.graph), {}, std::move(result.incomplete));
}

/// Empty if x has no symmetry, and is not folded outside of the square or meets itself.
std::optional<IntersectResult> self_intersect_symmetric(const BezierPatch& x, const Run& run) {
  constexpr std::size_t kOfSquare = 6;  // (7.19)
  const std::vector<Symmetry> known = symmetries(x);
  const Quotient quotient = quotient_of(x);
  const bool folded = quotient.fold[0] || quotient.fold[1];
  if (known.empty() && !folded) return std::nullopt;
  std::optional<std::vector<Node>> lines;
  if (known.size() == kOfSquare || (!folded && has_only_symmetric_pairs(x))) {
    lines.emplace();
  } else if (folded) {
    lines = collapsed_lines(x, quotient, run);
  }
  if (known.empty() && !lines) return std::nullopt;
  return symmetric_result(x, known, std::move(lines), run);
}

/// Two points that are mapped to one, t >= 0 at the first.
Symmetry symmetry(const PlanarFold& fold) {
  Symmetry result{{{{0, 1, 0}, {0, 0, 1}}}, fold.t};
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t k = 0; k < 3; ++k) result.image[j][k] += fold.direction[j] * fold.t[k];
  return result;
}

/// The fold runs through the inside of the square.
bool folds_inside(const PlanarFold& fold) {
  std::array<bool, 2> taken = {};
  for (const int u : {0, 1})
    for (const int v : {0, 1}) {
      const int s = sign(fold.t[0] + u * fold.t[1] + v * fold.t[2]);
      if (s != 0) taken[s > 0 ? 1 : 0] = true;
    }
  return taken[0] && taken[1];
}

bool is_planar_bilinear(const ControlNet& c) {
  return is_zero(c[2][0]) && is_zero(c[2][1]) && is_zero(c[2][2]) && is_zero(c[0][2]) && is_zero(c[1][2]) &&
         determinant(c[1][0], c[0][1], c[1][1]) == 0;
}

/// Of a planar bilinear patch; empty for all others, and without c11.
std::optional<IntersectResult> self_intersect_planar(const BezierPatch& x, const Run& run) {
  if (const auto fold = planar_fold(x))
    return symmetric_result(x, folds_inside(*fold) ? std::vector{symmetry(*fold)} : std::vector<Symmetry>{},
                            std::vector<Node>{}, run);
  for (const std::size_t fixed : {0, 1}) {
    const std::optional<Rational> value = collapsed_line(fixed == 0 ? x : x.exchanged());
    if (!value) continue;
    GraphBuilder graph;
    if (*value >= 0 && *value <= 1) graph.add_isolated(graph.add_node(collapsed_line_node(x, fixed, *value)));
    return finished(std::move(graph), {}, {});
  }
  return std::nullopt;
}

/// Of a patch in a plane whose normal points to both sides of it: it folds over where x_u x x_v = 0.
std::optional<IntersectResult> self_intersect_folded_plane(const BezierPatch& x) {
  constexpr int kCells = 8;
  if (!plane_of(x)) return std::nullopt;
  std::vector<Point> normals;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) {
      const Rational u(i, kCells);
      const Rational v(j, kCells);
      normals.push_back(cross(x.derivative_first(u, v), x.derivative_second(u, v)));
    }
  const bool turns = std::ranges::any_of(normals, [&](const Point& n) {
    return std::ranges::any_of(normals, [&](const Point& other) { return dot(n, other) < 0; });
  });
  if (!turns) return std::nullopt;
  const std::string why =
      "the patch lies in a plane and folds over where x_u x x_v = 0: regions it covers more than once are "
      "not "
      "decided";
  return undecided(whole_domain(), why);
}

}  // namespace

/// Two points with one image differ by t (b,-a), a = l.c10, b = l.c01, for l in the plane and normal to c11,
/// and (k10 b - k01 a) + b v - a u = t a b for the multiples k10, k01 of c11 next to c10, c01.
std::optional<PlanarFold> planar_fold(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  if (!is_planar_bilinear(c)) return std::nullopt;
  const Point& c11 = c[1][1];
  const Point first = cross(c[1][0], c11);
  const Point second = cross(c[0][1], c11);
  if (is_zero(first) || is_zero(second)) return std::nullopt;
  const Rational a = dot(first, first);
  const Rational b = dot(first, second);
  const Rational k10 = dot(c[1][0], c11) / dot(c11, c11);
  const Rational k01 = dot(c[0][1], c11) / dot(c11, c11);
  return PlanarFold{{(k10 * b - k01 * a) / (a * b), -1 / b, 1 / a}, {b, -a}};
}

std::optional<Rational> collapsed_line(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  const Point& c11 = c[1][1];
  if (!is_planar_bilinear(c) || is_zero(cross(c[1][0], c11)) || !is_zero(cross(c[0][1], c11)))
    return std::nullopt;
  return -dot(c[0][1], c11) / dot(c11, c11);
}

Node collapsed_line_node(const BezierPatch& x, std::size_t fixed, const Rational& value) {
  const ModelScale scale = model_scale(x, x);
  const PairSystem<DoubleBall> system(x, x, scale.origin, scale.frame.exponent);
  BallPoint<DoubleBall> at;
  ParameterBox box;
  std::vector<Side> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    const bool along = k % 2 != fixed;
    at[k] = DoubleBall::enclosing(along ? Rational(1, 2) : value);
    box[k] = along ? RationalInterval{0, 1} : RationalInterval{value, value};
    if (!along && (value == 0 || value == 1))
      sides.push_back({static_cast<Parameter>(k), value == 0 ? 0 : 1});
  }
  Node node = landmark_node(system, scale.frame, at, box, sides);
  node.kinds.clear();
  if (!sides.empty()) node.kinds.push_back(NodeKind::boundary);
  node.free = {static_cast<Parameter>(1 - fixed), static_cast<Parameter>(3 - fixed)};
  return node;
}

std::optional<IntersectResult> self_intersect_degenerate(const BezierPatch& x, const Run& run) {
  if (shape(x) != PatchShape::surface) return intersect_degenerate(x, x, run);
  if (auto result = self_intersect_planar(x, run)) return result;
  if (auto result = self_intersect_symmetric(x, run)) return result;
  if (auto result = self_intersect_collapsed(x, run)) return result;
  return self_intersect_folded_plane(x);
}

}  // namespace exsect
