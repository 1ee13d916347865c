// The options of exsect revolve as values.
#pragma once

#include <exsect/geometry/patch_file.h>

#include <string>
#include <vector>

#include "output/options/output_files.h"
#include "output/text/revolution_output.h"

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

/// The options of the method as values. Throws UsageError for unknown names and numbers out of range.
RevolveOptions revolve_options(const RevolveCommand& command);

/// The surface on a patch, and the exact points on the lines u = const whose values `lines` are as texts.
/// Throws UsageError for a spline and for values outside of [0,1].
ShownRevolutionPatch shown_on_patch(const std::vector<std::string>& lines, const Revolution& revolution,
                                    const NamedPatch& patch);

}  // namespace exsect::cli
