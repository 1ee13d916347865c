// Surfaces given by their equation: planes, cylinders, cones, spheres, tori, and polynomials up to degree 4.
#pragma once

#include <exsect/geometry/space_polynomial.h>
#include <exsect/geometry/surface_region.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace exsect {

enum class SurfaceKind { plane, cylinder, cone, sphere, torus, polynomial };
/// "plane", ..., "implicit" for a polynomial: as in files.
const char* name(SurfaceKind kind);

/// Data that are no surface: `where` is the key at fault, as "axis" or "radius", `reason` the violated
/// statement. what() is "where: reason".
class SurfaceError : public std::invalid_argument {
 public:
  SurfaceError(const std::string& where, const std::string& reason)
      : std::invalid_argument(where + ": " + reason), where_(where), reason_(reason) {}

  const std::string& where() const { return where_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string where_;
  std::string reason_;
};

/// A length whose square is rational: the equations (17.1) contain squares only. Negative lengths are kept as
/// such, for the makers of surfaces to refuse.
class Length {
 public:
  Length(const Rational& length) : squared_(length * length), sign_(sign(length)) {}  // NOLINT: a number
  Length(int length) : Length(Rational(length)) {}                                    // NOLINT
  /// The root of q; of the sign of q.
  static Length of_squared(const Rational& q);

  const Rational& squared() const { return squared_; }
  bool is_positive() const { return sign_ > 0; }

 private:
  Length(Rational squared, int sign) : squared_(std::move(squared)), sign_(sign) {}
  Rational squared_;
  int sign_;
};

/// A half space normal . P + constant >= 0: the nappe of a cone.
struct HalfSpaceBound {
  Point normal;
  Rational constant;

  Rational operator()(const Point& p) const { return dot(normal, p) + constant; }
};

/// What a maker was given. The directions are not normalised.
struct SurfaceData {
  Point point;  // of the plane or of the axis; the apex, the centre
  Point axis;   // of a plane its normal; zero for a sphere
  /// Of the radius, of the slope of a cone, of the major radius of a torus; 0 for a plane.
  Rational squared;
  Rational minor_squared;  // 0 unless it is a torus
};

/// The real points of equation() = 0, of one nappe only those in the half space bound(), and of a face only
/// those in its box(). Invariant, of whole surfaces: the
/// degree is 1 to 4, and every kind but `polynomial` has real points, a surface that is smooth apart from the
/// apex of a cone. Directions are any rational vectors other than zero, not normalised. The makers throw
/// SurfaceError.
class ImplicitSurface {
 public:
  static ImplicitSurface plane(const Point& point, const Point& normal);
  static ImplicitSurface cylinder(const Point& point, const Point& axis, const Length& radius);
  /// slope: radius per unit of height, positive. One nappe is the one on the side that the axis points to.
  static ImplicitSurface cone(const Point& apex, const Point& axis, const Length& slope, int nappes = 1);
  static ImplicitSurface sphere(const Point& centre, const Length& radius);
  /// 0 < minor < major: horn and spindle tori, which meet themselves, are refused by these names.
  static ImplicitSurface torus(const Point& centre, const Point& axis, const Length& major,
                               const Length& minor);
  /// F = 0; a multiple factor of F counts as contact with what it meets.
  static ImplicitSurface polynomial(const SpacePolynomial& f);

  SurfaceKind kind() const { return kind_; }
  /// Empty for a polynomial.
  const std::optional<SurfaceData>& data() const { return data_; }
  /// F of (17.1), not divided by common factors of its coefficients.
  const SpacePolynomial& equation() const { return equation_; }
  /// Of one nappe of a cone.
  const std::optional<HalfSpaceBound>& bound() const { return bound_; }
  /// What boxed() (surface_box.h) or part_in() cut it to; without clauses for a whole surface.
  const SurfaceRegion& box() const { return box_; }
  /// box() and bound().
  SurfaceRegion region() const;
  /// The same surface in this box alone.
  ImplicitSurface part_in(SurfaceRegion box) const;
  bool contains(const Point& p) const;
  /// The surface of the points q with origin + scale q on this one, of the same kind. Requires scale > 0.
  ImplicitSurface seen_from(const Point& origin, const Rational& scale) const;

 private:
  ImplicitSurface(SurfaceKind kind, std::optional<SurfaceData> data, SpacePolynomial equation)
      : kind_(kind), data_(std::move(data)), equation_(std::move(equation)) {}

  SurfaceKind kind_;
  std::optional<SurfaceData> data_;
  SpacePolynomial equation_;
  std::optional<HalfSpaceBound> bound_;
  SurfaceRegion box_;
};

}  // namespace exsect
