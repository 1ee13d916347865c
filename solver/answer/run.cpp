#include "answer/run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace exsect {

namespace {

/// Polylines finer than this are not made.
constexpr double kFinestTolerance = 0x1p-36;

/// How much of what is left each step is in the progress that is reported: how many follow is not known.
constexpr double kShare = 0.25;

double milliseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

Run::Run(const IntersectOptions& options)
    : turning_(options.turning),
      tolerance_(options.tolerance),
      call_(std::make_shared<Call>(Call{options, Clock::now(), 0, {}})) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw std::invalid_argument("tolerance must be a positive finite number");
  }
  if (options.max_seconds && !(*options.max_seconds > 0)) {
    throw std::invalid_argument("max_seconds must be positive");
  }
}

Run Run::with_turning(std::vector<Parameter> turning) const {
  Run part = *this;
  part.turning_ = std::move(turning);
  return part;
}

Run Run::with_tolerance(double tolerance) const {
  Run part = *this;
  part.tolerance_ = tolerance;
  return part;
}

bool Run::exact() const { return call_->options.exact; }

double Run::drawn_tolerance(double extent) const { return std::max(tolerance_, kFinestTolerance) * extent; }

bool Run::Call::is_over() const {
  return options.max_seconds && milliseconds(Clock::now() - start) > 1000 * *options.max_seconds;
}

void Run::add_time(const char* name, Clock::duration time) const {
  call_->work.steps[std::string(name) + " ms"] += milliseconds(time);
  if (call_->options.progress) {
    call_->progress += kShare * (1 - call_->progress);
    call_->options.progress(call_->progress, name);
  }
}

IntersectResult Run::finished(IntersectResult result) const {
  result.status = result.incomplete.empty() ? Status::complete : Status::incomplete;
  result.work = call_->work;
  result.work.milliseconds = milliseconds(Clock::now() - call_->start);
  if (call_->options.progress) {
    call_->progress = 1;
    call_->options.progress(1, "end");
  }
  return result;
}

}  // namespace exsect
