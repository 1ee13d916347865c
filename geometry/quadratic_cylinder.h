// The quadratic cylinder of a conic parameter line as an explicit quadric, and the planes that bound the line
// on it.
#pragma once

#include <exsect/algebra/polynomial.h>
#include <exsect/geometry/pull_back.h>

#include <array>
#include <vector>

namespace exsect {

/// coefficient x^i y^j z^k with exponents (i,j,k).
template <class Ring>
struct QuadricTermOver {
  Ring coefficient;
  std::array<int, 3> exponents;
};

/// A polynomial of degree at most 2 in x, y, z. Ring is Q, or Q[u] for a quadric that depends on the
/// parameter u.
template <class Ring>
class QuadricOver {
 public:
  /// Exponents of the ten monomials, in the order of `coefficients`.
  static constexpr std::array<std::array<int, 3>, 10> monomials = {{{2, 0, 0},
                                                                    {1, 1, 0},
                                                                    {1, 0, 1},
                                                                    {0, 2, 0},
                                                                    {0, 1, 1},
                                                                    {0, 0, 2},
                                                                    {1, 0, 0},
                                                                    {0, 1, 0},
                                                                    {0, 0, 1},
                                                                    {0, 0, 0}}};

  explicit QuadricOver(const std::array<Ring, 10>& coefficients) : coefficients_(coefficients) {}

  const std::array<Ring, 10>& coefficients() const { return coefficients_; }
  Ring operator()(const Point& p) const;
  /// The terms with coefficient != 0, in the order of `monomials`.
  std::vector<QuadricTermOver<Ring>> terms() const;

 private:
  std::array<Ring, 10> coefficients_;
};

using Quadric = QuadricOver<Rational>;
using QuadricTerm = QuadricTermOver<Rational>;
using SymbolicQuadric = QuadricOver<Polynomial>;
extern template class QuadricOver<Rational>;
extern template class QuadricOver<Polynomial>;

/// e0 e2 - e1^2 multiplied out: the cylinder that contains the line identically. For orthogonal_forms it is
/// N w2 - w1^2 = -zeta, with rulings along the plane's normal.
Quadric quadratic_cylinder(const LineForms& forms);
SymbolicQuadric quadratic_cylinder(const LineFormsOver<Polynomial>& forms);

/// The planes e1 = 0 and e1 = e0 for e0 > 0, as forms with the part 0 <= t <= 1 of the line where start >= 0
/// and end <= 0. On the line start = e0 t and end = e0 (t - 1).
struct BoundingPlanes {
  AffineForm start;
  AffineForm end;
};
/// Requires e0 a constant != 0, as for every line of a polynomial patch; else std::domain_error. For
/// orthogonal_forms: w1 and w1 - N.
BoundingPlanes bounding_planes(const LineForms& forms);

}  // namespace exsect
