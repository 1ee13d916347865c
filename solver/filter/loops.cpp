#include "filter/loops.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <type_traits>

#include "filter/direction_nets.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Levels of both patches together at which certificates are tried, and the search is given up. With weights
/// the scale varies in larger boxes too much for most tries to succeed.
template <class K>
constexpr int kFirstLoopTry = K::weighted ? 8 : 6;
constexpr int kLastLoopLevel = 40;
/// Nothing is behind the pairs that are not biquadratic.
template <class K>
constexpr long kMostLoopBoxes = std::is_same_v<K, Biquadratic> ? 6000 : 40000;
template <class K>  // around double points
constexpr long kMostBoxesAround = std::is_same_v<K, Biquadratic> ? 20000 : 80000;

/// One net for every sub-patch that asks for it.
template <class Net>
class NetCache {
 public:
  template <class Make>
  const Net& get(std::size_t node, const Make& make) {
    if (node >= index_.size()) {
      index_.resize(2 * node + 64, kNone);
    }
    if (index_[node] == kNone) {
      index_[node] = nets_.size();
      nets_.push_back(make());
    }
    return nets_[index_[node]];
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> index_;
  std::deque<Net> nets_;
};

/// The directions c that are tried.
const std::array<std::array<double, 2>, 16>& search_directions() {
  static const auto directions = [] {
    std::array<std::array<double, 2>, 16> result;
    for (std::size_t i = 0; i < result.size(); ++i) {
      const double angle = 0.19 * static_cast<double>(i);
      result[i] = {std::cos(angle), std::sin(angle)};
    }
    return result;
  }();
  return directions;
}

/// The direction c for which c.(u',v') keeps clearest away from zero on the curves known: any c is legal, a
/// good one leaves fewer boxes.
template <class K>
std::array<double, 2> search_direction(const std::vector<TraceOf<K>>& traces) {
  const auto& directions = search_directions();
  std::array<double, 16> least;  // of (c.(u',v'))^2 by |(u',v')|^2
  least.fill(1);
  for (const TraceOf<K>& trace : traces) {
    for (const PieceOf<K>& piece : trace.pieces) {
      const double u = piece.tube.slope[0];
      const double v = piece.tube.slope[1];
      const double share = 1 / std::max(1e-300, u * u + v * v);
      for (std::size_t i = 0; i < least.size(); ++i) {
        const double along = directions[i][0] * u + directions[i][1] * v;
        least[i] = std::min(least[i], along * along * share);
      }
    }
  }
  const auto best = std::max_element(least.begin(), least.end()) - least.begin();
  return directions[static_cast<std::size_t>(best)];
}

template <class K>
class LoopSearch {
 public:
  LoopSearch(const PairOf<K>& pair, const ContactsOf<K>& contacts,
             const std::vector<DoublePointOf<K>>& double_points, TreesOf<K>& trees,
             const std::vector<BoundaryPointOf<K>>& points, std::vector<TraceOf<K>>& traces, long& boxes)
      : pair_(pair),
        contacts_(contacts),
        double_points_(double_points),
        trees_(trees),
        points_(points),
        traces_(traces),
        boxes_(boxes),
        c_(search_direction(traces)) {}

  bool run(Vec4& stuck) {
    stack_.reserve(64);
    stack_.push_back({0, 0});
    const long most = boxes_ + (double_points_.empty() ? kMostLoopBoxes<K> : kMostBoxesAround<K>);
    while (!stack_.empty()) {
      const PiecePair item = stack_.back();
      stack_.pop_back();
      if (++boxes_ > most || !process(item)) {
        stuck = first_four<K>(box_of(trees_.x[item.x], trees_.y[item.y]).middle);
        return false;
      }
    }
    return true;
  }

 private:
  bool process(const PiecePair& item) {
    const SubPatchOf<K>& x = trees_.x[item.x];
    const SubPatchOf<K>& y = trees_.y[item.y];
    if (separated(x, y, pair_.net_error)) {
      return true;
    }
    const Meeting at =
        contacts_.empty() ? Meeting::unknown : meeting<K>(pair_, contacts_, part_of(x), part_of(y));
    if (at == Meeting::contact || (at == Meeting::unknown && keeps_direction(item, x, y))) {
      return true;
    }
    if (is_at_double_point(x, y)) {
      return true;
    }
    const int depth = x.level + y.level;
    TubeOf<K> tube;
    if (depth >= kFirstLoopTry<K> && at == Meeting::unknown && covered(x, y, tube)) {
      const std::optional<bool> known = known_or_traced(tube);
      if (known) {
        return *known;
      }
    }
    if (depth >= kLastLoopLevel) {
      return false;
    }
    trees_.split_larger(item, stack_);
    return true;
  }

  /// c.T has no zero on the two.
  bool keeps_direction(const PiecePair& item, const SubPatchOf<K>& x, const SubPatchOf<K>& y) {
    const DirectionNetOf<K>& d =
        directions_.get(item.x, [&] { return direction_net(x, c_, pair_.net_error); });
    const std::array<Row<K>, 4>& at_corners = corners_.get(item.y, [&] { return corner_normals<K>(y); });
    if (changes_sign<K>(d, at_corners)) {
      return false;
    }
    const NormalNetOf<K>& n = normals_.get(item.y, [&] { return normal_net(y, pair_.net_error); });
    return never_orthogonal<K>(d, n);
  }

  struct Box {
    Unknowns<K> middle;
    Unknowns<K> half;
  };
  static Box box_of(const SubPatchOf<K>& x, const SubPatchOf<K>& y) {
    const double hx = 0.5 * x.width;
    const double hy = 0.5 * y.width;
    Box box{{x.first + hx, x.second + hx, y.first + hy, y.second + hy}, {hx, hx, hy, hy}};
    if constexpr (K::weighted) {
      const RangeOfScale scale = range_of_scale(x, y);
      box.middle[4] = scale.middle;
      box.half[4] = scale.half;
    }
    return box;
  }

  bool is_at_double_point(const SubPatchOf<K>& x, const SubPatchOf<K>& y) const {
    return std::any_of(double_points_.begin(), double_points_.end(), [&](const DoublePointOf<K>& point) {
      const Box box = box_of(x, y);
      return lies_in_region(point, first_four<K>(box.middle), first_four<K>(box.half));
    });
  }

  /// A tube whose region contains the box.
  bool covered(const SubPatchOf<K>& x, const SubPatchOf<K>& y, TubeOf<K>& tube) const {
    const auto [middle, half] = box_of(x, y);
    if constexpr (K::weighted) {
      if (!(half[4] <= 1)) {
        return false;
      }
    }
    const Linearisation<K> at = linearise(pair_, middle);
    const std::size_t axis = steepest(first_four<K>(at.tangent), first_four<K>(half));
    Unknowns<K> centre = middle;
    if (!improve(pair_, centre, axis, 2)) {
      return false;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      if (std::fabs(centre[j] - middle[j]) > 8 * half[j]) {
        return false;
      }
    }
    if (!prepare(pair_, centre, axis, tube)) {
      return false;
    }
    Unknowns<K> width;
    for (std::size_t j = 0; j < K::unknowns; ++j) {
      const double across = std::fabs(centre[j] - middle[j]) + half[j];
      width[j] = kSlack * (in_tube(tube, j, across) + std::fabs(tube.slope[j]) * half[axis]) + kPlacing;
    }
    widen_scale<K>(width);
    return certify(pair_, tube, -half[axis], half[axis], width);
  }

  /// True: the tube's arc is known, or is outside the domain at one point, or on a closed curve that is now
  /// traced. False: the search has failed. Empty: undecided.
  std::optional<bool> known_or_traced(const TubeOf<K>& tube) {
    const BallOf<K> seed = point_at(tube, 0);
    bool inside = true;
    for (const double w : parameters_of(seed)) {
      if (std::fabs(w) > 0.5 + kSlack * seed.radius + kPlaceRounding) {
        return true;
      }
      inside = inside && std::fabs(w) < 0.5 - kSlack * seed.radius - kPlaceRounding;
    }
    for (const TraceOf<K>& trace : traces_) {
      if (std::any_of(trace.pieces.begin(), trace.pieces.end(),
                      [&](const PieceOf<K>& piece) { return contains(piece.tube, seed); })) {
        return true;
      }
    }
    for (const KnownBox& box : contacts_.boxes) {
      const std::optional<bool> is_known =
          is_in(box, std::span(seed.middle).template first<4>(), seed.radius);
      if (is_known != std::optional(false)) {
        return is_known;
      }
    }
    if (!inside) {
      return std::nullopt;
    }
    std::optional<TraceOf<K>> loop = trace_loop(pair_, points_, tube, 0);
    if (!loop || !differs_from_known_loops(*loop)) {
      return false;
    }
    traces_.push_back(std::move(*loop));
    return true;
  }

  /// True only if a point of every known closed curve is not on this one.
  bool differs_from_known_loops(const TraceOf<K>& loop) const {
    return std::all_of(traces_.begin(), traces_.end(), [&](const TraceOf<K>& known) {
      if (known.start >= 0) {
        return true;
      }
      const BallOf<K> point = point_at(known.pieces.front().tube, known.pieces.front().range.from());
      return std::all_of(loop.pieces.begin(), loop.pieces.end(),
                         [&](const PieceOf<K>& piece) { return excludes(piece.tube, point); });
    });
  }

  const PairOf<K>& pair_;
  const ContactsOf<K>& contacts_;
  const std::vector<DoublePointOf<K>>& double_points_;
  TreesOf<K>& trees_;
  const std::vector<BoundaryPointOf<K>>& points_;
  std::vector<TraceOf<K>>& traces_;
  long& boxes_;
  std::array<double, 2> c_;
  NetCache<DirectionNetOf<K>> directions_;
  NetCache<std::array<Row<K>, 4>> corners_;
  NetCache<NormalNetOf<K>> normals_;
  std::vector<PiecePair> stack_;
};

}  // namespace

template <class K>
bool add_loops(const PairOf<K>& pair, const ContactsOf<K>& contacts,
               const std::vector<DoublePointOf<K>>& double_points, TreesOf<K>& trees,
               const std::vector<BoundaryPointOf<K>>& points, std::vector<TraceOf<K>>& traces, long& boxes,
               Vec4& stuck) {
  return LoopSearch<K>(pair, contacts, double_points, trees, points, traces, boxes).run(stuck);
}

#define EXSECT_INSTANTIATE(K)                                                                               \
  template bool add_loops<K>(const PairOf<K>&, const ContactsOf<K>&, const std::vector<DoublePointOf<K>>&,  \
                             TreesOf<K>&, const std::vector<BoundaryPointOf<K>>&, std::vector<TraceOf<K>>&, \
                             long&, Vec4&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
