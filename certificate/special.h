// Stars, factors and constant parameters of a result. Internal to certificate/.
#pragma once

#include "certificate/draft.h"

namespace exsect::cli {

/// Factors, overlaps and stars, and the order of the nodes.
void find_special_places(Draft& draft);

}  // namespace exsect::cli
