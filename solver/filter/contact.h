// Corners and sides that both patches have in common, exactly, and the proof that a pair of sub-patches meets
// nowhere else. Internal to solver/; docs/method.md, section 14.7.
#pragma once

#include <optional>
#include <vector>

#include "filter/part.h"
#include "filter/path_contact.h"
#include "filter/pieces.h"

namespace exsect::filter {

/// The side of x and that of y are one curve or parts of one: x(.,t) = y(.,t') for t = offset + factor t', t
/// and t' counted as the views do; factor > 0. Both sides are the whole curve, with the same parametrisation,
/// unless there is a `path`.
struct SideContact {
  SideView x;
  SideView y;
  std::array<Vec3, 2> direction;  // control vectors of half the derivative of the common curve
  AcrossField x_across;
  AcrossField y_across;
  double offset = 0;
  double factor = 1;
  std::optional<SidePath> path = std::nullopt;
};

/// A corner of x, index 0, 2, 6 or 8 of the net, is one of y.
struct CornerContact {
  std::size_t x;
  std::size_t y;
};

/// Each is a point or an arc of solutions; no corner is an end of one of the others.
struct Contacts {
  std::vector<SideContact> sides;
  std::vector<PathContact> paths;  // sides of one patch only
  std::vector<CornerContact> corners;
  bool empty() const { return sides.empty() && paths.empty() && corners.empty(); }
};

/// All that the control points show, compared exactly. Empty if there may be more, or a patch closes up.
std::optional<Contacts> find_contacts(const BezierPatch& x, const BezierPatch& y, const Pair& pair);

/// Adds the side of one patch that lies on the other one in part; nothing if it is known already.
void add_path(const SidePath& path, const Pair& pair, Contacts& contacts);

enum class Meeting {
  contact,   // all solutions on the two parts belong to one of the contacts
  touching,  // the same contact is on both; nothing is proved
  unknown
};
Meeting meeting(const Pair& pair, const Contacts& contacts, const Part& x, const Part& y);

/// True only if all solutions belong to the contacts. `boxes` counts the pairs looked at.
bool meet_in_contacts_only(const Pair& pair, Trees& trees, const Contacts& contacts, long& boxes);

}  // namespace exsect::filter
