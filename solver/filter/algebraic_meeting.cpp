#include "filter/algebraic_meeting.h"

#include <exsect/algebra/common_field.h>
#include <exsect/algebra/resultant.h>
#include <exsect/algebra/triangular_point.h>

#include <algorithm>
#include <utility>

namespace exsect::filter {

namespace {

using AlongVector = std::array<BivariatePolynomial, 4>;

/// How near the point has to be to the place, and the widths of its intervals.
constexpr long kMeetingRoom = 36;
constexpr long kMeetingBits = 54;
/// By so many digits numbers are told, of fields of no higher degree.
constexpr int kDigitsOfField = 320;
constexpr int kMostMeetingDegree = 8;

/// Homogeneous coordinates and their derivatives on a side as polynomials in one variable, which is the free
/// parameter; constants in a corner.
struct AlongSide {
  AlongVector value;
  std::array<AlongVector, 2> derivative;

  /// The variable is r, or s.
  AlongSide(const RationalPatch& patch, const std::array<double, 2>& on, bool in_r) {
    for (std::size_t k = 0; k < 4; ++k) {
      const BivariatePolynomial f = patch.component(static_cast<int>(k));
      value[k] = restricted(f, on, in_r);
      derivative[0][k] = restricted(f.derivative_r(), on, in_r);
      derivative[1][k] = restricted(f.derivative_s(), on, in_r);
    }
  }

 private:
  static BivariatePolynomial restricted(const BivariatePolynomial& f, const std::array<double, 2>& on,
                                        bool in_r) {
    const auto side = [](double w) { return Rational(w > 0 ? 1 : 0); };
    Polynomial g = on[0] != 0 ? f.at_r(side(on[0])) : f.at_s(side(on[1]));
    if (on[0] != 0 && on[1] != 0) g = g(side(on[1]));
    const BivariatePolynomial result(std::vector<Polynomial>{std::move(g)});
    return in_r ? result.exchanged() : result;
  }
};

std::array<BivariatePolynomial, 6> minors_along(const AlongVector& a, const AlongVector& b) {
  const auto minor = [&](std::size_t i, std::size_t j) { return a[i] * b[j] - a[j] * b[i]; };
  return {minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 2), minor(1, 3), minor(2, 3)};
}

BivariatePolynomial determinant_along(const AlongVector& a, const AlongVector& b, const AlongVector& c,
                                      const AlongVector& d) {
  const auto p = minors_along(a, b), q = minors_along(c, d);
  return p[0] * q[5] - p[1] * q[4] + p[2] * q[3] + p[3] * q[2] - p[4] * q[1] + p[5] * q[0];
}

bool is_near(const RationalInterval& at, double place) {
  return abs(Rational(at.midpoint() - from_double(place) - Rational(1, 2))) <= power_of_two(-kMeetingRoom);
}

/// The point (r,s) next to the centred place where all equations hold; r = 0 if it is no variable.
std::optional<TriangularPoint> common_zero(const std::array<BivariatePolynomial, 6>& equations, bool has_r,
                                           const std::array<double, 2>& place) {
  BivariatePolynomial first, second;  // two of them without a common factor
  for (const BivariatePolynomial& f : equations) {
    if (!has_r) {
      first = gcd(first, f);
    } else if (first.is_zero()) {
      first = f;
    } else if (second.is_zero() && !f.is_zero() && gcd(first, f).total_degree() == 0) {
      second = f;
    }
  }
  const Polynomial eliminant = has_r ? resultant_r(first, second) : first.at_r(0);
  if (eliminant.is_zero()) return std::nullopt;
  const Rational width = power_of_two(-kMeetingBits);
  for (const RealAlgebraic& root : real_roots(eliminant, 0, 1)) {
    const RealAlgebraic s = root.refined_to(width);
    if (!is_near(s.interval(), place[1])) continue;
    const BivariatePolynomial over_s = has_r ? gcd_at(first, second, s) : BivariatePolynomial::r();
    if (over_s.is_zero()) continue;
    for (const TriangularPoint& candidate : roots_at(over_s, s, 0, 1)) {
      const TriangularPoint point = candidate.refined_to(width);
      if (has_r && !is_near(point.r_interval(), place[0])) continue;
      if (std::ranges::all_of(equations, [&](const auto& f) { return sign_at(f, point) == 0; })) return point;
    }
  }
  return std::nullopt;
}

FieldNumber field_value(const BivariatePolynomial& f, const FieldNumber& r, const FieldNumber& s) {
  FieldNumber sum = 0;
  for (int i = f.degree_r(); i >= 0; --i) {
    const Polynomial in_s = f.coefficient(i);
    FieldNumber coefficient = 0;
    for (int j = in_s.degree(); j >= 0; --j) coefficient = coefficient * s + in_s.coefficient(j);
    sum = sum * r + coefficient;
  }
  return sum;
}

bool lies_in(const FieldNumber& a, const RationalInterval& interval) {
  const RationalInterval at = enclosure(a, 2 * kMeetingBits);
  return interval.lower <= at.lower && at.upper <= interval.upper;
}

/// (r,s) in one field. The intervals of the point isolate it from other zeros of the equations.
std::optional<std::array<FieldNumber, 2>> in_field(const TriangularPoint& point,
                                                   const std::array<BivariatePolynomial, 6>& equations) {
  const TriangularPoint near = point.refined_to(power_of_two(-kDigitsOfField - 2));
  const auto numbers = recognised_in_field({near.r_interval().midpoint(), near.s().interval().midpoint()},
                                           kDigitsOfField, kMostMeetingDegree);
  if (!numbers) return std::nullopt;
  const FieldNumber &r = (*numbers)[0], &s = (*numbers)[1];
  const bool is_zero =
      std::ranges::all_of(equations, [&](const auto& f) { return field_value(f, r, s).is_zero(); });
  if (!is_zero || !lies_in(r, point.r_interval()) || !lies_in(s, point.s().interval())) return std::nullopt;
  return std::array{r, s};
}

}  // namespace

std::optional<ExactMeeting> algebraic_meeting(const RationalPatch& x, const RationalPatch& y,
                                              const Vec4& place, const Vec4& on) {
  const bool is_corner_of_x = on[0] != 0 && on[1] != 0, is_corner_of_y = on[2] != 0 && on[3] != 0;
  if (is_corner_of_y && !is_corner_of_x) {
    auto meeting =
        algebraic_meeting(y, x, {place[2], place[3], place[0], place[1]}, {on[2], on[3], on[0], on[1]});
    if (meeting) {
      std::rotate(meeting->at.begin(), meeting->at.begin() + 2, meeting->at.end());
      std::rotate(meeting->still.begin(), meeting->still.begin() + 2, meeting->still.end());
      if (auto& exact = meeting->exact) std::rotate(exact->begin(), exact->begin() + 2, exact->end());
    }
    return meeting;
  }
  if ((on[0] == 0 && on[1] == 0) || (on[2] != 0) == (on[3] != 0)) return std::nullopt;
  const std::size_t along_x = on[0] != 0 ? 1 : 0, along_y = on[2] != 0 ? 3 : 2;
  const AlongSide a(x, {on[0], on[1]}, true), b(y, {on[2], on[3]}, false);
  const auto equations = minors_along(a.value, b.value);
  const auto point = common_zero(equations, !is_corner_of_x, {place[along_x], place[along_y]});
  if (!point) return std::nullopt;
  const auto is_zero = [&](const BivariatePolynomial& f) { return sign_at(f, *point) == 0; };
  ExactMeeting result{on, 2 * kUnit, {}};
  const auto set = [&](std::size_t j, const RationalInterval& at) {
    result.at[j] = to_double(at.midpoint() - Rational(1, 2));
  };
  if (!is_corner_of_x) set(along_x, point->r_interval());
  set(along_y, point->s().interval());
  // As for simple numbers.
  for (std::size_t i = 0; i < 2; ++i) {
    result.still[i] =
        is_zero(determinant_along(a.value, a.derivative[1 - i], b.derivative[0], b.derivative[1]));
    result.still[2 + i] =
        is_zero(determinant_along(a.value, b.derivative[1 - i], a.derivative[0], a.derivative[1]));
  }
  const bool is_still = std::ranges::any_of(result.still, [](bool still) { return still; });
  if (const auto numbers = is_still ? in_field(*point, equations) : std::nullopt) {
    std::array<FieldNumber, 4>& exact = result.exact.emplace();
    for (std::size_t j = 0; j < 4; ++j) exact[j] = on[j] > 0 ? 1 : 0;
    if (!is_corner_of_x) exact[along_x] = (*numbers)[0];
    exact[along_y] = (*numbers)[1];
  }
  return result;
}

}  // namespace exsect::filter
