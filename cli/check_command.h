// exsect check CERTIFICATE
#pragma once

#include <string>

#include "cli/exit_status.h"
#include "cli/streams.h"

namespace exsect::cli {

/// The options as they stand on the command line; empty where not given.
struct CheckCommand {
  std::string file;
  std::string json;
  bool quiet = false;
};

/// complete if the certificate is accepted, negative if it is rejected. Throws InputError for what is no
/// certificate, UsageError or OutputError.
ExitStatus run(const CheckCommand& command, const Streams& streams);

}  // namespace exsect::cli
