// exsect revolve PROFILE
#pragma once

#include "cli/exit_status.h"
#include "cli/streams.h"
#include "output/options/revolve_options.h"

namespace exsect::cli {

/// complete, or incomplete if no distance was proved or the curve on the patch has meetings that are not
/// resolved. Throws UsageError, InputError or OutputError before anything is written to `out`.
ExitStatus run(const RevolveCommand& command, const Streams& streams);

}  // namespace exsect::cli
