// Claims about arcs. Internal to certificate/.
#pragma once

#include "certificate/draft.h"

namespace exsect::cli {

/// After that.
Json arc_claims(Draft& draft);

}  // namespace exsect::cli
