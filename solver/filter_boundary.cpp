#include "filter_boundary.h"

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

/// Levels of curve and patch together at which certificates are tried, and the search is given up.
constexpr int kFirstTry = 6;
constexpr int kLast = 36;
constexpr long kMostBoxes = 3000;

/// A boundary line runs along `along`; the other patch has the parameters `first`, first + 1.
struct Line {
  std::size_t fixed;
  std::size_t along;
  std::size_t first;
  double side;
};

std::array<Vec3, 3> control_points(const Patch& patch, std::size_t fixed, double side) {
  const std::size_t at = side > 0 ? 2 : 0;
  const auto& p = patch.net;
  return fixed % 2 == 0 ? std::array<Vec3, 3>{p[3 * at], p[3 * at + 1], p[3 * at + 2]}
                        : std::array<Vec3, 3>{p[at], p[3 + at], p[6 + at]};
}

/// A piece of the line and a sub-patch as a box of parameters, with width 0 in the fixed one.
struct Box {
  Vec4 centre;
  Vec4 half;
};
Box box_of(const Line& line, const SubCurve& curve, const SubPatch& patch) {
  Box box;
  box.centre[line.fixed] = line.side;
  box.half[line.fixed] = 0;
  box.half[line.along] = 0.5 * curve.width;
  box.centre[line.along] = curve.from + 0.5 * curve.width;
  box.half[line.first] = box.half[line.first + 1] = 0.5 * patch.width;
  box.centre[line.first] = patch.first + 0.5 * patch.width;
  box.centre[line.first + 1] = patch.second + 0.5 * patch.width;
  return box;
}

/// Bounds of |w_j - centre_j| over the box, one for each coordinate.
double farthest(const Tube& tube, const Vec4& middle, const Vec4& half, std::size_t j) {
  return kSlack * (std::fabs(middle[j] - tube.centre[j]) + half[j]) + 0x1p-50;
}

class LineSearch {
 public:
  LineSearch(const Pair& pair, const Line& line, PatchTree& tree, long& boxes)
      : pair_(pair), line_(line), tree_(tree), boxes_(boxes) {}

  /// Appends the points on the line; false if undecided.
  bool run(std::vector<BoundaryPoint>& points) {
    const Patch& owner = line_.fixed < 2 ? pair_.x : pair_.y;
    stack_.push_back({make_curve(control_points(owner, line_.fixed, line_.side), -0.5, 1, 0), 0});
    while (!stack_.empty()) {
      const Item item = stack_.back();
      stack_.pop_back();
      if (++boxes_ > kMostBoxes || !process(item)) {
        return false;
      }
    }
    for (const Root& root : roots_) {
      if (root.inside) {
        points.push_back({root.ball, line_.fixed, line_.side});
      }
    }
    return true;
  }

 private:
  struct Item {
    SubCurve curve;
    std::size_t patch;
  };
  struct Root {
    Tube tube;  // tau = 0 only
    Ball ball;
    bool inside;
  };

  bool process(const Item& item) {
    const SubPatch& patch = tree_[item.patch];
    if (separated(item.curve, patch, pair_.net_error)) {
      return true;
    }
    const int depth = item.curve.level + patch.level;
    if (depth >= kFirstTry) {
      const Box box = box_of(line_, item.curve, patch);
      if (std::any_of(roots_.begin(), roots_.end(),
                      [&](const Root& root) { return covers(root.tube, box); })) {
        return true;
      }
      Root root;
      if (covered(box, root.tube)) {
        return add(root);
      }
    }
    if (depth >= kLast) {
      return false;
    }
    subdivide(item, patch);
    return true;
  }

  void subdivide(const Item& item, const SubPatch& patch) {
    if (extent(item.curve.lower, item.curve.upper) > extent(patch.lower, patch.upper)) {
      for (const SubCurve& half : halves(item.curve)) {
        stack_.push_back({half, item.patch});
      }
      return;
    }
    const std::size_t children = tree_.split(item.patch);
    for (std::size_t k = 0; k < 4; ++k) {
      stack_.push_back({item.curve, children + k});
    }
  }

  bool covers(const Tube& tube, const Box& box) const {
    return std::all_of(tube.others.begin(), tube.others.end(), [&](std::size_t j) {
      return farthest(tube, box.centre, box.half, j) <= tube.halfwidth[j];
    });
  }

  /// A certificate on the line whose region contains the box.
  bool covered(const Box& box, Tube& tube) const {
    Vec4 centre = box.centre;
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
    Vec4 halfwidth;
    for (std::size_t j = 0; j < 4; ++j) {
      halfwidth[j] = farthest(tube, box.centre, box.half, j);
    }
    return certify(pair_, tube, 0, 0, halfwidth);
  }

  /// The root of a new certificate, unless an older one is it.
  bool add(Root& root) {
    root.ball = point_at(root.tube, 0);
    const double margin = root.ball.radius + 0x1p-48;  // the node's box must be in the region
    if (!(root.ball.radius < 0.25 * kEndMargin) ||
        !covers(root.tube, {root.ball.middle, {margin, margin, margin, margin}})) {
      return false;
    }
    for (const Root& old : roots_) {
      const Vec4 old_radius = {old.ball.radius, old.ball.radius, old.ball.radius, old.ball.radius};
      if (covers(root.tube, {old.ball.middle, old_radius})) {
        return true;
      }
      const bool different =
          std::any_of(root.tube.others.begin(), root.tube.others.end(), [&](std::size_t j) {
            return std::fabs(old.ball.middle[j] - root.ball.middle[j]) >
                   kSlack * (old.ball.radius + root.ball.radius) + 0x1p-50;
          });
      if (!different) {
        return false;
      }
    }
    root.inside = true;
    for (const std::size_t j : root.tube.others) {
      const double from_centre = std::fabs(root.ball.middle[j]);
      if (!(std::fabs(from_centre - 0.5) > kSlack * root.ball.radius + 0x1p-52)) {
        return false;  // perhaps on two sides
      }
      root.inside = root.inside && from_centre < 0.5;
    }
    roots_.push_back(root);
    return true;
  }

  const Pair& pair_;
  Line line_;
  PatchTree& tree_;
  long& boxes_;
  std::vector<Item> stack_;
  std::vector<Root> roots_;
};

}  // namespace

std::optional<std::vector<BoundaryPoint>> boundary_points(const Pair& pair, Trees& trees, long& boxes) {
  std::vector<BoundaryPoint> points;
  for (std::size_t fixed = 0; fixed < 4; ++fixed) {
    const std::size_t first = fixed < 2 ? 2 : 0;
    for (const double side : {-0.5, 0.5}) {
      const Line line = {fixed, fixed ^ 1U, first, side};
      if (!LineSearch(pair, line, fixed < 2 ? trees.y : trees.x, boxes).run(points)) {
        return std::nullopt;
      }
    }
  }
  return points;
}

}  // namespace exsect::filter
