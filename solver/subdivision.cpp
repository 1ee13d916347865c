#include "subdivision.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>
#include <utility>

namespace exsect {

namespace {

template <class Ball>
constexpr long kMostBoxes = 200000;
template <>
inline constexpr long kMostBoxes<DoubleDoubleBall> = 40000;
template <>
inline constexpr long kMostBoxes<ArbBall<256>> = 10000;
constexpr int kFirstCertificateDepth = 4;
constexpr int kDeepest = 24;  // halvings of either cell

/// Closed interval of doubles around everything a ball may be: the last terms cover the rounding of the
/// difference and of approximation().
struct Bounds {
  double lower;
  double upper;
};
template <class Ball>
Bounds bounds(const Ball& b) {
  const double a = b.approximation();
  const double r = b.radius() * (1 + 0x1p-50) + 0x1p-50 * std::fabs(a) + 0x1p-1000;
  return {a - r, a + r};
}

DoubleBall enclose(const Bounds& b) {
  const double mid = 0.5 * (b.lower + b.upper);
  const double rad = std::max(b.upper - mid, mid - b.lower);
  return DoubleBall(mid, 0).widened(rad * (1 + 0x1p-50) + 0x1p-50 * std::fabs(mid));
}

Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

using DirectionBox = std::array<DoubleBall, 3>;

/// A rectangle of one parameter square with the Bernstein net of its sub-patch.
template <class Ball>
struct Cell {
  std::array<double, 2> lower;
  std::array<double, 2> upper;
  std::array<BallVector<Ball>, 9> net;  // [3 i + j]
  std::array<Bounds, 3> box;
  std::array<DirectionBox, 2> derivative;  // with respect to the cell's own unit square, divided by 2
  std::array<double, 3> normal;            // approximate, any direction is legal
  double size;
  int depth;
  std::array<Cell*, 4> children = {};
};

template <class Ball>
void complete(Cell<Ball>& cell) {
  cell.size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    cell.box[c] = bounds(cell.net[0][c]);
    for (std::size_t i = 1; i < 9; ++i) {
      cell.box[c] = hull(cell.box[c], bounds(cell.net[i][c]));
    }
    cell.size = std::max(cell.size, cell.box[c].upper - cell.box[c].lower);
    for (std::size_t direction = 0; direction < 2; ++direction) {
      const std::size_t step = direction == 0 ? 3 : 1;
      Bounds all = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (std::size_t i = 0; i < 9; ++i) {
        if (direction == 0 ? i < 6 : i % 3 < 2) {
          all = hull(all, bounds(cell.net[i + step][c] - cell.net[i][c]));
        }
      }
      cell.derivative[direction][c] = enclose(all);
    }
  }
  const auto& a = cell.derivative[0];
  const auto& b = cell.derivative[1];
  const auto mid = [](const DoubleBall& ball) { return ball.approximation(); };
  cell.normal = {mid(a[1]) * mid(b[2]) - mid(a[2]) * mid(b[1]), mid(a[2]) * mid(b[0]) - mid(a[0]) * mid(b[2]),
                 mid(a[0]) * mid(b[1]) - mid(a[1]) * mid(b[0])};
}

/// de Casteljau at 1/2 of three consecutive points with the given stride: left and right halves.
template <class Ball>
void halve(const std::array<BallVector<Ball>, 9>& net, std::size_t first, std::size_t stride,
           std::array<BallVector<Ball>, 9>& left, std::array<BallVector<Ball>, 9>& right) {
  const Ball half(0.5);
  for (std::size_t c = 0; c < 3; ++c) {
    const Ball& p0 = net[first][c];
    const Ball& p1 = net[first + stride][c];
    const Ball& p2 = net[first + 2 * stride][c];
    const Ball q0 = half * (p0 + p1);
    const Ball q1 = half * (p1 + p2);
    const Ball m = half * (q0 + q1);
    left[first][c] = p0;
    left[first + stride][c] = q0;
    left[first + 2 * stride][c] = m;
    right[first][c] = m;
    right[first + stride][c] = q1;
    right[first + 2 * stride][c] = p2;
  }
}

/// The cells of one patch, split into four or two on demand.
template <class Ball>
class CellTree {
 public:
  CellTree(const TaylorNet<Ball>& taylor_at_corner, const std::array<double, 2>& lower,
           const std::array<double, 2>& upper) {
    Cell<Ball> root;
    root.lower = lower;
    root.upper = upper;
    root.depth = 0;
    // Power basis in the cell's own coordinates, then b = power + shifts (degree 2 in each direction).
    const std::array<Ball, 2> width = {Ball(upper[0]) - Ball(lower[0]), Ball(upper[1]) - Ball(lower[1])};
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<Ball, 9> a;
      for (std::size_t i = 0; i < 9; ++i) {
        a[i] = taylor_at_corner[i][c];
        for (std::size_t k = 0; k < i / 3; ++k) {
          a[i] *= width[0];
        }
        for (std::size_t k = 0; k < i % 3; ++k) {
          a[i] *= width[1];
        }
      }
      to_bernstein(a, 3, 1);
      to_bernstein(a, 1, 3);
      for (std::size_t i = 0; i < 9; ++i) {
        root.net[i][c] = a[i];
      }
    }
    complete(root);
    cells_.push_back(std::move(root));
  }

  Cell<Ball>& root() { return cells_.front(); }

  /// False if the midpoints are not doubles: the cell cannot be split. In a direction in which it is thin it
  /// is left as it is, and there are two children, the others null.
  bool split(Cell<Ball>& cell) {
    if (cell.children[0] != nullptr) {
      return true;
    }
    std::array<double, 2> middle{};
    for (std::size_t k = 0; k < 2; ++k) {
      middle[k] = 0.5 * (cell.lower[k] + cell.upper[k]);
      if (middle[k] - cell.lower[k] != cell.upper[k] - middle[k] || !(middle[k] > cell.lower[k])) {
        return false;
      }
    }
    const double first = extent(cell.derivative[0]);
    const double second = extent(cell.derivative[1]);
    const std::size_t rows = kThin * first < second ? 1 : 2;
    const std::size_t columns = kThin * second < first ? 1 : 2;
    std::array<Net, 2> half = {cell.net, cell.net};
    for (std::size_t j = 0; j < 3 && rows == 2; ++j) {
      halve(cell.net, j, 3, half[0], half[1]);
    }
    for (std::size_t a = 0; a < rows; ++a) {
      std::array<Net, 2> quarter = {half[a], half[a]};
      for (std::size_t i = 0; i < 9 && columns == 2; i += 3) {
        halve(half[a], i, 1, quarter[0], quarter[1]);
      }
      for (std::size_t b = 0; b < columns; ++b) {
        Cell<Ball> child;
        child.lower = {a == 0 ? cell.lower[0] : middle[0], b == 0 ? cell.lower[1] : middle[1]};
        child.upper = {a + 1 == rows ? cell.upper[0] : middle[0],
                       b + 1 == columns ? cell.upper[1] : middle[1]};
        child.net = std::move(quarter[b]);
        child.depth = cell.depth + 1;
        complete(child);
        cells_.push_back(std::move(child));
        cell.children[2 * a + b] = &cells_.back();
      }
    }
    return true;
  }

 private:
  using Net = std::array<BallVector<Ball>, 9>;
  static constexpr double kThin = 4;

  static double extent(const DirectionBox& derivative) {
    return std::max(
        {derivative[0].upper_magnitude(), derivative[1].upper_magnitude(), derivative[2].upper_magnitude()});
  }

  /// Power to Bernstein, degree 2: b0 = a0, b1 = a0 + a1/2, b2 = a0 + a1 + a2, along `stride`.
  static void to_bernstein(std::array<Ball, 9>& a, std::size_t stride, std::size_t other) {
    for (std::size_t i = 0; i < 3; ++i) {
      Ball& a0 = a[i * other];
      Ball& a1 = a[i * other + stride];
      Ball& a2 = a[i * other + 2 * stride];
      a2 = a0 + a1 + a2;
      a1 = a0 + Ball(0.5) * a1;
    }
  }

  std::deque<Cell<Ball>> cells_;  // stable addresses
};

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

  /// A tube whose region contains the whole box, and whose arc is outside the domain somewhere or on a known
  /// curve.
  bool covered(const Cell<Ball>& a, const Cell<Ball>& b) const {
    if (a.depth + b.depth < kFirstCertificateDepth || !some_tangent_component_cannot_vanish(a, b)) {
      return false;
    }
    const SearchRegion box = region_of(a, b);
    BallPoint<Ball> centre;
    std::array<double, 4> half{};
    for (std::size_t j = 0; j < 4; ++j) {
      centre[j] = Ball(0.5 * (box.lower[j] + box.upper[j]));
      half[j] = 0.5 * (box.upper[j] - box.lower[j]) * (1 + 0x1p-40);
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
      if (((*start)[j] - centre[j]).upper_magnitude() > 2 * half[j]) {
        return false;
      }
      const double slope = tangent[j].approximation() / tangent[axis].approximation();
      if (j != axis) {
        needed = std::max(needed, ((*start)[j] - centre[j]).upper_magnitude() + half[j] +
                                      1.01 * std::fabs(slope) * half[axis]);
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
    for (const double tau : {0.0, -tube.reach, tube.reach}) {
      for (const Ball& c : point_at(tube, tau)) {
        if (c.is_negative() || (c - Ball(1)).is_positive()) {
          return true;
        }
      }
    }
    return known_(point_at(tube, 0));
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

namespace {

/// The cells of a dyadic grid that hold the regions, at most `most` of them.
std::vector<SearchRegion> coarsened(const std::vector<SearchRegion>& regions, std::size_t most) {
  for (double grid = 0x1p-12;; grid *= 2) {
    std::set<std::pair<std::array<double, 4>, std::array<double, 4>>> cells;
    for (const SearchRegion& region : regions) {
      std::array<double, 4> lower{};
      std::array<double, 4> upper{};
      for (std::size_t j = 0; j < 4; ++j) {
        lower[j] = grid * std::floor(region.lower[j] / grid);
        upper[j] = grid * std::ceil(region.upper[j] / grid);
      }
      cells.emplace(lower, upper);
    }
    if (cells.size() > most) {
      continue;
    }
    std::vector<SearchRegion> result;
    for (const auto& [lower, upper] : cells) {
      result.push_back({lower, upper});
    }
    return result;
  }
}

constexpr std::size_t kMostMerged = 500;  // merging takes their number squared, or cubed

}  // namespace

std::vector<SearchRegion> merged(std::vector<SearchRegion> regions) {
  if (regions.size() > kMostMerged) {
    regions = coarsened(regions, kMostMerged);
  }
  const auto touch = [](const SearchRegion& a, const SearchRegion& b) {
    bool meets = true;
    for (std::size_t j = 0; j < 4; ++j) {
      meets = meets && a.lower[j] <= b.upper[j] && b.lower[j] <= a.upper[j];
    }
    return meets;
  };
  std::vector<SearchRegion> groups;
  while (!regions.empty()) {
    SearchRegion group = regions.back();
    regions.pop_back();
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t i = regions.size(); i-- > 0;) {
        if (touch(group, regions[i])) {
          for (std::size_t j = 0; j < 4; ++j) {
            group.lower[j] = std::min(group.lower[j], regions[i].lower[j]);
            group.upper[j] = std::max(group.upper[j], regions[i].upper[j]);
          }
          regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(i));
          grown = true;
        }
      }
    }
    groups.push_back(group);
  }
  return groups;
}

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
#undef EXSECT_INSTANTIATE_SEARCH

}  // namespace exsect
