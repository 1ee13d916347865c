// The parts of the check, in the order in which one relies on the other. Internal to checker/. N is Rational,
// or Enclosure: then what is proved is proved, and what is not may nevertheless be true.
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
template <class N>
struct ProvedTube {
  const Tube<N>& claim;
  CurveBounds<N> bounds;
};

template <class N>
struct Replay {
  const Certificate<N>& certificate;
  Pair<Rational> exact;  // x and -y in the power basis
  Vector3<Rational> origin;
  Pair<N> pair;  // the same, but x and y moved by -origin
  std::vector<ProvedTube<N>> tubes = {};
};

template <class N>
Replay<N> replay(const Certificate<N>& certificate);

template <class N>
void check_relations(const Replay<N>& replay);
/// Fills replay.tubes.
template <class N>
void check_tubes(Replay<N>& replay);
/// Distance in each parameter between `at`, which is in the tube, and the curve's point with the same
/// parameter of the axis: at most |C F(at)| / (1 - defect). Rejected at `where` if `at` is not in the tube.
template <class N>
N distance(const ProvedTube<N>& tube, const Pair<N>& pair, const Vector4<N>& at, const std::string& where);
template <class N>
void check_nodes(const Replay<N>& replay);

/// One end of an arc: it leaves its node in the node's tube with growing (1) or falling (-1) parameter of the
/// tube's axis.
struct ArcEnd {
  std::size_t node;
  int direction;
};
/// Both ends of the arc; its error bound is checked as well.
template <class N>
std::array<ArcEnd, 2> check_arc(const Replay<N>& replay, std::size_t i);
/// The greatest distance between an arc and its polyline; radius[j] bounds the distance of the point j, in
/// each parameter, from all places of the curve that it stands for.
template <class N>
void check_error_bound(const Replay<N>& replay, const Arc<N>& arc, const std::vector<N>& radius,
                       const std::string& where);
template <class N>
void check_graph(const Certificate<N>& certificate, const std::vector<std::array<ArcEnd, 2>>& ends);
template <class N>
void check_cover(const Replay<N>& replay);

/// F = 0 at `at`, which is exact.
template <class N>
bool is_solution(const Pair<Rational>& exact, const Vector4<N>& at);
/// Of a line.
template <class N>
void check_points(const Replay<N>& replay);

}  // namespace exsect::checker
