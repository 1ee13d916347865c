// The formulas of round charts, in balls, in doubles and for error bounds. Internal to solver/;
// docs/method-equations.md, section 17.21.
#pragma once

#include <exsect/geometry/implicit_surface.h>

#include <array>
#include <type_traits>

namespace exsect {

/// The cosine and sine of both angles; the second one may be a number instead, with 0.
template <class T>
struct RoundAngles {
  std::array<T, 2> around, along;
};

/// A function with its first and second derivatives (by the coordinates 00, 01, 11).
template <class T>
struct RoundDerivatives {
  T value;
  std::array<T, 2> first;
  std::array<T, 3> second;
};

/// Of the numbers T = DoubleBall, double, RoundedNumber.
template <class T>
struct RoundFormula {
  SurfaceKind kind = SurfaceKind::torus;
  T major{}, minor{};  // of a cylinder, and the slope of a cone: major
  T unit{};
  std::array<std::array<T, 3>, 3> axes{};
  std::array<T, 3> centre{};
  // The other surface in the axes.
  std::array<T, 3> offset{};     // c' - c
  std::array<T, 3> direction{};  // b'
  T offset_squared{}, offset_along{};
  bool has_square = false;
  T shift{}, linear{}, quadratic{}, along{}, constant{};

  /// The same with other numbers.
  template <class U, class Map>
  RoundFormula<U> mapped(const Map& map) const {
    const auto each = [&](const std::array<T, 3>& v) {
      return std::array<U, 3>{map(v[0]), map(v[1]), map(v[2])};
    };
    RoundFormula<U> result;
    result.kind = kind;
    result.major = map(major), result.minor = map(minor), result.unit = map(unit);
    for (std::size_t i = 0; i < 3; ++i) result.axes[i] = each(axes[i]);
    result.centre = each(centre), result.offset = each(offset), result.direction = each(direction);
    result.offset_squared = map(offset_squared), result.offset_along = map(offset_along);
    result.has_square = has_square;
    result.shift = map(shift), result.linear = map(linear), result.quadratic = map(quadratic);
    result.along = map(along), result.constant = map(constant);
    return result;
  }

  /// With derivatives by the second coordinate.
  struct Profile {
    std::array<T, 3> rho, z, square;  // rho^2 + z^2
  };
  /// (17.33)
  Profile profile(const RoundAngles<T>& at) const {
    if (kind == SurfaceKind::torus) {
      const T x = minor * at.along[0], y = minor * at.along[1], two = major + major;
      return {
          {major + x, -y, -x}, {y, x, -y}, {major * major + minor * minor + two * x, -(two * y), -(two * x)}};
    }
    const T& b = at.along[0];
    if (kind == SurfaceKind::cylinder)
      return {{major, T(0), T(0)}, {b, T(1), T(0)}, {major * major + b * b, b + b, T(2)}};
    const T k = major * major + T(1), two = k + k;
    return {{major * b, major, T(0)}, {b, T(1), T(0)}, {k * b * b, two * b, two}};
  }

  // The following ones also for X of several doubles at once, with the same operations.

  /// rho and z, and rho^2 + z^2.
  template <class X>
  struct Point {
    X rho, z, square;
  };
  template <class X>
  Point<X> point(const RoundAngles<X>& at) const {
    const X& b = at.along[0];
    if (kind == SurfaceKind::torus) {
      const X x = minor * b, rx = major * x;
      return {major + x, minor * at.along[1], major * major + minor * minor + (rx + rx)};
    }
    if (kind == SurfaceKind::cylinder) return {repeated<X>(major), b, major * major + b * b};
    return {major * b, b, (major * major + T(1)) * b * b};
  }

  /// H of the other surface.
  template <class X>
  X height(const RoundAngles<X>& at, const Point<X>& p) const {
    return p.rho * (direction[0] * at.around[0] + direction[1] * at.around[1]) + p.z * direction[2] -
           offset_along;
  }

  template <class X>
  X value(const RoundAngles<X>& at, const Point<X>& p) const {
    const X half = p.rho * (offset[0] * at.around[0] + offset[1] * at.around[1]) + p.z * offset[2];
    const X n = p.square + offset_squared - (half + half);
    const X t = height(at, p);
    const X f = linear * n + (quadratic * t + along) * t + constant;
    if (!has_square) return f;
    const X shifted = n + shift;
    return f + shifted * shifted;
  }

  /// In space.
  template <class X>
  std::array<X, 3> position(const RoundAngles<X>& at, const Point<X>& p) const {
    const auto& [c, s] = at.around;
    const X x = unit * p.rho * c, y = unit * p.rho * s, z = unit * p.z;
    std::array<X, 3> result{};
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = centre[k] + (x * axes[0][k] + y * axes[1][k] + z * axes[2][k]);
    return result;
  }

  T height(const RoundAngles<T>& at) const { return height(at, point(at)); }
  T value(const RoundAngles<T>& at) const { return value(at, point(at)); }
  std::array<T, 3> position(const RoundAngles<T>& at) const { return position(at, point(at)); }

  RoundDerivatives<T> derivatives(const RoundAngles<T>& at) const {
    const auto& [c, s] = at.around;
    const Profile p = profile(at);
    const auto &d = offset, &b = direction;
    const T g = d[0] * c + d[1] * s, dg = d[1] * c - d[0] * s;
    const T h = b[0] * c + b[1] * s, dh = b[1] * c - b[0] * s;
    const auto twice = [](const T& x) { return x + x; };
    const T rg = p.rho[0] * g, rh = p.rho[0] * h;
    const T n = p.square[0] + offset_squared - twice(rg + p.z[0] * d[2]);
    const T t = rh + p.z[0] * b[2] - offset_along;
    const std::array<T, 2> n1 = {-twice(p.rho[0] * dg), p.square[1] - twice(p.rho[1] * g + p.z[1] * d[2])};
    const std::array<T, 2> t1 = {p.rho[0] * dh, p.rho[1] * h + p.z[1] * b[2]};
    const std::array<T, 3> n2 = {twice(rg), -twice(p.rho[1] * dg),
                                 p.square[2] - twice(p.rho[2] * g + p.z[2] * d[2])};
    const std::array<T, 3> t2 = {-rh, p.rho[1] * dh, p.rho[2] * h + p.z[2] * b[2]};
    const T qt = quadratic * t, by_t = twice(qt) + along;
    T by_n = linear;
    RoundDerivatives<T> f{};
    f.value = linear * n + (qt + along) * t + constant;
    if (has_square) {
      const T shifted = n + shift;
      f.value = f.value + shifted * shifted;
      by_n = by_n + twice(shifted);
    }
    for (std::size_t i = 0; i < 2; ++i) f.first[i] = by_n * n1[i] + by_t * t1[i];
    const std::array<T, 2> q1 = {quadratic * t1[0], quadratic * t1[1]};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = k / 2, j = (k + 1) / 2;
      T square = q1[i] * t1[j];
      if (has_square) square = square + n1[i] * n1[j];
      f.second[k] = by_n * n2[k] + by_t * t2[k] + twice(square);
    }
    return f;
  }

 private:
  template <class X>
  static X repeated(const T& x) {
    if constexpr (std::is_same_v<X, T>)
      return x;
    else
      return X{} + x;
  }
};

}  // namespace exsect
