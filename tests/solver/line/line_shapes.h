// Patches for the tests of the solver.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/geometry/patch_file.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace exsect {

struct PatchPair {
  BezierPatch x;
  BezierPatch y;
};

inline PatchPair example(const std::string& file) {
  const PatchFile content = read_patches(std::string(EXSECT_EXAMPLES) + "/" + file);
  return {content.patches.at(0).patch, content.patches.at(1).patch};
}

/// Control points on a grid over the unit square, moved by multiples of 1/denominator up to 1/2 in each
/// coordinate; the third coordinate is free in [-1/2,1/2].
inline BezierPatch random_patch(std::mt19937& random, int denominator) {
  std::uniform_int_distribution<int> shift(-denominator, denominator);
  ControlNet net;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto move = [&] { return Rational(shift(random), 2 * denominator); };
      net[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {Rational(i, 2) + move() / 2,
                                                                       Rational(j, 2) + move() / 2, move()};
    }
  return BezierPatch(net);
}

inline PatchPair random_pair(std::mt19937& random, int denominator) {
  BezierPatch x = random_patch(random, denominator);
  return {std::move(x), random_patch(random, denominator)};
}

/// A patch from the coefficients c[i][j] of u^i v^j.
inline BezierPatch power_patch(const std::vector<std::vector<Point>>& rows) {
  ControlNet c;
  for (auto& row : c) row.fill(Point{0, 0, 0});
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) c[i][j] = rows[i][j];
  return BezierPatch::from_power_basis(c);
}

/// The height field (u, v, sum h[i][j] u^i v^j).
inline BezierPatch height_field(const std::vector<std::vector<Rational>>& h) {
  ControlNet c;
  for (auto& row : c) row.fill(Point{0, 0, 0});
  for (std::size_t i = 0; i < h.size(); ++i)
    for (std::size_t j = 0; j < h[i].size(); ++j) c[i][j][2] = h[i][j];
  c[1][0][0] = 1;
  c[0][1][1] = 1;
  return BezierPatch::from_power_basis(c);
}

/// Control points with coordinates 0, ..., range, the third 0, ..., height. By chance with a shared edge, a
/// line u = 0 that is straight, folded or a point, a patch that is degenerate at its side.
inline PatchPair grid_pair(std::mt19937& random, int range, int height) {
  const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n + 1)); };
  const auto net = [&] {
    ControlNet n;
    for (auto& row : n)
      for (Point& p : row) p = {up_to(range), up_to(range), up_to(height)};
    return n;
  };
  ControlNet x = net();
  ControlNet y = net();
  if (up_to(3) == 0) y[0] = x[0];
  if (up_to(3) == 0) x[1] = x[0];
  if (up_to(4) == 0)
    for (auto& row : y) row[1] = row[0];
  if (up_to(1) == 0) x[0][1] = x[0][0] + Rational(up_to(8) - 2, 4) * (x[0][2] - x[0][0]);
  if (up_to(6) == 0) x[0][2] = x[0][0];
  if (up_to(8) == 0) x[0][1] = x[0][0];
  return {BezierPatch(x), BezierPatch(y)};
}

}  // namespace exsect
