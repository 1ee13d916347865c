#include "trace/subdivision.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "trace/covering_tube.h"
#include "trace/subdivision_cell.h"
#include "trace/tube_points.h"

namespace exsect {

namespace {

using namespace subdivision;

template <class Ball>
constexpr long kMostBoxes = 200000;
template <>
inline constexpr long kMostBoxes<DoubleDoubleBall> = 40000;
template <long Bits>
inline constexpr long kMostBoxes<ArbBall<Bits>> = Bits > 256 ? 1000 : 10000;
constexpr int kFirstCertificateDepth = 4;
constexpr int kDeepest = 24;  // halvings of either cell
/// By the size of a box: a curve that is found farther away is not in it.
constexpr double kFarFromBox = 2;

template <class Ball>
bool separated_along(const Cell<Ball>& a, const Cell<Ball>& b, const std::array<double, 3>& n) {
  const auto extent = [&n](const Cell<Ball>& cell) {
    Bounds all = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const BallVector<Ball>& p : cell.net) {
      all = hull(all, bounds(Ball(n[0]) * p[0] + Ball(n[1]) * p[1] + Ball(n[2]) * p[2]));
    }
    return all;
  };
  const Bounds ea = extent(a);
  const Bounds eb = extent(b);
  return ea.upper < eb.lower || eb.upper < ea.lower;
}

template <class Ball>
bool separated(const Cell<Ball>& a, const Cell<Ball>& b) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (a.box[c].upper < b.box[c].lower || b.box[c].upper < a.box[c].lower) {
      return true;
    }
  }
  return separated_along(a, b, a.normal) || separated_along(a, b, b.normal);
}

/// c.T = (c_u x_v - c_v x_u).(y_r x y_s) up to the positive factor of the cells' widths.
template <class Ball>
bool tangent_cannot_vanish(const Cell<Ball>& a, const Cell<Ball>& b, const std::array<double, 2>& c) {
  const DoubleBall cu = DoubleBall(c[0]) * DoubleBall(a.upper[0] - a.lower[0]).widened(0x1p-50);
  const DoubleBall cv = DoubleBall(c[1]) * DoubleBall(a.upper[1] - a.lower[1]).widened(0x1p-50);
  DirectionBox d;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = cu * a.derivative[1][k] - cv * a.derivative[0][k];
  }
  return dot(d, cross(b.derivative[0], b.derivative[1])).certain_sign() != 0;
}

/// Some component of T, up to a positive factor, cannot vanish: all curves in the two cells run along it.
/// Without one a tube around both is hardly ever certified.
template <class Ball>
bool some_tangent_component_cannot_vanish(const Cell<Ball>& a, const Cell<Ball>& b) {
  const auto cannot_vanish = [](const Cell<Ball>& along, const Cell<Ball>& across) {
    const DirectionBox normal = cross(across.derivative[0], across.derivative[1]);
    return dot(along.derivative[0], normal).certain_sign() != 0 ||
           dot(along.derivative[1], normal).certain_sign() != 0;
  };
  return cannot_vanish(a, b) || cannot_vanish(b, a);
}

template <class Ball>
class Search {
 public:
  Search(const PairSystem<Ball>& system, const SearchRegion& region, const std::array<double, 2>& direction,
         const SeedHandler<Ball>& known, const SettledRegion& settled, const StopRequest& stop)
      : system_(system),
        direction_(direction),
        known_(known),
        settled_(settled),
        stop_(stop),
        x_(system.taylor_x(corner(region)), {region.lower[0], region.lower[1]},
           {region.upper[0], region.upper[1]}),
        y_(system.taylor_y(corner(region)), {region.lower[2], region.lower[3]},
           {region.upper[2], region.upper[3]}) {}

  SearchOutcome run() {
    return search_breadth_first(
        *this, {{&x_.root(), &y_.root()}},
        {kMostBoxes<Ball>, settled_ ? kMostWaitingOnSurface : kMostWaiting, settled_ ? 8 : 64}, stop_);
  }

  using Cell = std::pair<subdivision::Cell<Ball>*, subdivision::Cell<Ball>*>;

  bool is_done(const Cell& cell) const {
    const auto& [a, b] = cell;
    return separated(*a, *b) || tangent_cannot_vanish(*a, *b, direction_) || is_settled(cell) ||
           is_covered(cell);
  }

  bool split(const Cell& cell, std::deque<Cell>& waiting) {
    const auto& [a, b] = cell;
    const bool first = a->size >= b->size;
    if ((first ? a : b)->depth >= kDeepest || !(first ? x_.split(*a) : y_.split(*b))) return false;
    for (subdivision::Cell<Ball>* child : first ? a->children : b->children) {
      if (child != nullptr) waiting.emplace_back(first ? child : a, first ? b : child);
    }
    return true;
  }

  static SearchRegion region_of(const Cell& cell) {
    const auto& [a, b] = cell;
    return {{a->lower[0], a->lower[1], b->lower[0], b->lower[1]},
            {a->upper[0], a->upper[1], b->upper[0], b->upper[1]}};
  }

 private:
  static constexpr std::size_t kMostWaiting = 4000;            // around curves
  static constexpr std::size_t kMostWaitingOnSurface = 60000;  // around a surface of solutions

  static BallPoint<Ball> corner(const SearchRegion& region) {
    return {Ball(region.lower[0]), Ball(region.lower[1]), Ball(region.lower[2]), Ball(region.lower[3])};
  }

  static int depth(const Cell& cell) { return cell.first->depth + cell.second->depth; }

  bool is_settled(const Cell& cell) const {
    return settled_ && depth(cell) >= kFirstCertificateDepth && settled_(region_of(cell));
  }

  /// A tube whose region contains the whole box, and whose arc is outside the domain somewhere, which traced
  /// curves alone are, or on a known curve.
  bool is_covered(const Cell& cell) const {
    if (depth(cell) < kFirstCertificateDepth ||
        !some_tangent_component_cannot_vanish(*cell.first, *cell.second)) {
      return false;
    }
    const auto tube = covering_tube(system_, region_of(cell), std::nullopt, kFarFromBox);
    return tube && is_arc_known(*tube, known_);
  }

  const PairSystem<Ball>& system_;
  std::array<double, 2> direction_;
  const SeedHandler<Ball>& known_;
  const SettledRegion& settled_;
  const StopRequest& stop_;
  CellTree<Ball> x_;
  CellTree<Ball> y_;
};

}  // namespace

template <class Ball>
SearchOutcome search_closed_curves(const PairSystem<Ball>& system, const SearchRegion& region,
                                   const std::array<double, 2>& direction, const SeedHandler<Ball>& known,
                                   const SettledRegion& settled, const StopRequest& stop) {
  return Search<Ball>(system, region, direction, known, settled, stop).run();
}

#define EXSECT_INSTANTIATE_SEARCH(Ball)                                                               \
  template SearchOutcome search_closed_curves(const PairSystem<Ball>&, const SearchRegion&,           \
                                              const std::array<double, 2>&, const SeedHandler<Ball>&, \
                                              const SettledRegion&, const StopRequest&);

EXSECT_INSTANTIATE_SEARCH(DoubleBall)
EXSECT_INSTANTIATE_SEARCH(DoubleDoubleBall)
EXSECT_INSTANTIATE_SEARCH(ArbBall<256>)
EXSECT_INSTANTIATE_SEARCH(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_SEARCH

}  // namespace exsect
