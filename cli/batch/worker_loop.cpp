#include "cli/batch/worker_loop.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <vector>

namespace exsect::cli {
namespace {

using WorkerClock = std::chrono::steady_clock;

/// False at the end of the pipe.
bool read_all(int file, void* data, std::size_t size) {
  for (char* to = static_cast<char*>(data); size > 0;) {
    const ssize_t got = read(file, to, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send_all(int file, const std::string& text) {
  for (std::size_t had = 0; had < text.size();) {
    const ssize_t put = write(file, text.data() + had, text.size() - had);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return false;
    had += static_cast<std::size_t>(put);
  }
  return true;
}

/// Results on their way: they are sent in pieces, since a message a result would cost as much as a simple
/// task.
class Results {
 public:
  explicit Results(int file) : file_(file) {}

  bool add(std::uint64_t task, const std::string& text) {
    const std::uint64_t head[2] = {task, text.size()};
    waiting_.append(reinterpret_cast<const char*>(head), sizeof head);
    waiting_ += text;
    const bool due =
        waiting_.size() > (1 << 15) || WorkerClock::now() - sent_ > std::chrono::milliseconds(20);
    return !due || send();
  }
  bool send() {
    const bool sent = send_all(file_, waiting_);
    waiting_.clear();
    sent_ = WorkerClock::now();
    return sent;
  }

 private:
  int file_;
  std::string waiting_;
  WorkerClock::time_point sent_ = WorkerClock::now();
};

bool do_tasks(const Work& work, const std::vector<std::uint64_t>& tasks, Results& results, WorkerSlot& slot) {
  for (const std::uint64_t task : tasks) {
    slot.started = WorkerClock::now().time_since_epoch().count();
    slot.task = task;
    const bool sent = results.add(task, work(task));
    slot.task = no_task;
    if (!sent || slot.stop) return false;
  }
  return true;
}

}  // namespace

int worker_loop(const Work& work, int requests, int results_file, WorkerSlot& slot) noexcept {
  try {
    Results results(results_file);
    std::uint64_t count = 0;
    bool going = true;
    while (going && read_all(requests, &count, sizeof count)) {
      std::vector<std::uint64_t> tasks(count);
      going = read_all(requests, tasks.data(), count * sizeof count) && do_tasks(work, tasks, results, slot);
      if (!results.send()) return 1;
    }
    return 0;
  } catch (const std::bad_alloc&) {
    std::fputs("cannot allocate memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}

void limit_memory(std::uint64_t more) {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(file >> pages)) return;
  const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  rlimit limit = {};
  if (getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(pages * page + more, limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
}

}  // namespace exsect::cli
