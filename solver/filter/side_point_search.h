// Points where curves may end on sides of both patches, and double points on sides, found where searches end
// undecided. Internal to solver/; docs/method-doubles.md, sections 14.12, 14.16 and 14.18.
#pragma once

#include <optional>

#include "filter/contact.h"

namespace exsect::filter {

/// Where the search for boundary points ends undecided, centred; empty if that is not found again.
template <class K>
std::optional<Vec4> undecided_on_sides(const PairOf<K>& pair, TreesOf<K>& trees,
                                       const ContactsOf<K>& contacts);

/// Adds the side point near a place. False if it is known already, or not proved. A corner where a curve ends
/// is no contact.
template <class K>
bool add_side_point(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair, const Vec4& place,
                    ContactsOf<K>& contacts);

/// Adds the double point on sides near a place, with ports as near to its chords as `tolerance` says. False
/// if it is known already, or not proved, and for biquadratic pairs, behind which there is exact arithmetic.
/// A corner that is a crossing is no contact.
template <class K>
bool add_side_double_point(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                           const Vec4& place, double tolerance, ContactsOf<K>& contacts);

/// Adds the common corners that are side points: a curve ends there, or passes outside. False if there are
/// none.
template <class K>
bool add_corner_points(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                       ContactsOf<K>& contacts);

/// Proves of common corners that nothing else is near, (14.14a), or which arcs end there, Lemma 14.26: such a
/// corner is branched, as one in which common sides end, and appended to the centres if other arcs do. False
/// if of none for the first time.
template <class K>
bool find_corners(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                  ContactsOf<K>& contacts, std::vector<CentreOf<K>>& centres);

}  // namespace exsect::filter
