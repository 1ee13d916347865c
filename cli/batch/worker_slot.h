// What a worker process and the program that started it know of each other without a message.
#pragma once

#include <atomic>
#include <cstdint>

namespace exsect::cli {

inline constexpr std::uint64_t no_task = ~std::uint64_t{0};

/// Lies in memory that both processes share. The worker says which task it is at and since when
/// (nanoseconds of the steady clock); the program asks it to stop after that task.
struct WorkerSlot {
  std::atomic<std::uint64_t> task{no_task};
  std::atomic<std::int64_t> started{0};
  std::atomic<bool> stop{false};
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

}  // namespace exsect::cli
