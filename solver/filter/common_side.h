// How two patches meet along a side that is a side of both, and what both have of it. Internal to solver/;
// docs/method-doubles.md, sections 14.7 and 14.14.
#pragma once

#include "filter/contact.h"

namespace exsect::filter {

/// Control point a less control point b, rounded or exactly.
template <class K>
requires(!K::weighted) Vec3 step_between(const PatchOf<K>& patch, std::size_t a, std::size_t b) {
  return patch.net[a] - patch.net[b];
}
template <class Exact>
Point step_between(const Exact& patch, std::size_t a, std::size_t b) {
  using exsect::operator-;
  return control_point(patch, a) - control_point(patch, b);
}

/// Tangential if the patches touch all along the side, exactly; otherwise they cross along it.
template <class K>
Contact contact_along(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                      const SideContactOf<K>& side);

/// The ends of the common part of two sides, as the views of x and of y count.
using CommonPart = std::array<std::array<Rational, 2>, 2>;
template <class K>
CommonPart common_part(const SideContactOf<K>& side, const SidePath& path);

/// (u,v,r,s) at the first and the last end of it.
template <class K>
std::array<std::array<Rational, 4>, 2> ends_of_part(const SideContactOf<K>& side, const SidePath& path);

/// t' of the point t (14.35a).
Rational inverse(const MoebiusMap<Rational>& map, const Rational& t);

}  // namespace exsect::filter
