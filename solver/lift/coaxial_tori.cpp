#include "lift/coaxial_tori.h"

namespace exsect {

std::optional<CoaxialSection> coaxial_section(const SurfaceData& first, const SurfaceData& second) {
  const Point offset = second.point - first.point;
  if (!is_zero(cross(first.axis, second.axis)) || !is_zero(cross(first.axis, offset))) return std::nullopt;
  const std::optional<Rational> product = rational_root(first.squared * second.squared, 2);
  if (!product) return std::nullopt;
  // Of alpha r + beta h + gamma = 0 (17.10).
  const Rational length = dot(first.axis, first.axis), shift = dot(offset, first.axis) / length;
  const Rational beta = 2 * shift * length;
  const Rational gamma =
      first.squared - second.squared - first.minor_squared + second.minor_squared - shift * shift * length;
  const int alpha_sign = sign(second.squared - first.squared);
  const Rational alpha_squared = 4 * (first.squared + second.squared - 2 * *product);
  if (alpha_sign == 0 && beta == 0) return CoaxialSection{std::nullopt, gamma == 0};
  if (beta == 0) {
    if (alpha_sign * sign(gamma) >= 0) return CoaxialSection{};
    return CoaxialSection{
        ImplicitSurface::cylinder(first.point, first.axis, Length::of_squared(gamma * gamma / alpha_squared)),
        false, alpha_sign > 0};
  }
  const bool is_reversed = alpha_sign != 0 ? alpha_sign > 0 : beta > 0;
  const Point at = first.point + (-gamma / beta) * first.axis;
  if (alpha_sign == 0) return CoaxialSection{ImplicitSurface::plane(at, first.axis), false, is_reversed};
  const Rational up = -alpha_sign * sign(beta);
  return CoaxialSection{
      ImplicitSurface::cone(at, up * first.axis, Length::of_squared(beta * beta / (alpha_squared * length))),
      false, is_reversed};
}

}  // namespace exsect
