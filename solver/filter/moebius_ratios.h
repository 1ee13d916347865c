// The ratios of Moebius maps between the parameters of pieces of one surface. Internal to solver/;
// docs/method-doubles.md, section 14.15.
#pragma once

#include <exsect/algebra/rational.h>

#include <array>
#include <optional>

#include "filter/exact_patch.h"
#include "filter/place_on_patch.h"

namespace exsect::filter {

/// The k and l of (14.42) if y is x in other parameters, each a Moebius map of one of x: y at `on_y` is x
/// near `on_x` (both centred), and with the first parameter of y the one of x with index `with_first`
/// changes. Empty if the point is not found, or the ratios are no rational numbers of at most some eighty
/// digits. A guess to some 180 digits: nothing is proved.
template <class K>
std::optional<std::array<Rational, 2>> moebius_ratios(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                      const Place& on_x, const Place& on_y,
                                                      std::size_t with_first) requires K::weighted;

}  // namespace exsect::filter
