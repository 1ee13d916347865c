// Directions of a tube's arc from the exact control points, where doubles leave them open. Internal to
// solver/; docs/method-doubles.md, section 14.5.
#pragma once

#include <functional>

#include "filter/tube_direction.h"

namespace exsect::filter {

/// The direction of a tube's arc at an offset.
template <class K>
using DirectionSource = std::function<Direction<K>(const TubeOf<K>&, double)>;

/// As direction_at(), but the error is that of rational numbers rounded once, if all of the ball of
/// point_at() can be handled; otherwise the same. The scale of weighted patches has direction_at()'s middle,
/// for which the error does not hold. The source has copies of the patches, not of the pair.
template <class K>
DirectionSource<K> exact_directions(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair);

}  // namespace exsect::filter
