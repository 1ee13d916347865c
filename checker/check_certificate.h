// The independent check of a certificate: every polynomial is computed anew from the control points in it,
// every claim is replayed. Nothing of the solver is used.
#pragma once

#include <string>
#include <vector>

#include "certificate.h"

namespace exsect::checker {

/// What an accepted certificate proves, and how many claims were replayed.
struct Report {
  Summary summary;
  std::optional<Fixed> fixed;
  bool self = false;
  std::size_t exclusions = 0;
  std::size_t covered = 0;  // leaves in tubes, stars and overlaps
};

/// Returns if and only if every claim holds, so that docs/certificate.md proves the graph, or the points of a
/// line, to be the whole intersection: first in doubles with bounds of their errors, and if something is not
/// certain then, everything in exact arithmetic. Throws Unreadable, or Rejected with place and reason.
Report check_certificate(const std::string& text);
/// The error bounds that are too small where everything else holds: with an eighth more than it needs in the
/// place of each the certificate is accepted. Throws as check_certificate does if anything else is wrong.
std::vector<Shortfall> too_small_error_bounds(const std::string& text);

}  // namespace exsect::checker
