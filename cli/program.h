// The program exsect without its main.
#pragma once

#include <ostream>

namespace exsect::cli {

/// The streams of a run and whether a person watches `err` on a terminal.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool watched;
};

/// Runs the command line and returns its exit status (exit_status.h). No exception leaves it; every failure
/// is one message on `err` that begins with "exsect: ", with nothing on `out`.
int run(int argc, const char* const* argv, const Streams& streams);

}  // namespace exsect::cli
