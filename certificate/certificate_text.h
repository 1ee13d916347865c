// Certificates (docs/certificate.md): a complete result as claims that `exsect check` replays.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/result.h>

#include <string>

#include "certificate/search.h"
#include "output/text/intersection_json.h"

namespace exsect::cli {

/// The certificate of the intersection of x and y, with all four parameters' turning points as nodes. It has
/// been checked. Throws NoCertificate for a result that is incomplete or holds an event without a
/// certificate.
std::string certificate_text(const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                             const IntersectResult& result);
/// The same of a surface given by its equation and a patch, which is the first
/// one in the certificate; u's and v's turning points are its nodes.
std::string certificate_text(const ImplicitSurface& surface, const RationalPatch& patch,
                             const PatchNames& names, const IntersectResult& result);
/// The same of the patch's self-intersection.
std::string self_certificate_text(const RationalPatch& patch, const PatchNames& names,
                                  const IntersectResult& result);

}  // namespace exsect::cli
