// The independent check of a certificate: every polynomial is computed anew from the control points in it,
// every claim is replayed in exact arithmetic. Nothing of the solver is used.
#pragma once

#include <string>

#include "certificate.h"

namespace exsect::checker {

/// What an accepted certificate proves, and how many claims were replayed.
struct Report {
  Summary summary;
  std::size_t nodes = 0;
  std::size_t arcs = 0;
  std::size_t tubes = 0;
  std::size_t relations = 0;
  std::size_t exclusions = 0;
  std::size_t covered = 0;  // leaves in tubes
};

/// Returns if and only if every claim holds, so that docs/certificate.md proves the graph to be the whole
/// intersection. Throws Unreadable, or Rejected with place and reason.
Report check_certificate(const std::string& text);

}  // namespace exsect::checker
