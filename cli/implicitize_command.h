// exsect implicitize FILE
#pragma once

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/implicitize_options.h"

namespace exsect::cli {

/// A curve file (planar or spatial) or a patch file. complete or incomplete. Throws UsageError, InputError or
/// OutputError before anything is written to `out`.
ExitStatus run(const ImplicitizeCommand& command, const Streams& streams);

}  // namespace exsect::cli
