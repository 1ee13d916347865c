#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace exsect::cli {
namespace {

constexpr const char* wipe = "\r\x1b[K";

}  // namespace

Progress::~Progress() {
  if (on_screen_) stream_ << wipe << std::flush;
}

void Progress::report(double fraction, const char* step) {
  if (!shown_ || Clock::now() < next_) return;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  stream_ << wipe << fmt::format("exsect: {:3d} % {}", percent, step) << std::flush;
  on_screen_ = true;
  next_ = Clock::now() + std::chrono::milliseconds(100);
}

}  // namespace exsect::cli
