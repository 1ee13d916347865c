#include "cli/batch/worker_pool.h"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

namespace exsect::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Tasks = std::vector<std::uint64_t>;

/// Signals that end the work come as data, and a worker that is gone is an error of writing; everything is as
/// before afterwards.
class SignalFile {
 public:
  SignalFile() {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &pipe_before_);
    file_ = FileDescriptor(signalfd(-1, &signals_, SFD_NONBLOCK | SFD_CLOEXEC));
  }
  ~SignalFile() {
    sigaction(SIGPIPE, &pipe_before_, nullptr);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  SignalFile(const SignalFile&) = delete;
  SignalFile& operator=(const SignalFile&) = delete;

  int get() const { return file_.get(); }
  /// The next signal that came, or 0.
  int take() {
    signalfd_siginfo info = {};
    return read(get(), &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
  }

 private:
  sigset_t signals_ = {};
  sigset_t before_ = {};
  struct sigaction pipe_before_ = {};
  FileDescriptor file_;
};

class Pool {
 public:
  Pool(const PoolLimits& limits, const PoolUser& user) : limits_(limits), user_(user) {}

  PoolEnd run() {
    while (workers_.size() < limits_.workers && feed_new_worker()) {
    }
    while (!workers_.empty()) {
      wait_for_something();
      take_signals();
      for (std::size_t i = 0; i < workers_.size();) i += serve(i) ? 1 : 0;
      user_.tick();
    }
    return end_;
  }

 private:
  bool stopping() const { return end_.signal != 0; }

  /// Up to so many tasks, those to be repeated first; a repeated one is alone.
  Tasks take(std::size_t most) {
    Tasks tasks;
    if (stopping()) return tasks;
    while (tasks.size() < most) {
      if (!again_.empty()) {
        const std::uint64_t task = again_.front();
        const bool blamed = blamed_.count(task) != 0;
        if (blamed && !tasks.empty()) break;
        again_.pop_front();
        tasks.push_back(task);
        if (blamed) break;
      } else if (const std::optional<std::uint64_t> task = user_.next()) {
        tasks.push_back(*task);
      } else {
        break;
      }
    }
    return tasks;
  }

  /// A fiftieth of a second of work, so that nobody waits long for anybody in the end.
  std::size_t chunk() const {
    constexpr double seconds = 0.02;
    return static_cast<std::size_t>(std::clamp(seconds / mean_seconds_, 1.0, 64.0));
  }

  /// False if there is nothing left to do.
  bool feed_new_worker() {
    const Tasks tasks = take(chunk());
    if (tasks.empty()) return false;
    std::vector<int> inherited = {signals_.get()};
    for (const auto& worker : workers_) {
      const std::vector<int> files = worker->descriptors();
      inherited.insert(inherited.end(), files.begin(), files.end());
    }
    workers_.push_back(std::make_unique<WorkerProcess>(user_.work, limits_.max_memory, inherited));
    workers_.back()->send(tasks);
    return true;
  }

  void wait_for_something() {
    std::vector<pollfd> files = {{signals_.get(), POLLIN, 0}};
    for (const auto& worker : workers_) files.push_back({worker->results(), POLLIN, 0});
    poll(files.data(), static_cast<nfds_t>(files.size()), 100);
  }

  void take_signals() {
    while (const int signal = signals_.take()) {
      for (const auto& worker : workers_) stopping() ? worker->kill() : worker->stop();
      if (stopping()) continue;
      end_.signal = signal;
      stopped_ = Clock::now();
    }
    if (stopping() && Clock::now() - stopped_ > std::chrono::seconds(1)) {
      for (const auto& worker : workers_) worker->kill();
    }
  }

  /// Takes results and sends tasks; false if the worker is gone, and no longer among the workers.
  bool serve(std::size_t i) {
    WorkerProcess& worker = *workers_[i];
    const std::optional<std::vector<TaskResult>> results = worker.receive();
    if (!results) {
      bury(i);
      return false;
    }
    for (const TaskResult& result : *results) user_.done(result);
    count(results->size());
    if (limits_.max_time && worker.time_at_task() > *limits_.max_time && !worker.idle()) {
      out_of_time_.insert(worker.current_task());
      worker.kill();
    } else if (!worker.finishing() && worker.tasks().size() <= chunk() / 2) {
      const Tasks tasks = take(chunk());
      if (!tasks.empty())
        worker.send(tasks);
      else if (worker.idle())
        worker.finish();
    }
    return true;
  }

  void count(std::size_t done) {
    if (done == 0) return;
    early_ends_ = 0;
    done_ += done;
    const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    mean_seconds_ = std::max(seconds * limits_.workers / static_cast<double>(done_), 1e-6);
  }

  void bury(std::size_t i) {
    const std::unique_ptr<WorkerProcess> worker = std::move(workers_[i]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    const WorkerEnd end = worker->wait();
    end_.peak_kib = std::max(end_.peak_kib, end.peak_kib);
    if (stopping() || worker->idle()) return;
    const std::uint64_t at = worker->current_task();
    for (auto task = worker->tasks().rbegin(); task != worker->tasks().rend(); ++task) {
      if (*task != at) again_.push_front(*task);
    }
    if (std::find(worker->tasks().begin(), worker->tasks().end(), at) != worker->tasks().end()) {
      blame(at, end);
    } else if (++early_ends_ > 3) {
      throw std::runtime_error("workers end before their first task: the last one " + end.how);
    }
    feed_new_worker();
  }

  void blame(std::uint64_t task, const WorkerEnd& end) {
    if (out_of_time_.erase(task) != 0) {
      user_.lost(task, "took too long and was given up");
    } else if (blamed_.insert(task).second) {
      again_.push_front(task);
      return;
    } else {
      user_.lost(task,
                 end.out_of_memory ? "ran out of memory" : "lost its worker twice: the last one " + end.how);
    }
    blamed_.erase(task);
  }

  PoolLimits limits_;
  const PoolUser& user_;
  SignalFile signals_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::deque<std::uint64_t> again_;      // tasks whose worker ended before their result
  std::set<std::uint64_t> blamed_;       // those that it ended at
  std::set<std::uint64_t> out_of_time_;  // whose worker was ended for it
  Clock::time_point begun_ = Clock::now();
  Clock::time_point stopped_;
  std::uint64_t done_ = 0;
  double mean_seconds_ = 0.001;
  int early_ends_ = 0;
  PoolEnd end_;
};

}  // namespace

PoolEnd run_pool(const PoolLimits& limits, const PoolUser& user) { return Pool(limits, user).run(); }

}  // namespace exsect::cli
