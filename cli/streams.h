// What a command reads from and writes to. Internal to cli/.
#pragma once

#include <ostream>

namespace exsect::cli {

/// The streams of a run and whether a person watches `err` on a terminal.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool watched;
};

}  // namespace exsect::cli
