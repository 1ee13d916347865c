#include "overlap/common_sheet.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/sheet_contraction.h"

namespace exsect {

namespace {

using Pair = SheetContraction::Pair;

double upper(const DoubleBall& b) { return b.upper_magnitude(); }

double on_grid(double value, double grid) { return grid * std::round(value / grid); }

/// w' = (C y')^-1 C x': with |w'_k| <= width_k m and |E| m as error.
CommonSheet sheet_of(const SheetContraction& over) {
  CommonSheet result{over.first_derivatives()};
  for (std::size_t l = 0; l < 2; ++l) {
    const double largest = larger_bound(upper(result.derivative[0][l]) / over.width[0],
                                        upper(result.derivative[1][l]) / over.width[1]);
    const double m = kSlack * largest / (1 - over.contraction());
    for (std::size_t k = 0; k < 2; ++k)
      result.derivative[k][l] = result.derivative[k][l].widened(
          kSlack * m * (over.e[k][0] * over.width[0] + over.e[k][1] * over.width[1]));
  }
  return result;
}

/// On the line u = c_0 + a: near the middle of its image, with a short r or s.
bool meets_on_line(const SheetContraction& over, const CommonSurface& surface, double a) {
  const Pair across = {over.projected(0, over.x[3]).approximation(),
                       over.projected(1, over.x[3]).approximation()};
  const Pair along = {over.projected(0, over.x[1]).approximation(),
                      over.projected(1, over.x[1]).approximation()};
  const std::size_t fixed =
      std::fabs(along[1]) * over.width[0] >= std::fabs(along[0]) * over.width[1] ? 1 : 0;
  const double step = std::fabs(along[fixed]) * over.reach[1] / 16;
  if (!(step > 1e-12)) return false;
  const double value = on_grid(over.w0[fixed] + across[fixed] * a, std::ldexp(1, std::ilogb(step)));
  const double middle_of_other = over.w0[1 - fixed] + across[1 - fixed] * a;
  const double radius = 0.5 * over.width[1 - fixed];
  const RationalInterval v = {from_double(over.c[1] - 0.5 * over.reach[1]),
                              from_double(over.c[1] + 0.5 * over.reach[1])};
  const RationalInterval other = {from_double(middle_of_other - radius),
                                  from_double(middle_of_other + radius)};
  if (!(std::fabs(value - over.w0[fixed]) < over.width[fixed] &&
        std::fabs(across[1 - fixed] * a) + radius < over.width[1 - fixed]))
    return false;
  const Rational u = from_double(over.c[0] + a);
  return fixed == 1 ? surface.has_point(u, from_double(value), other, v)
                    : surface.has_point_at_r(u, from_double(value), other, v);
}

/// A point of W in the box, on the line u = c_0 or on one nearby: the former may be straight, the others
/// not.
bool meets(const SheetContraction& over, const CommonSurface& surface) {
  return meets_on_line(over, surface, 0) || meets_on_line(over, surface, 0.25 * over.reach[0]);
}

}  // namespace

std::optional<CommonSheet> CommonSheets::certify(const SearchRegion& region) const {
  SheetContraction attempt(region);
  if (!attempt.find_centre(system_) || !attempt.is_near() || !attempt.contracts()) return std::nullopt;
  if (!attempt.is_regular()) return std::nullopt;
  if (!surface_.planar() && !meets(attempt, surface_)) return std::nullopt;
  return sheet_of(attempt);
}

bool CommonSheets::settles(const SearchRegion& region) const {
  SheetContraction attempt(region);
  if (attempt.find_centre(system_) && attempt.contracts() && attempt.leaves_region()) return true;
  return certify(region).has_value();
}

}  // namespace exsect
