// Nodes and arcs of the corners and sides that two patches have in common. Internal to solver/;
// docs/method-doubles.md, section 14.7.
#pragma once

#include "answer/graph_builder.h"
#include "filter/contact.h"

namespace exsect::filter {

/// Appends an isolated node for each corner, two nodes and an arc for each side: contacts that no other
/// solution is near. Polylines are to keep within `tolerance` (space units). False if one cannot be proved to
/// keep within `accepted`; then the graph is not to be used.
template <class K>
bool append_contacts(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                     const ContactsOf<K>& contacts, double tolerance, double accepted, GraphBuilder& graph);

}  // namespace exsect::filter
