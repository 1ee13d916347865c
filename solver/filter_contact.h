// Corners and sides that both patches have in common, exactly, and the proof that a pair of sub-patches meets
// nowhere else. Internal to solver/; docs/method.md, section 14.7.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "filter_pieces.h"

namespace exsect::filter {

/// A side of a square: its first (0) or second (1) parameter is 0 or, if `upper`, 1.
struct SquareSide {
  std::size_t parameter;
  bool upper;
};

/// Control points of one patch as seen from one of its sides: point(across, along) of row `across` from the
/// side, along it in the direction of the parameter or, if `reversed`, against it.
struct SideView {
  SquareSide side;
  bool reversed;
  std::size_t index(std::size_t across, std::size_t along) const;
};

/// The side of x is that of y, with the same parametrisation: x(.,t) = y(.,t), t counted as the views do.
struct SideContact {
  SideView x;
  SideView y;
  std::array<Vec3, 2> direction;  // control vectors of half the derivative of the common curve
  std::array<Vec3, 6> x_across;   // of (x(a,t) - x(0,t)) / a, bidegree (1,2), index 3 i + j
  std::array<Vec3, 6> y_across;
};

/// A corner of x, index 0, 2, 6 or 8 of the net, is one of y.
struct CornerContact {
  std::size_t x;
  std::size_t y;
};

/// Each is a point or an arc of solutions; no corner is an end of one of the sides.
struct Contacts {
  std::vector<SideContact> sides;
  std::vector<CornerContact> corners;
  bool empty() const { return sides.empty() && corners.empty(); }
};

/// All that the control points show, compared exactly. Empty if there may be more, or a patch closes up.
std::optional<Contacts> find_contacts(const BezierPatch& x, const BezierPatch& y, const Pair& pair);

/// A rectangle of a square, which may be a segment or a point, and control points of the patch on it.
struct Part {
  struct Interval {
    double lower;
    double upper;
  };
  std::array<Interval, 2> range;  // parameters, not centred
  std::span<const Vec3> points;
};
Part part_of(const SubPatch& patch);
/// The curve is on the line where the first (0) or second (1) parameter is `value`, centred, of a square.
Part part_of(const SubCurve& curve, std::size_t fixed, double value);

enum class Meeting {
  contact,   // all solutions on the two parts belong to one of the contacts
  touching,  // the same contact is on both; nothing is proved
  unknown
};
Meeting meeting(const Pair& pair, const Contacts& contacts, const Part& x, const Part& y);

/// True only if all solutions belong to the contacts. `boxes` counts the pairs looked at.
bool meet_in_contacts_only(const Pair& pair, Trees& trees, const Contacts& contacts, long& boxes);

}  // namespace exsect::filter
