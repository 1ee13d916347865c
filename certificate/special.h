// Stars, factors and constant parameters of a result. Internal to certificate/.
#pragma once

#include "certificate/draft.h"

namespace exsect::cli {

/// The order of the nodes.
void number_nodes(Draft& draft);
/// It, and factors, overlaps and stars of two patches.
void find_special_places(Draft& draft, const Patches& patches);

}  // namespace exsect::cli
