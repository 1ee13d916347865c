#include "filter/line.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "filter/tube_derivatives.h"
#include "filter/tube_newton.h"

namespace exsect::filter {

namespace {

/// Levels of curve and patch together at which certificates are tried, and the search is given up. With
/// weights the scale varies in larger boxes too much for most tries to succeed.
template <class K>
constexpr int kFirstLineTry = K::weighted ? 8 : 6;
constexpr int kLastLineLevel = 40;
/// Of all searches of a pair. Nothing is behind the pairs that are not biquadratic.
template <class K>
constexpr long kMostLineBoxes = std::is_same_v<K, Biquadratic> ? 3000 : 40000;
/// Of biquadratic pairs: enough to come near one.
template <class K>
constexpr long kMostBoxesToPlace = std::is_same_v<K, Biquadratic> ? 400 : kMostLineBoxes<K>;

/// Bound of the error of the control points computed below, for an inner line.
template <class K>
double line_error(const Line& line) {
  return kLineRounding<K::degree> + kLineError<K::degree> * line.error;
}

template <std::size_t Rows>
Vec<Rows> curve_between(const Vec<Rows>& a, const Vec<Rows>& b, double t) {
  return a + t * (b - a);
}

/// Exactly those of the net on a side.
template <class K>
std::array<Row<K>, K::side> control_points(const PatchOf<K>& patch, std::size_t fixed, double value) {
  constexpr std::size_t n = K::degree;
  const std::size_t across = fixed % 2 == 0 ? kFirst<K> : kSecond;
  const std::size_t along = kFirst<K> + kSecond - across;
  std::array<Row<K>, K::side> result;
  for (std::size_t k = 0; k <= n; ++k) {
    std::array<Row<K>, K::side> p;
    for (std::size_t i = 0; i <= n; ++i) p[i] = patch.net[along * k + across * i];
    const double t = value + 0.5;
    for (std::size_t level = 1; std::fabs(value) != 0.5 && level <= n; ++level) {
      for (std::size_t i = 0; i + level <= n; ++i) p[i] = curve_between(p[i], p[i + 1], t);
    }
    result[k] = value == 0.5 ? p[n] : p[0];
  }
  return result;
}

/// A piece of the line and a sub-patch as a box of parameters, with width 0 in the fixed one.
template <class K>
struct Box {
  Unknowns<K> centre;
  Unknowns<K> half;
};
template <class K>
Box<K> box_of(const Line& line, const SubCurveOf<K>& curve, const SubPatchOf<K>& patch) {
  const std::size_t along = line.fixed ^ 1U;
  const std::size_t first = line.fixed < 2 ? 2 : 0;
  Box<K> box;
  box.centre[line.fixed] = line.value;
  box.half[line.fixed] = 0;
  box.half[along] = 0.5 * curve.width;
  box.centre[along] = curve.from + 0.5 * curve.width;
  box.half[first] = box.half[first + 1] = 0.5 * patch.width;
  box.centre[first] = patch.first + 0.5 * patch.width;
  box.centre[first + 1] = patch.second + 0.5 * patch.width;
  if constexpr (K::weighted) {
    const RangeOfScale scale = line.fixed < 2 ? range_of_scale(curve, patch) : range_of_scale(patch, curve);
    box.centre[4] = scale.middle;
    box.half[4] = scale.half;
  }
  return box;
}

template <class K>
class LineSearch {
 public:
  LineSearch(const PairOf<K>& pair, const Line& line, const ContactsOf<K>& contacts, PatchTreeOf<K>& tree,
             long& boxes)
      : pair_(pair),
        line_(line),
        contacts_(contacts),
        tree_(tree),
        boxes_(boxes),
        error_(kSlack * (pair.net_error + line_error<K>(line))) {}

  /// The points on the line; empty if undecided.
  std::optional<std::vector<BallOf<K>>> run(long most_boxes) {
    const PatchOf<K>& owner = line_.fixed < 2 ? pair_.x : pair_.y;
    curves_.reserve(32);
    curves_.push_back(
        {make_curve<K>(control_points(owner, line_.fixed, line_.value), -0.5, 1, 0, error_), 0});
    stack_.reserve(32);
    stack_.push_back({0, 0});
    while (!stack_.empty()) {
      const Item item = stack_.back();
      stack_.pop_back();
      if (++boxes_ > most_boxes || !process(item)) {
        undecided_ = first_four<K>(box_of(line_, curves_[item.curve].piece, tree_[item.patch]).centre);
        return std::nullopt;
      }
    }
    std::vector<BallOf<K>> points;
    for (const Root& root : roots_) {
      if (root.inside) {
        points.push_back(root.ball);
      }
    }
    return points;
  }

  /// Where it has ended undecided.
  const std::optional<Vec4>& undecided() const { return undecided_; }

 private:
  struct Curve {
    SubCurveOf<K> piece;
    std::size_t halves;  // index of the first of two; 0: not yet made
  };
  struct Item {  // indices
    std::size_t curve;
    std::size_t patch;
  };
  struct Root {
    TubeOf<K> tube;  // tau in [-line.error, line.error] only
    BallOf<K> ball;
    bool inside;
  };

  bool process(const Item& item) {
    const SubCurveOf<K>& curve = curves_[item.curve].piece;
    const SubPatchOf<K>& patch = tree_[item.patch];
    if (separated(curve, patch, error_)) {
      return true;
    }
    const Meeting meeting = meeting_of(curve, patch);
    if (meeting == Meeting::contact) {
      return true;
    }
    const int depth = curve.level + patch.level;
    if (depth >= kFirstLineTry<K> && meeting == Meeting::unknown) {
      const Box<K> box = box_of(line_, curve, patch);
      if (std::any_of(roots_.begin(), roots_.end(),
                      [&](const Root& root) { return covers(root.tube, box); })) {
        return true;
      }
      Root root;
      if (covered(box, root.tube)) {
        if (add(root)) {
          return true;
        }
        if (contacts_.empty()) {
          return false;
        }  // else it may be the end of one nearby
      }
    }
    if (depth >= kLastLineLevel) {
      return false;
    }
    subdivide(item);
    return true;
  }

  Meeting meeting_of(const SubCurveOf<K>& curve, const SubPatchOf<K>& patch) const {
    if (contacts_.empty()) {
      return Meeting::unknown;
    }
    const Part on_line = part_of(curve, line_.fixed % 2, line_.value);
    const Part other = part_of(patch);
    return line_.fixed < 2 ? meeting<K>(pair_, contacts_, on_line, other)
                           : meeting<K>(pair_, contacts_, other, on_line);
  }

  void subdivide(const Item& item) {
    const SubCurveOf<K>& curve = curves_[item.curve].piece;
    const SubPatchOf<K>& patch = tree_[item.patch];
    if (extent(curve.lower, curve.upper) > extent(patch.lower, patch.upper)) {
      const std::size_t first = halves_of(item.curve);
      stack_.push_back({first, item.patch});
      stack_.push_back({first + 1, item.patch});
      return;
    }
    const std::size_t children = tree_.split(item.patch);
    for (std::size_t k = 0; k < 4; ++k) {
      stack_.push_back({item.curve, children + k});
    }
  }

  /// Index of the first half; all references to curves end.
  std::size_t halves_of(std::size_t i) {
    if (curves_[i].halves == 0) {
      const std::array<SubCurveOf<K>, 2> both = halves(curves_[i].piece, error_);
      curves_[i].halves = curves_.size();
      curves_.push_back({both[0], 0});
      curves_.push_back({both[1], 0});
    }
    return curves_[i].halves;
  }

  /// Bounds of |w_j - centre_j - tau slope_j| in the tube's unknowns over the box and the line's tau.
  double farthest(const TubeOf<K>& tube, const Box<K>& box, std::size_t j) const {
    const double across = std::fabs(box.centre[j] - tube.centre[j]) + box.half[j];
    return kSlack * (in_tube(tube, j, across) + line_.error * std::fabs(tube.slope[j])) + kPlaceRounding;
  }

  bool covers(const TubeOf<K>& tube, const Box<K>& box) const {
    return std::all_of(tube.others.begin(), tube.others.end(),
                       [&](std::size_t j) { return farthest(tube, box, j) <= tube.halfwidth[j]; });
  }

  /// A certificate on the line whose region contains the box.
  bool covered(const Box<K>& box, TubeOf<K>& tube) const {
    if constexpr (K::weighted) {
      if (!(box.half[4] <= 1)) {
        return false;
      }
    }
    Unknowns<K> centre = box.centre;
    if (!improve(pair_, centre, line_.fixed, 3)) {
      return false;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      if (std::fabs(centre[j] - box.centre[j]) > 6 * box.half[j]) {
        return false;
      }
    }
    if (!prepare(pair_, centre, line_.fixed, tube)) {
      return false;
    }
    Unknowns<K> halfwidth;
    for (std::size_t j = 0; j < K::unknowns; ++j) {
      halfwidth[j] = farthest(tube, box, j);
    }
    widen_scale<K>(halfwidth);
    return certify(pair_, tube, -line_.error, line_.error, halfwidth);
  }

  /// The point on the line, wherever the line is within its error.
  BallOf<K> point_on_line(TubeOf<K>& tube) const {
    BallOf<K> ball = point_at(tube, 0);
    if (line_.error > 0) {
      bound_derivatives(pair_, tube);
      double steep = 1;
      for (std::size_t j = 0; j < K::unknowns; ++j) {  // of the scale, at most 1, the slope is relative
        steep = larger_bound(steep, std::fabs(tube.slope[j]) + tube.slope_error[j]);
      }
      ball.radius = kSlack * (ball.radius + line_.error * steep);
    }
    return ball;
  }

  static Box<K> around(const Unknowns<K>& middle, double radius) {
    Box<K> box{middle, {}};
    box.half.fill(radius);
    return box;
  }

  /// The root of a new certificate, unless an older one is it.
  bool add(Root& root) {
    root.ball = point_on_line(root.tube);
    const double margin = root.ball.radius + kPlacing;  // the node's box must be in the region
    if (!(root.ball.radius < 0.25 * kEndMargin<K::width>) ||
        !covers(root.tube, around(root.ball.middle, margin))) {
      return false;
    }
    for (const Root& old : roots_) {
      if (covers(root.tube, around(old.ball.middle, old.ball.radius))) {
        return true;
      }
      const bool different =
          std::any_of(root.tube.others.begin(), root.tube.others.end(), [&](std::size_t j) {
            return std::fabs(old.ball.middle[j] - root.ball.middle[j]) >
                   kSlack * (old.ball.radius + root.ball.radius) + kPlaceRounding;
          });
      if (!different) {
        return false;
      }
    }
    bool outside = false;
    bool inside = true;
    for (const std::size_t j : root.tube.others) {
      if (j == 4) {
        continue;
      }
      const double from_centre = std::fabs(root.ball.middle[j]);
      const double error = kSlack * root.ball.radius + kSumRounding;
      outside = outside || from_centre - 0.5 > error;
      inside = inside && 0.5 - from_centre > error;
    }
    if (!outside && !inside) {
      return false;  // perhaps on two sides
    }
    root.inside = inside;
    roots_.push_back(root);
    return true;
  }

  const PairOf<K>& pair_;
  Line line_;
  std::optional<Vec4> undecided_;
  const ContactsOf<K>& contacts_;
  PatchTreeOf<K>& tree_;
  long& boxes_;
  double error_;  // of the line's control points and sub-patches
  std::vector<Curve> curves_;
  std::vector<Item> stack_;
  std::vector<Root> roots_;
};

}  // namespace

template <class K>
std::optional<std::vector<BallOf<K>>> points_on_line(const PairOf<K>& pair, const Line& line,
                                                     const ContactsOf<K>& contacts, PatchTreeOf<K>& other,
                                                     long& boxes) {
  return LineSearch<K>(pair, line, contacts, other, boxes).run(kMostLineBoxes<K>);
}

template <class K>
std::optional<Vec4> undecided_on_line(const PairOf<K>& pair, const Line& line, const ContactsOf<K>& contacts,
                                      PatchTreeOf<K>& other) {
  long boxes = 0;
  LineSearch<K> search(pair, line, contacts, other, boxes);
  search.run(kMostBoxesToPlace<K>);
  return search.undecided();
}

#define EXSECT_INSTANTIATE(K)                                                                            \
  template std::optional<std::vector<BallOf<K>>> points_on_line<K>(                                      \
      const PairOf<K>&, const Line&, const ContactsOf<K>&, PatchTreeOf<K>&, long&);                      \
  template std::optional<Vec4> undecided_on_line<K>(const PairOf<K>&, const Line&, const ContactsOf<K>&, \
                                                    PatchTreeOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
