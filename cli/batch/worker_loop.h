// What a worker process does.
#pragma once

#include <cstdint>
#include <optional>

#include "cli/batch/worker_process.h"

namespace exsect::cli {

/// The child's side of WorkerProcess: reads requests (a count and so many tasks, 64 bits each) until their
/// end and writes results (task and length, 64 bits each, then the text). Returns the exit status of the
/// process.
int worker_loop(const Work& work, int requests, int results, WorkerSlot& slot) noexcept;

/// Limits the address space of this process to what it has now and `more` bytes. Nothing where that is not
/// possible.
void limit_memory(std::uint64_t more);

}  // namespace exsect::cli
