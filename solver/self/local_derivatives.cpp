#include "self/local_derivatives.h"

#include <algorithm>
#include <cmath>

#include "self/chart.h"

namespace exsect {
namespace {

using HomogeneousBall = std::array<DoubleBall, 4>;
using BallNet = std::vector<std::vector<HomogeneousBall>>;

BallNet moved_net(const RationalPatch& patch, const Point& origin) {
  BallNet net(static_cast<std::size_t>(patch.degree_u()) + 1);
  for (int i = 0; i <= patch.degree_u(); ++i) {
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      HomogeneousBall moved;
      for (std::size_t c = 0; c < 3; ++c) moved[c] = DoubleBall::enclosing(p[c] - p[3] * origin[c]);
      moved[3] = DoubleBall::enclosing(p[3]);
      net[static_cast<std::size_t>(i)].push_back(moved);
    }
  }
  return net;
}

HomogeneousBall difference(const HomogeneousBall& a, const HomogeneousBall& b, std::size_t factor) {
  HomogeneousBall p;
  for (std::size_t c = 0; c < 4; ++c) p[c] = DoubleBall(static_cast<double>(factor)) * (b[c] - a[c]);
  return p;
}

/// Control vectors of the derivative by the first parameter; none where it is zero.
BallNet by_first(const BallNet& net) {
  BallNet result;
  for (std::size_t i = 0; i + 1 < net.size(); ++i) {
    result.emplace_back();
    for (std::size_t j = 0; j < net[i].size(); ++j)
      result.back().push_back(difference(net[i][j], net[i + 1][j], net.size() - 1));
  }
  return result;
}

BallNet by_second(const BallNet& net) {
  BallNet result;
  for (const auto& row : net) {
    if (row.size() < 2) return {};
    result.emplace_back();
    for (std::size_t j = 0; j + 1 < row.size(); ++j)
      result.back().push_back(difference(row[j], row[j + 1], row.size() - 1));
  }
  return result;
}

DoubleBall blend(const DoubleBall& a, const DoubleBall& b, const DoubleBall& t) { return a + t * (b - a); }

/// De Casteljau's algorithm for vectors `step` apart, in place.
HomogeneousBall value_of(std::vector<HomogeneousBall> row, const DoubleBall& t) {
  for (std::size_t n = row.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t c = 0; c < 4; ++c) row[i][c] = blend(row[i][c], row[i + 1][c], t);
  return row[0];
}

constexpr ByOrder<double> kBinomial = {
    {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}}};

/// From X = x w by the rule of Leibniz: w x_ij = X_ij - sum of binomials times x_kl w_(i-k)(j-l) over the
/// lower ones.
AffineDerivatives affine_derivatives(const ByOrder<std::array<DoubleBall, 4>>& full, std::size_t orders) {
  AffineDerivatives x;
  const DoubleBall inverse =
      full[0][0][3].is_positive() ? reciprocal(full[0][0][3]) : DoubleBall(0, HUGE_VAL);
  for (std::size_t order = 0; order < orders; ++order) {
    for (std::size_t i = 0; i <= order; ++i) {
      const std::size_t j = order - i;
      for (std::size_t c = 0; c < 3; ++c) {
        DoubleBall sum = full[i][j][c];
        for (std::size_t k = 0; k <= i; ++k)
          for (std::size_t l = 0; l <= j; ++l)
            if (k + l < order)
              sum -= DoubleBall(kBinomial[i][k] * kBinomial[j][l]) * full[i - k][j - l][3] * x[k][l][c];
        x[i][j][c] = sum * inverse;
      }
    }
  }
  return x;
}

}  // namespace

DoubleBall hull_of(const std::vector<DoubleBall>& balls) {
  if (balls.empty()) return DoubleBall(0);
  double least = HUGE_VAL, most = -HUGE_VAL, radius = 0;
  for (const DoubleBall& ball : balls) {
    least = std::min(least, ball.approximation());
    most = std::max(most, ball.approximation());
    radius = larger_bound(radius, ball.radius());
  }
  // Halves are exact, or lose what `widened` adds.
  const DoubleBall middle = DoubleBall(0.5) * (DoubleBall(least) + DoubleBall(most));
  return middle.widened((DoubleBall(most) - DoubleBall(least)).upper_magnitude() * 0.5 + radius);
}

LocalDerivatives::LocalDerivatives(const RationalPatch& patch, const Point& origin, std::size_t orders)
    : orders_(orders) {
  BallNet rows = moved_net(patch, origin);
  for (std::size_t i = 0; i < orders_; ++i) {
    BallNet net = rows;
    for (std::size_t j = 0; i + j < orders_; ++j) {
      for (const auto& row : net) {
        nets_[i][j].columns = row.size();
        nets_[i][j].vectors.insert(nets_[i][j].vectors.end(), row.begin(), row.end());
      }
      net = by_second(net);
    }
    rows = by_first(rows);
  }
}

AffineDerivatives LocalDerivatives::everywhere() const {
  ByOrder<HomogeneousBall> full{};
  for (std::size_t i = 0; i < orders_; ++i) {
    for (std::size_t j = 0; i + j < orders_; ++j) {
      for (std::size_t c = 0; c < 4; ++c) {
        std::vector<DoubleBall> values;
        for (const HomogeneousBall& p : nets_[i][j].vectors) values.push_back(p[c]);
        full[i][j][c] = hull_of(values);
      }
    }
  }
  return affine_derivatives(full, orders_);
}

AffineDerivatives LocalDerivatives::at(const DoubleBall& u, const DoubleBall& v) const {
  ByOrder<HomogeneousBall> full{};
  for (std::size_t i = 0; i < orders_; ++i) {
    for (std::size_t j = 0; i + j < orders_; ++j) {
      const Net& net = nets_[i][j];
      std::vector<HomogeneousBall> column;
      for (std::size_t k = 0; k < net.vectors.size(); k += net.columns) {
        const auto from = net.vectors.begin() + static_cast<std::ptrdiff_t>(k);
        column.push_back(
            value_of(std::vector<HomogeneousBall>(from, from + static_cast<std::ptrdiff_t>(net.columns)), v));
      }
      if (!column.empty()) full[i][j] = value_of(std::move(column), u);
    }
  }
  return affine_derivatives(full, orders_);
}

}  // namespace exsect
