#include "derivative_bounds.h"

#include <exsect/algebra/rounding_bounds.h>
#include <exsect/algebra/tensor_bernstein.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "infinite.h"

namespace exsect {
namespace {

constexpr int parts_of_weighted = 4;  // of each parameter

using Vector4 = std::array<Rational, 4>;
/// Homogeneous control points over a rectangle, rows for the first parameter.
using Net = std::vector<std::vector<Vector4>>;

/// Of the polynomials in (r,s) = (u,v), of degree m in u and n in v.
Net net_over(const std::array<BivariatePolynomial, 4>& components, int m, int n, const Rectangle& part) {
  Net net(static_cast<std::size_t>(m) + 1, std::vector<Vector4>(static_cast<std::size_t>(n) + 1));
  for (std::size_t k = 0; k < 4; ++k) {
    const auto coefficients = tensor_bernstein(components[k], m, n, part);
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j) net[i][j][k] = coefficients[i][j];
  }
  return net;
}

/// The differences of neighbouring rows, times the degree over the width: the net of the derivative.
Net differentiated(const Net& net, const Rational& width) {
  Net result(net.size() - 1, std::vector<Vector4>(net.front().size()));
  const Rational factor = Rational(net.size() - 1) / width;
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j)
      for (std::size_t k = 0; k < 4; ++k) result[i][j][k] = factor * (net[i + 1][j][k] - net[i][j][k]);
  return result;
}

Net transposed(const Net& net) {
  Net result(net.front().size(), std::vector<Vector4>(net.size()));
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j) result[j][i] = net[i][j];
  return result;
}

double length(const Vector4& p) { return length_bound(to_double(p[0]), to_double(p[1]), to_double(p[2])); }

/// Of the vectors (first three entries) and of the weights: upper bounds of their sizes in a net.
struct Sizes {
  double vector = 0;
  double weight = 0;
};
Sizes sizes(const Net& net) {
  Sizes result;
  for (const auto& row : net) {
    for (const Vector4& p : row) {
      result.vector = std::max(result.vector, length(p));
      result.weight = std::max(result.weight, std::fabs(to_double(p[3])) * kSlack);
    }
  }
  return result;
}

/// From X = x w by the product rule, x counted from the origin.
DerivativeBounds bounds_over(const Net& net, const std::array<Rational, 2>& width) {
  DerivativeBounds result;
  Rational least = net.front().front()[3];
  for (const auto& row : net)
    for (const Vector4& p : row) least = std::min(least, p[3]);
  if (!(least > 0)) return {infinite, 0, {infinite, infinite}, {infinite, infinite, infinite}};
  result.least_weight = to_double(least) / kSlack;
  for (const auto& row : net)
    for (const Vector4& p : row)
      result.reach = std::max(result.reach, length(p) / (to_double(p[3]) / kSlack));
  const double w = result.least_weight;
  const Net by_u = differentiated(net, width[0]);
  const Net by_v = differentiated(transposed(net), width[1]);
  const Sizes u = sizes(by_u);
  const Sizes v = sizes(by_v);
  result.first = {(u.vector + result.reach * u.weight) / w * kSlack,
                  (v.vector + result.reach * v.weight) / w * kSlack};
  const auto second = [&](const Sizes& both, double mixed) {
    return (both.vector + mixed + result.reach * both.weight) / w * kSlack;
  };
  if (by_u.size() > 1)
    result.second[0] = second(sizes(differentiated(by_u, width[0])), 2 * result.first[0] * u.weight);
  else
    result.second[0] = second({}, 2 * result.first[0] * u.weight);
  result.second[1] = second(sizes(differentiated(transposed(by_u), width[1])),
                            result.first[0] * v.weight + result.first[1] * u.weight);
  if (by_v.size() > 1)
    result.second[2] = second(sizes(differentiated(by_v, width[1])), 2 * result.first[1] * v.weight);
  else
    result.second[2] = second({}, 2 * result.first[1] * v.weight);
  return result;
}

void include(DerivativeBounds& all, const DerivativeBounds& part) {
  all.reach = std::max(all.reach, part.reach);
  all.least_weight = std::min(all.least_weight, part.least_weight);
  for (std::size_t k = 0; k < 2; ++k) all.first[k] = std::max(all.first[k], part.first[k]);
  for (std::size_t k = 0; k < 3; ++k) all.second[k] = std::max(all.second[k], part.second[k]);
}

}  // namespace

DerivativeBounds derivative_bounds(const RationalPatch& patch, const Rational& margin,
                                   const std::array<double, 3>& origin, const Rational& scale) {
  const auto constant = [](const Rational& c) { return BivariatePolynomial::constant(c); };
  const BivariatePolynomial weight = constant(scale) * patch.component(3);
  std::array<BivariatePolynomial, 4> components = {weight, weight, weight, weight};
  for (std::size_t k = 0; k < 3; ++k)
    components[k] =
        constant(scale) * patch.component(static_cast<int>(k)) - constant(from_double(origin[k])) * weight;
  const int parts = patch.is_polynomial() ? 1 : parts_of_weighted;
  const Rational width = (1 + 2 * margin) / parts;
  const auto part = [&](int i) { return RationalInterval{-margin + i * width, -margin + (i + 1) * width}; };
  DerivativeBounds result{0, infinite, {}, {}};
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j)
      include(result,
              bounds_over(net_over(components, patch.degree_u(), patch.degree_v(), {part(i), part(j)}),
                          {width, width}));
  return result;
}

}  // namespace exsect
