// Nodes that doubles do not tell apart, and the arcs between them, in numbers as long as needed.
#pragma once

#include "certificate/chain.h"
#include "certificate/draft.h"

namespace exsect::cli {

/// The places of these nodes, each in the tube found for it, in numbers that tell all of them apart. Throws
/// NoCertificate if there are none.
std::vector<LongPlace> told_apart(const Draft& draft, const std::vector<const Node*>& nodes,
                                  const std::vector<Tube>& tubes);

/// The arc between two such nodes, if in doubles it is one point; each in the tube with its number. The point
/// of the curve in their middle is where it goes from one tube to the other one.
TracedArc short_arc(const Draft& draft, const LongPlace& from, const LongPlace& to,
                    const std::array<std::size_t, 2>& tubes, std::size_t vertices);

}  // namespace exsect::cli
