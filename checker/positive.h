// Denominators: polynomials that are positive on the unit square, by subdivision.
#pragma once

#include "net.h"
#include "require.h"

namespace exsect::checker {

/// Cells of the subdivision at most.
inline constexpr std::size_t max_denominator_cells = 4096;

/// Fails unless the polynomial of these Bernstein coefficients is proved to be positive on [0,1]^2: the
/// square is halved in the first parameter, its halves in the second one, and so on in turn, until all
/// coefficients over a cell are positive. At a corner the coefficient is the value.
inline void require_positive(const Grid<Rational, 1>& weights) {
  struct Part {
    Grid<Rational, 1> weights;
    std::size_t parameter;
  };
  std::vector<Part> waiting = {{weights, 0}};
  for (std::size_t cells = 0; !waiting.empty(); ++cells) {
    require(cells < max_denominator_cells, "its denominator may be 0 in the square");
    Part part = std::move(waiting.back());
    waiting.pop_back();
    bool positive = true;
    part.weights.each(
        [&](std::size_t i, std::size_t j) { positive = positive && part.weights[i][j][0] > 0; });
    if (positive) continue;
    const std::size_t m = part.weights.degree(0);
    const std::size_t n = part.weights.degree(1);
    for (const std::size_t i : {std::size_t{0}, m})
      for (const std::size_t j : {std::size_t{0}, n})
        require(part.weights[i][j][0] > 0, "its denominator is not positive in the square");
    const std::size_t next = 1 - part.parameter;
    waiting.push_back({part.weights.split(part.parameter), next});
    waiting.push_back({part.weights, next});
  }
}

}  // namespace exsect::checker
