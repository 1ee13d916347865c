#include "output/drawing/sampled_equation.h"

#include <exsect/geometry/beyond_doubles.h>
#include <exsect/geometry/number.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace exsect::cli {
namespace {

using Vector = std::array<double, 3>;
using Range = std::array<double, 2>;

/// Of what is covered, added at both ends.
constexpr double margin = 0.15;
constexpr std::array<double, 4> without_parameters = {no_parameter, no_parameter, no_parameter, no_parameter};

double finite(double value) {
  if (!std::isfinite(value))
    throw BeyondDoubles("drawing: a surface has coordinates beyond the range of doubles");
  return value;
}

Vector finite_vector(const Point& p) {
  return {finite(to_double(p[0])), finite(to_double(p[1])), finite(to_double(p[2]))};
}

Vector unit(const Vector& a) {
  const double length = std::sqrt(dot_over(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// Origin, and three orthogonal unit vectors, the last one along the axis.
struct Frame {
  Vector origin;
  std::array<Vector, 3> direction;

  Vector operator()(double x, double y, double z) const {
    Vector p = origin;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = finite(p[k] + x * direction[0][k] + y * direction[1][k] + z * direction[2][k]);
    return p;
  }
  double coordinate(const Vector& p, std::size_t k) const {
    return dot_over({p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]}, direction[k]);
  }
};

Frame frame_of(const SurfaceData& data) {
  Point axis = is_zero(data.axis) ? Point{0, 0, 1} : data.axis;
  Rational largest = 0;
  for (const Rational& c : axis) largest = std::max<Rational>(largest, abs(c));
  for (Rational& c : axis) c /= largest;
  const Vector along = unit(finite_vector(axis));
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::fabs(along[k]) < std::fabs(along[least])) least = k;
  Vector other = {0, 0, 0};
  other[least] = 1;
  const Vector first = unit(cross_over(other, along));
  return {finite_vector(data.point), {first, cross_over(along, first), along}};
}

/// The coordinate of the points, and a margin; `least` is the shortest range.
Range covered_range(const Frame& frame, const SpacePoints& points, std::size_t k, double least) {
  Range range = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vector& p : points) {
    const double c = frame.coordinate(p, k);
    range = {std::min(range[0], c), std::max(range[1], c)};
  }
  const double more = std::max(margin * (range[1] - range[0]), (least - (range[1] - range[0])) / 2);
  return {range[0] - more, range[1] + more};
}

SceneMesh grid(const std::string& name, int cells, const std::function<Vector(double, double)>& at) {
  SceneMesh mesh{"surface " + name, {}, {}, nothing_proved};
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      mesh.vertices.push_back(
          {without_parameters, at(static_cast<double>(i) / cells, static_cast<double>(j) / cells)});
  const auto n = static_cast<std::size_t>(cells);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t corner = i * (n + 1) + j;
      mesh.faces.push_back({corner, corner + n + 1, corner + n + 2, corner + 1});
    }
  return mesh;
}

double between(const Range& range, double part) { return range[0] + part * (range[1] - range[0]); }

/// The heights on a cone, with its apex, or on a cylinder that are drawn.
Range heights(const ImplicitSurface& surface, const Frame& frame, const SpacePoints& around, double radius) {
  const bool is_cone = surface.kind() == SurfaceKind::cone;
  const Range range = covered_range(frame, around, 2, is_cone ? 0 : radius);
  if (!is_cone) return range;
  return {surface.bound() ? 0 : std::min(range[0], 0.0), std::max(range[1], 0.0)};
}

}  // namespace

SpacePoints extreme_points(const ImplicitSurface& surface) {
  if (surface.kind() != SurfaceKind::sphere && surface.kind() != SurfaceKind::torus) return {};
  const SurfaceData& data = *surface.data();
  const Vector centre = finite_vector(data.point);
  const double reach =
      std::sqrt(finite(to_double(data.squared))) + std::sqrt(finite(to_double(data.minor_squared)));
  SpacePoints result;
  for (int corner = 0; corner < 8; ++corner) {
    Vector p = centre;
    for (std::size_t k = 0; k < 3; ++k) p[k] = finite(p[k] + ((corner >> k) % 2 == 0 ? reach : -reach));
    result.push_back(p);
  }
  return result;
}

std::optional<SceneMesh> sampled(const ImplicitSurface& surface, const std::string& name,
                                 const SpacePoints& around, int cells) {
  if (!surface.data()) return std::nullopt;
  const Frame frame = frame_of(*surface.data());
  const double radius = std::sqrt(finite(to_double(surface.data()->squared)));
  const double minor = std::sqrt(finite(to_double(surface.data()->minor_squared)));
  const auto round = [&](double from_axis, double height, double turn) {
    const double angle = 2 * std::numbers::pi * turn;
    return frame(from_axis * std::cos(angle), from_axis * std::sin(angle), height);
  };
  switch (surface.kind()) {
    case SurfaceKind::sphere:
      return grid(name, cells, [&](double turn, double part) {
        const double angle = std::numbers::pi * (part - 0.5);
        return round(radius * std::cos(angle), radius * std::sin(angle), turn);
      });
    case SurfaceKind::torus:
      return grid(name, cells, [&](double turn, double part) {
        const double angle = 2 * std::numbers::pi * part;
        return round(radius + minor * std::cos(angle), minor * std::sin(angle), turn);
      });
    case SurfaceKind::polynomial:
      return std::nullopt;
    default:
      break;
  }
  if (around.empty()) return std::nullopt;
  if (surface.kind() == SurfaceKind::plane) {
    const Range x = covered_range(frame, around, 0, 0), y = covered_range(frame, around, 1, 0);
    return grid(name, cells, [&](double i, double j) { return frame(between(x, i), between(y, j), 0); });
  }
  const bool is_cone = surface.kind() == SurfaceKind::cone;
  const Range h = heights(surface, frame, around, radius);
  return grid(name, cells, [&](double turn, double part) {
    const double height = between(h, part);
    return round(is_cone ? radius * height : radius, height, turn);
  });
}

}  // namespace exsect::cli
