// Parameter lines of one patch along which the other one touches it, and the proof that a pair of sub-patches
// meets nowhere else. Internal to solver/; docs/method-doubles.md, section 14.21.
#pragma once

#include <exsect/algebra/ball.h>
#include <exsect/solver/result.h>

#include <optional>

#include "filter/part.h"
#include "filter/side_path.h"

namespace exsect::filter {

/// The line is on the other patch, and the tangent planes agree all along it, exactly. Not of biquadratic
/// pairs.
template <class K>
struct ContactLineOf {
  LinePath path;
  DoubleBall value;                                       // centred
  std::array<std::array<DoubleBall, 2>, 2> ends;          // centred
  double ratio;                                           // rounded
  std::array<std::array<DoubleBall, 4>, K::count> owner;  // coefficients in centred parameters, homogeneous
  std::array<std::array<DoubleBall, 4>, K::count> carrier;
};

/// The line of contact near a place (centred), of either patch, with a simple value of its parameter.
template <class K>
std::optional<ContactLineOf<K>> contact_line_near(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                  const PairOf<K>& pair, const Vec4& near);

/// True only if all solutions on the two parts are on the line.
template <class K>
bool meet_on_line(const ContactLineOf<K>& line, const Part& x, const Part& y);

/// False only if no point of the line that is in both squares belongs to both parts.
template <class K>
bool may_touch(const ContactLineOf<K>& line, const Part& x, const Part& y);

/// The arc of contact and the nodes at its ends, which are to be its `from` and `to`.
struct ContactArc {
  Arc arc;
  std::array<Node, 2> ends;
};
template <class K>
ContactArc contact_arc(const ExactPatch<K>& x, const ExactPatch<K>& y, const LinePath& path,
                       double tolerance);

/// Explicit instantiations, at the end of a source.
#define EXSECT_FILTER_OTHER_KINDS(INSTANTIATE) \
  INSTANTIATE(Bicubic) INSTANTIATE(WeightedBiquadratic) INSTANTIATE(WeightedBicubic)

}  // namespace exsect::filter
