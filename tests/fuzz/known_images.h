// Exact maps of patches that leave an intersection the same, or change its parameters in a known way.
#pragma once

#include <exsect/geometry/rational_patch_file.h>
#include <exsect/solver/intersection_graph.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/graph_isomorphism.h"
#include "support/random_nets.h"

namespace exsect::known_images {

/// Maps of space, with their names: projective, a rotation, times 25.4, moved to 1e8.
std::vector<std::pair<std::string, random_nets::ProjectiveMap>> space_maps();
/// The same patch, with all homogeneous coordinates times 7.
RationalPatch multiplied(const RationalPatch& patch);
RationalPatch reversed(const RationalPatch& patch);  // 1 - u
/// With t in the place of u, u = k t / (1 + (k - 1) t), k = 7/5.
RationalPatch reparametrised(const RationalPatch& patch);
/// How far a chord bends by that, in t: it may be half as long as the square, and |d^2 t / d u^2| <= 1.12.
inline constexpr double kBentChord = 0.04;
/// A graph in the parameter t, parameter i being u; boxes exactly. Turning points are the same, as t(u) is
/// monotone.
IntersectionGraph reparametrised(IntersectionGraph graph, std::size_t i);

/// What is solved, mapped, and how a graph of it follows.
template <class Solved>
struct Image {
  std::string name;
  Solved of;
  Renaming renaming = {};
  std::optional<std::size_t> parameter = {};  // the one that is reparametrised

  /// As exsect::difference, of the graphs before and after the map.
  std::string difference(const IntersectionGraph& before, const IntersectionGraph& after) const {
    if (!parameter) return exsect::difference(before, after, renaming);
    return exsect::difference(reparametrised(before, *parameter), after, renaming, kBentChord);
  }
};

/// Writes the patches to a file beside other temporary files and says where.
std::string written(const std::string& name, const std::vector<NamedRationalPatch>& patches);

}  // namespace exsect::known_images
