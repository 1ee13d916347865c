// What a report says about where its result comes from.
#pragma once

#include <string>
#include <vector>

namespace exsect::cli {

/// An input file: its path as it was given and the SHA-256 of its bytes; no hash where the path is no regular
/// file, such as a pipe.
struct ReportInput {
  std::string file;
  std::string sha256 = {};
};

/// Any part may be empty; all may hold any characters.
struct ReportOrigin {
  std::string title = {};    // of the patches, as in their file
  std::string file = {};     // the file that is shown under the title
  std::string command = {};  // the command line that repeats the result
  std::vector<ReportInput> inputs = {};
};

/// The origin of a result of the program: `file` is the first of `inputs`, whose bytes are read for their
/// hashes. A file that can no longer be read has no hash.
ReportOrigin origin_of(const std::string& title, const std::string& command,
                       const std::vector<std::string>& inputs);

}  // namespace exsect::cli
