// Pairs of which the numbers of components and points are known: as data, <name>.json and
// <name>.expected.json, or made by a family.
#pragma once

#include <exsect/solver/result.h>

#include <array>
#include <string>

#include "support/random_pairs.h"

namespace exsect {

/// Of components by shape, of nodes of kind boundary, of nodes that turn in u, v, r, s, of isolated points,
/// of overlaps.
struct Numbers {
  int open = 0;
  int closed = 0;
  int branched = 0;
  int boundary = 0;
  std::array<int, 4> turning = {};
  int isolated = 0;
  int overlaps = 0;

  friend bool operator==(const Numbers&, const Numbers&) = default;
};
Numbers numbers_of(const IntersectionGraph& graph);
/// In words.
std::string to_string(const Numbers& numbers);

/// Empty if the intersection of the pair, in doubles where they suffice or only in exact mode, is complete
/// and sound and has these numbers, also with the patches exchanged. Otherwise the first difference in words.
std::string counted_failure(const random_pairs::Pair& pair, const Numbers& expected, bool exact);

/// True if the text of an .expected.json file states numbers, {"case", "why", "patch"?, "open", "closed",
/// "branched", "boundary", "turning": [u, v, r, s], "isolated", "overlaps"}, and no exact graph; what is left
/// out is 0.
/// "patch" names a patch whose self-intersection is meant.
bool states_numbers(const std::string& expected);
/// The same for the first two patches of a patch file, in doubles where they suffice and in exact mode, or
/// for the self-intersection of one. With weights or of degree 3 in doubles alone, and numbers alone are
/// compared.
std::string counted_failure(const std::string& patches, const std::string& expected);

}  // namespace exsect
