// Seeded biquadratic patches with weights for the tests of their eliminant.
#pragma once

#include <exsect/geometry/rational_patch.h>

#include "eliminant_pairs.h"

namespace exsect::weighted_pairs {

using eliminant_pairs::Random;
using eliminant_pairs::small_rational;

inline RationalPatch weighted_patch(Random& random) {
  std::vector<std::vector<Point>> points(3);
  std::vector<std::vector<Rational>> weights(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      points[i].push_back({small_rational(random), small_rational(random), small_rational(random)});
      weights[i].push_back(Rational(std::uniform_int_distribution<int>(8, 32)(random), 16));
    }
  return RationalPatch(points, weights);
}

/// Points of 53 bits, weights k/16.
inline RationalPatch weighted_doubles(Random& random) {
  std::vector<std::vector<Point>> points(3);
  std::vector<std::vector<Rational>> weights(3);
  const auto coordinate = [&] { return from_double(std::uniform_real_distribution<double>(-1, 1)(random)); };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      points[i].push_back({coordinate(), coordinate(), coordinate()});
      weights[i].push_back(Rational(std::uniform_int_distribution<int>(8, 32)(random), 16));
    }
  return RationalPatch(points, weights);
}

/// The coefficients of u^i v^j of X.
using PowerBasis = std::vector<std::vector<HomogeneousPoint>>;
inline PowerBasis power_basis(const RationalPatch& patch) {
  PowerBasis c(static_cast<std::size_t>(patch.degree_u() + 1),
               std::vector<HomogeneousPoint>(static_cast<std::size_t>(patch.degree_v() + 1)));
  for (std::size_t k = 0; k < 4; ++k) {
    const BivariatePolynomial component = patch.component(static_cast<int>(k));
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t j = 0; j < c[i].size(); ++j)
        c[i][j][k] = component.coefficient(static_cast<int>(i), static_cast<int>(j));
  }
  return c;
}

/// Bernstein coefficients b_k = sum_(i <= k) binom(k,i)/binom(n,i) c_i from those c_0, ..., c_n of powers.
inline void to_bernstein(std::vector<HomogeneousPoint>& c) {
  const long n = static_cast<long>(c.size()) - 1;
  Rational binomial = 1;
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (Rational& coordinate : c[i]) coordinate /= binomial;
    binomial = binomial * (n - static_cast<long>(i)) / (static_cast<long>(i) + 1);
  }
  for (std::size_t step = 1; step < c.size(); ++step)
    for (std::size_t i = c.size() - 1; i >= step; --i)
      for (std::size_t k = 0; k < 4; ++k) c[i][k] += c[i - 1][k];
}

inline RationalPatch from_power_basis(PowerBasis c) {
  for (auto& row : c) to_bernstein(row);
  for (std::size_t j = 0; j < c[0].size(); ++j) {
    std::vector<HomogeneousPoint> column;
    for (const auto& row : c) column.push_back(row[j]);
    to_bernstein(column);
    for (std::size_t i = 0; i < c.size(); ++i) c[i][j] = column[i];
  }
  return RationalPatch::from_homogeneous(c);
}

template <class Map>
RationalPatch mapped(const RationalPatch& patch, const Map& map) {
  std::vector<std::vector<HomogeneousPoint>> net(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) net[static_cast<std::size_t>(i)].push_back(map(patch.homogeneous(i, j)));
  return RationalPatch::from_homogeneous(net);
}

inline HomogeneousPoint projective(const HomogeneousPoint& p) {
  return {p[0] + p[1] / 3, p[1] - p[2] / 5, p[2] + p[3], p[3] + (p[0] + p[1] - p[2]) / 16};
}

}  // namespace exsect::weighted_pairs
