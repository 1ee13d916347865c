#include "cli/batch/worker_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include "cli/batch/worker_loop.h"

namespace exsect::cli {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(std::string(what) + ": " + std::generic_category().message(errno));
}

struct Pipe {
  FileDescriptor read;
  FileDescriptor write;
};

Pipe make_pipe() {
  std::array<int, 2> ends = {};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe to a worker");
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

/// The last 300 bytes that the worker wrote to its standard error.
std::string last_message(int file) {
  constexpr off_t longest = 300;
  const off_t end = lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(end, 0, longest)), '\0');
  const ssize_t got = pread(file, text.data(), text.size(), end - static_cast<off_t>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// What the child does between fork and its loop. The signal mask is inherited: signals for the program as a
/// whole are its starter's affair.
void become_worker(pid_t starter, int messages, std::optional<std::uint64_t> max_memory) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != starter) _exit(1);
  signal(SIGPIPE, SIG_IGN);
  dup2(messages, STDOUT_FILENO);
  dup2(messages, STDERR_FILENO);
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (max_memory) limit_memory(*max_memory);
}

}  // namespace

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  reset();
  number_ = std::exchange(other.number_, -1);
  return *this;
}

void FileDescriptor::reset() {
  if (number_ >= 0) close(number_);
  number_ = -1;
}

WorkerProcess::WorkerProcess(const Work& work, std::optional<std::uint64_t> max_memory,
                             const std::vector<int>& inherited) {
  Pipe requests = make_pipe();
  Pipe results = make_pipe();
  messages_ = FileDescriptor(memfd_create("worker messages", MFD_CLOEXEC));
  if (messages_.get() < 0) fail("no file for the messages of a worker");
  void* shared = mmap(nullptr, sizeof(WorkerSlot), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) fail("no memory shared with a worker");
  slot_ = new (shared) WorkerSlot;
  const pid_t starter = getpid();
  process_ = fork();
  if (process_ < 0) {
    munmap(shared, sizeof(WorkerSlot));
    fail("no worker process");
  }
  if (process_ == 0) {
    for (const int file : inherited) close(file);
    requests.write.reset();
    results.read.reset();
    become_worker(starter, messages_.get(), max_memory);
    _exit(worker_loop(work, requests.read.get(), results.write.get(), *slot_));
  }
  requests_ = std::move(requests.write);
  results_ = std::move(results.read);
  fcntl(results_.get(), F_SETFL, O_NONBLOCK);
}

WorkerProcess::~WorkerProcess() {
  if (process_ > 0) {
    kill();
    waitpid(process_, nullptr, 0);
  }
  munmap(slot_, sizeof(WorkerSlot));
}

bool WorkerProcess::send(const std::vector<std::uint64_t>& tasks) {
  std::vector<std::uint64_t> request = {tasks.size()};
  request.insert(request.end(), tasks.begin(), tasks.end());
  tasks_.insert(tasks_.end(), tasks.begin(), tasks.end());
  // Short enough for the pipe to take it whole and at once.
  const auto size = static_cast<ssize_t>(request.size() * sizeof request[0]);
  return write(requests_.get(), request.data(), static_cast<std::size_t>(size)) == size;
}

void WorkerProcess::kill() {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

std::optional<std::vector<TaskResult>> WorkerProcess::receive() {
  std::array<char, 1 << 16> chunk;
  const ssize_t got = read(results_.get(), chunk.data(), chunk.size());
  if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) return std::nullopt;
  if (got > 0) received_.append(chunk.data(), static_cast<std::size_t>(got));
  std::vector<TaskResult> results;
  std::size_t used = 0;
  std::uint64_t head[2] = {};
  while (received_.size() - used >= sizeof head) {
    std::memcpy(head, received_.data() + used, sizeof head);
    if (received_.size() - used - sizeof head < head[1]) break;
    results.push_back({head[0], received_.substr(used + sizeof head, head[1])});
    used += sizeof head + head[1];
    tasks_.pop_front();  // results come in the order of the tasks
  }
  received_.erase(0, used);
  return results;
}

WorkerEnd WorkerProcess::wait() {
  int status = 0;
  rusage usage = {};
  while (wait4(process_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  process_ = -1;
  const std::string message = last_message(messages_.get());
  // GMP, FLINT and worker_loop say "Cannot allocate", "Unable to allocate" and "cannot allocate".
  const bool out_of_memory = message.find("allocate memory") != std::string::npos;
  std::string how = WIFSIGNALED(status) ? fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                                                      strsignal(WTERMSIG(status)))
                                        : fmt::format("ended with status {}", WEXITSTATUS(status));
  if (!message.empty()) how += ": " + message;
  return {out_of_memory, how, usage.ru_maxrss};
}

std::chrono::nanoseconds WorkerProcess::time_at_task() const {
  if (slot_->task == no_task) return std::chrono::nanoseconds(0);
  return std::chrono::steady_clock::now().time_since_epoch() - std::chrono::nanoseconds(slot_->started);
}

}  // namespace exsect::cli
