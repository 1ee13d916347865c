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
using PowerBasis = std::array<std::array<HomogeneousPoint, 3>, 3>;
inline PowerBasis power_basis(const RationalPatch& patch) {
  PowerBasis c;
  for (std::size_t k = 0; k < 4; ++k) {
    const BivariatePolynomial component = patch.component(static_cast<int>(k));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        c[i][j][k] = component.coefficient(static_cast<int>(i), static_cast<int>(j));
  }
  return c;
}

inline RationalPatch from_power_basis(PowerBasis c) {
  const auto to_bernstein = [](HomogeneousPoint& b0, HomogeneousPoint& b1, HomogeneousPoint& b2) {
    for (std::size_t k = 0; k < 4; ++k) {
      b2[k] += b0[k] + b1[k];
      b1[k] = b0[k] + b1[k] / 2;
    }
  };
  for (auto& row : c) to_bernstein(row[0], row[1], row[2]);
  for (std::size_t j = 0; j < 3; ++j) to_bernstein(c[0][j], c[1][j], c[2][j]);
  std::vector<std::vector<HomogeneousPoint>> net;
  for (const auto& row : c) net.emplace_back(row.begin(), row.end());
  return RationalPatch::from_homogeneous(net);
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
