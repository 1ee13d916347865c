// Chains of straight pieces with proved bounds, and what is near a point. Internal to solver/;
// docs/method-verify.md, section 15.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace exsect {

using SpacePoint = std::array<double, 3>;

double distance(const SpacePoint& a, const SpacePoint& b);
/// The largest coordinate in magnitude.
double largest(const SpacePoint& a);
SpacePoint between(const SpacePoint& a, const SpacePoint& b, double t);
/// The parameter in [0,1] of a point of the segment that is nearest to p, up to rounding; 0 for a = b.
double foot(const SpacePoint& p, const SpacePoint& a, const SpacePoint& b);

/// A curve cut into consecutive pieces: piece i is within bound[i] of the segment from points[i] to
/// points[i+1], by a matching of the two that runs forward from end to end (Fréchet distance). at[i] is the
/// curve's own parameter at points[i], exactly. All numbers are finite but bounds, which are never NaN: an
/// infinite one says that nothing is known.
struct Chain {
  std::vector<SpacePoint> points;
  std::vector<double> at;
  std::vector<double> bound;
  bool closed = false;  // the last point is the first one

  std::size_t pieces() const { return bound.size(); }
};

/// A place on one of several chains: position i + t is at the fraction t of piece i.
struct ChainPlace {
  std::size_t chain;
  double position;
  double distance;  // from the point that was asked for
  double bound;     // of the piece
};

/// The pieces of several chains, which must outlive it.
class PieceTree {
 public:
  static constexpr double never = -std::numeric_limits<double>::infinity();

  explicit PieceTree(const std::vector<Chain>& chains);

  bool empty() const { return pieces_.empty(); }
  // With `enough` the search ends at a number that is not above it: the functions "from below" then return
  // some number up to `enough` if what they stand for is not above it, and those "from above" some valid one.
  // It begins at the piece *first, by its number, and leaves there that of the best one.

  /// At most the distance of p from every curve, up to the rounding of some operations on coordinates;
  /// infinite without pieces.
  double distance_from_below(const SpacePoint& p, double enough = never, std::size_t* first = nullptr) const;
  /// At most the distance of every point of the segment from a to b from every curve, up to rounding (15.3).
  double distance_from_below(const SpacePoint& a, const SpacePoint& b, double enough = never) const;
  /// At least the distance of p from the nearest curve, up to rounding; infinite without pieces.
  double distance_from_above(const SpacePoint& p) const;
  /// At least the distance of every point of the segment from the nearest curve, up to rounding (15.4).
  double distance_from_above(const SpacePoint& a, const SpacePoint& b, double enough = never,
                             std::size_t* first = nullptr) const;
  /// Calls `found` for every piece whose segment is within `radius` of p, its place nearest to p, in the
  /// order of chains and positions.
  void within(const SpacePoint& p, double radius, const std::function<void(const ChainPlace&)>& found) const;

 private:
  struct Piece {
    std::size_t chain;
    std::size_t index;
  };
  struct Box {
    SpacePoint lower;
    SpacePoint upper;
    double square_of_distance(const Box& other) const;
  };
  /// A search for the least value of a piece; a value is at least the piece's distance from the box less the
  /// largest bound.
  template <class Value>
  struct Search {
    const Box& box;
    const Value& value;
    double enough;
    double best = std::numeric_limits<double>::infinity();
    std::size_t piece = 0;

    void look_at(const std::vector<Piece>& pieces, std::size_t i) {
      const double found = value(pieces[i]);  // never NaN
      if (found < best) best = found, piece = i;
    }
  };

  void build(std::size_t node, std::size_t from, std::size_t to);
  /// Below a node whose box has this distance from that of the search.
  template <class Value>
  void descend(std::size_t node, std::size_t from, std::size_t to, double square,
               Search<Value>& search) const;
  /// The least value, or the first one found that is not above `enough`.
  template <class Value>
  double least(const Box& box, double enough, std::size_t* first, const Value& value) const;
  ChainPlace place(const Piece& piece, const SpacePoint& p) const;
  void visit(std::size_t node, std::size_t from, std::size_t to, const SpacePoint& p, double radius,
             const std::function<void(const ChainPlace&)>& found) const;

  const std::vector<Chain>& chains_;
  std::vector<Piece> pieces_;
  std::vector<Box> boxes_;  // a binary tree over consecutive pieces, node i above 2i+1 and 2i+2
  double largest_bound_ = 0;
};

}  // namespace exsect
