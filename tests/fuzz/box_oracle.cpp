#include "box_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace exsect::box_oracle {
namespace {

using tiny_boxes::Face, tiny_boxes::depth_in;
using Vector = std::array<double, 3>;

constexpr double kRounding = 1e-9;

Vector between(const Vector& a, const Vector& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}
double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// From a point to a segment.
double distance(const Vector& p, const Vector& a, const Vector& b) {
  double along = 0, square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    square += (b[k] - a[k]) * (b[k] - a[k]);
  }
  return distance(p, square > 0 ? between(a, b, std::clamp(along / square, 0.0, 1.0)) : a);
}

double distance(const Vector& p, const SurfaceIntersection& result) {
  double least = INFINITY;
  for (const SpaceArc& arc : result.arcs)
    for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i)
      least = std::min(least, distance(p, arc.polyline[i], arc.polyline[i + 1]));
  for (const SpaceNode& node : result.nodes) least = std::min(least, distance(p, node.approx));
  return least;
}

double error_of(const SurfaceIntersection& result) {
  double error = kRounding;
  for (const SpaceArc& arc : result.arcs) error = std::max(error, arc.error_bound);
  return error;
}

std::string at(const std::string& what, const Vector& p) {
  std::ostringstream text;
  text << what << " at (" << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return text.str();
}

class Comparison {
 public:
  Comparison(const Face& first, const Face& second, const SurfaceIntersection& whole,
             const SurfaceIntersection& in_boxes)
      : first_(first),
        second_(second),
        whole_(whole),
        in_boxes_(in_boxes),
        room_(2 * (error_of(whole) + error_of(in_boxes))) {}

  std::string difference() const {
    if (whole_.is_same) return difference_of_regions();
    if (in_boxes_.is_same) return "one surface";
    for (const auto& text : {missing(), added(), other_lengths()})
      if (!text.empty()) return text;
    return {};
  }

 private:
  double depth(const Vector& p) const { return std::min(depth_in(first_, p), depth_in(second_, p)); }

  std::string missing() const {
    const auto is_missing = [&](const Vector& p) {
      return depth(p) > room_ && distance(p, in_boxes_) > room_;
    };
    for (const SpaceArc& arc : whole_.arcs)
      for (std::size_t i = 0; i < arc.polyline.size(); i += 5)
        if (is_missing(arc.polyline[i])) return at("a curve is missing", arc.polyline[i]);
    for (const SpaceNode& node : whole_.nodes)
      if (is_missing(node.approx)) return at("a node is missing", node.approx);
    return {};
  }

  /// Unbounded curves are drawn as far as there are nodes.
  std::string added() const {
    const bool is_bounded = whole_.count(SpaceNodeKind::cut) == 0;
    const auto is_added = [&](const Vector& p) {
      return depth(p) < -room_ || (is_bounded && distance(p, whole_) > room_);
    };
    for (const SpaceArc& arc : in_boxes_.arcs)
      for (std::size_t i = 0; i < arc.polyline.size(); i += 5)
        if (is_added(arc.polyline[i])) return at("a curve is added", arc.polyline[i]);
    for (const SpaceNode& node : in_boxes_.nodes)
      if (is_added(node.approx)) return at("a node is added", node.approx);
    return {};
  }

  std::string other_lengths() const {
    if (whole_.count(SpaceNodeKind::cut) > 0) return {};
    double least = 0, greatest = 0, found = 0;
    for (const SpaceArc& arc : whole_.arcs)
      for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i) {
        const Vector &a = arc.polyline[i], &b = arc.polyline[i + 1];
        const double length = distance(a, b) / 16;
        for (int k = 0; k < 16; ++k) {
          const double inside = depth(between(a, b, (k + 0.5) / 16));
          if (inside > room_ + length) least += length;
          if (inside > -room_ - length) greatest += length;
        }
      }
    for (const SpaceArc& arc : in_boxes_.arcs)
      for (std::size_t i = 0; i + 1 < arc.polyline.size(); ++i)
        found += distance(arc.polyline[i], arc.polyline[i + 1]);
    const double slack = 0.01 * greatest + 20 * room_;
    if (found >= least - slack && found <= greatest + slack) return {};
    std::ostringstream text;
    text << "length " << found << " instead of " << least << " to " << greatest;
    return text.str();
  }

  /// Of one surface: points of a net that are in both boxes, and what the boxes share besides.
  std::string difference_of_regions() const {
    if (!in_boxes_.is_same)
      for (const Vector& p : net_of(first_.whole))
        if (depth(p) > room_) return at("the boxes share more", p);
    for (const SpaceArc& arc : in_boxes_.arcs)
      for (const Vector& p : arc.polyline)
        if (depth(p) < -room_) return at("a shared curve leaves a box", p);
    for (const SpaceNode& node : in_boxes_.nodes)
      if (depth(node.approx) < -room_) return at("a shared point is in no box", node.approx);
    return {};
  }

  static std::vector<Vector> net_of(const ImplicitSurface& surface) {
    const SurfaceData& data = *surface.data();
    const bool is_ball = surface.kind() == SurfaceKind::sphere;
    const Point axis = is_ball ? Point{0, 0, 1} : data.axis, e = cross(axis, least_parallel_axis(axis)),
                f = cross(axis, e);
    const auto unit = [](const Point& p) {
      const double size = std::sqrt(to_double(dot(p, p)));
      return Vector{to_double(p[0]) / size, to_double(p[1]) / size, to_double(p[2]) / size};
    };
    const std::array<Vector, 3> frame = {unit(e), unit(f), unit(axis)};
    std::vector<Vector> net;
    for (int i = 0; i < 60; ++i)
      for (int j = 0; j < 60; ++j) {
        const auto [width, height] = profile(surface, (j + 0.5) / 60);
        const double turn = (i + 0.5) / 60 * 2 * std::numbers::pi;
        Vector p;
        for (std::size_t k = 0; k < 3; ++k)
          p[k] = to_double(data.point[k]) + height * frame[2][k] +
                 width * (std::cos(turn) * frame[0][k] + std::sin(turn) * frame[1][k]);
        if (!surface.bound() || height > 0) net.push_back(p);
      }
    return net;
  }

  /// Distance from the axis and height of a point of the profile, 0 < t < 1.
  static std::array<double, 2> profile(const ImplicitSurface& surface, double t) {
    const double radius = std::sqrt(to_double(surface.data()->squared)), height = 10 * t - 5;
    switch (surface.kind()) {
      case SurfaceKind::plane:
        return {5 * t, 0};
      case SurfaceKind::cylinder:
        return {radius, height};
      case SurfaceKind::cone:
        return {radius * std::fabs(height), height};
      case SurfaceKind::sphere:
        return {radius * std::sin(std::numbers::pi * t), radius * std::cos(std::numbers::pi * t)};
      default: {
        const double minor = std::sqrt(to_double(surface.data()->minor_squared));
        return {radius + minor * std::cos(2 * std::numbers::pi * t),
                minor * std::sin(2 * std::numbers::pi * t)};
      }
    }
  }

  const Face& first_;
  const Face& second_;
  const SurfaceIntersection& whole_;
  const SurfaceIntersection& in_boxes_;
  double room_;
};

}  // namespace

std::string difference(const Face& first, const Face& second, const SurfaceIntersection& whole,
                       const SurfaceIntersection& in_boxes) {
  return Comparison(first, second, whole, in_boxes).difference();
}

}  // namespace exsect::box_oracle
