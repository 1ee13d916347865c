// Pairs at which the curves of a self-intersection are cut. Internal to solver/; docs/method.md, section 6.3.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "self/curves.h"

namespace exsect {

/// A pair x(u1,v1) = x(u2,v2) of different points at which the curves are to be cut; each once.
struct PairCut {
  CertifiedPoint at;                     // `sides` are those of the patch's own square
  std::optional<std::size_t> exchanged;  // the number of the same pair in the other order, if that is a cut
  std::function<std::array<bool, 4>()> zero_tangent;  // components of T that are known to vanish there
};

/// Where a cut is found: at a landmark, or at the centre of a star.
struct CutPlace {
  std::optional<std::size_t> star;
  std::size_t landmark;
  bool exchanged;                  // the pair there is the cut's in the other order
  std::vector<Parameter> turning;  // of the pair there, ascending: the curve turns in them in its inside
};

/// Cuts the traces: appends to them, and to the landmarks. The places of every cut; empty if one of them
/// could not be found, or not be told apart from a turning point or another cut. A turning point that is a
/// cut is no turning point any more. `width`: of the boxes around
/// exact points.
template <class Ball>
std::optional<std::vector<std::vector<CutPlace>>> cut_curves(SelfCurves<Ball>& found,
                                                             const ExactPlaces& exact,
                                                             const std::vector<PairCut>& cuts,
                                                             const Rational& width);

}  // namespace exsect
