// The polynomials R and S1 of the fibre of patches with weights at one u, for any arithmetic.
#pragma once

#include "eliminant/homogeneous_forms.h"

namespace exsect {

/// The equations (16.4) to (16.7) of docs/method-equations.md at single values of u; no vector c of (16.3) is
/// needed.
template <class Field>
class WeightedEliminantForms : public HomogeneousForms<Field, WeightedKind> {
  using Base = HomogeneousForms<Field, WeightedKind>;
  using Base::field_;
  using Base::y_;

 public:
  using typename Base::Fibre;
  using typename Base::Residue;
  using typename Base::Sum;
  using typename Base::Vector;

  WeightedEliminantForms(const Field& field, const typename Base::FirstNet& x,
                         const typename Base::SecondNet& y, const typename Base::SmallNumbers& small)
      : Base(field, x, y, small) {
    constexpr std::size_t pairs[3][2] = {{0, 2}, {1, 2}, {0, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = pairs[i];
      this->set_wedge(y_wedge_[i], y_.c[a], y_.c[b]);
      lead_wedge_[i][0] = this->wedge(y_.c[2][a], y_.c[2][b]);
    }
  }

  Fibre fibre(const Residue& u) const {
    Vector a[3];
    this->set_line(a, u);
    const Bivector p[3] = {this->wedge(a[1], a[2]), this->negated(this->wedge(a[0], a[2])),
                           this->wedge(a[0], a[1])};
    const Vector plane = covector(p[2], a[2]);
    Residue pa[3], pb[3];  // A and B of (16.4)
    for (std::size_t d = 0; d < 3; ++d) {
      pa[d] = this->dot(plane, y_.c[2][d]);
      pb[d] = this->dot(plane, y_.c[1][d]);
    }
    const Cone<5> cone(*this, p, y_wedge_);
    Fibre result;
    cone.set_resultant(*this, result.r);
    cone.set_subresultant(*this, pa, pb, result.s1);
    result.lead_s = result.r[16];
    Residue lead[1];  // of R with r and s exchanged: its y_j have the leading coefficients y_2j
    Cone<1>(*this, p, lead_wedge_).set_resultant(*this, lead);
    result.lead_r = lead[0];
    return result;
  }

 private:
  using typename Base::Bivector;

  /// The covector q -> p.(a ^ q).
  Vector covector(const Bivector& p, const Vector& a) const {
    const Bivector m = this->negated(p);
    const auto sum = [&](const Residue& f, std::size_t i, const Residue& g, std::size_t j, const Residue& h,
                         std::size_t k) {
      Sum result(f, a.c[i]);
      result.add(g, a.c[j]);
      result.add(h, a.c[k]);
      return field_.reduce_few(result);
    };
    return {{sum(m.c[3], 3, p.c[4], 2, m.c[5], 1), sum(p.c[1], 3, m.c[2], 2, p.c[5], 0),
             sum(m.c[0], 3, p.c[2], 1, m.c[4], 0), sum(p.c[0], 2, m.c[1], 1, p.c[3], 0)}};
  }

  /// One of the forms U, L, M of (16.5), with n coefficients in s.
  template <std::size_t n>
  struct Form {
    Residue alpha[n], beta[n], gamma[n], twice_alpha[n], minus_beta[n];

    void set(const WeightedEliminantForms& forms, const Bivector& p, const Bivector (&q)[3][n]) {
      const Bivector minus_p = forms.negated(p);
      for (std::size_t d = 0; d < n; ++d) {
        alpha[d] = forms.pairing(p, minus_p, q[0][d]);
        beta[d] = forms.pairing(p, minus_p, q[1][d]);
        gamma[d] = forms.pairing(p, minus_p, q[2][d]);
      }
      forms.set_doubled(twice_alpha, alpha);
      forms.set_negated(minus_beta, beta);
    }
  };

  /// U, L, M.
  template <std::size_t n>
  struct Cone {
    Form<n> u, l, m;

    Cone(const WeightedEliminantForms& forms, const Bivector (&p)[3], const Bivector (&q)[3][n]) {
      u.set(forms, p[0], q);
      l.set(forms, p[1], q);
      m.set(forms, p[2], q);
    }

    /// R of (16.6).
    void set_resultant(const WeightedEliminantForms& forms, Residue (&r)[4 * n - 3]) const {
      Residue res_u[2 * n - 1], res_l[2 * n - 1], res_m[2 * n - 1], twice_res_l[2 * n - 1];
      set_res(forms, res_u, u);
      set_res(forms, res_l, l);
      set_res(forms, res_m, m);
      forms.set_doubled(twice_res_l, res_l);
      Residue pol_ml[2 * n - 1], pol_ul[2 * n - 1], pol_mu[2 * n - 1], minus_pol_ul[2 * n - 1];
      set_pol(forms, pol_ml, m, l);
      set_pol(forms, pol_ul, u, l);
      set_pol(forms, pol_mu, m, u);
      forms.set_negated(minus_pol_ul, pol_ul);
      Residue mixed[4 * n - 3];  // all four products would be 32
      forms.set_sum(mixed, forms.product(pol_ml, minus_pol_ul), forms.product(res_l, pol_mu));
      forms.set_sum(r, forms.product(res_m, res_u), forms.square(res_l, twice_res_l));
      for (std::size_t k = 0; k < 4 * n - 3; ++k) r[k] = forms.field_.add(r[k], mixed[k]);
    }
    /// S1 of (16.7).
    void set_subresultant(const WeightedEliminantForms& forms, const Residue (&pa)[3], const Residue (&pb)[3],
                          Residue (&s1)[2 * n + 1]) const {
      Residue q1[2 * n - 1], minus_q2[2 * n - 1], minus_twice_alpha[n], twice_beta[n];
      forms.set_negated(minus_twice_alpha, l.twice_alpha);
      forms.set_doubled(twice_beta, l.beta);
      forms.set_sum(q1, forms.product(u.alpha, m.beta), forms.product(m.alpha, u.beta),
                    forms.product(minus_twice_alpha, l.beta));
      forms.set_sum(minus_q2, forms.square(l.beta, twice_beta), forms.product(u.minus_beta, m.beta));
      forms.set_sum(s1, forms.product(pa, q1), forms.product(pb, minus_q2));
    }

   private:
    static void set_res(const WeightedEliminantForms& forms, Residue (&result)[2 * n - 1], const Form<n>& f) {
      forms.set_sum(result, forms.square(f.alpha, f.twice_alpha), forms.product(f.minus_beta, f.gamma));
    }
    static void set_pol(const WeightedEliminantForms& forms, Residue (&result)[2 * n - 1], const Form<n>& f,
                        const Form<n>& g) {
      forms.set_sum(result, forms.product(f.twice_alpha, g.alpha), forms.product(f.minus_beta, g.gamma),
                    forms.product(g.minus_beta, f.gamma));
    }
  };

  Bivector y_wedge_[3][5];     // y_0 ^ y_2, y_1 ^ y_2, y_0 ^ y_1
  Bivector lead_wedge_[3][1];  // of the coefficients of r^2
};

}  // namespace exsect
