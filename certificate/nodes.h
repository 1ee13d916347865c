// Claims about nodes. Internal to certificate/.
#pragma once

#include "certificate/draft.h"

namespace exsect::cli {

/// After that: of the nodes that are no stars.
Json node_claims(Draft& draft);

}  // namespace exsect::cli
