// The largest resident memory of this process, as far as the system tells.
#pragma once

#include <optional>

namespace exsect::cli {

/// Starts a new measurement where the system can (Linux), so that what came before does not count.
void reset_peak_memory();
/// Kibibytes since the last reset; nothing where the system does not tell.
std::optional<long> peak_memory_kib();

}  // namespace exsect::cli
