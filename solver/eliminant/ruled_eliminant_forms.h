// The polynomials R and S1 of the fibre of a patch whose lines x(u,.) are straight, at one u, for any
// arithmetic.
#pragma once

#include "eliminant/homogeneous_forms.h"

namespace exsect {

/// The equations (16.13) and (16.14) of docs/method-equations.md at single values of u.
template <class Field, std::size_t m, std::size_t n>
class RuledEliminantForms : public HomogeneousForms<Field, RuledKind<m, n>> {
  using Base = HomogeneousForms<Field, RuledKind<m, n>>;
  using Base::field_;
  using Base::y_;

 public:
  using typename Base::Fibre;
  using typename Base::Residue;
  using typename Base::Sum;
  using typename Base::Vector;

  RuledEliminantForms(const Field& field, const typename Base::FirstNet& x, const typename Base::SecondNet& y,
                      const typename Base::SmallNumbers& small)
      : Base(field, x, y, small) {
    for (std::size_t j = 1; j <= m; ++j)
      for (std::size_t i = 0; i < j; ++i) this->set_wedge(y_wedge_[i][j], y_.c[i], y_.c[j]);
    for (std::size_t j = 1; j <= n; ++j)
      for (std::size_t i = 0; i < j; ++i) lead_wedge_[i][j][0] = this->wedge(y_.c[m][i], y_.c[m][j]);
  }

  Fibre fibre(const Residue& u) const {
    Vector a[2];
    this->set_line(a, u);
    const Bivector line = this->wedge(a[0], a[1]);
    Fibre result;
    set_determinants(result.r, result.s1, line, y_wedge_);
    result.lead_s = result.r[RuledKind<m, n>::points];
    Residue lead[1], unused[1];  // of R with r and s exchanged: its y_j have the leading coefficients y_mj
    set_determinants(lead, unused, line, lead_wedge_);
    result.lead_r = lead[0];
    return result;
  }

 private:
  using typename Base::Bivector;

  /// The determinant of the matrix (16.13), and that without its first row and column. `wedges` has y_i ^ y_j
  /// for i < j, each of `size` coefficients.
  template <std::size_t all, std::size_t fewer, std::size_t order, std::size_t size>
  void set_determinants(Residue (&determinant)[all], Residue (&cofactor)[fewer], const Bivector& line,
                        const Bivector (&wedges)[order][order + 1][size]) const {
    const Bivector minus_line = this->negated(line);
    Residue b[order][order][size];  // b[p][q] for p <= q
    for (std::size_t p = 0; p < order; ++p)
      for (std::size_t q = p; q < order; ++q)
        for (std::size_t d = 0; d < size; ++d) {
          b[p][q][d] = this->pairing(line, minus_line, wedges[p][q + 1][d]);
          if (p > 0 && q + 1 < order) b[p][q][d] = field_.add(b[p][q][d], b[p - 1][q + 1][d]);
        }
    set_determinants(determinant, cofactor, b);
  }

  template <std::size_t all, std::size_t size>
  void set_determinants(Residue (&determinant)[all], Residue (&cofactor)[1],
                        const Residue (&b)[1][1][size]) const {
    for (std::size_t d = 0; d < size; ++d) determinant[d] = b[0][0][d];
    cofactor[0] = this->small_[1];
  }
  template <std::size_t all, std::size_t fewer, std::size_t size>
  void set_determinants(Residue (&determinant)[all], Residue (&cofactor)[fewer],
                        const Residue (&b)[2][2][size]) const {
    Residue minus_b01[size];
    this->set_negated(minus_b01, b[0][1]);
    this->set_sum(determinant, this->product(b[0][0], b[1][1]), this->product(minus_b01, b[0][1]));
    for (std::size_t d = 0; d < size; ++d) cofactor[d] = b[1][1][d];
  }
  template <std::size_t all, std::size_t fewer, std::size_t size>
  void set_determinants(Residue (&determinant)[all], Residue (&cofactor)[fewer],
                        const Residue (&b)[3][3][size]) const {
    Residue minus_b01[size], minus_b02[size], minus_b12[size], second[2 * size - 1], third[2 * size - 1];
    this->set_negated(minus_b01, b[0][1]);
    this->set_negated(minus_b02, b[0][2]);
    this->set_negated(minus_b12, b[1][2]);
    this->set_sum(cofactor, this->product(b[1][1], b[2][2]), this->product(minus_b12, b[1][2]));
    this->set_sum(second, this->product(b[0][2], b[1][2]), this->product(minus_b01, b[2][2]));
    this->set_sum(third, this->product(b[0][1], b[1][2]), this->product(minus_b02, b[1][1]));
    this->set_sum(determinant, this->product(b[0][0], cofactor), this->product(b[0][1], second),
                  this->product(b[0][2], third));
  }

  Bivector y_wedge_[m][m + 1][2 * n + 1];
  Bivector lead_wedge_[n][n + 1][1];  // of the coefficients of r^m
};

}  // namespace exsect
