// The progress line on a terminal.
#pragma once

#include <chrono>
#include <ostream>

namespace exsect::cli {

/// Shows how far the work is on one line that is written over, from the first second on and at most ten times
/// a second, and wipes the line in the end. Shows nothing if it is not `shown`.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  Progress(std::ostream& stream, bool shown, Clock::duration delay = std::chrono::seconds(1))
      : stream_(stream), shown_(shown), next_(Clock::now() + delay) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A fraction in [0,1] and the name of the step.
  void report(double fraction, const char* step);

 private:
  std::ostream& stream_;
  bool shown_;
  bool on_screen_ = false;
  Clock::time_point next_;
};

}  // namespace exsect::cli
