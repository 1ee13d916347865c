#include "trace/tube_line_bounds.h"

#include <exsect/algebra/rounding_bounds.h>

namespace exsect {

namespace {

/// C times derivatives of order two and more.
template <class Ball, class Powers>
void bound_higher(AlongLine& bounds, const LineRemainder<Ball>& left, const Powers& powers) {
  constexpr std::size_t degree = kLineDegree<Ball>;
  std::array<std::array<SeriesBound, 3>, 3> c;
  for (std::size_t k = 0; k <= degree; ++k) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t m = 0; m < 3; ++m) {
        c[row][m].add_multiple(left.preconditioner[k][row][m], powers[k]);
      }
    }
  }
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t m = 0; m < 3; ++m) {
      std::array<SeriesBound, 9> g;
      for (std::size_t k = 0; k <= 2 * degree; ++k) {
        for (const std::size_t i : {2, 4, 5, 6, 7, 8}) {
          g[i].add_multiple(kSlack * left.higher[k][p][m][i], powers[k]);
        }
      }
      for (std::size_t row = 0; row < 3; ++row) {
        for (const std::size_t i : {2, 4, 5, 6, 7, 8}) {
          bounds.derivative[p][row][i].add_product(c[row][m], g[i]);
        }
      }
    }
  }
}

}  // namespace

SeriesBound SeriesBound::of_power(std::size_t k, double ratio, double scale) {
  const double degree = static_cast<double>(k);
  double power = kSlack;
  for (std::size_t i = 2; i < k; ++i) {
    power *= ratio;
  }
  return {power * (k < 1   ? 1
                   : k < 2 ? ratio
                           : ratio * ratio),
          k < 1 ? 0 : degree * power * (k < 2 ? 1 : ratio) / scale,
          k < 2 ? 0 : degree * (degree - 1) * power / (scale * scale)};
}

void SeriesBound::add_product(const SeriesBound& f, const SeriesBound& g) {
  value += f.value * g.value;
  first += f.first * g.value + f.value * g.first;
  second += f.second * g.value + 2 * f.first * g.first + f.value * g.second;
}

template <class Ball>
AlongLine along_line(const Tube<Ball>& tube, const LineRemainder<Ball>& left) {
  constexpr std::size_t degree = kLineDegree<Ball>;
  const auto others = other_axes(tube.axis);
  std::array<SeriesBound, 5 * degree + 1> powers;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    powers[k] = SeriesBound::of_power(k, tube.reach / tube.scale, tube.scale);
  }
  const SeriesBound lost = {left.underflow, left.underflow / tube.scale,
                            left.underflow / tube.scale / tube.scale};
  AlongLine bounds;
  for (auto& bound : bounds.residual) bound = lost;
  for (auto& patch : bounds.derivative)
    for (auto& row : patch) row.fill(lost);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k <= 5 * degree; ++k) {
      bounds.residual[row].add_multiple(left.residual[k][row], powers[k]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      SeriesBound& column = bounds.derivative[others[i] / 2][row][column_index(others[i])];
      for (std::size_t k = 0; k <= 4 * degree; ++k) {
        column.add_multiple(left.columns[k][row][i], powers[k]);
      }
    }
  }
  bound_higher(bounds, left, powers);
  for (const std::size_t j : others) {
    bounds.bend[j] = bounds.higher_bend[j] = lost;
  }
  for (std::size_t k = 2; k <= degree; ++k) {
    for (const std::size_t j : others) {
      const double magnitude = tube.line[k - 1][j].upper_magnitude();
      bounds.bend[j].add_multiple(magnitude, powers[k]);
      if (k > 2) {
        bounds.higher_bend[j].add_multiple(magnitude, powers[k]);
      }
    }
  }
  return bounds;
}

template AlongLine along_line(const Tube<DoubleBall>&, const LineRemainder<DoubleBall>&);
template AlongLine along_line(const Tube<DoubleDoubleBall>&, const LineRemainder<DoubleDoubleBall>&);
template AlongLine along_line(const Tube<ArbBall<256>>&, const LineRemainder<ArbBall<256>>&);
template AlongLine along_line(const Tube<ArbBall<1024>>&, const LineRemainder<ArbBall<1024>>&);

}  // namespace exsect
