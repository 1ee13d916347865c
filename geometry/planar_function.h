// Implicit functions of the plane: polynomials, and splines on a grid of cells.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>

#include <optional>
#include <vector>

namespace exsect {

/// The closed box x × y; polynomials in (x,y) have x as their first variable r and y as their second s.
struct PlanarBox {
  RationalInterval x;
  RationalInterval y;
};

/// A polynomial on the whole plane, or a continuously differentiable spline: a polynomial on each of some
/// cells of a grid. The grid is one of (x,y) or, for functions of x^2 and y, of (x^2,y); the polynomials are
/// those in (x,y) either way. The spline is defined on its cells only.
class PlanarFunction {
 public:
  PlanarFunction(BivariatePolynomial polynomial);  // NOLINT: a polynomial is a function

  struct Grid {
    std::vector<Rational> breaks_x;  // ascending; of x^2 if `squared`
    std::vector<Rational> breaks_y;
    bool squared = false;
  };
  /// cells[i][j] belongs to the i-th interval of breaks_x and the j-th of breaks_y; empty where the spline is
  /// not defined. Throws std::invalid_argument unless the shapes agree and breaks ascend. The caller promises
  /// that neighbouring cells join with continuous first derivatives.
  PlanarFunction(Grid grid, std::vector<std::vector<std::optional<BivariatePolynomial>>> cells);

  bool is_polynomial() const { return grid_.breaks_x.empty(); }
  /// Requires is_polynomial(), else std::domain_error.
  const BivariatePolynomial& polynomial() const;
  const Grid& grid() const { return grid_; }
  const std::vector<std::vector<std::optional<BivariatePolynomial>>>& cells() const { return cells_; }

  /// Polynomials such that the function agrees at every point of the box with one of them; empty if the
  /// function is not defined on the whole box.
  std::vector<BivariatePolynomial> polynomials_on(const PlanarBox& box) const;
  /// The value; nothing where the function is not defined.
  std::optional<Rational> operator()(const Rational& x, const Rational& y) const;

 private:
  Grid grid_;
  std::vector<std::vector<std::optional<BivariatePolynomial>>> cells_;
};

}  // namespace exsect
