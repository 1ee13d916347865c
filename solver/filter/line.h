// All points of a parameter line on the other patch, by subdivision with certificates. Internal to solver/;
// docs/method-doubles.md, section 14.3.
#pragma once

#include <exsect/algebra/nearest_double.h>
#include <exsect/solver/parameter.h>

#include <vector>

#include "filter/contact.h"
#include "filter/error_bounds.h"
#include "filter/tube.h"

namespace exsect::filter {

/// The line where the parameter `fixed` (0..3, centred) has a number within `error` of `value`; |value| <=
/// 1/2, and error is far below 1.
struct Line {
  std::size_t fixed;
  double value;
  double error;
};

/// The lines where p has a value in this interval in [0,1].
inline Line centred_line(Parameter p, const RationalInterval& values) {
  const NearestDouble nearest = nearest_double(values.midpoint() - Rational(1, 2));
  const double rounding = nearest.exact ? 0 : kValueError;
  const double spread = values.width() == 0 ? 0 : to_double(values.width()) + kUnit;  // half of it is needed
  return {index(p), nearest.value, rounding + spread};
}

/// Every solution on the line, apart from the contacts, with the other three
/// parameters inside their intervals: exactly one in each ball, the curve crosses the line there; the balls
/// lie inside these intervals and are disjoint. Empty if that is not decided: points on sides, tangents and
/// lines on the other patch among other reasons. `other` is the tree of the patch that does not have the
/// line; `boxes` counts the pairs looked at.
template <class K>
std::optional<std::vector<BallOf<K>>> points_on_line(const PairOf<K>& pair, const Line& line,
                                                     const ContactsOf<K>& contacts, PatchTreeOf<K>& other,
                                                     long& boxes);

/// Near where this search does not come to an end soon, (u,v,r,s) centred; empty if it does.
template <class K>
std::optional<Vec4> undecided_on_line(const PairOf<K>& pair, const Line& line, const ContactsOf<K>& contacts,
                                      PatchTreeOf<K>& other);

}  // namespace exsect::filter
