#include "filter/double_point.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "filter/common_normal.h"
#include "filter/exact_place.h"
#include "filter/ports.h"

namespace exsect::filter {

namespace {

/// Of a parameter from the rational number it stands for, and of both patches from each other.
constexpr double kCloseSheets = 0x1p-40;
/// Of the boxes of the parameters, relative to these.
constexpr long kBoxBits = 60;
constexpr double kFirstReach = 0x1p-1;
constexpr double kLeastReach = 0x1p-12;

/// (14.20), (14.21).
template <class K>
bool has_star(const LocalFormsOf<K>& forms, const LocalBounds& bounds, double reach) {
  const double value = kSlack * (bounds.value * reach + forms.rest);
  return forms.crossing ? value < 0.5 && kSlack * (bounds.slope * reach + 2 * forms.rest) < 1 : value < 1;
}

/// The simplest rational parameters near w.
std::array<FieldNumber, 4> simplest_place(const Vec4& w) {
  std::array<FieldNumber, 4> at;
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational near = from_double(w[j] + 0.5);
    at[j] = simplest_between(near - from_double(kCloseSheets), near + from_double(kCloseSheets));
  }
  return at;
}

/// Sets the place and the forms, the latter proved; false if there is no such point in the squares.
template <class K>
bool find_place(const ExactPatch<K>& x, const ExactPatch<K>& y, const Vec4& w, DoublePointOf<K>& point) {
  point.at = simplest_place(w);
  auto forms = local_forms<K>(x, y, point.at);
  if constexpr (!std::is_same_v<K, Biquadratic>) {  // exact arithmetic is behind these
    if (!forms) {
      const auto place = exact_place<K>(x, y, w);
      if (!place) return false;
      point.at = *place;
      forms = local_forms<K>(x, y, point.at);
    }
  }
  if (!forms) return false;
  point.forms = *forms;
  for (std::size_t j = 0; j < 4; ++j) {
    if (sign(point.at[j]) < 0 || sign(point.at[j] - 1) > 0) return false;
    point.on[j] = point.at[j].is_zero() ? -0.5 : point.at[j] == FieldNumber(1) ? 0.5 : 0;
    point.centre[j] = to_double(point.at[j] - Rational(1, 2));
    point.box[j] = enclosure(point.at[j], kBoxBits);
    point.box[j].upper = std::min<Rational>(point.box[j].upper, 1);
  }
  return true;
}

}  // namespace

template <class K>
bool is_on_side(const CentreOf<K>& point) {
  return point.on != Vec4{};
}

template <class K>
bool may_be_same(const DoublePointOf<K>& point, const DoublePointOf<K>& other) {
  for (std::size_t j = 0; j < 4; ++j) {
    if (point.box[j].upper < other.box[j].lower || other.box[j].upper < point.box[j].lower) return false;
  }
  return true;
}

template <class K>
std::optional<DoublePointOf<K>> double_point_near(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                  const PairOf<K>& pair, const Vec4& guess,
                                                  double tolerance) {
  const auto w = common_normal(pair, guess);
  if (!w || !(w->distance < kCloseSheets)) {
    return std::nullopt;
  }
  DoublePointOf<K> point;
  if (!find_place<K>(x, y, w->at, point)) return std::nullopt;
  for (point.reach = kFirstReach; point.reach >= kLeastReach; point.reach *= 0.5) {
    const auto bounds = local_bounds<K>(point.forms, point.reach);
    if (bounds && has_star(point.forms, *bounds, point.reach)) {
      point.width = {bounds->k[0] * point.reach, bounds->k[1] * point.reach};
      if (!leaves_sides(pair, point)) continue;
      return add_ports(pair, point, tolerance) ? std::optional(std::move(point)) : std::nullopt;
    }
  }
  return std::nullopt;
}

template <class K>
LocalPlace local_place(const DoublePointOf<K>& point, const Vec4& middle, const Vec4& half) {
  const Matrix2& s = point.forms.s;
  const std::array<double, 2> a = {middle[2] - point.centre[2], middle[3] - point.centre[3]};
  const double inverse = 1 / (s[0][0] * s[1][1] - s[0][1] * s[1][0]);
  const Matrix2 rows = {{{s[1][1] * inverse, -s[0][1] * inverse}, {-s[1][0] * inverse, s[0][0] * inverse}}};
  LocalPlace place;
  for (std::size_t i = 0; i < 2; ++i) {
    place.t[i] = rows[i][0] * a[0] + rows[i][1] * a[1];
    place.error[i] = 0;
    for (std::size_t j = 0; j < 2; ++j) {
      place.error[i] +=
          std::fabs(rows[i][j]) * (half[2 + j] + kInverseError * std::fabs(a[j]) + kPlaceRounding);
    }
    place.error[i] *= kInverseSlack;
  }
  const auto within = [&](std::size_t i) {
    return kSlack * (std::fabs(middle[i] - point.centre[i]) + half[i] + kPlaceRounding) <= point.width[i];
  };
  place.has_width = within(0) && within(1);
  return place;
}

template <class K>
bool lies_in_region(const DoublePointOf<K>& point, const Vec4& middle, const Vec4& half) {
  const LocalPlace at = local_place(point, middle, half);
  const auto within = [&](std::size_t i) { return std::fabs(at.t[i]) + at.error[i] <= point.reach; };
  return at.has_width && within(0) && within(1);
}

#define EXSECT_INSTANTIATE(K)                                                                               \
  template std::optional<DoublePointOf<K>> double_point_near<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                                const PairOf<K>&, const Vec4&, double);     \
  template bool is_on_side<K>(const CentreOf<K>&);                                                          \
  template bool may_be_same<K>(const DoublePointOf<K>&, const DoublePointOf<K>&);                           \
  template LocalPlace local_place<K>(const DoublePointOf<K>&, const Vec4&, const Vec4&);                    \
  template bool lies_in_region<K>(const DoublePointOf<K>&, const Vec4&, const Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
