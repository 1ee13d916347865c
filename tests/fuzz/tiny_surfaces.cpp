#include "tiny_surfaces.h"

#include <sstream>

namespace exsect::tiny_surfaces {

using random_pairs::Generator;
using random_pairs::integer;
using S = ImplicitSurface;

Point vector_of(Generator& generator, long size) {
  const auto number = [&] { return Rational(integer(generator, -size, size)); };
  const Rational x = number(), y = number();
  return {x, y, number()};
}

S tiny_surface(Generator& generator) {
  const Point at = vector_of(generator, 1);
  Point axis = {0, 0, 1};
  if (integer(generator, 0, 1) == 0) axis = vector_of(generator, 1);
  if (is_zero(axis)) axis = {1, 0, 0};
  const Rational radius = integer(generator, 1, 2);
  switch (integer(generator, 0, 4)) {
    case 0:
      return S::plane(at, axis);
    case 1:
      return S::cylinder(at, axis, radius);
    case 2:
      return S::cone(at, axis, radius, static_cast<int>(integer(generator, 1, 2)));
    case 3:
      return S::sphere(at, radius);
    default:
      return S::torus(at, axis, radius + 1, 1);
  }
}

S unnamed(const S& surface) { return S::polynomial(surface.equation()); }

std::string written(const S& surface) {
  std::ostringstream text;
  const SurfaceData& data = *surface.data();
  const auto point = [&](const Point& p) { text << " (" << p[0] << ',' << p[1] << ',' << p[2] << ')'; };
  text << name(surface.kind());
  point(data.point);
  point(data.axis);
  text << ' ' << data.squared << ' ' << data.minor_squared
       << (surface.kind() == SurfaceKind::cone && !surface.bound() ? " two nappes" : "");
  return text.str();
}

}  // namespace exsect::tiny_surfaces
