// Factors along common lines of patches with parallel lines in them, as cylinders with parallel axes have.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <array>
#include <optional>

#include "certificate/coordinates.h"

namespace exsect::cli {

/// Of a curve along which w_i and w_j, one parameter of each patch, are constant and irrational, from the
/// node on: F depends on these two alone in two directions. The factor's map is (m(w_i), w_j - c(w_i), F in
/// the third direction), m the minimal polynomial of the constant w_i. Nothing if F does not, or w_j is in no
/// field of w_i that is found, or degrees are too high.
std::optional<checker::Factor> ruled_factor(const ExactMap& equation,
                                            const std::array<std::size_t, 2>& constant, const Node& node);

}  // namespace exsect::cli
