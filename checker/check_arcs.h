// Arcs: from node to node through tubes, monotone in every parameter, near their polylines.
#pragma once

#include <cmath>

#include "check_stars.h"
#include "polynomials.h"

namespace exsect::checker {

/// One end of an arc: it leaves its node in the node's tube with growing (1) or falling (-1) variable of the
/// tube's axis.
struct ArcEnd {
  int direction;
  std::size_t tube;
};

/// The distance between arcs and polylines, step by step.
template <class N>
class ErrorBound {
 public:
  ErrorBound(const Replay<N>& replay, const Arc<N>& arc) : replay_(replay), arc_(arc) {
    for (std::size_t d = 0; d < 3; ++d) origin_[d] = N(replay.origin[d]);
  }

  /// Every point of the arc has a place on the polyline: a point without a vertex the one nearest to it on
  /// its edge, but none before that of another point before it.
  void place_on_polyline() {
    const auto& points = arc_.points;
    require(points.front().vertex && points.back().vertex, "an end of the polyline is missing");
    std::size_t a = 0;
    for (std::size_t b = 1; b < points.size(); ++b) {
      if (!points[b].vertex) continue;
      const Vector3<N> from = difference(*points[a].vertex, origin_);
      const Vector3<N> edge = difference(*points[b].vertex, *points[a].vertex);
      places_.push_back(from);
      N before = 0;
      for (std::size_t j = a + 1; j < b; ++j) {
        const N length = dot(edge, edge);
        require(length > 0, "an edge of the polyline has no length");
        const N nearest = dot(edge, difference(replay_.space[0].value(points[j].at), from)) / length;
        const N t = -larger(N(-larger(before, nearest)), N(-1));
        before = t;
        places_.push_back({from[0] + t * edge[0], from[1] + t * edge[1], from[2] + t * edge[2]});
      }
      a = b;
    }
    places_.push_back(difference(*points.back().vertex, origin_));
  }

  /// Adds the steps between the points first, ... of a piece, at `at` in the variables of the tube's map,
  /// each within `near` of the curve. Of the parameters that are not known to be monotone in the tube,
  /// `open`, the signs of their derivatives all along; 0 where there is none.
  std::array<int, 4> add(const ProvedTube<N>& tube, std::size_t first, const std::vector<Vector4<N>>& at,
                         const std::vector<N>& near, const std::array<bool, 4>& open = {}) {
    std::array<int, 4> signs{};
    for (std::size_t j = 0; j + 1 < at.size();) {
      const std::size_t last = std::min(j + together_, at.size() - 1);
      const std::optional<Steps> steps = tried(tube, first, at, near, open, j, last);
      if (!steps) {
        together_ = (last - j) / 2;
        continue;
      }
      most_ = larger(most_, steps->distance);
      for (std::size_t i = 0; i < 4; ++i)
        if (open[i]) signs[i] = j == 0 || signs[i] == steps->signs[i] ? steps->signs[i] : 0;
      if (last == j + together_ && 10 * steps->distance < 9 * arc_.error_bound)
        together_ += 1 + together_ / 4;
      j = last;
    }
    return signs;
  }
  /// What was added is within the error bound.
  void check() const {
    if (most_ <= arc_.error_bound) return;
    Failed failed("the error bound is too small", Violation::error_bound);
    if (const double needed = above(most_); std::isfinite(needed)) failed.needed = needed;
    throw failed;
  }

 private:
  /// What is known of some steps together.
  struct Steps {
    N distance;                // at most, between arc and polyline
    std::array<int, 4> signs;  // of the derivatives
  };
  static bool have_signs(const std::array<int, 4>& signs, const std::array<bool, 4>& open) {
    bool result = true;
    for (std::size_t i = 0; i < 4; ++i) result = result && (!open[i] || signs[i] != 0);
    return result;
  }
  bool suffice(const Steps& steps, const std::array<bool, 4>& open) const {
    return steps.distance <= arc_.error_bound && have_signs(steps.signs, open);
  }

  static Vector3<N> difference(const Vector3<N>& a, const Vector3<N>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static N norm_above(const Vector3<N>& a) { return root_above(dot(a, a)); }
  /// q rounded down to a multiple of 2^-24: short numbers.
  static Rational rounded_down(const Rational& q) {
    const Rational scaled = q * (1 << 24);
    return Rational(numerator(scaled) / denominator(scaled)) / (1 << 24);
  }
  static Enclosure rounded_down(const Enclosure& a) { return a; }

  /// The steps j, ..., last - 1 together; nothing where fewer of them may say more.
  std::optional<Steps> tried(const ProvedTube<N>& tube, std::size_t first, const std::vector<Vector4<N>>& at,
                             const std::vector<N>& near, const std::array<bool, 4>& open, std::size_t j,
                             std::size_t last) const {
    if (last == j + 1) return over(tube, first, at, near, open, j, last);
    try {
      const Steps steps = over(tube, first, at, near, open, j, last);
      if (suffice(steps, open)) return steps;
    } catch (const Failed&) {
    }
    return std::nullopt;
  }

  Steps over(const ProvedTube<N>& tube, std::size_t first, const std::vector<Vector4<N>>& at,
             const std::vector<N>& near, const std::array<bool, 4>& open, std::size_t j,
             std::size_t last) const {
    N margin = 0;
    for (std::size_t i = j; i <= last; ++i) margin = larger(margin, near[i]);
    const Box<N> box = around_chord(tube.claim, tube.bounds, at[j], at[last], margin, open);
    Vector4<N> middle;
    Vector4<N> half;
    for (std::size_t i = 0; i < 4; ++i) {
      middle[i] = rounded_down(box[i].middle);
      half[i] = rounded_down(box[i].radius) + N(0x1p-23);
    }
    const std::size_t k = tube.claim.axis;
    const CurveBounds<N> bounds = bounds_over(tube.map, k, middle, half);
    require(bounds.defect < 1, "no derivative over a step of the polyline");
    const Position<N>& space = replay_.space_of(tube.claim);
    const auto [partial, second] = space.bounds(middle, half, bounds.first, bounds.second);
    Vector3<N> slope = {};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t d = 0; d < 3; ++d)
        if (i != k) slope[d] += partial[i][d].magnitude();
    const N bend = norm_above({second[0].magnitude(), second[1].magnitude(), second[2].magnitude()}) / 8;
    const N speed = norm_above(slope);
    Steps result = {};
    if (open != std::array<bool, 4>{})
      result.signs = signs_along(tube, bounds, at, near, margin, open, j, last);
    N before = 0;
    for (std::size_t i = j; i <= last; ++i) {
      const N end = norm_above(difference(space.value(at[i]), places_[first + i])) + speed * near[i];
      if (i > j) {
        const N step = at[i][k] - at[i - 1][k];
        result.distance = larger(result.distance, N(larger(before, end) + step * step * bend));
      }
      before = end;
    }
    return result;
  }

  /// The signs of the derivatives on these steps together, from the point in their middle, or from either of
  /// the two there: both ends of a single step.
  std::array<int, 4> signs_along(const ProvedTube<N>& tube, const CurveBounds<N>& bounds,
                                 const std::vector<Vector4<N>>& at, const std::vector<N>& near,
                                 const N& margin, const std::array<bool, 4>& open, std::size_t j,
                                 std::size_t last) const {
    const std::size_t k = tube.claim.axis;
    std::array<int, 4> result{};
    for (std::size_t c = (j + last) / 2; c <= (j + last + 1) / 2 && !have_signs(result, open); ++c) {
      const N length = larger(magnitude(N(at[c][k] - at[j][k])), magnitude(N(at[c][k] - at[last][k])));
      const auto found = checker::slope_signs(tube.map, k, bounds, at[c], near[c], N(length + margin));
      for (std::size_t i = 0; i < 4; ++i) result[i] = result[i] == 0 ? found[i] : result[i];
    }
    return result;
  }

  const Replay<N>& replay_;
  const Arc<N>& arc_;
  Vector3<N> origin_;
  std::vector<Vector3<N>> places_;  // on the polyline
  N most_ = 0;                      // the greatest distance so far
  std::size_t together_ = 8;        // steps: as many as sufficed last, and some more
};

template <class N>
class ArcCheck {
 public:
  ArcCheck(const Replay<N>& replay, std::size_t i)
      : replay_(replay), index_(i), arc_(replay.certificate.arcs[i]), bound_(replay, arc_) {}

  /// Both ends of the arc.
  std::array<ArcEnd, 2> check() {
    const Node<N>& from = replay_.certificate.nodes[arc_.from];
    const Node<N>& to = replay_.certificate.nodes[arc_.to];
    require(!arc_.pieces.empty(), "without pieces");
    require((from.star >= 0 || arc_.pieces.front().tube == from.tube) &&
                (to.star >= 0 || arc_.pieces.back().tube == to.tube),
            "does not begin and end in its nodes' tubes");
    require(arc_.pieces.back().last + 1 == arc_.points.size(), "its pieces do not cover it");
    bound_.place_on_polyline();
    std::size_t first = 0;
    N entered = from.radius;
    int begins = 0;
    int ends = 0;
    for (const Piece& piece : arc_.pieces) {
      ends = check_piece(piece, first, entered);
      if (begins == 0) begins = ends;
      first = piece.last;
    }
    replay_.check_error_bound(std::nullopt, index_, [&] { bound_.check(); });
    return {ArcEnd{begins, arc_.pieces.front().tube}, ArcEnd{-ends, arc_.pieces.back().tube}};
  }

 private:
  /// The box around points[j] in the variables of the tube's map.
  Box<N> box(const Tube<N>& tube, std::size_t j, const N& radius) const {
    if (j == 0) return node_box(tube, replay_.certificate.nodes[arc_.from]);
    if (j + 1 == arc_.points.size()) return node_box(tube, replay_.certificate.nodes[arc_.to]);
    return in_chart(replay_, tube, box_around(arc_.points[j].at, radius));
  }

  /// The direction along the tube's axis. `entered`: distance in the parameters of the point where the curve
  /// comes in from points[first]; afterwards that of the point where it goes out from points[last].
  int check_piece(const Piece& piece, std::size_t first, N& entered) {
    const ProvedTube<N>& tube = element(replay_.tubes, piece.tube, "names no tube");
    const std::size_t k = tube.claim.axis;
    require(first < piece.last && piece.last < arc_.points.size(), "a piece is empty");
    const Box<N> enters = box(tube.claim, first, entered);
    require(tube.claim.contains(enters), "not in two tubes where it goes from one to the next");
    std::vector<Vector4<N>> at;
    std::vector<N> near;
    for (std::size_t j = first; j <= piece.last; ++j) {
      at.push_back(middles(box(tube.claim, j, N(0))));
      near.push_back(distance(tube, at.back()));
    }
    const bool final = piece.last + 1 == arc_.points.size();
    for (const Ball<N>& b : enters) near.front() = larger(near.front(), b.radius);
    const N out = near.back();  // at the end of this piece
    if (final) near.back() = larger(near.back(), replay_.certificate.nodes[arc_.to].radius);

    const auto step = [&](std::size_t j) { return N(at[j + 1][k] - at[j][k]); };
    const int direction = sign_of(step(0));
    for (std::size_t j = 0; j + 1 < at.size(); ++j) {
      N least = 0;
      if (j == 0) least += enters[k].radius;
      if (j + 2 == at.size()) least += near.back();
      require(N(direction) * step(j) > least, "a piece runs back");
    }
    std::array<int, 4> grows = tube.claim.chart == Chart::star ? tube.grows
                               : tube.claim.chart == Chart::pair
                                   ? slope_signs(tube, {first == 0, final}, {first, piece.last},
                                                 {entered, final ? near.back() : out})
                                   : pair_signs(tube, first, piece.last);
    std::array<bool, 4> open{};
    for (std::size_t i = 0; i < 4; ++i) open[i] = grows[i] == 0 && !tube.constant[i];
    const std::array<int, 4> along = bound_.add(tube, first, at, near, open);
    for (std::size_t i = 0; i < 4; ++i) {
      if (open[i]) grows[i] = along[i];
      if (first == 0) grows_[i] = direction * grows[i];
      require((grows[i] != 0 || tube.constant[i]) && direction * grows[i] == grows_[i],
              "not monotone in a parameter");
    }
    entered = out_of_chart(tube.claim, piece.last, out);
    return direction;
  }

  /// The distance in parameters from points[j] to a point of the curve within `near` of it in the chart.
  N out_of_chart(const Tube<N>& tube, std::size_t j, const N& near) const {
    if (tube.chart == Chart::pair) return near;
    // u = U + t, v = V + m t with |t| <= 1 and w = t^2 known.
    if (tube.chart != Chart::star) return 2 * near;
    if (j + 1 == arc_.points.size()) return near;
    Box<N> z = box(tube, j, N(0));
    for (const std::size_t i : others(tube.axis)) z[i].radius += near;
    const Box<N> w = from_star(replay_.certificate.stars[tube.star], tube.direction, z);
    N most = 0;
    for (std::size_t i = 0; i < 4; ++i)
      most = larger(most, N(magnitude(N(w[i].middle - arc_.points[j].at[i])) + w[i].radius));
    return most;
  }

  /// The signs of w_i' between two points of the piece, where they follow from the tube and both ends; or 0.
  std::array<int, 4> slope_signs(const ProvedTube<N>& tube, std::array<bool, 2> is_node,
                                 std::array<std::size_t, 2> at, const std::array<N, 2>& near) const {
    std::array<int, 4> result{};
    std::array<std::optional<Box<N>>, 2> t;
    for (std::size_t i = 0; i < 4; ++i) {
      result[i] = tube.bounds.first[i].sign();
      if (result[i] != 0 || tube.constant[i] || tube.bounds.second[i].sign() == 0) continue;
      // w_i' is monotone: the signs at the ends decide, of which one may be a turning point.
      std::array<int, 2> signs{};
      std::array<bool, 2> turns{};
      for (std::size_t e = 0; e < 2; ++e) {
        const Node<N>& node = replay_.certificate.nodes[e == 0 ? arc_.from : arc_.to];
        turns[e] = is_node[e] && std::find(node.wrt.begin(), node.wrt.end(), i) != node.wrt.end();
        if (!t[e]) t[e] = tangent(tube.map.at(arc_.points[at[e]].at), {near[e], near[e], near[e], near[e]});
        signs[e] = (*t[e])[i].sign() * (*t[e])[tube.claim.axis].sign();
        turns[e] =
            turns[e] || (is_node[e] && signs[e] == 0 && !node.on.empty() && turns_at(tube.claim, i, node.on));
      }
      if (turns[0] || turns[1])
        result[i] = turns[0] ? (turns[1] ? 0 : signs[1]) : signs[0];
      else if (signs[0] == signs[1])
        result[i] = signs[0];
    }
    return result;
  }

  bool turns_at(const Tube<N>& tube, std::size_t i, const std::vector<Side>& sides) const {
    const Polynomial one = {{Power{}, 1}};
    const Map<Rational>& map = replay_.exact_map(tube);
    return turns_on_sides(map, {one, one}, i, sides) || turns_on_sides(map, replay_.weights, i, sides);
  }

  /// In a chart, the signs with growing w of u, v, r, s; on one side of the diagonal.
  std::array<int, 4> pair_signs(const ProvedTube<N>& tube, std::size_t first, std::size_t last) const {
    const std::size_t p = tube.claim.chart == Chart::first ? 0 : 1;
    int side = 0;
    for (std::size_t j = first; j <= last; ++j) {
      if (j == 0 || j + 1 == arc_.points.size()) continue;
      const int sign = sign_of(N(arc_.points[j].at[p] - arc_.points[j].at[p + 2]));
      require(sign != 0 && (side == 0 || side == sign), "not on one side of the diagonal");
      side = sign;
    }
    const int m = sign_of(tube.claim.centre[2]);
    return p == 0 ? std::array{side, side * m, -side, -side * m}
                  : std::array{side * m, side, -side * m, -side};
  }

  const Replay<N>& replay_;
  std::size_t index_;
  const Arc<N>& arc_;
  ErrorBound<N> bound_;
  std::array<int, 4> grows_{};
};

}  // namespace exsect::checker
