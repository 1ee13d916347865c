// The search for seams: lines of solutions next to which there are no others.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/checker/star_maps.h>

#include <array>
#include <string>

#include "certificate_search.h"

namespace exsect::cli {

/// A subdivision of the chart, 0 <= t <= 1 and |d_j| <= 1, that does not end soon.
struct NotAlone {};

/// A direction in which the map has one sign where its variables differ by `half` at most from the middle, as
/// an entry of a subdivision; empty if none is found.
std::string one_sign(const Map& map, const Parameters& middle, const Parameters& half, std::size_t axis);

/// The charts' maps of a star or seam, whose rows are each multiplied by a power of 2, so that the largest
/// term is near 1; the orders become the largest possible ones.
std::array<Map, 8> scaled_maps(checker::Star& star, const checker::Map<Rational>& equation);

/// A seam with the largest tube around its line.
struct FoundSeam {
  checker::Star claim;                      // without its charts
  std::array<std::string, 8> subdivisions;  // of its charts
  Tube tube;
};

/// The seam number `index` around the line number `line`, which is `on` in the variables of the map and
/// straight: for `middle` - `half` <= t <= `middle` + `half`. Along the line the map's derivative has rank 2,
/// and its kernel one plane. Throws NotAlone if other solutions are too near.
FoundSeam seam_along(const checker::Map<Rational>& equation, const checker::MapName& of,
                     const checker::OnAxis<Rational>& on, std::size_t axis, const Rational& middle,
                     const Rational& half, std::size_t index, int line);

/// The seam of the plane at + a first + b second, for |a|, |b| <= 1 and as wide as it can be. The directions
/// are independent in u and v. Throws NoCertificate if this is no plane of solutions, or others are near.
FoundSeam seam_of_plane(const checker::Map<Rational>& equation, const std::array<Rational, 4>& at,
                        const std::array<Rational, 4>& first, const std::array<Rational, 4>& second);

/// Throws NoCertificate if there is none.
checker::Matrix4 inverse(checker::Matrix4 m);

}  // namespace exsect::cli
