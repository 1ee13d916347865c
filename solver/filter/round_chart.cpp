#include "filter/round_chart.h"

#include <exsect/algebra/binary_order.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "filter/rounded_number.h"

namespace exsect {
namespace {

/// The root of a positive number, and of its inverse; NaN for others. The rounded number, its root and the
/// quotient err by 2^-52 in all.
DoubleBall root_ball(const Rational& q) {
  const double root = std::sqrt(to_double(q));
  return {root, root * 0x1p-50};
}
DoubleBall inverse_root_ball(const Rational& q) {
  const double inverse = 1 / std::sqrt(to_double(q));
  return {inverse, inverse * 0x1p-50};
}

/// A positive multiple of a vector other than 0, with the greatest coordinate in [1,2).
Point with_unit_size(const Point& direction) {
  Rational greatest = 0;
  for (const Rational& c : direction) greatest = std::max<Rational>(greatest, abs(c));
  return power_of_two(-binary_order(greatest)) * direction;
}

Point unit_point(std::size_t axis) {
  Point p{0, 0, 0};
  p[axis] = 1;
  return p;
}

/// Of the second coordinate where it is no angle: so sums of such numbers err by less than 2^-46.
constexpr double kMostRange = 64;

/// A positive upper bound of the distance of its points from its centre; 0 for others than spheres and tori.
double reach_from_centre(const ImplicitSurface& surface) {
  if (surface.kind() == SurfaceKind::sphere) return root_ball(surface.data()->squared).upper_magnitude();
  if (surface.kind() != SurfaceKind::torus) return 0;
  return (root_ball(surface.data()->squared) + root_ball(surface.data()->minor_squared)).upper_magnitude();
}

/// The point of the axis of a cylinder next to the centre, or to the axis, of another surface; empty if that
/// axis is parallel.
std::optional<Point> foot_on(const SurfaceData& cylinder, const ImplicitSurface& other) {
  const Point &a = cylinder.axis, &b = other.data()->axis, off = other.data()->point - cylinder.point;
  Rational bb = 1, ab = 0, bq = 0;
  if (reach_from_centre(other) == 0) bb = dot(b, b), ab = dot(a, b), bq = dot(b, off);
  const Rational determinant = dot(a, a) * bb - ab * ab;
  if (determinant == 0) return std::nullopt;
  return cylinder.point + (bb * dot(a, off) - ab * bq) / determinant * a;
}

/// 0: no chart; the greatest one is taken.
int chart_rank(const ImplicitSurface& surface) {
  switch (surface.kind()) {
    case SurfaceKind::torus:
      return 3;
    case SurfaceKind::cylinder:
      return 2;
    case SurfaceKind::cone:
      return 1;
    default:
      return 0;
  }
}

bool is_apex_common(const ImplicitSurface& cone, const ImplicitSurface& other) {
  return cone.kind() == SurfaceKind::cone && other.equation()(cone.data()->point) == 0;
}

/// Of a direction, by its length and by rounding its turns.
constexpr double kDirectionError = 0x1p-49;

std::array<DoubleBall, 2> circle(const RoundCoordinate& v, double reach) {
  // cos (x + h) = cos x cos h - sin x sin h, |sin h| <= |h|, |cos h - 1| <= h^2 / 2.
  const double half_square = reach * reach / 2;
  return {
      DoubleBall(v[0], (std::fabs(v[1]) * reach + std::fabs(v[0]) * half_square + kDirectionError) * kSlack),
      DoubleBall(v[1], (std::fabs(v[0]) * reach + std::fabs(v[1]) * half_square + kDirectionError) * kSlack)};
}

}  // namespace

std::optional<RoundChart> RoundChart::of(const ImplicitSurface& first, const ImplicitSurface& second) {
  if (!first.data() || !second.data()) return std::nullopt;
  if (chart_rank(first) < chart_rank(second)) {
    std::optional<RoundChart> chart = of(second, first);
    if (chart) chart->is_of_second_ = true;
    return chart;
  }
  if (chart_rank(first) == 0) return std::nullopt;
  if (second.kind() == SurfaceKind::plane && first.kind() != SurfaceKind::torus) return std::nullopt;
  if (is_apex_common(first, second) || is_apex_common(second, first)) return std::nullopt;
  RoundChart chart;
  chart.balls_.kind = first.kind();
  const SurfaceData &one = *first.data(), &other = *second.data();
  Point centre = one.point;
  if (first.kind() == SurfaceKind::cylinder) {
    const std::optional<Point> foot = foot_on(one, second);
    if (!foot) return std::nullopt;
    centre = *foot;
  }
  if (first.kind() == SurfaceKind::cone && other.point == centre) return std::nullopt;
  // Lengths are those of the chart, or of the distance of an apex.
  const Point apart = other.point - centre;
  const Rational length = first.kind() == SurfaceKind::cone ? dot(apart, apart) : one.squared;
  const long order = binary_order(length);
  const long exponent = (order - (order & 1)) / 2;
  if (std::labs(exponent) > 400) return std::nullopt;
  chart.unit_ = std::ldexp(1.0, static_cast<int>(exponent));
  const Rational inverse_unit = power_of_two(-exponent);
  const Point a = with_unit_size(one.axis);
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(a[k]) < abs(a[least])) least = k;
  const Point across = cross(a, unit_point(least));
  const std::array<Point, 3> raw = {across, cross(a, across), a};
  const bool has_axis = second.kind() != SurfaceKind::sphere;
  const Point b = has_axis ? with_unit_size(other.axis) : Point{0, 0, 0};
  const DoubleBall shorter = has_axis ? inverse_root_ball(dot(b, b)) : DoubleBall(0);
  const Point off = inverse_unit * apart;
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleBall inverse = inverse_root_ball(dot(raw[i], raw[i]));
    for (std::size_t k = 0; k < 3; ++k) chart.balls_.axes[i][k] = DoubleBall::enclosing(raw[i][k]) * inverse;
    chart.balls_.offset[i] = DoubleBall::enclosing(dot(raw[i], off)) * inverse;
    chart.balls_.direction[i] = DoubleBall::enclosing(dot(raw[i], b)) * inverse * shorter;
    chart.balls_.centre[i] = DoubleBall::enclosing(centre[i]);
  }
  chart.balls_.offset_squared = DoubleBall::enclosing(dot(off, off));
  chart.balls_.offset_along = DoubleBall::enclosing(dot(b, off)) * shorter;
  chart.set_profile(first);
  chart.set_equation(second);
  if (!chart.set_range(first, second)) return std::nullopt;
  chart.set_doubles();
  return chart;
}

void RoundChart::set_profile(const ImplicitSurface& surface) {
  balls_.unit = unit_;
  const DoubleBall inverse(surface.kind() == SurfaceKind::cone ? 1.0 : 1 / unit_);
  balls_.major = root_ball(surface.data()->squared) * inverse;
  balls_.minor = surface.kind() == SurfaceKind::torus ? root_ball(surface.data()->minor_squared) * inverse
                                                      : DoubleBall(0);
}

void RoundChart::set_equation(const ImplicitSurface& surface) {
  const Rational inverse_unit = 1 / (from_double(unit_) * from_double(unit_));
  const Rational& squared = surface.data()->squared;
  balls_.linear = 1;
  switch (surface.kind()) {
    case SurfaceKind::plane:
      balls_.linear = 0;
      balls_.along = 1;
      return;
    case SurfaceKind::cylinder:
      balls_.quadratic = -1;
      balls_.constant = -DoubleBall::enclosing(Rational(squared * inverse_unit));
      return;
    case SurfaceKind::cone:
      balls_.quadratic = -DoubleBall::enclosing(Rational(1 + squared));
      has_one_nappe_ = surface.bound().has_value();
      return;
    case SurfaceKind::torus:
      balls_.has_square = true;
      balls_.shift =
          DoubleBall::enclosing(Rational((squared - surface.data()->minor_squared) * inverse_unit));
      balls_.quadratic = DoubleBall::enclosing(Rational(4 * squared * inverse_unit));
      balls_.linear = -balls_.quadratic;
      return;
    default:
      balls_.constant = -DoubleBall::enclosing(Rational(squared * inverse_unit));
  }
}

/// In f = A b^2 + B b + C, over an angle, |b| <= |B| / |A| + sqrt(|C| / |A|) at a zero.
bool RoundChart::set_range(const ImplicitSurface& chart, const ImplicitSurface& other) {
  if (is_closed()) return true;
  double reach = 0;
  if (const double distance = reach_from_centre(other); distance > 0) {
    // |P - c'| is at most that, and |P - c| at least |b|.
    reach = (distance / unit_ + std::sqrt(balls_.offset_squared.upper_magnitude())) * kSlack;
  } else {
    constexpr int count = 32;
    RoundPlace place{{RoundCoordinate{1, 0}, RoundCoordinate{0, 0}}};
    for (int i = 0; i < count; ++i) {
      const RoundJet f = jet({place, {0x1p-3, 0}});
      const double least = f.second[2].lower_magnitude() / 2;
      const double bound =
          f.first[1].upper_magnitude() / least + std::sqrt(f.value.upper_magnitude() / least);
      reach = larger_bound(reach, bound * kSlack);
      place.at[0] = turned(place.at[0], 0.2);
    }
  }
  reach = reach * 1.0001 + 0x1p-30;
  if (!(reach < kMostRange)) return false;
  is_half_ = chart.bound().has_value();
  range_ = {is_half_ ? 0 : -reach, reach};
  return true;
}

/// The errors of both kinds of numbers stand for directions of length 1.
void RoundChart::set_doubles() {
  doubles_ = balls_.mapped<double>([](const DoubleBall& x) { return x.approximation(); });
  const auto bounds = balls_.mapped<RoundedNumber>(RoundedNumber::of);
  const RoundedNumber unknown(1 + kDirectionError, kDirectionError);
  RoundAngles<RoundedNumber> all{{unknown, unknown}, {unknown, unknown}};
  if (!is_closed()) all.along[0] = quick_reach_ = larger_bound(-range_[0], range_[1]) + 3;
  const auto f = bounds.derivatives(all);
  // Both formulas for the value are used.
  errors_.value = larger_bound(f.value.error(), bounds.value(all).error());
  for (std::size_t i = 0; i < 2; ++i) errors_.first[i] = f.first[i].error();
  for (std::size_t i = 0; i < 3; ++i) errors_.second[i] = f.second[i].error();
  const auto x = bounds.position(all);
  for (std::size_t k = 0; k < 3; ++k) position_errors_[k] = x[k].error();
}

RoundAngles<DoubleBall> RoundChart::angles(const RoundBox& box) const {
  return {circle(box.centre.at[0], box.reach[0]),
          is_closed() ? circle(box.centre.at[1], box.reach[1])
                      : std::array<DoubleBall, 2>{DoubleBall(box.centre.at[1][0]).widened(box.reach[1]), 0}};
}

[[gnu::flatten]] RoundJet RoundChart::jet(const RoundBox& box) const {
  return balls_.derivatives(angles(box));
}

RoundJet RoundChart::quick_jet(const RoundPlace& place) const {
  const RoundDerivatives<double> f = doubles_.derivatives(angles(place));
  const auto &f1 = f.first, &e1 = errors_.first;
  const auto &f2 = f.second, &e2 = errors_.second;
  if (!is_quick(place)) return jet(place);
  return {{f.value, errors_.value},
          {DoubleBall(f1[0], e1[0]), DoubleBall(f1[1], e1[1])},
          {DoubleBall(f2[0], e2[0]), DoubleBall(f2[1], e2[1]), DoubleBall(f2[2], e2[2])}};
}

DoubleBall RoundChart::value(const RoundPlace& place) const { return balls_.value(angles({place, {}})); }

bool RoundChart::is_on_other_nappe(const RoundBox& box) const {
  return has_one_nappe_ && balls_.height(angles(box)).is_negative();
}

int RoundChart::side(const RoundBox& box) const {
  const int on_chart = is_half_ ? DoubleBall(box.centre.at[1][0]).widened(box.reach[1]).certain_sign() : 1;
  const int on_other = has_one_nappe_ ? balls_.height(angles(box)).certain_sign() : 1;
  if (on_chart < 0 || on_other < 0) return -1;
  return std::min(on_chart, on_other);
}

[[gnu::flatten]] std::array<DoubleBall, 3> RoundChart::position(const RoundBox& box) const {
  return balls_.position(angles(box));
}

std::array<double, 2> RoundChart::speeds(const RoundBox& box) const {
  const auto p = balls_.profile(angles(box));
  const double along = is_closed() ? balls_.minor.upper_magnitude()
                                   : length_bound(p.rho[1].upper_magnitude(), p.z[1].upper_magnitude(), 0);
  return {p.rho[0].upper_magnitude() * unit_, along * unit_};
}

/// (17.35)
RoundMotion RoundChart::motion(const RoundBox& box, std::size_t axis, const DoubleBall& slope,
                               const DoubleBall& bend) const {
  const auto p = balls_.profile(angles(box));
  const DoubleBall unit(unit_), none(0), one(1);
  const DoubleBall &a1 = axis == 0 ? one : slope, &b1 = axis == 0 ? slope : one;
  const DoubleBall &a2 = axis == 0 ? none : bend, &b2 = axis == 0 ? bend : none;
  const DoubleBall rho1 = p.rho[1] * b1, bb = b1 * b1;
  return {{unit * rho1, unit * p.rho[0] * a1, unit * p.z[1] * b1},
          {unit * (p.rho[2] * bb + p.rho[1] * b2 - p.rho[0] * a1 * a1),
           unit * (DoubleBall(2) * rho1 * a1 + p.rho[0] * a2), unit * (p.z[2] * bb + p.z[1] * b2)}};
}

DoubleBall RoundChart::difference(std::size_t coordinate, const RoundPlace& a, const RoundPlace& b) const {
  const RoundCoordinate &p = a.at[coordinate], &q = b.at[coordinate];
  if (coordinate == 1 && !is_closed()) return DoubleBall(p[0]) - DoubleBall(q[0]);
  const DoubleBall far(0, std::numeric_limits<double>::infinity());
  if (!(p[0] * q[0] + p[1] * q[1] > 0.5)) return far;
  // The sine, of vectors of length 1 within 2^-50, and its inverse by its series: the coefficients that are
  // left out are below 0.0116, and the sum of the powers below 4 for |x| <= 0.87.
  const DoubleBall x =
      (DoubleBall(q[0]) * DoubleBall(p[1]) - DoubleBall(q[1]) * DoubleBall(p[0])).widened(0x1p-48);
  const DoubleBall y = x * x;
  DoubleBall sum(0);
  for (int k = 7; k > 0; --k) {
    const double ratio = (2.0 * k - 1) * (2.0 * k - 1) / (2.0 * k * (2.0 * k + 1));
    sum = y * DoubleBall(ratio, ratio * 0x1p-50) * (DoubleBall(1) + sum);
  }
  const double most = x.upper_magnitude();
  const double rest = 0.05 * std::pow(most, 17);
  return (x + x * sum).widened(rest);
}

RoundPlace RoundChart::moved(const RoundPlace& from, std::size_t coordinate, double by) const {
  RoundPlace place = from;
  if (coordinate == 1 && !is_closed())
    place.at[1][0] += by;
  else
    place.at[coordinate] = turned(place.at[coordinate], by);
  return place;
}

}  // namespace exsect
