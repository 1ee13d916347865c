// The parts of the check, in the order in which one relies on the other. Internal to checker/.
#pragma once

#include "certificate.h"

namespace exsect::checker {

std::string place(const char* list, std::size_t i);
void require(bool holds, const std::string& place, const char* reason);
/// list[i]; rejected at `place` if there is none.
template <class T>
const T& element(const std::vector<T>& list, std::size_t i, const std::string& place, const char* reason) {
  require(i < list.size(), place, reason);
  return list[i];
}

/// A tube that is proved to hold one curve, with the derivatives on it.
struct ProvedTube {
  const Tube<Rational>& claim;
  CurveBounds<Rational> bounds;
};

/// x and -y in the power basis.
Pair<Rational> power_basis(const std::array<BezierPatch, 2>& patches);

std::vector<ProvedTube> check_tubes(const Certificate& certificate, const Pair<Rational>& pair);
/// Distance in each parameter between `at`, which is in the tube, and the curve's point with the same
/// parameter of the axis: at most |C F(at)| / (1 - defect). Rejected at `where` if `at` is not in the tube.
Rational distance(const ProvedTube& tube, const Pair<Rational>& pair, const Vector4<Rational>& at,
                  const std::string& where);
void check_relations(const Certificate& certificate, const Pair<Rational>& pair);
void check_nodes(const Certificate& certificate, const Pair<Rational>& pair,
                 const std::vector<ProvedTube>& tubes);

/// One end of an arc: it leaves its node in the node's tube with growing (1) or falling (-1) parameter of the
/// tube's axis.
struct ArcEnd {
  std::size_t node;
  int direction;
};
/// Both ends of the arc; its error bound is checked as well.
std::array<ArcEnd, 2> check_arc(const Certificate& certificate, const Pair<Rational>& pair,
                                const std::vector<ProvedTube>& tubes, std::size_t i);
/// The greatest distance between an arc and its polyline; radius[j] bounds the distance of the point j, in
/// each parameter, from all places of the curve that it stands for.
void check_error_bound(const Arc& arc, const Pair<Rational>& pair, const std::vector<ProvedTube>& tubes,
                       const std::vector<Rational>& radius, const std::string& where);
void check_graph(const Certificate& certificate, const std::vector<std::array<ArcEnd, 2>>& ends);
void check_cover(const Certificate& certificate);

}  // namespace exsect::checker
