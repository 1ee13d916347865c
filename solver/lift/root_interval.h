// Intervals around all real roots of polynomials. Internal to solver/.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

namespace exsect {

/// Greater than every root in absolute value, complex ones too: a power of 2, less than 8 times Fujiwara's
/// bound. Requires f != 0.
Rational above_all_roots(const Polynomial& f);

/// The closed interval from the least to the greatest of the real roots and the other numbers, and beyond, by
/// half its length or by `room` > 0; about 0 if there is none. Constants have no roots.
RationalInterval interval_around(const std::vector<Polynomial>& polynomials, std::vector<Rational> others,
                                 const Rational& room);

/// An interval around all roots that is not much longer than their distances, whatever the unit.
RationalInterval fitted_interval(const std::vector<Polynomial>& polynomials);

}  // namespace exsect
