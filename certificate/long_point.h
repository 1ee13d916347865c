// Places of nodes in numbers far longer than doubles.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <optional>

#include "certificate/events.h"

namespace exsect::cli {

/// Towards 0 to a multiple of 2^-bits.
Rational in_bits(const Rational& q, int bits);

/// The solution in the node's box with its exact parameters, each to some 2^-bits: where the derivative of F
/// in the others has full rank, or where it has none, but in no neighbouring solution. Nothing if Newton's
/// method does not find it.
std::optional<Place> long_point(const ExactMap& equation, const Node& node, int bits);

}  // namespace exsect::cli
