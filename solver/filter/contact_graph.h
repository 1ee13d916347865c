// Nodes and arcs of the corners and sides that two patches have in common. Internal to solver/;
// docs/method.md, section 14.7.
#pragma once

#include "answer/graph_builder.h"
#include "filter/contact.h"

namespace exsect::filter {

/// Appends an isolated node for each corner, two nodes and an arc for each side: contacts that no other
/// solution is near. False if a polyline cannot be proved to keep within `tolerance` (space units); then the
/// graph is not to be used.
bool append_contacts(const BezierPatch& x, const BezierPatch& y, const Pair& pair, const Contacts& contacts,
                     double tolerance, GraphBuilder& graph);

}  // namespace exsect::filter
