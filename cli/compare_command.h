// exsect compare FILE
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct CompareCommand {
  std::string file;
  std::string first;
  std::string second;
  std::string lines = "64";
  std::string fit = "conics";
  std::string pieces = "2";
  std::string plane = "u,r";
  OutputFiles output;
  bool quiet = false;
};

/// complete, or incomplete if parameter lines or resultant give no complete answer. Throws UsageError,
/// InputError or OutputError before anything is written to `out`.
ExitStatus run(const CompareCommand& command, const Streams& streams);

}  // namespace exsect::cli
