#include "implicit_surface.h"

#include <array>
#include <utility>

#include "space_forms.h"

namespace exsect {
namespace {

void require_direction(const char* key, const Point& direction) {
  if (is_zero(direction)) throw SurfaceError(key, "the vector is zero");
}

void require_positive_length(const char* key, const Length& length) {
  if (!length.is_positive()) throw SurfaceError(key, "not positive");
}

/// |d|^2 times the squared distance from the axis through c along d.
SpacePolynomial axis_distance(const Point& c, const Point& d) {
  const SpacePolynomial h = height_form(c, d);
  return dot(d, d) * squared_distance(c) - h * h;
}

/// f(origin + scale p)
SpacePolynomial moved_form(const SpacePolynomial& f, const Point& origin, const Rational& scale) {
  std::array<SpacePolynomial, 3> coordinate;
  for (std::size_t k = 0; k < 3; ++k)
    coordinate[k] = SpacePolynomial::constant(origin[k]) + scale * SpacePolynomial::variable(k);
  SpacePolynomial moved;
  for (const auto& [exponents, coefficient] : f.terms()) {
    SpacePolynomial term = SpacePolynomial::constant(coefficient);
    for (std::size_t k = 0; k < 3; ++k)
      for (int i = 0; i < exponents[k]; ++i) term = term * coordinate[k];
    moved += term;
  }
  return moved;
}

}  // namespace

const char* name(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::plane:
      return "plane";
    case SurfaceKind::cylinder:
      return "cylinder";
    case SurfaceKind::cone:
      return "cone";
    case SurfaceKind::sphere:
      return "sphere";
    case SurfaceKind::torus:
      return "torus";
    case SurfaceKind::polynomial:
      break;
  }
  return "implicit";
}

Length Length::of_squared(const Rational& q) { return {abs(q), sign(q)}; }

ImplicitSurface ImplicitSurface::plane(const Point& point, const Point& normal) {
  require_direction("normal", normal);
  return {SurfaceKind::plane, SurfaceData{point, normal, 0, 0}, height_form(point, normal)};
}

ImplicitSurface ImplicitSurface::cylinder(const Point& point, const Point& axis, const Length& radius) {
  require_direction("axis", axis);
  require_positive_length("radius", radius);
  return {SurfaceKind::cylinder, SurfaceData{point, axis, radius.squared(), 0},
          axis_distance(point, axis) - SpacePolynomial::constant(radius.squared() * dot(axis, axis))};
}

ImplicitSurface ImplicitSurface::cone(const Point& apex, const Point& axis, const Length& slope, int nappes) {
  require_direction("axis", axis);
  require_positive_length("slope", slope);
  if (nappes != 1 && nappes != 2) throw SurfaceError("nappes", "neither 1 nor 2");
  const SpacePolynomial h = height_form(apex, axis);
  ImplicitSurface cone(SurfaceKind::cone, SurfaceData{apex, axis, slope.squared(), 0},
                       axis_distance(apex, axis) - slope.squared() * h * h);
  if (nappes == 1) cone.bound_ = HalfSpaceBound{axis, -dot(apex, axis)};
  return cone;
}

ImplicitSurface ImplicitSurface::sphere(const Point& centre, const Length& radius) {
  require_positive_length("radius", radius);
  return {SurfaceKind::sphere, SurfaceData{centre, {0, 0, 0}, radius.squared(), 0},
          squared_distance(centre) - SpacePolynomial::constant(radius.squared())};
}

ImplicitSurface ImplicitSurface::torus(const Point& centre, const Point& axis, const Length& major,
                                       const Length& minor) {
  require_direction("axis", axis);
  require_positive_length("major", major);
  require_positive_length("minor", minor);
  if (minor.squared() == major.squared()) {
    throw SurfaceError("minor", "as great as major: a horn torus, which meets itself in its centre");
  }
  if (minor.squared() > major.squared()) {
    throw SurfaceError("minor", "greater than major: a spindle torus, which meets itself on its axis");
  }
  const SpacePolynomial s =
      squared_distance(centre) + SpacePolynomial::constant(major.squared() - minor.squared());
  return {SurfaceKind::torus, SurfaceData{centre, axis, major.squared(), minor.squared()},
          dot(axis, axis) * (s * s) - Rational(4 * major.squared()) * axis_distance(centre, axis)};
}

ImplicitSurface ImplicitSurface::polynomial(const SpacePolynomial& f) {
  if (f.degree() < 1) throw SurfaceError("terms", "the polynomial is constant");
  if (f.degree() > 4) throw SurfaceError("terms", "the degree is above 4");
  return {SurfaceKind::polynomial, std::nullopt, f};
}

bool ImplicitSurface::contains(const Point& p) const {
  return equation_(p) == 0 && (!bound_ || (*bound_)(p) >= 0) && box_.contains(p);
}

SurfaceRegion ImplicitSurface::region() const {
  SurfaceRegion all = box_;
  if (bound_) {
    all.clauses.push_back({all.bounds.size()});
    all.bounds.push_back({"", affine_form(bound_->normal, bound_->constant), SpacePolynomial::constant(1)});
  }
  return all;
}

ImplicitSurface ImplicitSurface::part_in(SurfaceRegion box) const {
  ImplicitSurface part = *this;
  part.box_ = std::move(box);
  return part;
}

ImplicitSurface ImplicitSurface::seen_from(const Point& origin, const Rational& scale) const {
  std::optional<SurfaceData> data = data_;
  if (data) {
    data->point = 1 / scale * (data->point - origin);
    data->minor_squared /= scale * scale;
    if (kind_ != SurfaceKind::cone) data->squared /= scale * scale;
  }
  ImplicitSurface result(kind_, std::move(data), moved_form(equation_, origin, scale));
  if (bound_) result.bound_ = HalfSpaceBound{scale * bound_->normal, (*bound_)(origin)};
  result.box_ = box_;
  for (SurfaceBound& bound : result.box_.bounds) {
    bound.form = moved_form(bound.form, origin, scale);
    bound.where = moved_form(bound.where, origin, scale);
  }
  return result;
}

}  // namespace exsect
