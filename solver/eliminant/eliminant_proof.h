// The proof by the turning eliminant that the known curves are the whole intersection. Internal to solver/;
// docs/method-doubles.md, section 14.8.
#pragma once

#include <exsect/solver/parameter.h>

#include <functional>
#include <optional>
#include <vector>

namespace exsect {

/// A curve of the intersection: enclosures of the sweep parameter at its turning points with respect to it,
/// in order, those of an open curve between its two ends. From one to the next the parameter is strictly
/// monotone, for a closed curve also from the last to the first.
struct Stations {
  std::vector<RationalInterval> at;
  bool closed;
};

/// A real root of the turning eliminant: enclosed as by isolate_roots, or the rational of width zero.
struct EliminantRoot {
  RationalInterval at;
  int order = 1;  // its multiplicity
};

/// The number of points on each line where the sweep parameter has a value in this interval, one or a few
/// bits wide; a curve crosses the line in each of them. Empty: not known.
using FibreCount = std::function<std::optional<std::size_t>(const RationalInterval&)>;

/// True: `curves` and singular points are the whole intersection, apart from what is known on sides. They are
/// different, and all solutions on sides are known. Stations that are one point twice are an isolated point.
/// `roots` of the turning eliminant are ascending and disjoint, and all in (0,1). `singular` encloses the
/// sweep parameter, inside (0,1), at different singular solutions that are isolated in their fibres over the
/// complex numbers. False if the enclosures are too wide for a proof, a fibre is not known, or a multiple
/// root has a greater order than what is known over it explains, and its own fibre is not known. Throws
/// ProofFailure if roots or fibres contradict the curves.
bool no_curve_is_missing(const std::vector<EliminantRoot>& roots, const std::vector<Stations>& curves,
                         const FibreCount& fibre, Parameter sweep = Parameter::u,
                         const std::vector<RationalInterval>& singular = {});
/// The same roots, all of them simple.
std::vector<EliminantRoot> simple_roots(const std::vector<RationalInterval>& roots);

}  // namespace exsect
