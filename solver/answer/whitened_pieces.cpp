#include "answer/whitened_pieces.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {
namespace {

using Rows = std::array<std::array<double, 3>, 3>;

/// Added to the mean squares, relative to the greatest one.
constexpr double kLeastSquare = 0x1p-44;

/// Of the control points; none if a weight is not positive.
std::vector<std::array<double, 3>> points_of(const RationalPatch& first, const RationalPatch& second) {
  std::vector<std::array<double, 3>> points;
  for (const RationalPatch* patch : {&first, &second}) {
    for (int i = 0; i <= patch->degree_u(); ++i) {
      for (int j = 0; j <= patch->degree_v(); ++j) {
        if (!(patch->weight(i, j) > 0)) return {};
        const Point p = patch->point(i, j);
        points.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
      }
    }
  }
  return points;
}

std::array<double, 3> mean_of(const std::vector<std::array<double, 3>>& points) {
  std::array<double, 3> mean{};
  for (const auto& p : points)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += p[c] / static_cast<double>(points.size());
  return mean;
}

/// The inverse of the lower triangular matrix G with G G^T the mean square of the differences from the mean.
Rows inverse_root(const std::vector<std::array<double, 3>>& points, const std::array<double, 3>& mean) {
  Rows square{};
  for (const auto& p : points)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        square[i][j] += (p[i] - mean[i]) * (p[j] - mean[j]) / static_cast<double>(points.size());
  const double most = std::max({square[0][0], square[1][1], square[2][2]});
  Rows root{}, inverse{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = square[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= root[i][k] * root[j][k];
      root[i][j] = i == j ? std::sqrt(std::max(sum, kLeastSquare * most)) : sum / root[j][j];
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = j; i < 3; ++i) {
      double sum = i == j ? 1 : 0;
      for (std::size_t k = j; k < i; ++k) sum -= root[i][k] * inverse[k][j];
      inverse[i][j] = sum / root[i][i];
    }
  }
  return inverse;
}

}  // namespace

std::optional<Whitening> Whitening::of(const RationalPatch& first, const RationalPatch& second) {
  const auto points = points_of(first, second);
  if (points.empty()) return std::nullopt;
  const std::array<double, 3> mean = mean_of(points);
  const Rows rows = inverse_root(points, mean);
  Matrix map, inverse;
  Point origin;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(mean[i])) return std::nullopt;
    origin[i] = from_double(mean[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      if (!std::isfinite(rows[i][j]) || !(rows[i][i] > 0)) return std::nullopt;
      map[i][j] = from_double(rows[i][j]);
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      Rational sum = i == j ? 1 : 0;
      for (std::size_t k = j; k < i; ++k) sum -= map[i][k] * inverse[k][j];
      inverse[i][j] = i < j ? Rational(0) : Rational(sum / map[i][i]);
    }
  }
  return Whitening(map, inverse, origin);
}

Whitening::Whitening(const Matrix& map, const Matrix& inverse, const Point& origin)
    : map_(map), inverse_(inverse), origin_(origin) {
  double sum = 0;
  for (const auto& row : inverse_)
    for (const Rational& entry : row) sum += to_double(entry * entry);
  stretch_ = std::sqrt(sum) * kSlack + kUnderflowLoss;
}

RationalPatch Whitening::operator()(const RationalPatch& patch) const {
  std::vector<std::vector<HomogeneousPoint>> net(static_cast<std::size_t>(patch.degree_u()) + 1);
  for (int i = 0; i <= patch.degree_u(); ++i) {
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      HomogeneousPoint q = {0, 0, 0, p[3]};
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          if (map_[c][k] != 0) q[c] += map_[c][k] * (p[k] - p[3] * origin_[k]);
      net[static_cast<std::size_t>(i)].push_back(std::move(q));
    }
  }
  return RationalPatch::from_homogeneous(net);
}

double Whitening::restore(std::array<double, 3>& point) const {
  std::array<double, 3> result, error;
  for (std::size_t i = 0; i < 3; ++i) {
    DoubleBall sum = DoubleBall::enclosing(origin_[i]);
    for (std::size_t k = 0; k < 3; ++k) sum += DoubleBall::enclosing(inverse_[i][k]) * DoubleBall(point[k]);
    result[i] = sum.approximation();
    error[i] = sum.radius();
  }
  point = result;
  return length_bound(error[0], error[1], error[2]);
}

void Whitening::restore(IntersectionGraph& graph) const {
  for (Node& node : graph.nodes) restore(node.point);
  for (Arc& arc : graph.arcs) {
    double moved = 0;
    for (PolylineVertex& vertex : arc.polyline) moved = larger_bound(moved, restore(vertex.point));
    arc.error_bound = (arc.error_bound * stretch_ + moved) * kSlack + kUnderflowLoss;
  }
}

}  // namespace exsect
