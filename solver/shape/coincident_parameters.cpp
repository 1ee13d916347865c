#include "shape/coincident_parameters.h"

#include <vector>

#include "shape/planar_patch.h"

namespace exsect {

namespace {

/// The vectors that a linear form must annihilate to depend on one parameter alone: all coefficients of the
/// power basis but those of its powers.
void append_constraints(std::vector<Point>& constraints, const ControlNet& c, std::size_t parameter) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if ((parameter == 0 ? j : i) > 0 && !is_zero(c[i][j])) {
        constraints.push_back(c[i][j]);
      }
    }
  }
}

/// The form, a quadratic polynomial of the parameter alone, has a derivative without zero on [0,1].
bool is_strictly_monotone(const Point& form, const ControlNet& c, std::size_t parameter) {
  const Rational at_0 = dot(form, parameter == 0 ? c[1][0] : c[0][1]);
  const Rational at_1 = at_0 + 2 * dot(form, parameter == 0 ? c[2][0] : c[0][2]);
  return sign(at_0) * sign(at_1) > 0;
}

}  // namespace

std::array<std::size_t, 4> coincident_parameters(const BezierPatch& x, const BezierPatch& y) {
  std::array<std::size_t, 4> partner = {0, 1, 2, 3};
  const ControlNet of_x = x.power_basis();
  const ControlNet of_y = y.power_basis();
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      std::vector<Point> constraints;
      append_constraints(constraints, of_x, a);
      append_constraints(constraints, of_y, b);
      for (const Point& form : orthogonal_complement(constraints)) {
        if (is_strictly_monotone(form, of_x, a) && is_strictly_monotone(form, of_y, b)) {
          partner[a] = 2 + b;
          partner[2 + b] = a;
        }
      }
    }
  }
  return partner;
}

std::array<std::optional<std::size_t>, 2> plane_coordinates(const BezierPatch& x, const BezierPatch& y) {
  std::array<std::optional<std::size_t>, 2> result;
  for (std::size_t p = 0; p < 2; ++p) {
    const auto plane = plane_of(p == 0 ? x : y);
    for (std::size_t k = 0; plane && k < 3 && !result[p]; ++k) {
      result[p] = plane->normal[k] != 0 ? std::optional(k) : std::nullopt;
    }
  }
  return result;
}

}  // namespace exsect
