// Many tasks done by worker processes, so that a task that crashes or grows loses itself alone.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "cli/batch/worker_process.h"

namespace exsect::cli {

struct PoolLimits {
  unsigned workers = 1;                     // >= 1
  std::optional<std::uint64_t> max_memory;  // bytes that a worker may take beyond what it starts with
  std::optional<std::chrono::nanoseconds> max_time;  // a task that takes longer is given up
};

/// What the pool asks and tells its user, all in the program's own process.
struct PoolUser {
  /// The next task, or nothing when there is none left.
  std::function<std::optional<std::uint64_t>()> next;
  Work work;  // in a worker
  std::function<void(TaskResult)> done;
  /// The task has no result: why, as an end of the sentence "the pair ...".
  std::function<void(std::uint64_t task, const std::string& why)> lost;
  /// Called at least ten times a second.
  std::function<void()> tick;
};

struct PoolEnd {
  int signal = 0;     // the one that stopped the work early; 0: all tasks are done or lost
  long peak_kib = 0;  // of the largest worker
};

/// Does all tasks. A task whose worker ends is given to a new worker, alone and once; if that one ends too,
/// the task is lost. So is one that exceeds the time. SIGINT, SIGTERM and SIGHUP end the work: each worker
/// finishes its task if that takes less than a second (a second signal does not wait), and what has come is
/// given to `done`. Throws std::runtime_error if workers cannot be started or all end at once.
PoolEnd run_pool(const PoolLimits& limits, const PoolUser& user);

}  // namespace exsect::cli
