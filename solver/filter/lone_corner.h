// The proof in rational numbers that two patches meet near a common corner in the corner alone, where planes
// through it touch their nets. Internal to solver/; docs/method-doubles.md, section 14.7.
#pragma once

#include "filter/corner_contact.h"
#include "filter/exact_patch.h"

namespace exsect::filter {

/// Places of a square, counted from one of its corners: bit 3 i + j for the first parameter 0 (i = 0),
/// between 0 and 1 (1), or 1 (2), and the second one likewise.
using SquarePlaces = unsigned;
inline constexpr SquarePlaces kCornerPlace = 1;
inline constexpr SquarePlaces kAllPlaces = 0777;
/// The side where that parameter is 0.
constexpr SquarePlaces side_places(std::size_t parameter) { return parameter == 0 ? 07 : 0111; }

/// Homogeneous control points, counted from the corner, of a patch one point of which is the origin, and the
/// places that are that point of space, all of which are on sides.
struct CornerNet {
  ControlVectors points;
  SquarePlaces own;
};

/// About this corner, or pole, which is moved to the origin.
template <class K>
CornerNet corner_net(const ExactPatch<K>& patch, std::size_t corner, const std::optional<SquareSide>& pole);

/// True only if x = y on both squares at pairs of `own` places alone, (14.14a). Requires x = y = 0 there.
bool meet_in_own_places(const CornerNet& x, const CornerNet& y);

/// The greatest 2^-k, k not too large, so that the parts [0, 2^-k]^2 counted from the corner, or from its
/// pole's side, of both patches meet in the corner, or its pole, alone; 0 if that is not proved for any.
template <class K>
double lone_reach(const ExactPatch<K>& x, const ExactPatch<K>& y, const CornerContact& corner);

}  // namespace exsect::filter
