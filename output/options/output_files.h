// Where results go: files that are checked before the work starts and written whole after it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace exsect::cli {

/// A bad command line; what() names the option and the reason.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Paths of files for other tools, given by --obj, --ply, --vtp and --csv; empty where the option is not
/// given. `grid`: cells of the sampled patches along each side.
struct ExportFiles {
  std::string obj;
  std::string ply;
  std::string vtp;
  std::string csv;
  std::string grid = "32";
};

/// Paths given by --json, --svg, --report and --certificate; empty where the option is not given. "-" is the
/// standard output, for JSON only. `line` is the command line as a report shows it (shell_command.h).
struct OutputFiles {
  std::string json;
  std::string svg;
  std::string report;
  std::string certificate;
  ExportFiles exports;
  std::string line;

  bool json_to_stdout() const { return json == "-"; }
};

/// Throws UsageError if a path is a directory, lies in a directory that does not exist or may not be written,
/// is the input file, or if two are one file.
void check(const OutputFiles& files, const std::string& input);

/// The same for the one file of a batch, which must be a regular file or not there yet.
void check_output(const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

}  // namespace exsect::cli
