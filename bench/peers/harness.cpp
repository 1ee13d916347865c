#include "harness.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <iostream>
#include <vector>

namespace peers {
namespace {

using Json = nlohmann::ordered_json;

/// Of this thread: none of the programs has others, and with a limit of processor time Linux updates the
/// clock of the process at every tick only, 4 ms apart.
double processor_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The first run in a process is slower, by up to a millisecond: short ones are repeated.
double median_time(const std::function<void()>& timed) {
  constexpr double enough = 20;  // milliseconds
  constexpr std::size_t most_runs = 31;
  std::vector<double> times;
  const double start = processor_milliseconds();
  double last = start;
  do {
    timed();
    const double now = processor_milliseconds();
    times.push_back(now - last);
    last = now;
  } while (times.size() < most_runs && last - start < enough);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

Json solve(const std::function<Task()>& make) {
  Json result;
  try {
    const Task task = make();
    const double time = median_time(task.timed);
    const Json answer = task.answer();
    result["status"] = "done";
    result["milliseconds"] = time;
    result.update(answer);
  } catch (const std::exception& error) {
    result["status"] = "error";
    result["reason"] = error.what();
  }
  return result;
}

void write_all(int to, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(to, text.data() + done, text.size() - done);
    if (count <= 0) _exit(1);
    done += static_cast<std::size_t>(count);
  }
}

std::string read_all(int from) {
  std::string text;
  std::vector<char> buffer(1 << 16);
  for (ssize_t count; (count = read(from, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

/// The result of `solve` in a child process.
Json solve_apart(const std::function<Task()>& make, int seconds) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    close(ends[0]);
    dup2(STDERR_FILENO, STDOUT_FILENO);  // what a library prints is no answer
    const rlimit limit{static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds)};
    setrlimit(RLIMIT_CPU, &limit);
    write_all(ends[1], solve(make).dump());
    _exit(0);
  }
  close(ends[1]);
  const std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return Json::parse(text);
  const bool timeout = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
  return {{"status", timeout ? "timeout" : "crash"}};
}

Settings parse(int argc, char** argv) {
  Settings settings;
  const auto value = [&](int& i) -> std::string {
    if (++i == argc) throw std::invalid_argument(std::string(argv[i - 1]) + " needs a value");
    return argv[i];
  };
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--lines") {
      settings.lines = true;
    } else if (argument == "--tolerance") {
      settings.tolerance = std::stod(value(i));
    } else if (argument == "--method") {
      settings.method = value(i);
    } else if (argument == "--seconds") {
      settings.seconds = std::stoi(value(i));
    } else if (settings.pairs.empty()) {
      settings.pairs = argument;
    } else {
      throw std::invalid_argument("unknown argument " + argument);
    }
  }
  if (settings.pairs.empty()) throw std::invalid_argument("no file of pairs");
  return settings;
}

}  // namespace

int run(int argc, char** argv, const std::function<std::string(const Settings&)>& program,
        const std::function<Task(const SurfacePair&, const Settings&)>& task) {
  try {
    const Settings settings = parse(argc, argv);
    const std::string name = program(settings);
    for (const SurfacePair& pair : read_pairs(settings.pairs)) {
      Json line = {{"name", pair.name}, {"program", name}, {"tolerance", settings.tolerance}};
      line.update(solve_apart([&] { return task(pair, settings); }, settings.seconds));
      std::cout << line.dump() << std::endl;
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << "\n";
    return 2;
  }
}

}  // namespace peers
