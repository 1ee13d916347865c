// The polynomials R and S1 of the fibre of polynomial patches at one u, for any arithmetic.
#pragma once

#include "eliminant/fibre_resultants.h"

namespace exsect {

/// The equations (4.3)-(4.5) of docs/method.md at single values of u.
template <class Field>
class EliminantForms : public FibreResultants<Field, PolynomialKind> {
  using Base = FibreResultants<Field, PolynomialKind>;
  using Base::field_;
  using Base::x_;
  using Base::y_;

 public:
  using typename Base::Fibre;
  using typename Base::Residue;
  using typename Base::Sum;
  using typename Base::Vector;

  EliminantForms(const Field& field, const typename Base::FirstNet& x, const typename Base::SecondNet& y,
                 const typename Base::SmallNumbers& small)
      : Base(field, x, y, small) {
    cross_coefficients(y_cross_[0], 0, 1);
    cross_coefficients(y_cross_[1], 0, 2);
    cross_coefficients(y_cross_[2], 1, 2);
  }

  Fibre fibre(const Residue& u) const;

 private:
  Vector cross(const Vector& a, const Vector& b) const {
    return {this->minor(a, b, 1, 2), this->minor(a, b, 2, 0), this->minor(a, b, 0, 1)};
  }
  /// y_i x y_j as polynomials in s.
  void cross_coefficients(Vector (&result)[5], std::size_t i, std::size_t j) const {
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t e = 0; e < 3; ++e) {
        const Vector term = cross(y_.c[i][d], y_.c[j][e]);
        const bool first = d == 0 || e == 2;  // of the terms of degree d + e
        for (std::size_t k = 0; k < 3; ++k)
          result[d + e].c[k] = first ? term.c[k] : field_.add(result[d + e].c[k], term.c[k]);
      }
  }
  /// a . (w_i x w_j), where w_0 = y_0 - a_0 and w_i = y_i otherwise.
  void set_bracket(Residue (&result)[5], const Vector& a, const Vector& a0_cross_a, std::size_t i,
                   std::size_t j) const {
    for (std::size_t d = 0; d < 5; ++d) {
      const Vector& y_cross = y_cross_[i + j - 1][d];
      Sum sum(a.c[0], y_cross.c[0]);
      sum.add(a.c[1], y_cross.c[1]);
      sum.add(a.c[2], y_cross.c[2]);
      if (i == 0 && d < 3)  // a . (-a_0 x w_j) = (a_0 x a) . w_j
        for (std::size_t k = 0; k < 3; ++k) sum.add(a0_cross_a.c[k], y_.c[j][d].c[k]);
      result[d] = field_.reduce(sum);
    }
  }
  Residue leading_bracket(const Vector& a, std::size_t i, std::size_t j) const {
    return this->dot(a, cross(y_.c[2][i], y_.c[2][j]));
  }

  Vector y_cross_[3][5];  // of y_0 x y_1, y_0 x y_2, y_1 x y_2
};

template <class Field>
typename EliminantForms<Field>::Fibre EliminantForms<Field>::fibre(const Residue& u) const {
  Vector a[3];
  this->set_line(a, u);
  const Vector n = cross(a[1], a[2]);
  const Vector a0_cross_a1 = cross(a[0], a[1]);
  const Vector a0_cross_a2 = cross(a[0], a[2]);

  // A and B of the plane A r^2 + B r + C, and the brackets with a_2 and a_1 (4.3).
  Residue pa[3], pb[3];
  for (std::size_t d = 0; d < 3; ++d) {
    pa[d] = this->dot(n, y_.c[2][d]);
    pb[d] = this->dot(n, y_.c[1][d]);
  }
  Residue la[5], lb[5], lc[5], ma[5], mb[5], mc[5];
  set_bracket(la, a[2], a0_cross_a2, 0, 2);
  set_bracket(lb, a[2], a0_cross_a2, 1, 2);
  set_bracket(lc, a[2], a0_cross_a2, 0, 1);
  set_bracket(ma, a[1], a0_cross_a1, 0, 2);
  set_bracket(mb, a[1], a0_cross_a1, 1, 2);
  set_bracket(mc, a[1], a0_cross_a1, 0, 1);
  Residue minus_lb[5], minus_mb[5], twice_la[5], minus_twice_la[5], twice_ma[5], twice_lb[5], twice_rl[9];
  this->set_negated(minus_lb, lb);
  this->set_negated(minus_mb, mb);
  this->set_doubled(twice_la, la);
  this->set_negated(minus_twice_la, twice_la);
  this->set_doubled(twice_ma, ma);
  this->set_doubled(twice_lb, lb);

  // (4.4): R = A^2 rm - pml pul + rl pmu + rl^2 and S1 = A (A Mb - 2 La Lb) + B Lb^2.
  Residue rl[9], rm[9], pml[9], minus_pul[7], pmu[7], a_square[5], lb_square[9], inner[9];
  this->set_sum(rl, this->square(la, twice_la), this->product(minus_lb, lc));
  this->set_sum(rm, this->square(ma, twice_ma), this->product(minus_mb, mc));
  this->set_sum(pml, this->product(twice_la, ma), this->product(minus_lb, mc), this->product(minus_mb, lc));
  this->set_sum(minus_pul, this->product(pa, minus_twice_la), this->product(pb, lb));
  this->set_sum(pmu, this->product(pa, twice_ma), this->product(pb, minus_mb));
  this->set_sum(a_square, this->product(pa, pa));
  this->set_sum(lb_square, this->square(lb, twice_lb));
  this->set_sum(inner, this->product(twice_la, minus_lb), this->product(pa, mb));

  this->set_doubled(twice_rl, rl);

  Fibre result;
  this->set_sum(result.r, this->product(a_square, rm), this->product(minus_pul, pml), this->product(pmu, rl),
                this->square(rl, twice_rl));
  this->set_sum(result.s1, this->product(pa, inner), this->product(pb, lb_square));
  // (4.5): g_s is the coefficient of s^8 in rl, g_r the same with r and s exchanged.
  result.lead_s = rl[8];
  const Residue middle = leading_bracket(a[2], 0, 2);
  Sum g_r(middle, middle);
  g_r.add(field_.negate(leading_bracket(a[2], 1, 2)), leading_bracket(a[2], 0, 1));
  result.lead_r = field_.reduce_few(g_r);
  return result;
}

}  // namespace exsect
