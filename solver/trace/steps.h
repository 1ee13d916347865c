// How long the steps of the tracers are, in one table by what they follow. Internal to solver/.
#pragma once

#include <cstddef>

namespace exsect {

/// Steps are lengths in the parameter along which a tube is a graph. They are chosen to end near the
/// contraction `good`; a tube with one above `worst` is not used.
struct Steps {
  double first;
  double least;         // in doubles: below it the numbers are too rough for what is followed
  double least_of_two;  // in sums of two doubles
  double longest;
  double good;
  double worst;
  std::size_t most_pieces;
};

inline constexpr Steps kPairSteps = {0.1, 0x1p-40, 0x1p-70, 0.5, 0.25, 0.5, 200000};
/// The tubes of contact curves have no larger contraction than `worst`.
inline constexpr Steps kContactSteps = {0.1, 0x1p-30, 0x1p-30, 0.25, 0.3, 0.5, 20000};
/// Of curves in the charts of one patch; the least step is a small part of w, if that is less.
inline constexpr Steps kChartSteps = {0x1p-6, 0x1p-24, 0x1p-24, 0.25, 0.25, 0.5, 2000};
/// Of round surfaces, as lengths in units of their size.
inline constexpr Steps kRoundSteps = {0x1p-3, 0x1p-24, 0x1p-24, 0.5, 0.3, 0.5, 4000};
/// Of an equation on a patch, whose parameters run from -1 to 1.
inline constexpr Steps kSectionSteps = {0x1p-3, 0x1p-24, 0x1p-24, 0.5, 0.3, 0.5, 4000};
/// Of the filter, whose tubes have error bounds that do not shrink with them.
inline constexpr Steps kFilterSteps = {0x1p-3, 0x1p-30, 0x1p-30, 0.5, 0.2, 0.32, 2000};

}  // namespace exsect
