#include "trace/subdivision.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

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
    // Breadth first: what is left when the budget ends are small boxes around the difficult places.
    std::deque<std::pair<Cell<Ball>*, Cell<Ball>*>> waiting = {{&x_.root(), &y_.root()}};
    const std::size_t most_waiting = settled_ ? kMostWaitingOnSurface : kMostWaiting;
    while (!waiting.empty()) {
      auto [a, b] = waiting.front();
      waiting.pop_front();
      ++outcome_.boxes;
      if (separated(*a, *b) || tangent_cannot_vanish(*a, *b, direction_) || is_settled(*a, *b) ||
          covered(*a, *b)) {
        continue;
      }
      const bool stopped = outcome_.boxes > kMostBoxes<Ball> || waiting.size() > most_waiting ||
                           (outcome_.boxes % (settled_ ? 8 : 64) == 0 && is_stopped(stop_));
      const bool first = a->size >= b->size;
      const bool deepest = (first ? a : b)->depth >= kDeepest;
      if (stopped || deepest || !(first ? x_.split(*a) : y_.split(*b))) {
        outcome_.undecided.push_back(region_of(*a, *b));
        if (stopped) {
          give_up(waiting);
        }
        continue;
      }
      for (Cell<Ball>* child : first ? a->children : b->children) {
        if (child != nullptr) {
          waiting.emplace_back(first ? child : a, first ? b : child);
        }
      }
    }
    return std::move(outcome_);
  }

 private:
  static constexpr std::size_t kMostWaiting = 4000;            // around curves
  static constexpr std::size_t kMostWaitingOnSurface = 60000;  // around a surface of solutions

  static BallPoint<Ball> corner(const SearchRegion& region) {
    return {Ball(region.lower[0]), Ball(region.lower[1]), Ball(region.lower[2]), Ball(region.lower[3])};
  }

  static SearchRegion region_of(const Cell<Ball>& a, const Cell<Ball>& b) {
    return {{a.lower[0], a.lower[1], b.lower[0], b.lower[1]},
            {a.upper[0], a.upper[1], b.upper[0], b.upper[1]}};
  }

  void give_up(std::deque<std::pair<Cell<Ball>*, Cell<Ball>*>>& waiting) {
    for (const auto& [a, b] : waiting) {
      outcome_.undecided.push_back(region_of(*a, *b));
    }
    waiting.clear();
  }

  bool is_settled(const Cell<Ball>& a, const Cell<Ball>& b) const {
    return settled_ && a.depth + b.depth >= kFirstCertificateDepth && settled_(region_of(a, b));
  }

  /// A tube whose region contains the whole box, and whose arc is outside the domain somewhere, which traced
  /// curves alone are, or on a known curve.
  bool covered(const Cell<Ball>& a, const Cell<Ball>& b) const {
    if (a.depth + b.depth < kFirstCertificateDepth || !some_tangent_component_cannot_vanish(a, b)) {
      return false;
    }
    const SearchRegion box = region_of(a, b);
    BallPoint<Ball> centre;
    std::array<double, 4> half{};
    for (std::size_t j = 0; j < 4; ++j) {
      centre[j] = Ball(0.5 * (box.lower[j] + box.upper[j]));
      half[j] = 0.5 * (box.upper[j] - box.lower[j]) * kSlack;
    }
    const BallPoint<Ball> tangent = Expansion<Ball>(system_, centre).tangent();
    std::size_t axis = 0;
    for (std::size_t j = 1; j < 4; ++j) {
      if (std::fabs(tangent[j].approximation()) > std::fabs(tangent[axis].approximation())) {
        axis = j;
      }
    }
    const auto start = newton_corrected(system_, centre, axis, 3);
    if (!start) {
      return false;
    }
    double needed = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      const double distance = ((*start)[j] - centre[j]).upper_magnitude();
      const double rise = std::fabs(tangent[j].approximation() / tangent[axis].approximation()) * half[axis];
      if (distance > 2 * (half[j] + rise)) {
        return false;  // the curve is not in the box
      }
      if (j != axis) {
        needed = std::max(needed, distance + half[j] + 1.01 * rise);
      }
    }
    const auto tube = certify_tube(system_, *start, axis, half[axis] * 1.01, needed * 1.01);
    if (!tube || !contains_region(*tube, centre, half)) {
      return false;
    }
    return settled(*tube);
  }

  static bool contains_region(const Tube<Ball>& tube, const BallPoint<Ball>& centre,
                              const std::array<double, 4>& half) {
    BallPoint<Ball> box;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = centre[j].widened(half[j]);
    }
    return contains(tube, box);
  }

  bool settled(const Tube<Ball>& tube) const {
    return std::ranges::any_of(std::array{0.0, -tube.reach, tube.reach},
                               [&](double tau) { return known_(point_at(tube, tau)); });
  }

  const PairSystem<Ball>& system_;
  std::array<double, 2> direction_;
  const SeedHandler<Ball>& known_;
  const SettledRegion& settled_;
  const StopRequest& stop_;
  CellTree<Ball> x_;
  CellTree<Ball> y_;
  SearchOutcome outcome_;
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
