// Linear spaces of functions of the plane in which implicit equations are sought.
#pragma once

#include <exsect/algebra/rational_matrix.h>
#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/planar_function.h>

#include <vector>

namespace exsect {

/// The span of products a_i(x) b_j(y) of piecewise polynomials in one variable. Invariant: the products are
/// linearly independent on the cells of the space.
class PlanarSpace {
 public:
  /// x^i y^j with i + j <= degree, ordered by i + j, then by j. Throws std::invalid_argument for degree < 0.
  /// Tension is measured on the box.
  static PlanarSpace monomials(int degree, const PlanarBox& box);
  /// The same in the coordinates ((x - c1)/unit, (y - c2)/unit) with short rationals c1, c2 and a power of
  /// two as unit, in which the box is one of coordinates of at most about 1.
  static PlanarSpace local_monomials(int degree, const PlanarBox& box);
  /// The Bernstein polynomials of bidegree (m,n) of the box.
  static PlanarSpace bernstein(int m, int n, const PlanarBox& box);
  /// Uniform tensor B-splines of bidegree (m,n), m and n >= 2, on the box divided into cells_x by cells_y
  /// equal cells; cells that the curve cannot meet, and their neighbours, are left out, and so are functions
  /// that vanish on all cells kept. The curve must lie in the box.
  static PlanarSpace b_splines(int m, int n, const PlanarBox& box, int cells_x, int cells_y,
                               const BezierCurve& curve);
  /// The functions phi(x^2, y) for phi in this space, whose box is then one of (x^2, y).
  PlanarSpace in_squares() const;

  std::size_t dimension() const { return products_.size(); }
  bool is_polynomial() const { return breaks_x_.size() == 2 && breaks_y_.size() == 2; }
  bool squared() const { return squared_; }
  /// Largest total degree of a function, in (x,y); of a piece for splines.
  int total_degree() const;

  struct Values {
    std::vector<Rational> value;
    std::vector<Rational> dx;
    std::vector<Rational> dy;
  };
  /// All functions and their first derivatives at a point. Throws std::domain_error where a spline space is
  /// not defined.
  Values at(const Rational& x, const Rational& y) const;
  /// H with c' H c = ∬ f_xx^2 + 2 f_xy^2 + f_yy^2 over the cells of the space for f = sum c_i phi_i (10.3);
  /// in the variables (x^2, y) for a space in squares.
  RationalMatrix tension() const;
  /// sum c_i phi_i. Throws std::invalid_argument unless there are dimension() coefficients.
  PlanarFunction combination(const std::vector<Rational>& c) const;

 private:
  /// functions[i][k]: the i-th function on the k-th interval, a polynomial of the variable.
  using Piecewise = std::vector<std::vector<Polynomial>>;
  struct Product {
    std::size_t i;
    std::size_t j;
  };

  PlanarSpace() = default;
  static PlanarSpace powers_of(int degree, const PlanarBox& box, const Polynomial& x, const Polynomial& y);
  bool active(std::size_t k, std::size_t l) const { return active_[k][l]; }

  std::vector<Rational> breaks_x_;
  std::vector<Rational> breaks_y_;
  Piecewise in_x_;
  Piecewise in_y_;
  std::vector<std::vector<bool>> active_;  // [k][l]: the cell belongs to the space
  std::vector<Product> products_;
  bool squared_ = false;
};

/// The box of the control points of the part of a planar curve over [from, to], 0 <= from < to <= 1: the
/// part lies in it.
PlanarBox control_box(const HomogeneousCurve& curve, const Rational& from, const Rational& to);

}  // namespace exsect
