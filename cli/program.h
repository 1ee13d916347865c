// The program exsect without its main.
#pragma once

#include "cli/streams.h"

namespace exsect::cli {

/// Runs the command line and returns its exit status (exit_status.h). No exception leaves it; every failure
/// is one message on `err` that begins with "exsect: ", with nothing on `out`.
int run(int argc, const char* const* argv, const Streams& streams);

}  // namespace exsect::cli
