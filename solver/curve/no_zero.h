// A proof that a polynomial has no zero on an interval. Internal to solver/.
#pragma once

#include <exsect/algebra/bernstein.h>

#include <algorithm>

namespace exsect {

/// True only if f has no zero on the closed interval: Bernstein coefficients of one sign, end points not
/// zero.
inline bool has_no_zero(const Polynomial& f, const RationalInterval& on) {
  if (on.lower == on.upper) return f.sign_at(on.lower) != 0;
  const std::vector<Rational> b = bernstein_coefficients(f, std::max(f.degree(), 0), on.lower, on.upper);
  return sign_variations(b) == 0 && b.front() != 0 && b.back() != 0;
}

}  // namespace exsect
