// Arcs: from node to node through tubes, monotone in every parameter, near their polylines.
#include <algorithm>

#include "replay.h"

namespace exsect::checker {
namespace {

template <class N>
class ArcCheck {
 public:
  ArcCheck(const Replay<N>& replay, std::size_t i)
      : replay_(replay), arc_(replay.certificate.arcs[i]), where_(place("arcs", i)) {}

  std::array<ArcEnd, 2> check() {
    const Node<N>& from = element(replay_.certificate.nodes, arc_.from, where_, "names no node");
    const Node<N>& to = element(replay_.certificate.nodes, arc_.to, where_, "names no node");
    require(arc_.points.size() >= 2 && !arc_.pieces.empty(), where_, "without pieces");
    require(arc_.points.front().at == from.at && arc_.points.back().at == to.at, where_,
            "does not begin and end where its nodes are");
    require(arc_.pieces.front().tube == from.tube && arc_.pieces.back().tube == to.tube, where_,
            "does not begin and end in its nodes' tubes");
    require(arc_.pieces.back().last + 1 == arc_.points.size(), where_, "its pieces do not cover it");
    radius_.assign(arc_.points.size(), 0);
    radius_.front() = from.radius;
    radius_.back() = to.radius;
    std::size_t first = 0;
    N entered = from.radius;
    int begins = 0;
    int ends = 0;
    for (const Piece& piece : arc_.pieces) {
      ends = check_piece(piece, first, entered);
      if (begins == 0) begins = ends;
      first = piece.last;
    }
    check_error_bound(replay_, arc_, radius_, where_);
    return {ArcEnd{arc_.from, begins}, ArcEnd{arc_.to, -ends}};
  }

 private:
  /// The direction along the tube's axis. `entered`: distance of the point where the curve comes in from
  /// points[first]; afterwards that of the point where it goes out from points[last].
  int check_piece(const Piece& piece, std::size_t first, N& entered) {
    const ProvedTube<N>& tube = element(replay_.tubes, piece.tube, where_, "names no tube");
    const std::size_t k = tube.claim.axis;
    require(first < piece.last && piece.last < arc_.points.size(), where_, "a piece is empty");
    require(tube.claim.contains(arc_.points[first].at, {entered, entered, entered, entered}), where_,
            "not in two tubes where it goes from one to the next");
    const bool final = piece.last + 1 == arc_.points.size();
    std::vector<N> near;
    for (std::size_t j = first; j <= piece.last; ++j)
      near.push_back(distance(tube, replay_.pair, arc_.points[j].at, where_));
    for (std::size_t j = first; j <= piece.last; ++j) radius_[j] = larger(radius_[j], near[j - first]);
    const N leaves = final ? radius_.back() : near.back();

    const auto step = [&](std::size_t a) { return N(arc_.points[a + 1].at[k] - arc_.points[a].at[k]); };
    const int direction = sign_of(step(first));
    for (std::size_t j = first; j < piece.last; ++j) {
      N least = 0;
      if (j == first) least += entered;
      if (j + 1 == piece.last) least += leaves;
      require(N(direction) * step(j) > least, where_, "a piece runs back");
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const int grows =
          direction * slope_sign(tube, i, {first == 0, final}, {first, piece.last}, {entered, leaves});
      if (first == 0) grows_[i] = grows;
      require(grows != 0 && grows == grows_[i], where_, "not monotone in a parameter");
    }
    entered = leaves;
    return direction;
  }

  /// The sign of w_i' between two points of the piece; 0 if it is not proved to be constant.
  int slope_sign(const ProvedTube<N>& tube, std::size_t i, std::array<bool, 2> is_node,
                 std::array<std::size_t, 2> at, const std::array<N, 2>& near) const {
    if (tube.bounds.first[i].sign() != 0) return tube.bounds.first[i].sign();
    // w_i' is monotone: the signs at the ends decide, of which one may be a turning point.
    std::array<int, 2> signs{};
    std::array<bool, 2> turns{};
    for (std::size_t e = 0; e < 2; ++e) {
      const Node<N>& node = replay_.certificate.nodes[e == 0 ? arc_.from : arc_.to];
      turns[e] = is_node[e] && std::find(node.wrt.begin(), node.wrt.end(), i) != node.wrt.end();
      if (turns[e]) continue;
      const auto t = tangent(replay_.pair.at(arc_.points[at[e]].at), {near[e], near[e], near[e], near[e]});
      signs[e] = t[i].sign() * t[tube.claim.axis].sign();
      if (signs[e] == 0) return 0;
    }
    if (turns[0]) return signs[1];
    return turns[1] || signs[0] == signs[1] ? signs[0] : 0;
  }

  const Replay<N>& replay_;
  const Arc<N>& arc_;
  const std::string where_;
  std::vector<N> radius_;
  std::array<int, 4> grows_{};
};

}  // namespace

template <class N>
std::array<ArcEnd, 2> check_arc(const Replay<N>& replay, std::size_t i) {
  return ArcCheck<N>(replay, i).check();
}
template std::array<ArcEnd, 2> check_arc(const Replay<Rational>&, std::size_t);
template std::array<ArcEnd, 2> check_arc(const Replay<Enclosure>&, std::size_t);

}  // namespace exsect::checker
