// exsect implicitize FILE
#pragma once

#include <string>

#include "exit_status.h"
#include "output_files.h"
#include "program.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct ImplicitizeCommand {
  std::string file;
  std::string patch;
  std::string method;
  std::string degree;
  std::string space;
  std::string cells;
  std::string samples;
  std::string w1;
  std::string w2;
  std::string digits;
  std::string box;
  std::string variables;
  std::string axis;
  std::string factor_degree;
  std::string epsilon;
  bool exact_arithmetic = false;
  OutputFiles output;
  bool quiet = false;
};

/// A curve file (planar or spatial) or a patch file. complete or incomplete. Throws UsageError, InputError or
/// OutputError before anything is written to `out`.
ExitStatus run(const ImplicitizeCommand& command, const Streams& streams);

}  // namespace exsect::cli
