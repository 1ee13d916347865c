// A command line as a shell reads it, for what a report says of its origin.
#pragma once

#include <string>

namespace exsect::cli {

/// "exsect intersect model.json --tolerance 1e-9": what repeats a result. The name of the program comes
/// first, options that only say where results go (--json, --svg, --report, --quiet, ...) are left out, and
/// arguments that a shell would change are quoted.
std::string shell_command(int argc, const char* const* argv);

}  // namespace exsect::cli
