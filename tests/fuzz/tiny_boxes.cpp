#include "tiny_boxes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tiny_surfaces.h"

namespace exsect::tiny_boxes {
namespace {

using random_pairs::Generator;
using random_pairs::integer;
using tiny_surfaces::vector_of;
using Vector = std::array<double, 3>;
using Flat = std::array<double, 2>;

Vector doubles(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }
double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& a) { return std::sqrt(product(a, a)); }
Vector combined(const Vector& a, double t, const Vector& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

std::array<Rational, 2> direction(Generator& generator) {
  const Rational c = integer(generator, -1, 1);
  return {c, Rational(integer(generator, -1, 1))};
}

SurfaceBox box_of(Generator& generator, const ImplicitSurface& whole) {
  SurfaceBox box;
  if (whole.kind() == SurfaceKind::plane) {
    const Point first = cross(whole.data()->axis, vector_of(generator, 1));
    box.sides = {first, cross(whole.data()->axis, vector_of(generator, 2))};
    return box;
  }
  if (whole.kind() == SurfaceKind::sphere) box.axis = vector_of(generator, 1);
  if (integer(generator, 0, 1) == 0) {
    const Point from = vector_of(generator, 1);
    box.sector = AxisSector{from, vector_of(generator, 1)};
  }
  if (integer(generator, 0, 1) == 0) {
    const Rational from = Rational(integer(generator, -3, 3)) / 2;
    box.height = HeightRange{from, from + Rational(integer(generator, 1, 4)) / 2};
  }
  if (whole.kind() == SurfaceKind::torus && integer(generator, 0, 1) == 0) {
    const auto from = direction(generator);
    box.tube = TubeSector{from, direction(generator)};
  }
  return box;
}

/// The depth of a point of the plane in the angle from one direction to another, counter-clockwise.
double depth_in_angle(const Flat& p, const Flat& from, const Flat& to) {
  constexpr double kTurn = 6.283185307179586;
  const auto angle = [&](const Flat& q) {
    const double turned = std::atan2(from[0] * q[1] - from[1] * q[0], from[0] * q[0] + from[1] * q[1]);
    return turned < 0 ? turned + kTurn : turned;
  };
  const auto distance = [&](const Flat& side) {
    const double size = std::hypot(side[0], side[1]);
    const double along = (p[0] * side[0] + p[1] * side[1]) / size;
    return along < 0 ? std::hypot(p[0], p[1]) : std::fabs(p[0] * side[1] - p[1] * side[0]) / size;
  };
  const double off = std::min(distance(from), distance(to));
  return angle(p) <= angle(to) ? off : -off;
}

}  // namespace

ImplicitSurface Face::unnamed() const {
  const ImplicitSurface polynomial = tiny_surfaces::unnamed(whole);
  return box ? polynomial.part_in(surface().box()) : polynomial;
}

Face tiny_face(Generator& generator) {
  Face face{tiny_surfaces::tiny_surface(generator), {}};
  if (integer(generator, 0, 3) == 0) return face;
  for (;;) {
    face.box = box_of(generator, face.whole);
    try {
      static_cast<void>(face.surface());
      return face;
    } catch (const SurfaceError&) {  // as for directions along the axis
    }
  }
}

Face moved(const surface_moves::Motion& motion, const Face& face) {
  Face result{motion(face.whole), face.box};
  if (!face.box) return result;
  SurfaceBox& box = *result.box;
  if (box.axis) box.axis = motion.direction(*box.axis);
  if (box.sector) box.sector = {motion.direction(box.sector->from), motion.direction(box.sector->to)};
  if (box.height) box.height = {motion.scale * box.height->from, motion.scale * box.height->to};
  if (box.tube)
    for (auto* end : {&box.tube->from, &box.tube->to}) (*end)[1] *= motion.scale;
  if (box.sides)
    for (Point& side : *box.sides) side = motion.scale * motion.direction(side);
  return result;
}

std::string written(const Face& face) {
  std::ostringstream text;
  text << tiny_surfaces::written(face.whole);
  if (!face.box) return text.str();
  const SurfaceBox& box = *face.box;
  const auto point = [&](const Point& p) { text << " (" << p[0] << ',' << p[1] << ',' << p[2] << ')'; };
  text << " in";
  if (box.axis) text << " axis", point(*box.axis);
  if (box.sector) text << " sector", point(box.sector->from), point(box.sector->to);
  if (box.height) text << " height " << box.height->from << ".." << box.height->to;
  if (box.tube)
    for (const auto& end : {box.tube->from, box.tube->to}) text << " tube " << end[0] << ',' << end[1];
  if (box.sides) text << " sides", point((*box.sides)[0]), point((*box.sides)[1]);
  return text.str();
}

double depth_in(const Face& face, const std::array<double, 3>& p) {
  if (!face.box) return 1;
  const SurfaceBox& box = *face.box;
  const SurfaceData& data = *face.whole.data();
  const Vector off = combined(p, -1, doubles(data.point)), axis = doubles(box.axis.value_or(data.axis));
  const double size = length(axis), height = product(off, axis) / size;  // as a length
  double depth = INFINITY;
  if (box.sector) {
    const auto flat = [&](const Vector& v) {  // along the part of `from`, and a quarter turn from it
      const Vector from = doubles(box.sector->from);
      const Vector e = combined(from, -product(from, axis) / (size * size), axis);
      const Vector f = {axis[1] * e[2] - axis[2] * e[1], axis[2] * e[0] - axis[0] * e[2],
                        axis[0] * e[1] - axis[1] * e[0]};
      return Flat{product(v, e) / length(e), product(v, f) / length(f)};
    };
    depth = std::min(
        depth, depth_in_angle(flat(off), flat(doubles(box.sector->from)), flat(doubles(box.sector->to))));
  }
  if (box.height)
    depth = std::min(
        {depth, height - size * to_double(box.height->from), size * to_double(box.height->to) - height});
  if (box.tube) {
    const double major = std::sqrt(to_double(data.squared));
    const auto flat = [&](const std::array<Rational, 2>& d) {
      return Flat{major * to_double(d[0]), size * to_double(d[1])};
    };
    const double width = length(combined(off, -height / size, axis));
    depth =
        std::min(depth, depth_in_angle({width - major, height}, flat(box.tube->from), flat(box.tube->to)));
  }
  if (box.sides) {
    const Vector a = doubles((*box.sides)[0]), b = doubles((*box.sides)[1]);
    const double aa = product(a, a), ab = product(a, b), bb = product(b, b), det = aa * bb - ab * ab;
    const double pa = product(off, a), pb = product(off, b);
    const double s = (pa * bb - pb * ab) / det, t = (pb * aa - pa * ab) / det;
    const double across_a = std::sqrt(det / bb), across_b = std::sqrt(det / aa);  // heights of the sides
    depth = std::min({depth, s * across_a, (1 - s) * across_a, t * across_b, (1 - t) * across_b});
  }
  return depth;
}

}  // namespace exsect::tiny_boxes
