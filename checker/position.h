// The point of space as a function of the variables of a map: a quotient of polynomial maps.
#pragma once

#include <optional>

#include "certificate.h"

namespace exsect::checker {

/// Derivatives of the position along a curve w over a box, in balls.
template <class N>
struct PositionBounds {
  std::array<Balls<N>, 4> partial;  // with respect to each variable
  Balls<N> second;                  // along w, with its first and second derivative
};

/// X / W of two polynomial maps, W the first component of `weight`; X alone without it.
template <class N>
struct Position {
  Map<N> points;
  std::optional<Map<N>> weight = {};

  /// Fails where W is not certainly positive.
  Vector3<N> value(const Vector4<N>& w) const {
    Vector3<N> result = points.value(w);
    if (!weight) return result;
    const N divisor = weight->value(w)[0];
    require(divisor > 0, "a denominator that may be 0");
    for (N& c : result) c = c / divisor;
    return result;
  }

  /// Over |w - middle| <= half, `first` and `second` those of a curve there. With P = X / W:
  /// W P_i = X_i - P W_i, and W D^2 P[t,t] = D^2 X[t,t] - 2 DP[t] DW[t] - P D^2 W[t,t]. Fails where W may be
  /// 0.
  PositionBounds<N> bounds(const Vector4<N>& middle, const Vector4<N>& half, const Box<N>& first,
                           const Box<N>& second) const {
    const Map<N> local = points.at(middle);
    const Ranges over(local, half);
    PositionBounds<N> result = {{}, over.second(first)};
    for (std::size_t i = 0; i < 4; ++i) result.partial[i] = over.first(i);
    if (weight) divide(result, over.value(), Ranges(weight->at(middle), half), first);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t d = 0; d < 3; ++d)
        result.second[d] = result.second[d] + result.partial[i][d] * second[i];
    return result;
  }

 private:
  /// From the derivatives of X to those of the quotient, without the curve's second derivative.
  static void divide(PositionBounds<N>& result, const Balls<N>& x, const Ranges<N>& weight, const Box<N>& t) {
    const Ball<N> w = weight.value()[0];
    require(w.sign() > 0, "a denominator that may be 0");
    Box<N> slope;
    Ball<N> along;
    for (std::size_t i = 0; i < 4; ++i) {
      slope[i] = weight.first(i)[0];
      along = along + slope[i] * t[i];
    }
    const Ball<N> bend = weight.second(t)[0];
    for (std::size_t d = 0; d < 3; ++d) {
      const Ball<N> p = x[d] / w;
      Ball<N> p_along;
      for (std::size_t i = 0; i < 4; ++i) {
        result.partial[i][d] = (result.partial[i][d] - p * slope[i]) / w;
        p_along = p_along + result.partial[i][d] * t[i];
      }
      result.second[d] = (result.second[d] - N(2) * p_along * along - p * bend) / w;
    }
  }
};

/// x(u,v), of the coefficients.
template <class N>
Position<N> position_on(const WeightedNet<N>& x) {
  Position<N> result;
  add_product(result.points, x.points, one<N>(), N(1), 0);
  if (!x.has_weights()) return result;
  Net<N> weights(x.weights.degree(0), x.weights.degree(1));
  x.weights.each([&](std::size_t i, std::size_t j) { weights[i][j][0] = x.weights[i][j][0]; });
  add_product(result.weight.emplace(), weights, one<N>(), N(1), 0);
  return result;
}
template <class N>
Position<N> rounded(const Position<Rational>& position) {
  Position<N> result = {rounded<N>(position.points)};
  if (position.weight) result.weight = rounded<N>(*position.weight);
  return result;
}

}  // namespace exsect::checker
