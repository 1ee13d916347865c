// exsect revolve PROFILE
#pragma once

#include <string>
#include <vector>

#include "exit_status.h"
#include "output_files.h"
#include "program.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct RevolveCommand {
  std::string file;
  std::string method;
  std::string degree;
  std::string cells;
  std::string samples = "21";
  std::string w1 = "1";
  std::string w2 = "0";
  std::string region;
  std::string mesh;
  std::string mesh_size = "48,96";
  std::string patch_file;
  std::string patch;
  std::vector<std::string> lines;
  OutputFiles output;
  bool quiet = false;
};

/// complete, or incomplete if no distance was proved or the curve on the patch has meetings that are not
/// resolved. Throws UsageError, InputError or OutputError before anything is written to `out`.
ExitStatus run(const RevolveCommand& command, const Streams& streams);

}  // namespace exsect::cli
