// Regions of the domain in which all solutions are on sides that the patches have in common. Internal to
// solver/; docs/method-doubles.md, section 14.7.
#pragma once

#include <exsect/geometry/bezier_patch.h>

#include <optional>

#include "filter/contact.h"
#include "trace/subdivision.h"

namespace exsect {

/// What doubles prove of the sides of one patch that lie on the other one, in exact arithmetic as well: the
/// contacts are exact.
class ContactRegions {
 public:
  ContactRegions(const BezierPatch& x, const BezierPatch& y);

  /// True only if all solutions in the region, of [0,1]^4, are points of sides of one patch that lie on the
  /// other one.
  bool settles(const SearchRegion& region) const;

 private:
  std::optional<filter::Pair> pair_;
  filter::Contacts contacts_;
};

}  // namespace exsect
