// Where a search in doubles ends undecided. Internal to solver/.
#pragma once

#include <exsect/solver/result.h>

#include "filter/tube.h"

namespace exsect::filter {

/// Without a graph: a small box around the place (centred), or around the solution on a side next to it, with
/// the reason and a word about what is there, approximately; and all of the domain for what has not been
/// searched.
template <class K>
IntersectResult ended_at(const PairOf<K>& pair, const Vec4& searched);

}  // namespace exsect::filter
