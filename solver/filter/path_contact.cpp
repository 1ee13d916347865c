#include "filter/path_contact.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

const Part& owner_part(const PathContact& contact, const Part& x, const Part& y) {
  return contact.path.of_x ? x : y;
}
const Part& carrier_part(const PathContact& contact, const Part& x, const Part& y) {
  return contact.path.of_x ? y : x;
}

/// The coordinates of a, b and c in the system of these three vectors are unit vectors: rows of the inverse.
std::array<Vec3, 3> inverse_rows(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 bc = cross(b, c);
  const double inverse = 1 / dot(a, bc);
  return {inverse * bc, inverse * cross(c, a), inverse * cross(a, b)};
}

}  // namespace

PathContact path_contact(const SidePath& path, const Pair& pair) {
  const SideView side = {path.side, false};
  PathContact contact{path, side, {}, across_field<Biquadratic>((path.of_x ? pair.x : pair.y).net, side)};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      contact.ends[i][j] = to_double(path.ends[i][j] - Rational(1, 2));
    }
  }
  return contact;
}

/// The ends err by u times their size, and (1-t) a + t b by 3 u (|a| + |b|) more: by 2^-50 times that in all.
Rectangle line_along(const PathContact& contact, const SideIntervals& on_owner) {
  Rectangle result;
  for (std::size_t i = 0; i < 2; ++i) {
    const double a = contact.ends[0][i];
    const double b = contact.ends[1][i];
    const double error = 0x1p-50 * (std::fabs(a) + std::fabs(b)) + 0x1p-100;
    const auto [lower, upper] = std::minmax({(1 - on_owner.along.lower) * a + on_owner.along.lower * b,
                                             (1 - on_owner.along.upper) * a + on_owner.along.upper * b});
    result.lower[i] = lower - error;
    result.upper[i] = upper + error;
  }
  return result;
}

// (14.25), (14.26). The coefficients in the rows' coordinates err by 2 total_error times the rows' size, as
// the sums below have each of them twice at most, and control vectors of the field across the side by 4
// net_error, as in (14.13), and a product with them by 5 net_error.
bool meet_on_line(const Pair& pair, const PathContact& contact, const Part& x, const Part& y) {
  const SideIntervals on_owner = intervals(contact.side, owner_part(contact, x, y));
  const Part& on_carrier = carrier_part(contact, x, y);
  Rectangle where = line_along(contact, on_owner);
  for (std::size_t i = 0; i < 2; ++i) {
    where.lower[i] = std::min(where.lower[i], on_carrier.range[i].lower - 0.5);
    where.upper[i] = std::max(where.upper[i], on_carrier.range[i].upper - 0.5);
  }
  const auto carrier = expand(contact.path.of_x ? pair.y : pair.x, where);
  if (!carrier) {
    return false;
  }
  const Coefficients& c = carrier->at_middle;
  const AcrossField field = restricted<Biquadratic>(contact.across, on_owner);
  const std::array<Vec3, 3> rows = inverse_rows(c[3], c[1], 0.5 * (field[1] + field[4]));
  for (std::size_t i = 0; i < 3; ++i) {
    const double size = size1(rows[i]);
    const MeanDerivative first = mean_first(*carrier, rows[i]);
    const MeanDerivative second = mean_second(*carrier, rows[i]);
    double across = 0;
    for (const Vec3& v : field) {
      across = larger_bound(across, std::fabs(dot(rows[i], v) - (i == 2 ? 1 : 0)));
    }
    const double sum = std::fabs(first.middle - (i == 0 ? 1 : 0)) + first.deviation +
                       std::fabs(second.middle - (i == 1 ? 1 : 0)) + second.deviation + across +
                       size * (4 * pair.total_error + 5 * pair.net_error);
    if (!(kSlack * sum < 1)) {
      return false;
    }
  }
  return true;
}

bool may_touch(const PathContact& contact, const Part& x, const Part& y) {
  const SideIntervals on_owner = intervals(contact.side, owner_part(contact, x, y));
  const Part& on_carrier = carrier_part(contact, x, y);
  if (on_owner.across.lower > 0) {
    return false;
  }
  const Rectangle line = line_along(contact, on_owner);
  for (std::size_t i = 0; i < 2; ++i) {
    if (line.upper[i] < on_carrier.range[i].lower - 0.5 || line.lower[i] > on_carrier.range[i].upper - 0.5) {
      return false;
    }
  }
  return true;
}

}  // namespace exsect::filter
