// The clock of one intersection: its limit, the times of its steps and its progress. Internal to solver/.
#pragma once

#include <exsect/solver/intersect.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace exsect {

/// The clock runs from the construction on. The options must outlive it.
class RunClock {
 public:
  /// Each step is this share of the progress that is reported.
  explicit RunClock(const IntersectOptions& options, double share = 1) : options_(options), share_(share) {}

  bool out_of_time() const {
    return options_.max_seconds && milliseconds_since(start_) > 1000 * *options_.max_seconds;
  }

  /// Runs the step and adds its time to work.steps[name + " ms"].
  template <class Step>
  void run(Work& work, const char* name, Step&& body) {
    const auto begin = Clock::now();
    body();
    work.steps[std::string(name) + " ms"] += milliseconds_since(begin);
    if (options_.progress) {
      progress_ += share_;
      options_.progress(std::min(progress_, 1.0), name);
    }
  }

  /// Since the construction.
  double milliseconds() const { return milliseconds_since(start_); }

 private:
  using Clock = std::chrono::steady_clock;
  static double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }

  const IntersectOptions& options_;
  double share_;
  Clock::time_point start_ = Clock::now();
  double progress_ = 0;
};

}  // namespace exsect
