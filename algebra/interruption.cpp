#include "interruption.h"

#include <utility>

namespace exsect {

namespace {

thread_local const InterruptionScope* innermost = nullptr;

}  // namespace

InterruptionScope::InterruptionScope(std::function<bool()> stop)
    : stop_(std::move(stop)), outer_(std::exchange(innermost, this)) {}

InterruptionScope::~InterruptionScope() { innermost = outer_; }

void interruption_point() {
  if (innermost != nullptr && innermost->stop_ && innermost->stop_()) throw Interrupted();
}

}  // namespace exsect
