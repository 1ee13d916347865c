// The equation of a self-intersection near a folded parameter line. Internal to solver/; docs/method.md,
// section 7.7.
//
// Notation: the line v = c turns at u = f; x(f + p, c + h) = sum d_ij p^i h^j. All pairs f + t, f - t on the
// line meet: H(U,V,m,w) (7.3), (7.13) vanishes for p = U - f = 0, h = V - c = 0, m = 0 and every w = t^2.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <optional>
#include <type_traits>
#include <vector>

namespace exsect {

/// H = z_1 M_1 + z_2 M_2 + z_3 M_3 with polynomials z_i that vanish together on the line only: where
/// det(M_1,M_2,M_3) != 0 there are no other pairs near it. (7.14)
///   not planar:  z = (p + k_1 h + ..., h^order, m),  M_2 = second_0 + second_1 h + second_2 h^2
///   planar:      z = (p + alpha m, h + beta m, m^2), d_01 + w d_21 = 2 alpha d_20 + beta second_0
/// and beta^2 H with z = (p + k_1 h + ... + alpha m, h^order + beta m, h^(order + 1)) if both planar and
/// order > 1; then M_2 and M_3 are dependent where beta = 0. (7.15)
struct FoldExpansion {
  Rational turn;      // f
  Rational constant;  // c
  ControlNet d;
  int order;
  bool planar;
  std::array<Point, 3> second;
  std::vector<Rational> turns;    // k_1, k_2, ...
  std::array<Rational, 2> alpha;  // alpha_0 + alpha_1 w
  std::array<Rational, 2> beta;
  Polynomial contact;  // det(M_1,M_2,M_3) on the line, in w; not zero

  /// Both tangent planes agree all along the line.
  bool is_multiple() const { return order > 1 || planar; }
};

/// Of the folded line v = c with its turn at u = f. Empty if all lines near v = c are folded, or the
/// expansion does not come to an end with a determinant that is not identically zero.
std::optional<FoldExpansion> fold_expansion(const BezierPatch& x, const Rational& f, const Rational& c);

/// M_1, M_2, M_3 over numbers or enclosures.
template <class Scalar>
class FoldFactors {
 public:
  using Vector = std::array<Scalar, 3>;

  explicit FoldFactors(const FoldExpansion& fold)
      : planar_(fold.planar),
        order_(fold.order),
        alpha_({from(fold.alpha[0]), from(fold.alpha[1])}),
        beta_({from(fold.beta[0]), from(fold.beta[1])}) {
    for (const Rational& k : fold.turns) turns_.push_back(from(k));
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 9; ++i) d_[i][k] = from(fold.d[i / 3][i % 3][k]);
      for (std::size_t i = 0; i < 3; ++i) second_[i][k] = from(fold.second[i][k]);
    }
  }

  std::array<Vector, 3> operator()(const Scalar& p, const Scalar& h, const Scalar& m, const Scalar& w) const {
    const Scalar two(2);
    const Scalar alpha = alpha_[0] + w * alpha_[1];
    const Scalar beta = beta_[0] + w * beta_[1];
    Scalar turn(0);    // k_1 + k_2 h + ...
    Scalar before(1);  // h^(order - 1)
    for (int i = order_ - 1; i > 0; --i) {
      turn = turn * h + turns_[static_cast<std::size_t>(i - 1)];
      before = before * h;
    }
    std::array<Vector, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto d = [&](std::size_t i, std::size_t j) -> const Scalar& { return d_[3 * i + j][k]; };
      const Scalar first = two * (d(2, 0) + h * (d(2, 1) + h * d(2, 2)));
      const Scalar a = d(1, 1) + two * h * d(1, 2) + p * (d(2, 1) + two * h * d(2, 2));
      const Scalar c = w * (d(1, 2) + two * p * d(2, 2));
      if (planar_ && order_ > 1) {
        const Scalar b = two * (d(0, 2) + w * d(2, 2) - alpha * (d(2, 1) + h * d(2, 2))) -
                         beta * (second_[1][k] + h * second_[2][k]);
        const Scalar e = b - turn * a;
        const Scalar f = c - alpha * a;
        const Scalar second = second_[0][k] + h * (second_[1][k] + h * second_[2][k]);
        result[0][k] = first + m * a;
        result[1][k] = beta * (beta * second + h * e + m * f) - h * before * f;
        result[2][k] = before * f - beta * e;
      } else if (planar_) {
        const Scalar b = two * (d(0, 2) + w * d(2, 2) - alpha * (d(2, 1) + h * d(2, 2))) - beta * d(1, 2);
        result[0][k] = first + m * a;
        result[1][k] = d(1, 1) + h * d(1, 2) + m * b;
        result[2][k] = c - alpha * a - beta * b;
      } else {
        result[0][k] = first;
        result[1][k] = second_[0][k] + h * (second_[1][k] + h * second_[2][k]);
        result[2][k] = d(0, 1) + two * h * d(0, 2) + p * a + w * (d(2, 1) + two * h * d(2, 2)) + m * c;
      }
    }
    return result;
  }

 private:
  static Scalar from(const Rational& value) {
    if constexpr (std::is_same_v<Scalar, Rational>)
      return value;
    else
      return Scalar::enclosing(value);
  }

  bool planar_;
  int order_;
  std::vector<Scalar> turns_;
  std::array<Scalar, 2> alpha_;
  std::array<Scalar, 2> beta_;
  std::array<Vector, 9> d_;
  std::array<Vector, 3> second_;
};

}  // namespace exsect
