// Whether patches seem to be pieces of one surface, and in which parameters. Internal to solver/;
// docs/method-doubles.md, section 14.15.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "answer/parameter_names.h"
#include "answer/proof.h"
#include "filter/patch.h"

namespace exsect::filter {

/// Whether a point of y was found on x, inside the square or not, at which each of y's parameters changes one
/// of x's, in doubles: so it is where y is x in other parameters, each a function of one of x. A guess:
/// pieces may be missed, and not all that seem to be some are.
template <class K>
bool seem_to_be_pieces(const PairOf<K>& pair);

/// The k and l, not both 1, for which y as a patch of r' and s', r = r' / (k (1 - r') + r') and s = s' / (l
/// (1 - s') + s'), seems to have affine functions of x's parameters: where y is x in other parameters, each a
/// Moebius map of one of x. A guess: nothing is proved, and nothing depends on it.
template <class K>
std::optional<std::array<Rational, 2>> parameter_ratios(const PairOf<K>& pair, const ExactPatch<K>& x,
                                                        const ExactPatch<K>& y) requires K::weighted;

/// The patch of r' and s' (14.42): the same surface. Requires k, l > 0.
template <class K>
ElevatedPatch<K> in_other_parameters(const ElevatedPatch<K>& patch, const std::array<Rational, 2>& ratios);

/// With y in parameters in which it may be an affine piece of x: whatever these are, the same question. What
/// `solve` finds of x and that patch, in the parameters of y; empty if there are no such ones, or it finds
/// nothing.
template <class K, class Solve>
std::optional<IntersectResult> in_affine_parameters(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                    const PairOf<K>& pair, const Run& run,
                                                    const Solve& solve) {
  if constexpr (!K::weighted) {
    return std::nullopt;
  } else {
    const auto ratios = parameter_ratios(pair, x, y);
    if (!ratios) return std::nullopt;
    std::optional<IntersectResult> result = solve(in_other_parameters<K>(y, *ratios));
    if (!result) return std::nullopt;
    return changed(*std::move(result), run, [ratios](IntersectResult& other, const Run&) {
      change_parameter(other, Parameter::r, (*ratios)[0]);
      change_parameter(other, Parameter::s, (*ratios)[1]);
    });
  }
}

}  // namespace exsect::filter
