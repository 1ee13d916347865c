#include "overlap/two_pieces.h"

#include <algorithm>

namespace exsect {

BezierPatch TwoPieces::hull() const {
  const auto& [u, v] = around;
  return x.restricted_to(u(0), u(1), v(0), v(1));
}

std::optional<TwoPieces> two_pieces(const BezierPatch& x, const BezierPatch& y) {
  const auto copy = shifted_copy(x, y);
  if (!copy) return std::nullopt;
  TwoPieces result{x, y, *copy, {}};
  for (std::size_t j = 0; j < 2; ++j) {
    const auto [lower, upper] = std::minmax({Rational(0), Rational(1), copy->maps[j](0), copy->maps[j](1)});
    result.around[j] = {lower, upper - lower};
  }
  return result;
}

}  // namespace exsect
