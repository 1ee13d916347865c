#include "lift/sphere_boxes.h"

#include <exsect/geometry/surface_box.h>

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "lift/space_sides.h"

namespace exsect {
namespace {

using PointKey = std::tuple<std::size_t, std::size_t, int>;  // two planes, and the order along their line

/// normal . (P - centre).
SpacePolynomial rise_from(const Point& centre, const Point& normal) {
  return SpacePolynomial({{{1, 0, 0}, normal[0]},
                          {{0, 1, 0}, normal[1]},
                          {{0, 0, 1}, normal[2]},
                          {{0, 0, 0}, -dot(normal, centre)}});
}

/// A circle with its nodes on all planes, and the bounds on its chart.
struct BoundCircle {
  std::size_t plane;
  LiftedCurve curve;
  std::vector<SheetFunction> bounds;
  std::vector<LiftedArc> kept = {};
  std::vector<std::size_t> points = {};
};

/// The circles in which the planes of all bounds cut the sphere, and the faces between them.
class CircleArrangement {
 public:
  CircleArrangement(const ImplicitSurface& sphere, const SurfaceRegion& region)
      : centre_(sphere.data()->point), region_(region) {
    for (std::size_t i = 0; i < region.bounds.size(); ++i) add_plane(region.bounds[i].form);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const Point normal = gradient(planes_[i]);
      const Point foot = -planes_[i].coefficient({0, 0, 0}) / dot(normal, normal) * normal;
      LiftedCurve curve = *lifted_curve(sphere, ImplicitSurface::plane(foot, normal), {region.bounds, {}});
      if (curve.nodes.empty()) continue;
      circles_.push_back({i, std::move(curve), {}});
      for (const SurfaceBound& bound : region.bounds)
        circles_.back().bounds.push_back(on_chart(bound.form, circles_.back().curve.chart));
    }
  }

  SphereRegion run() {
    SphereRegion result;
    for (BoundCircle& circle : circles_) find_points(circle);
    is_covered_.assign(count_, false);
    for (BoundCircle& circle : circles_) find_arcs(circle);
    for (BoundCircle& circle : circles_) find_touch_points(circle);
    for (BoundCircle& circle : circles_) result.circles.push_back(kept_part(circle));
    result.has_inner_points = std::ranges::any_of(is_covered_, [](bool is) { return is; });
    if (circles_.empty())
      result.has_inner_points = is_inside([&](std::size_t i) { return sign_at_centre(i); });
    return result;
  }

 private:
  void add_plane(const SpacePolynomial& form) {
    const auto known = std::ranges::find_if(
        planes_, [&](const SpacePolynomial& plane) { return sign_of_quotient(plane, form).has_value(); });
    plane_of_.push_back(static_cast<std::size_t>(known - planes_.begin()));
    if (known == planes_.end()) planes_.push_back(form);
  }

  int sign_at_centre(std::size_t bound) const { return sign(region_.bounds[bound].form(centre_)); }

  /// Whether every clause has a bound with a positive sign, or not a negative one.
  bool is_inside(const std::function<int(std::size_t)>& sign, int least = 1) const {
    return std::ranges::all_of(region_.clauses, [&](const std::vector<std::size_t>& clause) {
      return std::ranges::any_of(clause, [&](std::size_t i) { return sign(i) >= least; });
    });
  }

  static int sign_on(const BoundCircle& circle, std::size_t bound, const TriangularPoint& p, int sheet) {
    return sign_on_sheet(circle.bounds[bound], circle.curve.chart, p, sheet);
  }

  /// Nodes on several planes by two of these, which meet the sphere in two points at most.
  void find_points(BoundCircle& circle) {
    for (const LiftedNode& node : circle.curve.nodes) {
      std::size_t point = count_;
      std::vector<PointKey> keys;
      if (const auto& p = circle.curve.below.nodes[node.below].exact)
        for (std::size_t i = 0; i < region_.bounds.size(); ++i)
          if (plane_of_[i] != circle.plane && sign_on(circle, i, *p, node.sheet) == 0) {
            const std::size_t a = std::min(circle.plane, plane_of_[i]),
                              b = std::max(circle.plane, plane_of_[i]);
            const Point along = cross(gradient(planes_[a]), gradient(planes_[b]));
            const SheetFunction rise = on_chart(rise_from(centre_, along), circle.curve.chart);
            keys.emplace_back(a, b, sign_on_sheet(rise, circle.curve.chart, *p, node.sheet));
          }
      for (const PointKey& key : keys)
        if (const auto known = points_.find(key); known != points_.end()) point = known->second;
      for (const PointKey& key : keys) points_.emplace(key, point);
      if (point == count_) ++count_;
      circle.points.push_back(point);
    }
  }

  /// Of all bounds on both sides of an arc: a plane changes its sign in its own circle alone.
  std::vector<SideSigns> signs_beside(const BoundCircle& circle, std::size_t arc) const {
    const LiftedArc& at = circle.curve.arcs[arc];
    std::vector<SideSigns> signs;
    for (std::size_t i = 0; i < circle.bounds.size(); ++i) {
      const int sign = sign_on(circle, i, circle.curve.below.arcs[at.below].inside, at.sheet);
      std::optional<SideSigns> both = SideSigns{sign, sign};
      if (sign == 0) both = sides_on_chart(circle.curve, circle.bounds[i], arc, 1);
      if (!both) throw ProofFailure(whole_domain(), "a plane does not cross a sphere along their circle");
      signs.push_back(*both);
    }
    return signs;
  }

  void find_arcs(BoundCircle& circle) {
    for (std::size_t i = 0; i < circle.curve.arcs.size(); ++i) {
      const LiftedArc& arc = circle.curve.arcs[i];
      const std::vector<SideSigns> signs = signs_beside(circle, i);
      const bool has_face = is_inside([&](std::size_t k) { return signs[k].left; }) ||
                            is_inside([&](std::size_t k) { return signs[k].right; });
      for (const std::size_t end : {arc.from, arc.to})
        if (has_face) is_covered_[circle.points[end]] = true;
      const TriangularPoint& inside = circle.curve.below.arcs[arc.below].inside;
      if (!has_face && is_inside([&](std::size_t k) { return sign_on(circle, k, inside, arc.sheet); }, 0))
        circle.kept.push_back(arc);
    }
  }

  /// A plane that touches the sphere has around the point the sign that it has in the centre. If another
  /// plane cuts the sphere there, its arcs have told of the faces.
  void find_touch_points(BoundCircle& circle) {
    for (std::size_t i = 0; i < circle.curve.nodes.size(); ++i) {
      const LiftedNode& node = circle.curve.nodes[i];
      if (node.degree > 0) continue;
      const TriangularPoint& p = *circle.curve.below.nodes[node.below].exact;
      if (is_inside([&](std::size_t k) {
            const int sign = sign_on(circle, k, p, node.sheet);
            const bool touches = plane_of_[k] == circle.plane;
            return sign != 0 || !touches ? sign : sign_at_centre(k);
          }))
        is_covered_[circle.points[i]] = true;
    }
  }

  /// In the region, and in no face of it. Points at which planes meet are exact; others are in the region as
  /// their arcs are.
  bool is_alone(const BoundCircle& circle, std::size_t i) const {
    const LiftedNode& node = circle.curve.nodes[i];
    const auto& p = circle.curve.below.nodes[node.below].exact;
    return !is_covered_[circle.points[i]] && p &&
           is_inside([&](std::size_t k) { return sign_on(circle, k, *p, node.sheet); }, 0);
  }

  SphereCircle kept_part(BoundCircle& circle) {
    LiftedCurve& curve = circle.curve;
    for (LiftedNode& node : curve.nodes) node.degree = 0;
    for (const LiftedArc& arc : circle.kept)
      for (const std::size_t end : {arc.from, arc.to}) ++curve.nodes[end].degree;
    std::vector<LiftedNode> nodes;
    std::vector<std::size_t> position, points;
    for (std::size_t i = 0; i < curve.nodes.size(); ++i) {
      position.push_back(nodes.size());
      if (curve.nodes[i].degree == 0 && !is_alone(circle, i)) continue;
      nodes.push_back(curve.nodes[i]);
      points.push_back(circle.points[i]);
    }
    curve.arcs = circle.kept;
    for (LiftedArc& arc : curve.arcs) arc.from = position[arc.from], arc.to = position[arc.to];
    curve.nodes = std::move(nodes);
    return {std::move(curve), std::move(points)};
  }

  Point centre_;
  const SurfaceRegion& region_;
  std::vector<SpacePolynomial> planes_;  // each once
  std::vector<std::size_t> plane_of_;    // of each bound
  std::vector<BoundCircle> circles_;
  std::map<PointKey, std::size_t> points_;
  std::size_t count_ = 0;
  std::vector<bool> is_covered_;  // points that faces of the region come to
};

}  // namespace

SphereRegion sphere_region(const ImplicitSurface& sphere, const SurfaceRegion& region) {
  return CircleArrangement(sphere, region).run();
}

}  // namespace exsect
