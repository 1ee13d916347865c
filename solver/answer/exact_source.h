// Points given by fractions at a triangular set, as certified points. Internal to solver/.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/certified_point.h>

#include <vector>

namespace exsect {

/// A closed interval of width at most `width` around parameter j.
RationalInterval enclosure(const ExactParameters& exact, std::size_t j, const Rational& width);

/// The point, given the sides it lies on: inside a box of width 2^-100, no fibre's multiplicity or branch.
CertifiedPoint certified(ExactParameters exact, const std::vector<Side>& sides);

/// True only if parameter j of the point is this number.
bool takes_value(const ExactParameters& exact, std::size_t j, const RealAlgebraic& value);

/// Parameters j and j + 2 are the same number.
bool agree(const ExactParameters& exact, std::size_t j);

}  // namespace exsect
