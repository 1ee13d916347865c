// The certificate of the points of a parameter line.
#pragma once

#include "certificate/certificate_text.h"
#include "output/text/line_json.h"

namespace exsect::cli {

/// The certificate of the points of a line, which has been checked. Throws NoCertificate likewise. There is
/// none for points where the line touches the other patch, and for parts of it on that patch.
std::string certificate_text(const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                             const LineIntersection& line);

}  // namespace exsect::cli
