// Corners of both patches in which sides end that they have in common. Internal to solver/;
// docs/method-doubles.md, section 14.26.
#pragma once

#include <vector>

#include "filter/contact.h"
#include "filter/corner_equation.h"

namespace exsect::filter {

struct SideCorner {
  CornerContact corner;  // no pole
  std::vector<SideAtCorner> sides;
};

/// Each with all common sides of the contacts that end there.
template <class K>
std::vector<SideCorner> side_corners(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                                     const ContactsOf<K>& contacts);

}  // namespace exsect::filter
