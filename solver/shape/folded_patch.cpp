#include "shape/folded_patch.h"

#include <algorithm>

namespace exsect {

std::optional<FoldedPatch> folded_patch(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  std::optional<Rational> ratio;  // c1 = ratio c2
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      if (!ratio && c[2][j][k] != 0) ratio = c[1][j][k] / c[2][j][k];
  if (!ratio) return std::nullopt;
  FoldedPatch result{-*ratio / 2, {}, c[2]};
  for (std::size_t j = 0; j < 3; ++j) {
    if (!(c[1][j] == *ratio * c[2][j])) return std::nullopt;
    result.a[j] = c[0][j] - result.fold * result.fold * c[2][j];
  }
  return result;
}

BezierPatch unfolded(const FoldedPatch& patch) {
  const Rational at0 = patch.fold * patch.fold;
  const Rational at1 = (1 - patch.fold) * (1 - patch.fold);
  const Rational least = patch.fold >= 0 && patch.fold <= 1 ? Rational(0) : std::min(at0, at1);
  const Rational range = std::max(at0, at1) - least;
  ControlNet c{};
  for (std::size_t j = 0; j < 3; ++j) {
    c[0][j] = patch.a[j] + least * patch.b[j];
    c[1][j] = range * patch.b[j];
  }
  return BezierPatch::from_power_basis(c);
}

}  // namespace exsect
