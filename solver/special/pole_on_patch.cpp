#include "special/pole_on_patch.h"

#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/patch_ray.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/polynomial_vector.h"
#include "special/remaining_squares.h"

namespace exsect {
namespace {

constexpr int kNewtonSteps = 40;
/// How far simple numbers are from doubles, and the point is from y, at most.
constexpr double kSimple = 0x1p-40;
const Rational kSmallSquare(1, 64);
const Rational kPlaceWidth = power_of_two(-80);

/// Newton's method for Z = 0, least squares, from a double to a double.
std::optional<std::array<double, 2>> root_near(const PolynomialVector& z, std::array<double, 2> at) {
  const auto rounded = [](const Point& p) {
    return std::array<double, 3>{to_double(p[0]), to_double(p[1]), to_double(p[2])};
  };
  const auto product = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const PolynomialVector z_r = derivative_r(z), z_s = derivative_s(z);
  for (int step = 0; step < kNewtonSteps; ++step) {
    const Rational r = from_double(at[0]), s = from_double(at[1]);
    const auto p = rounded(value(z_r, r, s)), q = rounded(value(z_s, r, s)), v = rounded(value(z, r, s));
    const double pp = product(p, p), pq = product(p, q), qq = product(q, q);
    const double vp = product(v, p), vq = product(v, q), d = pp * qq - pq * pq;
    at = {at[0] - (qq * vp - pq * vq) / d, at[1] - (pp * vq - pq * vp) / d};
    if (!(std::fabs(at[0]) < 2 && std::fabs(at[1]) < 2)) return std::nullopt;
  }
  return at;
}

bool is_regular(const PolynomialVector& z, const Rational& r, const Rational& s) {
  return !is_zero(cross(value(derivative_r(z), r, s), value(derivative_s(z), r, s)));
}

/// The simplest rational place near a double one, if the point is on y there and y is regular; `z` is Z.
std::optional<PoleOnPatch> rational_place(const Point& p, const PolynomialVector& z,
                                          const std::array<double, 2>& near) {
  std::array<Rational, 2> at;
  for (std::size_t j = 0; j < 2; ++j) {
    const Rational middle = from_double(near[j]), room = from_double(kSimple);
    at[j] = simplest_between(middle - room, middle + room);
  }
  const bool is_in_square = std::ranges::all_of(at, [](const Rational& t) { return 0 <= t && t <= 1; });
  if (!is_in_square || !is_zero(value(z, at[0], at[1])) || !is_regular(z, at[0], at[1])) return std::nullopt;
  return PoleOnPatch{p, {RationalInterval{at[0], at[0]}, RationalInterval{at[1], at[1]}}};
}

/// A place where a ray from the point along the normal of y crosses y in the point, exactly.
std::optional<PoleOnPatch> algebraic_place(const Point& p, const PolynomialVector& z, const RationalPatch& y,
                                           const std::array<double, 2>& near) {
  const Rational r = from_double(near[0]), s = from_double(near[1]);
  const Point z_r = value(derivative_r(z), r, s), z_s = value(derivative_s(z), r, s), off = value(z, r, s);
  const double room = kSimple * kSimple * to_double(dot(z_r, z_r) + dot(z_s, z_s));
  if (!(to_double(dot(off, off)) <= room)) return std::nullopt;
  const Point normal = cross(z_r, z_s);
  Point direction;
  for (std::size_t c = 0; c < 3; ++c) direction[c] = from_double(to_double(normal[c]));
  if (is_zero(direction)) return std::nullopt;
  for (const RayHit& hit : intersect_ray(p, direction, y).hits) {
    if (hit.t.compare(0) != 0 || hit.contact != RayContact::transversal || !hit.parameters) continue;
    const TriangularPoint place = hit.parameters->refined_to(kPlaceWidth);
    const RationalInterval at_r = place.r_interval(), at_s = place.s().interval();
    const bool is_inside = at_r.lower > 0 && at_r.upper < 1 && at_s.lower > 0 && at_s.upper < 1;
    if (is_inside && is_regular(z, at_r.midpoint(), at_s.midpoint()))
      return PoleOnPatch{p, {at_r, at_s}, place};
  }
  return std::nullopt;
}

}  // namespace

bool is_pole(const RationalPatch& x) {
  const PolynomialVector z = coordinates_from(x, x(0, 0));
  return std::ranges::all_of(z, [](const BivariatePolynomial& f) { return f.coefficient(0).is_zero(); });
}

bool is_pole(const RationalPatch& x, const Side& side) {
  const RationalPatch first = side.parameter == Parameter::u ? x : x.transposed();
  return is_pole(side.value == 0 ? first : first.restricted_to(1, 0, 0, 1));
}

bool is_pole_alone(const RationalPatch& x, const Side& pole) {
  const PolynomialVector z =
      coordinates_from(x, pole.parameter == Parameter::u ? x(pole.value, 0) : x(0, pole.value));
  for (const Parameter p : {Parameter::u, Parameter::v})
    for (const int value : {0, 1}) {
      if (pole == Side{p, value}) continue;
      Polynomial common;
      for (const BivariatePolynomial& f : z)
        common = gcd(common, p == Parameter::u ? f.at_r(value) : f.at_s(value));
      if (common.is_zero()) return false;
      const bool has_corner = p != pole.parameter;
      for (const RealAlgebraic& at : real_roots(common, 0, 1))
        if (!has_corner || at != RealAlgebraic(pole.value)) return false;
    }
  return true;
}

std::optional<PoleOnPatch> pole_on_patch(const RationalPatch& x, const RationalPatch& y) {
  const Point p = x(0, 0);
  if (!is_pole(x)) return std::nullopt;
  const PolynomialVector z = coordinates_from(y, p);
  std::vector<BivariatePolynomial> tests;
  for (const BivariatePolynomial& f : z)
    for (const int sign : {1, -1}) tests.push_back(f * Polynomial(sign));
  const auto squares = remaining_squares(tests, [](const Rectangle& square) {
    return square.r.width() <= kSmallSquare && square.s.width() <= kSmallSquare;
  });
  if (!squares) return std::nullopt;
  for (const Rectangle& square : *squares) {
    const auto near = root_near(z, {to_double(square.r.midpoint()), to_double(square.s.midpoint())});
    if (!near) continue;
    if (auto pole = rational_place(p, z, *near)) return pole;
    if (auto pole = algebraic_place(p, z, y, *near)) return pole;
  }
  return std::nullopt;
}

}  // namespace exsect
