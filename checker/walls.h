// Factors whose curve lies on a side of both parameter squares, as on the common side of neighbours. Internal
// to checker/.
#pragma once

#include <cmath>

#include "factors.h"

namespace exsect::checker {

/// Two components of a map that are each a multiple of w_i - 0 or w_i - 1, of one sign in [0,1]^4.
struct Walls {
  std::array<std::size_t, 2> components;
  std::array<int, 2> signs;
  std::vector<Side> sides;

  std::size_t other() const { return 3 - components[0] - components[1]; }
};

/// The side on which component d vanishes, and its sign in [0,1]^4 elsewhere; nothing if it is none.
inline std::optional<std::pair<Side, int>> wall(const Map<Rational>& map, std::size_t d) {
  const Polynomial g = component(map, d);
  if (degree(g) != 1 || g.rbegin()->first == Power{}) return std::nullopt;
  const Power& power = g.rbegin()->first;
  const Rational slope = g.rbegin()->second;
  const auto i = static_cast<std::size_t>(std::find(power.begin(), power.end(), 1) - power.begin());
  const Rational rest = g.size() == 1 ? Rational(0) : g.begin()->second;
  if (g.size() > 2 || (g.size() == 2 && g.begin()->first != Power{})) return std::nullopt;
  if (rest == 0) return std::pair(Side{{i}, 0}, sign(slope));
  if (rest == -slope) return std::pair(Side{{i}, 1}, -sign(slope));
  return std::nullopt;
}

/// Those of a factor whose other component is on them c w_k + h, c a number and h without w_k: a graph, of
/// which the polynomials that vanish there are the multiples. Nothing if it has none.
inline std::optional<Walls> walls_of(const Factor& factor) {
  if (factor.is_surface()) return std::nullopt;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto a = wall(factor.map, (c + 1) % 3);
    const auto b = wall(factor.map, (c + 2) % 3);
    if (!a || !b || a->first.parameter == b->first.parameter) continue;
    const Walls walls = {{(c + 1) % 3, (c + 2) % 3}, {a->second, b->second}, {a->first, b->first}};
    const Polynomial g = on_sides(component(factor.map, c), walls.sides);
    for (std::size_t k = 0; k < 4; ++k) {
      const Polynomial slope = derivative(g, k);
      if (!is_zero(slope) && degree(slope) == 0) return walls;
    }
  }
  return std::nullopt;
}

/// The determinant of the columns vanishes all along the curve of a factor with walls: the patches touch.
inline bool is_singular_along(const Factor& factor, const Walls& walls) {
  std::array<Vector3<Polynomial>, 3> m;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t d = 0; d < 3; ++d) m[j][d] = on_sides(component(factor.columns[j], d), walls.sides);
  return is_multiple(determinant(m), on_sides(component(factor.map, walls.other()), walls.sides));
}

/// Where the factor's map vanishes, the patches touch.
inline bool touches(const Factor& factor) {
  const auto walls = walls_of(factor);
  return factor.is_surface() || *std::max_element(factor.powers.begin(), factor.powers.end()) > 1 ||
         (walls && is_singular_along(factor, *walls));
}

/// The curve lies on both walls, with all of F on one side of it: there is an n such that n . (M_a x M_c) and
/// n . (M_b x M_c), with the signs of the walls' powers in [0,1]^4, are positive in the box, c the component
/// that is no wall. So F vanishes in the box and in [0,1]^4 with the factor's map alone.
template <class N>
bool on_one_side(const Factor& factor, const Walls& walls, const std::array<Map<N>, 3>& columns,
                 const Box<N>& box) {
  std::array<Balls<N>, 3> m;
  for (std::size_t j = 0; j < 3; ++j) m[j] = Ranges(columns[j].at(middles(box)), radii(box)).value();
  std::array<Balls<N>, 2> across;
  Balls<N> n = {};
  for (std::size_t w = 0; w < 2; ++w) {
    const std::size_t j = walls.components[w];
    across[w] = cross(m[j], m[walls.other()]);
    if (factor.powers[j] % 2 == 1 && walls.signs[w] < 0)
      for (Ball<N>& b : across[w]) b.middle = -b.middle;
    double most = 0;
    for (const Ball<N>& b : across[w]) most = std::max(most, std::abs(approximate(b.middle)));
    if (!(most > 0 && std::isfinite(most))) return false;
    for (std::size_t d = 0; d < 3; ++d) n[d].middle += N(approximate(across[w][d].middle) / most);
  }
  return dot(n, across[0]).sign() > 0 && dot(n, across[1]).sign() > 0;
}

}  // namespace exsect::checker
