#include "tube_line.h"

#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

/// Taylor index of the first derivative that column j of the Jacobian is made of.
constexpr std::size_t column_index(std::size_t j) { return j % 2 == 0 ? 3 : 1; }

template <class Ball>
NetRow<Ball> row_of(const TaylorNet<Ball>& net, std::size_t row) {
  NetRow<Ball> result;
  for (std::size_t i = 0; i < 9; ++i) {
    result[i] = net[i][row];
  }
  return result;
}

template <class Ball>
NetRow<double> magnitudes(const NetRow<Ball>& row) {
  NetRow<double> result;
  for (std::size_t i = 0; i < 9; ++i) {
    result[i] = row[i].upper_magnitude();
  }
  return result;
}

template <class Ball, std::size_t degree>
Monomials<double, degree> magnitudes(const Monomials<Ball, degree>& m) {
  Monomials<double, degree> result;
  for (std::size_t k = 1; k <= 4 * degree; ++k) {
    result.a[k] = m.a[k].upper_magnitude();
    result.b[k] = m.b[k].upper_magnitude();
    result.aa[k] = m.aa[k].upper_magnitude();
    result.ab[k] = m.ab[k].upper_magnitude();
    result.bb[k] = m.bb[k].upper_magnitude();
    result.aab[k] = m.aab[k].upper_magnitude();
    result.abb[k] = m.abb[k].upper_magnitude();
    result.aabb[k] = m.aabb[k].upper_magnitude();
  }
  return result;
}

template <class Ball>
Matrix3 magnitudes(const BallMatrix<Ball>& m) {
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i][j] = m[i][j].upper_magnitude();
    }
  }
  return result;
}

template <class Ball>
BallMatrix<Ball> product(const BallMatrix<Ball>& a, const BallMatrix<Ball>& b) {
  BallMatrix<Ball> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
  }
  return c;
}

/// One fit: the line and the preconditioner order by order, then bounds.
template <class Ball>
class LineFit {
 public:
  static constexpr std::size_t kDegree = kLineDegree<Ball>;
  /// Up to this order coefficients are balls; above, what is small by cancellation is the square of that.
  static constexpr std::size_t kExact = 2 * kDegree + 1;

  explicit LineFit(Tube<Ball>& tube) : tube_(tube), others_(other_axes(tube.axis)) {
    for (std::size_t k = 0; k < powers_.size(); ++k) {
      powers_[k] = SeriesBound::of_power(k, tube.reach / tube.scale, tube.scale);
    }
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t row = 0; row < 3; ++row) {
        rows_[p][row] = row_of(tube.nets[p], row);
        row_bounds_[p][row] = magnitudes(rows_[p][row]);
      }
    }
  }

  bool run(AlongLine& bounds) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < 3; ++i) {
        columns_[0][row][i] = rows_[others_[i] / 2][row][column_index(others_[i])];
      }
    }
    const BallMatrix<Ball>& d = columns_[0];
    const auto inverse = approximate_inverse<Ball>({BallVector<Ball>{d[0][0], d[1][0], d[2][0]},
                                                    BallVector<Ball>{d[0][1], d[1][1], d[2][1]},
                                                    BallVector<Ball>{d[0][2], d[1][2], d[2][2]}});
    if (!inverse) {
      return false;
    }
    tube_.preconditioner[0] = *inverse;
    fit_line();
    fit_preconditioner();
    extend_bounds();
    bound_residual(bounds);
    bound_columns(bounds);
    bound_higher(bounds);
    for (std::size_t k = 2; k <= kDegree; ++k) {
      for (const std::size_t j : others_) {
        const double magnitude = tube_.line[k - 1][j].upper_magnitude();
        bounds.bend[j].add_multiple(magnitude, powers_[k]);
        if (k > 2) {
          bounds.higher_bend[j].add_multiple(magnitude, powers_[k]);
        }
      }
    }
    return true;
  }

 private:
  void store(std::size_t k, std::size_t j, const Ball& value) {
    tube_.line[k - 1][j] = value;
    (j % 2 == 0 ? monomials_[j / 2].a : monomials_[j / 2].b)[k] = value;
  }

  BallVector<Ball> value_of_order(std::size_t k) const {
    BallVector<Ball> sum;
    for (std::size_t row = 0; row < 3; ++row) {
      sum[row] = value_coefficient(rows_[0][row], monomials_[0], k) +
                 value_coefficient(rows_[1][row], monomials_[1], k);
    }
    return sum;
  }

  /// F(p + l) at order k depends on the coefficient of sigma^k of l through D(p) alone.
  void fit_line() {
    store(1, tube_.axis, Ball(tube_.scale));
    for (std::size_t k = 1; k <= kDegree; ++k) {
      monomials_[0].extend(k);
      monomials_[1].extend(k);
      const BallVector<Ball> rest = preconditioned(tube_.preconditioner[0], value_of_order(k));
      for (std::size_t row = 0; row < 3; ++row) {
        store(k, others_[row], -rest[row].midpoint());
      }
    }
    tube_.slope = {};
    tube_.slope[tube_.axis] = 1;
    for (const std::size_t j : others_) {
      tube_.slope[j] = tube_.line[0][j].approximation() / tube_.scale;
    }
  }

  /// Order by order C D = 1 along the line, D the columns other than the axis.
  void fit_preconditioner() {
    for (std::size_t k = 1; k <= kDegree; ++k) {
      columns_[k] = columns_of_order(rows_, monomials_, k);
      const BallMatrix<Ball> next = product(product_of_order(k, k), tube_.preconditioner[0]);
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
          tube_.preconditioner[k][row][i] = -next[row][i].midpoint();
        }
      }
    }
  }

  /// D along the line, order k > 0, or bounds of its entries.
  template <class Coefficient>
  std::array<std::array<Coefficient, 3>, 3> columns_of_order(
      const std::array<std::array<NetRow<Coefficient>, 3>, 2>& rows,
      const std::array<Monomials<Coefficient, kDegree>, 2>& monomials, std::size_t k) const {
    std::array<std::array<Coefficient, 3>, 3> result;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = others_[i];
        result[row][i] = gradient_coefficients(rows[j / 2][row], monomials[j / 2], k)[j % 2];
      }
    }
    return result;
  }

  /// Of C D, order k, the terms of C of order below `end`.
  BallMatrix<Ball> product_of_order(std::size_t k, std::size_t end) const {
    BallMatrix<Ball> sum;
    for (std::size_t i = 0; i < end; ++i) {
      const BallMatrix<Ball> term = product(tube_.preconditioner[i], columns_[k - i]);
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t j = 0; j < 3; ++j) {
          sum[row][j] += term[row][j];
        }
      }
    }
    return sum;
  }

  /// The coefficients above kExact, by magnitudes.
  void extend_bounds() {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t k = kDegree + 1; k <= kExact; ++k) {
        monomials_[p].extend(k);
      }
      monomial_bounds_[p] = magnitudes(monomials_[p]);
      for (std::size_t k = kExact + 1; k <= 4 * kDegree; ++k) {
        monomial_bounds_[p].extend(k);
      }
    }
    for (std::size_t k = 0; k <= kDegree; ++k) {
      preconditioner_bounds_[k] = magnitudes(tube_.preconditioner[k]);
    }
  }

  /// C F along the line, of degree 5 times that of the line.
  void bound_residual(AlongLine& bounds) {
    std::array<BallVector<Ball>, kExact + 1> value;
    for (std::size_t row = 0; row < 3; ++row) {
      value[0][row] = rows_[0][row][0] + rows_[1][row][0];
    }
    for (std::size_t k = 1; k <= kExact; ++k) {
      value[k] = value_of_order(k);
    }
    for (std::size_t k = 0; k <= kExact; ++k) {
      BallVector<Ball> sum;
      for (std::size_t i = 0; i <= std::min(k, kDegree); ++i) {
        const BallVector<Ball> term = preconditioned(tube_.preconditioner[i], value[k - i]);
        for (std::size_t row = 0; row < 3; ++row) {
          sum[row] += term[row];
        }
      }
      for (std::size_t row = 0; row < 3; ++row) {
        bounds.residual[row].add_multiple(sum[row].upper_magnitude(), powers_[k]);
      }
    }
    std::array<Row3, 4 * kDegree + 1> magnitude{};
    for (std::size_t k = 0; k <= 4 * kDegree; ++k) {
      for (std::size_t row = 0; row < 3; ++row) {
        magnitude[k][row] = k <= kExact ? value[k][row].upper_magnitude()
                                        : value_coefficient(row_bounds_[0][row], monomial_bounds_[0], k) +
                                              value_coefficient(row_bounds_[1][row], monomial_bounds_[1], k);
      }
    }
    for (std::size_t k = kExact + 1; k <= 5 * kDegree; ++k) {
      for (std::size_t row = 0; row < 3; ++row) {
        double sum = 0;
        for (std::size_t i = k > 4 * kDegree ? k - 4 * kDegree : 0; i <= kDegree; ++i) {
          for (std::size_t m = 0; m < 3; ++m) {
            sum += preconditioner_bounds_[i][row][m] * magnitude[k - i][m];
          }
        }
        bounds.residual[row].add_multiple(kSlack * sum, powers_[k]);
      }
    }
  }

  /// C D - 1: in balls where the orders cancel, by magnitudes of C and D above.
  void bound_columns(AlongLine& bounds) {
    for (std::size_t k = 0; k <= kDegree; ++k) {
      const BallMatrix<Ball> m = product_of_order(k, k + 1);
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
          const Ball entry = m[row][i] - Ball(k == 0 && row == i ? 1.0 : 0.0);
          column_bound(bounds, row, i).add_multiple(entry.upper_magnitude(), powers_[k]);
        }
      }
    }
    std::array<Matrix3, 3 * kDegree + 1> d;  // |D| by orders
    for (std::size_t k = 0; k <= 3 * kDegree; ++k) {
      d[k] = k <= kDegree  ? magnitudes(columns_[k])
             : k <= kExact ? magnitudes(columns_of_order(rows_, monomials_, k))
                           : columns_of_order(row_bounds_, monomial_bounds_, k);
    }
    for (std::size_t k = kDegree + 1; k <= 4 * kDegree; ++k) {
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
          double sum = 0;
          for (std::size_t n = k > 3 * kDegree ? k - 3 * kDegree : 0; n <= kDegree; ++n) {
            for (std::size_t m = 0; m < 3; ++m) {
              sum += preconditioner_bounds_[n][row][m] * d[k - n][m][i];
            }
          }
          column_bound(bounds, row, i).add_multiple(kSlack * sum, powers_[k]);
        }
      }
    }
  }

  SeriesBound& column_bound(AlongLine& bounds, std::size_t row, std::size_t i) const {
    return bounds.derivative[others_[i] / 2][row][column_index(others_[i])];
  }

  /// C times derivatives of order two and more: no cancellation is needed.
  void bound_higher(AlongLine& bounds) {
    std::array<std::array<SeriesBound, 3>, 3> c;
    for (std::size_t k = 0; k <= kDegree; ++k) {
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t m = 0; m < 3; ++m) {
          c[row][m].add_multiple(preconditioner_bounds_[k][row][m], powers_[k]);
        }
      }
    }
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t m = 0; m < 3; ++m) {
        std::array<SeriesBound, 9> g;
        for (std::size_t k = 0; k <= 2 * kDegree; ++k) {
          const NetRow<double> d =
              k == 0 ? row_bounds_[p][m] : higher_coefficients(row_bounds_[p][m], monomial_bounds_[p], k);
          for (const std::size_t i : {2, 4, 5, 6, 7, 8}) {
            g[i].add_multiple(kSlack * d[i], powers_[k]);
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

  Tube<Ball>& tube_;
  std::array<std::size_t, 3> others_;
  std::array<SeriesBound, 5 * kDegree + 1> powers_;
  std::array<std::array<NetRow<Ball>, 3>, 2> rows_;
  std::array<std::array<NetRow<double>, 3>, 2> row_bounds_;
  std::array<Monomials<Ball, kDegree>, 2> monomials_;
  std::array<Monomials<double, kDegree>, 2> monomial_bounds_;
  std::array<Matrix3, kDegree + 1> preconditioner_bounds_;
  std::array<BallMatrix<Ball>, kDegree + 1> columns_;
};

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
std::optional<AlongLine> fit_line(Tube<Ball>& tube) {
  AlongLine bounds;
  tube.scale = std::ldexp(1.0, std::ilogb(tube.reach) + 1);
  return LineFit<Ball>(tube).run(bounds) ? std::optional(bounds) : std::nullopt;
}

template std::optional<AlongLine> fit_line(Tube<DoubleBall>&);
template std::optional<AlongLine> fit_line(Tube<DoubleDoubleBall>&);
template std::optional<AlongLine> fit_line(Tube<ArbBall<256>>&);

}  // namespace exsect
