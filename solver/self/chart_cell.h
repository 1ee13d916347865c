// Boxes of a chart with the Bernstein coefficients of H on them. Internal to solver/.
#pragma once

#include <array>
#include <optional>

#include "self/chart.h"
#include "self/known_places.h"

namespace exsect {

template <class Ball>
struct ChartCell {
  ChartBox box;
  ChartNet<Ball, 2> net;
  int depth = 0;  // halvings
};

/// The box as the root of a subdivision.
template <class Ball>
ChartCell<Ball> chart_cell(const ChartSystem<Ball>& system, const ChartBox& box);

/// True only if H does not vanish on the box: all coefficients lie on one side of a plane through 0.
template <class Ball>
bool cannot_vanish(const ChartNet<Ball, 2>& net);

/// The derivative of H with respect to U, V or m (j: 0, 1, 2), enclosed over the box.
template <class Ball>
BallVector<Ball> derivative_over(const ChartCell<Ball>& cell, std::size_t j);

/// Halves w where one half is outside, else the variable in which H varies most, or one in which the box is
/// far longer; false if its midpoint is no double.
template <class Ball>
bool split(const ChartCell<Ball>& cell, std::array<ChartCell<Ball>, 2>& halves);

}  // namespace exsect
