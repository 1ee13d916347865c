// One worker process: a fork of the program that does tasks and sends their results back through a pipe.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/batch/worker_slot.h"

namespace exsect::cli {

/// Does a task, in a worker process; the text of its result. An exception ends the worker.
using Work = std::function<std::string(std::uint64_t task)>;

/// A pipe's end or an open file, closed in the end.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { reset(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;

  int get() const { return number_; }
  void reset();

 private:
  int number_ = -1;
};

/// How a worker ended.
struct WorkerEnd {
  bool out_of_memory;
  std::string how;  // "was ended by signal 9 (Killed)"
  long peak_kib;    // largest resident memory, with what it shares
};

struct TaskResult {
  std::uint64_t task;
  std::string text;
};

/// A running worker. It ends when this object does, when its starter ends, or after an exception.
class WorkerProcess {
 public:
  /// Forks. The child closes `inherited`, allows itself `max_memory` bytes of address space more than it
  /// begins with, and does what it is sent. Throws std::runtime_error if no process can be made.
  WorkerProcess(const Work& work, std::optional<std::uint64_t> max_memory, const std::vector<int>& inherited);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Sends tasks; they stay in tasks() until their results have come. False if the worker is gone.
  bool send(const std::vector<std::uint64_t>& tasks);
  /// Tells the worker that no more tasks come: it ends when it has done what it has.
  void finish() { requests_.reset(); }
  bool finishing() const { return requests_.get() < 0; }
  /// Asks it to end after the task that it is at.
  void stop() { slot_->stop = true; }
  void kill();

  /// Readable when results have come or the worker is gone.
  int results() const { return results_.get(); }
  /// What has come since the last call; nothing once the worker is gone.
  std::optional<std::vector<TaskResult>> receive();
  /// Waits for the process, after receive() gave nothing.
  WorkerEnd wait();

  const std::deque<std::uint64_t>& tasks() const { return tasks_; }
  /// The task that the worker is at, or no_task; how long it has been at it.
  std::uint64_t current_task() const { return slot_->task; }
  std::chrono::nanoseconds time_at_task() const;
  bool idle() const { return tasks_.empty(); }
  /// The descriptors that a further child must close.
  std::vector<int> descriptors() const { return {requests_.get(), results_.get(), messages_.get()}; }

 private:
  WorkerSlot* slot_ = nullptr;
  FileDescriptor requests_;
  FileDescriptor results_;
  FileDescriptor messages_;  // what the worker wrote to its standard error
  pid_t process_ = -1;
  std::deque<std::uint64_t> tasks_;
  std::string received_;
};

}  // namespace exsect::cli
