// Corners and sides that both patches have in common, exactly, and the proof that a pair of sub-patches meets
// nowhere else. Internal to solver/; docs/method-doubles.md, section 14.7.
#pragma once

#include <optional>
#include <vector>

#include "filter/contact_line.h"
#include "filter/corner_contact.h"
#include "filter/double_point.h"
#include "filter/known_box.h"
#include "filter/path_contact.h"
#include "filter/pieces.h"
#include "filter/side_point.h"

namespace exsect::filter {

/// The side of x and that of y are one curve or parts of one: x(.,t) = y(.,t') for t = offset + factor t', t
/// and t' counted as the views do; factor > 0. Both sides are the whole curve, with the same parametrisation,
/// unless there is a `path`.
template <class K>
struct SideContactOf {
  SideView x;
  SideView y;
  std::array<Vec3, K::degree> direction;  // control vectors of 1/n of the derivative of the common curve
  AcrossFieldOf<K> x_across;
  AcrossFieldOf<K> y_across;
  double offset = 0;
  double factor = 1;
  std::optional<SidePath> path = std::nullopt;
  /// Its ends; poles where a patch has one there. Nothing if there is a `path`.
  std::vector<CornerContact> ends = {};
  /// By how much the fields and their errors grow when they are divided at poles, (14.32).
  double growth = 1;
};
using SideContact = SideContactOf<Biquadratic>;

/// The increasing map t' -> ((1-t') value[0] + t' value[1]) / ((1-t') weight[0] + t' weight[1]), (14.35a).
template <class Number>
struct MoebiusMap {
  std::array<Number, 2> value;
  std::array<Number, 2> weight;
};

/// Of weighted patches: the sides are one curve, from end to end unless there is a `path`.
template <class K>
requires K::weighted struct SideContactOf<K> {
  SideView x;
  SideView y;
  MoebiusMap<Rational> to_x;  // from t' on y to t on x, as the views count
  MoebiusMap<double> rounded_to_x;
  std::array<Row<K>, K::side> own;                      // control vectors of the side of x
  std::array<Row<K>, K::side> own_of_y;                 // and of y
  std::array<Vec3, K::degree * K::degree> line;         // of C(t) ^ C(t') / (t' - t): w' p - w p'
  std::array<Vec3, K::degree * K::degree> line_moment;  // and p x p'
  AcrossFieldOf<K> x_across;
  AcrossFieldOf<K> y_across;
  std::vector<CornerContact> ends = {};
  double growth = 1;
  std::optional<SidePath> path = std::nullopt;
};

/// Each is a point or an arc of solutions, or a box that holds all of some curves; no corner is an end of one
/// of the others, or a side point, but a double point that is no crossing may be a corner. Within its
/// reach all solutions are a branched corner and its arcs.
template <class K>
struct ContactsOf {
  std::vector<SideContactOf<K>> sides;
  std::vector<PathContact> paths;       // sides of one patch only; biquadratic pairs
  std::vector<ContactLineOf<K>> lines;  // of other pairs
  std::vector<CornerContact> corners;
  std::vector<SidePointOf<K>> points;           // where a curve may end, alone among these
  std::vector<DoublePointOf<K>> double_points;  // on sides; not of biquadratic pairs
  std::vector<KnownBox> boxes;                  // not of biquadratic pairs
  std::vector<CornerContact> branched;          // corners that are ends of arcs, of sides or with ports
  bool empty() const {
    return sides.empty() && paths.empty() && lines.empty() && corners.empty() && points.empty() &&
           double_points.empty() && boxes.empty() && branched.empty();
  }
};
using Contacts = ContactsOf<Biquadratic>;

/// The side point is the corner.
template <class K>
bool is_at(const SidePointOf<K>& point, const CornerContact& corner) {
  return point.on == place_of<K>(corner);
}

enum class Meeting {
  contact,   // all solutions on the two parts belong to one of the contacts, or to arcs of its points
  touching,  // the same contact is on both; nothing is proved
  unknown
};
template <class K>
Meeting meeting(const PairOf<K>& pair, const ContactsOf<K>& contacts, const Part& x, const Part& y);

/// True only if all solutions belong to the contacts. `boxes` counts the pairs looked at.
template <class K>
bool meet_in_contacts_only(const PairOf<K>& pair, TreesOf<K>& trees, const ContactsOf<K>& contacts,
                           long& boxes);

}  // namespace exsect::filter
