// The eliminant of the turning points at one u modulo one prime: the inner loop of turning_eliminant.
#pragma once

#include <exsect/algebra/modular.h>
#include <exsect/geometry/integer_pair.h>

#include <array>

namespace exsect {

/// Values of E(u) (docs/method.md, equation (4.8)) of a pair reduced modulo a prime.
class ModularEliminant {
 public:
  ModularEliminant(const PrimeField& field, const IntegerPair& pair);

  /// E(u) by Euclid's algorithm without inverses (4.13). The denominator is zero where g_s(u) Res(R,S1)(u) =
  /// 0, and also where a leading coefficient of the remainder sequences vanishes.
  ResidueFraction fast_value(Residue u) const;
  /// E(u) from resultants that allow any sequence of degrees: the denominator is zero only where
  /// g_s(u) Res(R,S1)(u) = 0. Several times slower.
  ResidueFraction value(Residue u) const;

 private:
  using Vector = std::array<Residue, 3>;
  template <std::size_t size>
  using Coefficients = std::array<Residue, size>;  // of a polynomial in s, constant term first
  /// R, its first subresultant S1, and g_r, g_s at one u (4.3)-(4.5).
  struct Fibre {
    Coefficients<17> r;
    Coefficients<11> s1;
    Residue g_r;
    Residue g_s;
  };

  Vector cross(const Vector& a, const Vector& b) const;
  Residue dot(const Vector& a, const Vector& b) const;
  Coefficients<5> bracket(const Vector& a, const Vector& a0_cross_a, std::size_t i, std::size_t j) const;
  Fibre fibre(Residue u) const;

  PrimeField field_;
  std::array<std::array<Vector, 3>, 3> x_;
  std::array<std::array<Vector, 3>, 3> y_;
  std::array<std::array<Coefficients<5>, 3>, 3>
      y_cross_;  // of y_0 x y_1, y_0 x y_2, y_1 x y_2, by coordinate
};

}  // namespace exsect
