#include "self_degenerate.h"

#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <string>
#include <utility>

#include "degenerate_patches.h"
#include "model_scale.h"
#include "parameter_names.h"
#include "rim_arc.h"

namespace exsect {
namespace {

constexpr const char* kTooFine = "the tolerance is below what a polyline in doubles can be proved to keep";

/// a + b q over the values q of (u - fold)^2, 0 <= u <= 1: run through once.
BezierPatch unfolded(const FoldedPatch& patch) {
  const Rational at0 = patch.fold * patch.fold;
  const Rational at1 = (1 - patch.fold) * (1 - patch.fold);
  const Rational least = patch.fold >= 0 && patch.fold <= 1 ? Rational(0) : std::min(at0, at1);
  const Rational range = std::max(at0, at1) - least;
  ControlNet c{};
  for (std::size_t j = 0; j < 3; ++j) {
    c[0][j] = patch.a[j] + least * patch.b[j];
    c[1][j] = range * patch.b[j];
  }
  return BezierPatch::from_power_basis(c);
}

using Pair = std::array<Rational, 4>;

/// An overlap of the patch with itself, its rim given by the pairs at its corners; where the two points of a
/// pair agree it is on the fold.
class FoldOverlap {
 public:
  FoldOverlap(const BezierPatch& x, const IntersectOptions& options)
      : x_(x), scale_(model_scale(x, x)), tolerance_(options.tolerance * scale_.extent) {}

  IntersectResult run(const std::vector<Pair>& corners) {
    std::vector<RimEnd> ends;
    for (const Pair& at : corners) ends.push_back(add(at));
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const RimEnd& to = ends[(i + 1) % ends.size()];
      const ArcPlace place =
          on_fold(ends[i].at) && on_fold(to.at) ? ArcPlace::interior : ArcPlace::patch_boundary;
      chain.push_back(rim_arc(x_, ends[i], to, place, tolerance_));
      chain.back().id = static_cast<int>(i);
      if (!(chain.back().error_bound <= tolerance_)) incomplete(result_.graph.nodes[i].box, kTooFine);
    }
    result_.graph.overlaps.push_back({0, {std::move(chain)}});
    result_.status = result_.incomplete.empty() ? Status::complete : Status::incomplete;
    return std::move(result_);
  }

 private:
  static bool on_fold(const Pair& at) { return at[0] == at[2] && at[1] == at[3]; }

  void incomplete(const ParameterBox& where, const std::string& why) {
    result_.incomplete.push_back({where, why});
  }

  RimEnd add(const Pair& at) {
    ParameterBox box;
    BallPoint<DoubleBall> ball;
    std::vector<Side> sides;
    for (const Parameter p : all_parameters) {
      const std::size_t j = index(p);
      box[j] = {at[j], at[j]};
      ball[j] = DoubleBall::enclosing(at[j]);
      if (at[j] == 0 || at[j] == 1) sides.push_back({p, at[j] == 0 ? 0 : 1});
    }
    const PairSystem<DoubleBall> system(x_, x_, scale_.origin, scale_.frame.exponent);
    Node node = landmark_node(system, scale_.frame, ball, box, sides);
    if (on_fold(at)) node.kinds.push_back(NodeKind::cusp);
    node.id = static_cast<int>(result_.graph.nodes.size());
    result_.graph.nodes.push_back(node);
    return {at, node.id};
  }

  const BezierPatch& x_;
  ModelScale scale_;
  double tolerance_;
  IntersectResult result_{};
};

/// The pairs (fold + d, v), (fold - d, v): the rim are two segments v = 0, 1, the side or sides at the
/// largest d, and the fold d = 0.
std::vector<Pair> rim(const FoldedPatch& patch) {
  const Rational reach = std::min<Rational>(patch.fold, 1 - patch.fold);
  const auto pair = [&](const Rational& d, int v) -> Pair { return {patch.fold + d, v, patch.fold - d, v}; };
  return {pair(0, 0), pair(reach, 0), pair(reach, 1), pair(0, 1)};
}

using PlanePoint = std::array<Rational, 2>;

Rational t_at(const PlanarFold& fold, const PlanePoint& w) {
  return fold.t[0] + fold.t[1] * w[0] + fold.t[2] * w[1];
}

PlanePoint partner(const PlanarFold& fold, const PlanePoint& w) {
  const Rational t = t_at(fold, w);
  return {w[0] + t * fold.direction[0], w[1] + t * fold.direction[1]};
}

/// The part of a convex polygon where f >= 0, f of degree 1.
template <class Form>
std::vector<PlanePoint> cut(const std::vector<PlanePoint>& polygon, const Form& f) {
  std::vector<PlanePoint> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanePoint& p = polygon[i];
    const PlanePoint& q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = f(p);
    const Rational at_q = f(q);
    if (at_p >= 0) rest.push_back(p);
    if (sign(at_p) * sign(at_q) < 0) {
      const Rational c = at_p / (at_p - at_q);
      rest.push_back({p[0] + c * (q[0] - p[0]), p[1] + c * (q[1] - p[1])});
    }
  }
  return rest;
}

/// The polygon of (u,v) with t >= 0 and both points in the square.
std::vector<Pair> rim(const PlanarFold& fold) {
  std::vector<PlanePoint> polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  polygon = cut(polygon, [&](const PlanePoint& w) { return t_at(fold, w); });
  for (const std::size_t j : {0, 1}) {
    polygon = cut(polygon, [&](const PlanePoint& w) { return partner(fold, w)[j]; });
    polygon = cut(polygon, [&](const PlanePoint& w) -> Rational { return 1 - partner(fold, w)[j]; });
  }
  std::vector<Pair> result;
  for (const PlanePoint& w : polygon) {
    const PlanePoint other = partner(fold, w);
    result.push_back({w[0], w[1], other[0], other[1]});
  }
  return result;
}

/// The fold runs through the inside of the square.
bool is_inside(const PlanarFold& fold) {
  std::array<bool, 2> taken = {};
  for (const int u : {0, 1})
    for (const int v : {0, 1}) {
      const int s = sign(t_at(fold, {u, v}));
      if (s != 0) taken[s > 0 ? 1 : 0] = true;
    }
  return taken[0] && taken[1];
}

/// Empty if the patch is not folded in u, or meets itself in another way too.
std::optional<IntersectResult> self_intersect_folded(const BezierPatch& x, const IntersectOptions& options) {
  const std::optional<FoldedPatch> folded = folded_patch(x);
  if (!folded) return std::nullopt;
  IntersectResult rest = self_intersect(unfolded(*folded), options);
  if (rest.status != Status::complete || !rest.graph.nodes.empty()) return std::nullopt;
  if (folded->fold <= 0 || folded->fold >= 1) return rest;
  IntersectResult result = FoldOverlap(x, options).run(rim(*folded));
  result.work = rest.work;
  return result;
}

bool is_planar_bilinear(const ControlNet& c) {
  return is_zero(c[2][0]) && is_zero(c[2][1]) && is_zero(c[2][2]) && is_zero(c[0][2]) && is_zero(c[1][2]) &&
         determinant(c[1][0], c[0][1], c[1][1]) == 0;
}

/// Of a planar bilinear patch; empty for all others, and without c11.
std::optional<IntersectResult> self_intersect_planar(const BezierPatch& x, const IntersectOptions& options) {
  if (const auto fold = planar_fold(x))
    return is_inside(*fold) ? FoldOverlap(x, options).run(rim(*fold)) : IntersectResult{};
  for (const std::size_t fixed : {0, 1}) {
    const std::optional<Rational> value = collapsed_line(fixed == 0 ? x : x.exchanged());
    if (!value) continue;
    IntersectResult result{};
    if (*value >= 0 && *value <= 1) {
      result.graph.nodes.push_back(collapsed_line_node(x, fixed, *value));
      result.graph.isolated_points.push_back(0);
    }
    return result;
  }
  return std::nullopt;
}

}  // namespace

std::optional<FoldedPatch> folded_patch(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  std::optional<Rational> ratio;  // c1 = ratio c2
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      if (!ratio && c[2][j][k] != 0) ratio = c[1][j][k] / c[2][j][k];
  if (!ratio) return std::nullopt;
  FoldedPatch result{-*ratio / 2, {}, c[2]};
  for (std::size_t j = 0; j < 3; ++j) {
    if (!(c[1][j] == *ratio * c[2][j])) return std::nullopt;
    result.a[j] = c[0][j] - result.fold * result.fold * c[2][j];
  }
  return result;
}

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
  node.id = 0;
  return node;
}

std::optional<IntersectResult> self_intersect_degenerate(const BezierPatch& x,
                                                         const IntersectOptions& options) {
  using enum Parameter;
  if (shape(x) != PatchShape::surface) return intersect_degenerate(x, x, options);
  if (auto result = self_intersect_planar(x, options)) return result;
  if (auto result = self_intersect_folded(x, options)) return result;
  IntersectOptions exchanged = options;
  for (Parameter& p : exchanged.turning) p = static_cast<Parameter>(index(p) ^ 1U);
  auto result = self_intersect_folded(x.exchanged(), exchanged);
  if (result) rename_parameters(*result, {v, u, s, r});
  return result;
}

}  // namespace exsect
