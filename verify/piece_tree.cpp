#include "piece_tree.h"

#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <cmath>

#include "infinite.h"

namespace exsect {
namespace {

/// What is not a number bounds nothing.
double lower_bound(double x) { return std::isnan(x) ? PieceTree::never : x; }
double upper_bound(double x) { return std::isnan(x) ? infinite : x; }

SpacePoint minus(const SpacePoint& a, const SpacePoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// At most the distance of the segments [a,b] and [c,d]: the width of the slab between them in one direction,
/// which is that of nearest points as far as these were found, so that the number is then the distance
/// itself.
double segments_apart(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d) {
  SpacePoint p = between(a, b, 0.5);
  SpacePoint q = between(c, d, foot(p, c, d));
  const SpacePoint e = minus(b, a);
  const SpacePoint f = minus(d, c);
  const double ee = dot_over(e, e);
  const double ff = dot_over(f, f);
  const double ef = dot_over(e, f);
  const double determinant = ee * ff - ef * ef;
  if (determinant > 0) {
    const SpacePoint g = minus(a, c);
    const double t = std::clamp((ef * dot_over(f, g) - ff * dot_over(e, g)) / determinant, 0.0, 1.0);
    p = between(a, b, t);
  }
  q = between(c, d, foot(p, c, d));
  p = between(a, b, foot(q, a, b));
  for (const SpacePoint& end : {a, b}) {
    const SpacePoint other = between(c, d, foot(end, c, d));
    if (distance(end, other) < distance(p, q)) p = end, q = other;
  }
  for (const SpacePoint& end : {c, d}) {
    const SpacePoint other = between(a, b, foot(end, a, b));
    if (distance(end, other) < distance(p, q)) p = other, q = end;
  }
  const SpacePoint n = minus(q, p);
  const double length = std::sqrt(dot_over(n, n));
  if (!(length > 0)) return 0;
  const double at_c = dot_over(n, minus(c, a));
  const double at_d = dot_over(n, minus(d, a));
  const double width = (at_c <= at_d ? at_c : at_d) - std::max(dot_over(n, e), 0.0);
  return std::max(0.0, width / length);  // 0 for NaN
}

}  // namespace

double distance(const SpacePoint& a, const SpacePoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double largest(const SpacePoint& a) { return std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])}); }

SpacePoint between(const SpacePoint& a, const SpacePoint& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double foot(const SpacePoint& p, const SpacePoint& a, const SpacePoint& b) {
  double dot = 0;
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    dot += (p[k] - a[k]) * (b[k] - a[k]);
    square += (b[k] - a[k]) * (b[k] - a[k]);
  }
  return square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
}

double PieceTree::Box::square_of_distance(const Box& other) const {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({lower[k] - other.upper[k], other.lower[k] - upper[k], 0.0});
    square += outside * outside;
  }
  return square;
}

PieceTree::PieceTree(const std::vector<Chain>& chains) : chains_(chains) {
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (std::size_t i = 0; i < chains[c].pieces(); ++i) {
      pieces_.push_back({c, i});
      largest_bound_ = std::max(largest_bound_, chains[c].bound[i]);
    }
  }
  if (!pieces_.empty()) build(0, 0, pieces_.size());
}

void PieceTree::build(std::size_t node, std::size_t from, std::size_t to) {
  if (boxes_.size() <= node) boxes_.resize(std::max(node + 1, 2 * boxes_.size()));
  if (to - from == 1) {
    const Chain& chain = chains_[pieces_[from].chain];
    const SpacePoint& a = chain.points[pieces_[from].index];
    const SpacePoint& b = chain.points[pieces_[from].index + 1];
    for (std::size_t k = 0; k < 3; ++k) {
      boxes_[node].lower[k] = std::min(a[k], b[k]);
      boxes_[node].upper[k] = std::max(a[k], b[k]);
    }
    return;
  }
  const std::size_t middle = from + (to - from) / 2;
  build(2 * node + 1, from, middle);
  build(2 * node + 2, middle, to);
  for (std::size_t k = 0; k < 3; ++k) {
    boxes_[node].lower[k] = std::min(boxes_[2 * node + 1].lower[k], boxes_[2 * node + 2].lower[k]);
    boxes_[node].upper[k] = std::max(boxes_[2 * node + 1].upper[k], boxes_[2 * node + 2].upper[k]);
  }
}

ChainPlace PieceTree::place(const Piece& piece, const SpacePoint& p) const {
  const Chain& chain = chains_[piece.chain];
  const SpacePoint& a = chain.points[piece.index];
  const SpacePoint& b = chain.points[piece.index + 1];
  const double t = foot(p, a, b);
  return {piece.chain, static_cast<double>(piece.index) + t, distance(p, between(a, b, t)),
          chain.bound[piece.index]};
}

template <class Value>
void PieceTree::descend(std::size_t node, std::size_t from, std::size_t to, double square,
                        Search<Value>& search) const {
  const double reach = search.best + largest_bound_;
  if (search.best <= search.enough || reach <= 0 || square >= reach * reach) return;
  if (to - from == 1) {
    search.look_at(pieces_, from);
    return;
  }
  const std::size_t middle = from + (to - from) / 2;
  const double left = boxes_[2 * node + 1].square_of_distance(search.box);
  const double right = boxes_[2 * node + 2].square_of_distance(search.box);
  const bool right_first = left > right;
  if (!right_first) descend(2 * node + 1, from, middle, left, search);
  descend(2 * node + 2, middle, to, right, search);
  if (right_first) descend(2 * node + 1, from, middle, left, search);
}

template <class Value>
double PieceTree::least(const Box& box, double enough, std::size_t* first, const Value& value) const {
  Search<Value> search{box, value, enough};
  if (pieces_.empty()) return search.best;
  if (first != nullptr)
    for (std::size_t i = *first; i < std::min(*first + 2, pieces_.size()); ++i) search.look_at(pieces_, i);
  descend(0, 0, pieces_.size(), 0, search);
  if (first != nullptr) *first = search.piece;
  return search.best;
}

double PieceTree::distance_from_below(const SpacePoint& p, double enough, std::size_t* first) const {
  return least({p, p}, enough, first, [&](const Piece& piece) {
    const ChainPlace found = place(piece, p);
    return lower_bound(found.distance - found.bound);
  });
}

double PieceTree::distance_from_above(const SpacePoint& p) const {
  return least({p, p}, never, nullptr, [&](const Piece& piece) {
    const ChainPlace found = place(piece, p);
    return upper_bound(found.distance + found.bound);
  });
}

double PieceTree::distance_from_below(const SpacePoint& a, const SpacePoint& b, double enough) const {
  Box box{a, a};
  for (std::size_t k = 0; k < 3; ++k) {
    box.lower[k] = std::min(a[k], b[k]);
    box.upper[k] = std::max(a[k], b[k]);
  }
  return least(box, enough, nullptr, [&](const Piece& piece) {
    const Chain& chain = chains_[piece.chain];
    return lower_bound(segments_apart(a, b, chain.points[piece.index], chain.points[piece.index + 1]) -
                       chain.bound[piece.index]);
  });
}

double PieceTree::distance_from_above(const SpacePoint& a, const SpacePoint& b, double enough,
                                      std::size_t* first) const {
  // The distance from one piece is a convex function, largest at an end of the segment.
  return least({a, a}, enough, first, [&](const Piece& piece) {
    const Chain& chain = chains_[piece.chain];
    const SpacePoint& c = chain.points[piece.index];
    const SpacePoint& d = chain.points[piece.index + 1];
    const double at_a = distance(a, between(c, d, foot(a, c, d)));
    const double at_b = distance(b, between(c, d, foot(b, c, d)));
    return upper_bound((at_a <= at_b ? at_b : at_a) + chain.bound[piece.index]);
  });
}

void PieceTree::visit(std::size_t node, std::size_t from, std::size_t to, const SpacePoint& p, double radius,
                      const std::function<void(const ChainPlace&)>& found) const {
  if (boxes_[node].square_of_distance({p, p}) > radius * radius) return;
  if (to - from == 1) {
    const ChainPlace here = place(pieces_[from], p);
    if (here.distance <= radius) found(here);
    return;
  }
  const std::size_t middle = from + (to - from) / 2;
  visit(2 * node + 1, from, middle, p, radius, found);
  visit(2 * node + 2, middle, to, p, radius, found);
}

void PieceTree::within(const SpacePoint& p, double radius,
                       const std::function<void(const ChainPlace&)>& found) const {
  if (!pieces_.empty()) visit(0, 0, pieces_.size(), p, radius, found);
}

}  // namespace exsect
