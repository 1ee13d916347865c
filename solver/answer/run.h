// One call of intersect() or self_intersect(): what it asks for, and the one clock, work cap, progress and
// work record of all its stages. Internal to solver/.
#pragma once

#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "answer/stop_request.h"

namespace exsect {

/// Copies belong to the same call: they share its clock and its record. Invariant: the options are in range.
class Run {
 public:
  /// Starts the clock. Throws std::invalid_argument for a tolerance or time that is not positive, or a
  /// tolerance that is infinite.
  Run(const IntersectOptions& options = {});

  /// A part of the call's work, with other turning points as nodes or another tolerance (> 0, relative).
  Run with_turning(std::vector<Parameter> turning) const;
  Run with_tolerance(double tolerance) const;

  const std::vector<Parameter>& turning() const { return turning_; }
  bool exact() const;

  /// The tolerance that is asked for, as a length in a model of this extent.
  double tolerance(double extent) const { return tolerance_ * extent; }
  /// The one that polylines are made to keep: not below 2^-36 of the extent, since vertices are doubles.
  double drawn_tolerance(double extent) const;

  bool out_of_time() const { return call_->is_over(); }
  StopRequest stop() const {
    return [call = call_] { return call->is_over(); };
  }

  /// Runs the step and adds its time to the record, as "<name> ms".
  template <class Step>
  void timed(const char* name, Step&& body) const {
    const auto begin = Clock::now();
    body();
    add_time(name, Clock::now() - begin);
  }
  /// Adds to the record.
  void count(const char* name, double amount) const { call_->work.steps[name] += amount; }
  /// Adds all the time since the start.
  void add_time_until_now(const char* name) const { add_time(name, Clock::now() - call_->start); }

  /// The call's result: with its status and the record. Reports the end.
  IntersectResult finished(IntersectResult result) const;

 private:
  using Clock = std::chrono::steady_clock;

  struct Call {
    IntersectOptions options;
    Clock::time_point start;
    double progress;
    Work work;

    bool is_over() const;
  };

  void add_time(const char* name, Clock::duration time) const;

  std::vector<Parameter> turning_;
  double tolerance_;
  std::shared_ptr<Call> call_;
};

}  // namespace exsect
