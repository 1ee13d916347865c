// How long exact computations are given up when the time of a call is over.
#pragma once

#include <functional>
#include <stdexcept>

namespace exsect {

/// Thrown by `interruption_point`.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("the work was interrupted") {}
};

/// While it lives, each `interruption_point` of the same thread asks `stop`, which returns true when the work
/// is to end; it may be empty, which is never. Scopes nest: the innermost one alone is asked.
class InterruptionScope {
 public:
  explicit InterruptionScope(std::function<bool()> stop);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

 private:
  std::function<bool()> stop_;
  const InterruptionScope* outer_;

  friend void interruption_point();
};

/// Throws Interrupted if the work is to end; nothing outside a scope. For loops whose number of steps, or the
/// length of whose numbers, grows with the heights of the input: a step of a bisection, a prime of a modular
/// result. The caller's objects have to be as before when it passes.
void interruption_point();

}  // namespace exsect
