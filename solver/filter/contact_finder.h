// The corners and sides that both patches have in common, found exactly. Internal to solver/;
// docs/method-doubles.md, sections 14.7 and 14.14.
#pragma once

#include "filter/contact.h"

namespace exsect::filter {

/// All that the control points show, compared exactly. Empty if there may be more, or a patch closes up.
template <class K>
std::optional<ContactsOf<K>> find_contacts(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                           const PairOf<K>& pair);

/// Of two sides that are one curve, of patches without weights.
template <class K>
SideContactOf<K> side_contact(const PairOf<K>& pair, const SideView& x, const SideView& y);
/// With weights, and these parameters of x at those of y.
template <class K>
requires K::weighted SideContactOf<K> weighted_side_contact(const PairOf<K>& pair, const SideView& x,
                                                            const SideView& y,
                                                            const MoebiusMap<Rational>& to_x);

}  // namespace exsect::filter
