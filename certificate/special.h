// Stars, factors and constant parameters of a result. Internal to certificate/.
#pragma once

#include "certificate/draft.h"

namespace exsect::cli {

/// The order of the nodes, factors, overlaps and stars.
void find_special_places(Draft& draft, const SingularSearch& search);

}  // namespace exsect::cli
