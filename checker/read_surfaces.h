// Patches and equations in the text of a certificate.
#pragma once

#include "read_values.h"

namespace exsect::checker {

/// m+1 rows of n+1 entries, m and n in {1,2,3}.
template <std::size_t dimension>
void read(Reader& in, Grid<Rational, dimension>& grid) {
  constexpr const char* shape = "must be 2 to 4 rows of 2 to 4 entries, all of one length";
  Grid<Rational, dimension> entries(3, 3);
  std::size_t columns = 0;
  const std::size_t rows = in.list([&](std::size_t i) {
    require(i < 4, shape);
    const std::size_t size = in.list([&](std::size_t j) {
      require(j < 4, shape);
      if constexpr (dimension == 1)
        read(in, entries[i][j][0]);
      else
        read(in, entries[i][j]);
    });
    require(size >= 2 && (i == 0 || size == columns), shape);
    columns = size;
  });
  require(rows >= 2, shape);
  grid = Grid<Rational, dimension>(rows - 1, columns - 1);
  grid.each([&](std::size_t i, std::size_t j) { grid[i][j] = entries[i][j]; });
}

/// Of the shape of the points, which become multiples of them.
inline void read_weights(Reader& in, WeightedNet<Rational>& net) {
  Grid<Rational, 1> weights;
  read(in, weights);
  for (const std::size_t p : {std::size_t{0}, std::size_t{1}})
    require(weights.degree(p) == net.points.degree(p), "must be of the shape of the points");
  net.weights = weights;
  weights.each([&](std::size_t i, std::size_t j) {
    for (Rational& c : net.points[i][j]) c *= weights[i][j][0];
  });
}

/// A coefficient followed by n exponents, their sum at most `most`.
template <std::size_t n>
std::pair<std::array<int, n>, Rational> read_term(Reader& in, int most) {
  constexpr const char* form = "must be a coefficient and an exponent for each variable";
  std::pair<std::array<int, n>, Rational> result;
  auto& [power, c] = result;
  int degree = 0;
  const std::size_t size = in.list([&](std::size_t i) {
    require(i <= n, form);
    if (i == 0) return read(in, c);
    read(in, power[i - 1]);
    require(power[i - 1] <= most, "an exponent that is too large");
    degree += power[i - 1];
    require(degree <= most, "exponents with a sum that is too large");
  });
  require(size == n + 1, form);
  return result;
}
inline void read_equation(Reader& in, std::optional<SurfaceEquation>& equation) {
  equation.emplace();
  in.list([&](std::size_t) {
    const auto [power, c] = read_term<3>(in, max_equation_degree);
    (*equation)[power] += c;
  });
}

}  // namespace exsect::checker
