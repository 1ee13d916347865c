// Bivectors of R^4 in any arithmetic, for the fibres of patches with weights. Internal to solver/.
#pragma once

#include "eliminant/fibre_resultants.h"

namespace exsect {

template <class Field, class Kind>
class HomogeneousForms : public FibreResultants<Field, Kind> {
  using Base = FibreResultants<Field, Kind>;

 public:
  using Base::Base;
  using typename Base::Residue;
  using typename Base::Sum;
  using typename Base::Vector;

 protected:
  using Base::field_;

  /// The minors of indices 01, 02, 03, 12, 13, 23.
  struct Bivector {
    Residue c[6];
  };
  Bivector wedge(const Vector& a, const Vector& b) const {
    return {{this->minor(a, b, 0, 1), this->minor(a, b, 0, 2), this->minor(a, b, 0, 3),
             this->minor(a, b, 1, 2), this->minor(a, b, 1, 3), this->minor(a, b, 2, 3)}};
  }
  Bivector negated(const Bivector& p) const {
    Bivector result;
    for (std::size_t k = 0; k < 6; ++k) result.c[k] = field_.negate(p.c[k]);
    return result;
  }
  /// f ^ g for vectors of polynomials in s.
  template <std::size_t n>
  void set_wedge(Bivector (&result)[2 * n - 1], const Vector (&f)[n], const Vector (&g)[n]) const {
    for (std::size_t d = 0; d < n; ++d)
      for (std::size_t e = 0; e < n; ++e) {
        const Bivector term = wedge(f[d], g[e]);
        const bool first = d == 0 || e == n - 1;  // of the terms of degree d + e
        for (std::size_t k = 0; k < 6; ++k)
          result[d + e].c[k] = first ? term.c[k] : field_.add(result[d + e].c[k], term.c[k]);
      }
  }
  /// p.q, the determinant of the four vectors.
  Residue pairing(const Bivector& p, const Bivector& minus_p, const Bivector& q) const {
    Sum sum(p.c[0], q.c[5]);
    sum.add(minus_p.c[1], q.c[4]);
    sum.add(p.c[2], q.c[3]);
    sum.add(p.c[3], q.c[2]);
    sum.add(minus_p.c[4], q.c[1]);
    sum.add(p.c[5], q.c[0]);
    return field_.reduce(sum);
  }
};

}  // namespace exsect
