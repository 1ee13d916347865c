// How a caller bounds the work. Internal to solver/.
#pragma once

#include <functional>

namespace exsect {

/// Returns true when the work must stop. It may be empty: never.
using StopRequest = std::function<bool()>;

inline bool is_stopped(const StopRequest& stop) { return stop && stop(); }

}  // namespace exsect
