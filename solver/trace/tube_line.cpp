#include "trace/tube_line.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {

namespace {

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

/// sum += a b
template <class Ball>
void add_matrix_product(BallMatrix<Ball>& sum, const BallMatrix<Ball>& a, const BallMatrix<Ball>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t m = 0; m < 3; ++m) {
        add_product(sum[i][j], a[i][m], b[m][j]);
      }
    }
  }
}

/// One fit: the line and the preconditioner order by order, then magnitudes of what is left.
template <class Ball>
class LineFit {
 public:
  static constexpr std::size_t kDegree = kLineDegree<Ball>;
  /// Up to this order coefficients are balls; above, what is small by cancellation is the square of that.
  static constexpr std::size_t kExact = 2 * kDegree + 1;

  explicit LineFit(Tube<Ball>& tube) : tube_(tube), others_(other_axes(tube.axis)) {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t row = 0; row < 3; ++row) {
        rows_[p][row] = row_of(tube.nets[p], row);
        row_bounds_[p][row] = magnitudes(rows_[p][row]);
      }
    }
  }

  /// The line alone.
  bool begin() {
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
    return true;
  }

  /// All the rest, after the line.
  void finish(LineRemainder<Ball>& left) {
    fit_preconditioner();
    extend_bounds(left);
    bound_residual(left);
    bound_columns(left);
    bound_higher(left);
    left.underflow = underflow(left);
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
      BallMatrix<Ball> next;
      add_matrix_product(next, product_of_order(k, k), tube_.preconditioner[0]);
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
      for (std::size_t p = 0; p < 2; ++p) {
        const auto gradient = gradient_coefficients(rows[p][row], monomials[p], k);
        for (std::size_t i = 0; i < 3; ++i) {
          if (others_[i] / 2 == p) {
            result[row][i] = gradient[others_[i] % 2];
          }
        }
      }
    }
    return result;
  }

  /// Of C D, order k, the terms of C of order below `end`.
  BallMatrix<Ball> product_of_order(std::size_t k, std::size_t end) const {
    BallMatrix<Ball> sum;
    for (std::size_t i = 0; i < end; ++i) {
      add_matrix_product(sum, tube_.preconditioner[i], columns_[k - i]);
    }
    return sum;
  }

  /// The coefficients above kExact, by magnitudes.
  void extend_bounds(LineRemainder<Ball>& left) {
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
      left.preconditioner[k] = magnitudes(tube_.preconditioner[k]);
    }
  }

  /// C F along the line, of degree 5 times that of the line.
  void bound_residual(LineRemainder<Ball>& left) {
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
        left.residual[k][row] = sum[row].upper_magnitude();
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
            sum += left.preconditioner[i][row][m] * magnitude[k - i][m];
          }
        }
        left.residual[k][row] = kSlack * sum;
      }
    }
  }

  /// C D - 1: in balls where the orders cancel, by magnitudes of C and D above.
  void bound_columns(LineRemainder<Ball>& left) {
    for (std::size_t k = 0; k <= kDegree; ++k) {
      const BallMatrix<Ball> m = product_of_order(k, k + 1);
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
          const Ball entry = m[row][i] - Ball(k == 0 && row == i ? 1.0 : 0.0);
          left.columns[k][row][i] = entry.upper_magnitude();
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
              sum += left.preconditioner[n][row][m] * d[k - n][m][i];
            }
          }
          left.columns[k][row][i] = kSlack * sum;
        }
      }
    }
  }

  /// Derivatives of order two and more of both nets along the line: no cancellation is needed.
  void bound_higher(LineRemainder<Ball>& left) const {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t m = 0; m < 3; ++m) {
        left.higher[0][p][m] = row_bounds_[p][m];
        for (std::size_t k = 1; k <= 2 * kDegree; ++k) {
          left.higher[k][p][m] = higher_coefficients(row_bounds_[p][m], monomial_bounds_[p], k);
        }
      }
    }
  }

  /// Behind a product that underflows there are at most one factor of C, one of the nets, and three of the
  /// line's powers and products.
  double underflow(const LineRemainder<Ball>& left) const {
    double c = 1, net = 1, line = 1;
    for (const Matrix3& m : left.preconditioner)
      for (const Row3& row : m) c = larger_bound(c, row[0], row[1], row[2]);
    for (std::size_t p = 0; p < 2; ++p) {
      for (const NetRow<double>& row : row_bounds_[p]) net = std::max(net, *std::ranges::max_element(row));
      const Monomials<double, kDegree>& m = monomial_bounds_[p];
      for (std::size_t k = 1; k <= 4 * kDegree; ++k)
        line = larger_bound(line, m.a[k], m.b[k], m.aa[k], m.ab[k], m.bb[k], m.aab[k], m.abb[k], m.aabb[k]);
    }
    return kUnderflow * c * net * line * line * line;
  }

  Tube<Ball>& tube_;
  std::array<std::size_t, 3> others_;
  std::array<std::array<NetRow<Ball>, 3>, 2> rows_;
  std::array<std::array<NetRow<double>, 3>, 2> row_bounds_;
  std::array<Monomials<Ball, kDegree>, 2> monomials_;
  std::array<Monomials<double, kDegree>, 2> monomial_bounds_;
  std::array<BallMatrix<Ball>, kDegree + 1> columns_;
};

}  // namespace

template <class Ball>
std::optional<LineRemainder<Ball>> fit_line(Tube<Ball>& tube) {
  tube.scale = std::ldexp(1.0, std::ilogb(tube.reach) + 1);
  LineFit<Ball> fit(tube);
  if (!fit.begin()) {
    return std::nullopt;
  }
  LineRemainder<Ball> left;
  fit.finish(left);
  return left;
}

template <class Ball>
bool fit_line_alone(Tube<Ball>& tube) {
  tube.scale = std::ldexp(1.0, std::ilogb(tube.reach) + 1);
  return LineFit<Ball>(tube).begin();
}

#define EXSECT_INSTANTIATE_LINE(Ball)                                \
  template std::optional<LineRemainder<Ball>> fit_line(Tube<Ball>&); \
  template bool fit_line_alone(Tube<Ball>&);

EXSECT_INSTANTIATE_LINE(DoubleBall)
EXSECT_INSTANTIATE_LINE(DoubleDoubleBall)
EXSECT_INSTANTIATE_LINE(ArbBall<256>)
EXSECT_INSTANTIATE_LINE(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_LINE

}  // namespace exsect
