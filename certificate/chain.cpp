#include "certificate/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace exsect::cli {
namespace {

/// Whether the tube holds the point and what is next to it.
bool contains(const Tube& tube, const Parameters& w, double margin = 0x1p-44) {
  return tube.contains({{{w[0], margin}, {w[1], margin}, {w[2], margin}, {w[3], margin}}});
}

class Chain {
 public:
  Chain(const Equation& equation, std::vector<TracedPoint> points, std::size_t goal, std::vector<Tube>& tubes)
      : equation_(equation), goal_(goal), tubes_(tubes), points_(std::move(points)) {}

  TracedArc run(std::size_t tube) {
    std::size_t at = 0;
    while (true) {
      std::size_t last = at;
      const auto arrived = [&] { return tube != goal_ && last > at && in(goal_, last); };
      while (!arrived() && last + 1 < points_.size() && in(tube, last + 1)) settle(tubes_[tube], ++last);
      if (tube == goal_ && last + 1 == points_.size()) {
        pieces_.push_back({tube, in_monotone_steps(tube, at, last)});
        return {points_, pieces_};
      }
      if (last == at) {
        insert_after(at, tube);
        continue;
      }
      if (last + 1 == points_.size()) {
        insert_before_end(tube);
        continue;
      }
      last = in_monotone_steps(tube, at, last);
      pieces_.push_back({tube, last});
      tube = in(goal_, last) ? goal_ : new_tube(last, tubes_[tube]);
      at = last;
    }
  }

 private:
  bool in(std::size_t tube, std::size_t point) const { return contains(tubes_[tube], points_[point].at); }

  /// A polyline may be as far from the curve as its error bound, in its vertices too, but the points of an
  /// arc are to be on the curve. Those stay that have no point of the curve nearer to them than other points.
  void settle(const Tube& tube, std::size_t point) {
    TracedPoint& p = points_[point];
    if (p.vertex < 0 || point + 1 == points_.size()) return;
    const Vector f = equation_.map.value(p.at);
    double step = 0;
    for (const auto& row : tube.inverse) step = std::max(step, std::abs(checker::dot(row, f)));
    if (!(step > 0x1p-33)) return;
    const Parameters w = on_curve(equation_.map, p.at, tube.axis);
    const double away = 4 * apart(w, p.at);
    const bool is_near = away < distance(point - 1, point) && away < distance(point, point + 1);
    if (is_near && contains(tube, w)) p.at = w;
  }

  /// A tube that holds the point `last` and goes on as far beyond it as possible.
  std::size_t new_tube(std::size_t last, const Tube& before) {
    const double limit = std::min(1.0, std::exp2(std::ceil(std::log2(4 * before.width))));
    for (double reach = 0.8 * before.reach;;) {
      std::size_t middle = last;
      while (middle + 1 < points_.size() && distance(last, middle + 1) <= reach) ++middle;
      const Parameters& w = points_[middle].at;
      const Tube tube = tube_at(equation_, w, best_axis(equation_.map, w), Turns::often, limit);
      // Cells where it meets the tube before are small unless both hold some of the curve.
      const double margin = middle == last ? 0x1p-44 : tube.width / 10;
      if (contains(tube, points_[last].at, margin)) {
        tubes_.push_back(tube);
        return tubes_.size() - 1;
      }
      if (middle == last) throw NoCertificate("an arc that could not be followed by tubes");
      reach = 0.85 * std::min(reach, tube.reach);
    }
  }
  /// Adds points in the tube until the check finds each parameter monotone on every step from point `first`
  /// to `last`; the number of that one then.
  std::size_t in_monotone_steps(std::size_t tube, std::size_t first, std::size_t last) {
    const Tube& t = tubes_[tube];
    const checker::CurveBounds<double> bounds = bounds_in(equation_.map, t);
    const auto constant = factored(equation_, t);
    std::array<bool, 4> open;
    for (std::size_t i = 0; i < 4; ++i)
      open[i] = !(constant && (*constant)[i]) && !definite(bounds.first[i]) && !definite(bounds.second[i]);
    if (t.chart != Chart::pair || open == std::array<bool, 4>{}) return last;
    for (std::size_t a = first, b = last; a < last;) {
      if (monotone(t, bounds, open, a, b)) {
        a = b;
        b = last;
      } else if (b > a + 1) {
        b = (a + b) / 2;
      } else {
        insert_between(a, t);
        ++last;
      }
    }
    return last;
  }
  /// The open parameters are so, on the part of the tube's curve between the points.
  bool monotone(const Tube& tube, const checker::CurveBounds<double>& bounds, const std::array<bool, 4>& open,
                std::size_t a, std::size_t b) const {
    constexpr double near = 0x1p-32;
    const std::size_t k = tube.axis;
    const Parameters& middle = points_[(a + b) / 2].at;
    const auto box = checker::around_chord(tube, bounds, points_[a].at, points_[b].at, near, open);
    const auto over = checker::bounds_over(equation_.map, k, checker::middles(box), checker::radii(box));
    const double length =
        std::max(std::abs(middle[k] - points_[a].at[k]), std::abs(middle[k] - points_[b].at[k]));
    const auto signs =
        checker::slope_signs(equation_.map, k, over, middle, near, rounding_margin * length + near);
    bool result = rounding_margin * over.defect < 1;
    for (std::size_t i = 0; i < 4; ++i) result = result && (!open[i] || signs[i] != 0);
    return result;
  }
  /// A point of the curve in the tube between the point and the next one.
  void insert_between(std::size_t point, const Tube& tube) {
    const Parameters& a = points_[point].at;
    const Parameters& b = points_[point + 1].at;
    if (points_.size() > 200000 || !(std::abs(a[tube.axis] - b[tube.axis]) > 0x1p-36))
      throw NoCertificate("an arc on which a parameter may turn");
    Parameters w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = (a[i] + b[i]) / 2;
    w = on_curve(equation_.map, w, tube.axis);
    if (!contains(tube, w)) throw NoCertificate("an arc that leaves a tube");
    points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(point) + 1, {w, -1});
  }
  double distance(std::size_t a, std::size_t b) const { return apart(points_[a].at, points_[b].at); }

  /// A point of the curve in the tube on the way to the next vertex, which is outside.
  void insert_after(std::size_t at, std::size_t tube) {
    if (points_.size() > 200000) throw NoCertificate("an arc that needs too many tubes");
    const Tube& t = tubes_[tube];
    const double end = points_[at + 1].at[t.axis];
    const double begin = points_[at].at[t.axis];
    const double limit = t.centre[t.axis] + (end > begin ? 1 : -1) * 0.9 * t.reach;
    double step =
        (end > begin) == (limit > begin) ? std::min(std::abs(limit - begin), 0.5 * std::abs(end - begin)) : 0;
    for (; step > 0x1p-36; step /= 2) {
      Parameters w = points_[at].at;
      const double t0 = begin + (end > begin ? step : -step);
      for (std::size_t i = 0; i < 4; ++i) w[i] += (t0 - begin) * (i == t.axis ? 1 : t.slope[i]);
      w[t.axis] = t0;
      w = on_curve(equation_.map, w, t.axis);
      if (contains(t, w)) {
        points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(at) + 1, {w, -1});
        return;
      }
    }
    throw NoCertificate("an arc that leaves a tube on the wrong side");
  }

  /// A point of the curve shortly before its end, where it goes from the tube to that of the last node.
  void insert_before_end(std::size_t tube) {
    const Tube& t = tubes_[goal_];
    const Parameters& end = points_.back().at;
    const double back = points_[points_.size() - 2].at[t.axis] - end[t.axis];
    for (double step = back / 2; std::abs(step) > 0x1p-36; step /= 2) {
      Parameters w = end;
      for (std::size_t i = 0; i < 4; ++i) w[i] += step * t.slope[i];
      w = on_curve(equation_.map, w, t.axis);
      if (contains(t, w) && contains(tubes_[tube], w)) {
        points_.insert(points_.end() - 1, {w, -1});
        return;
      }
    }
    throw NoCertificate("an arc whose end could not be joined to its node's tube");
  }

  const Equation equation_;
  std::size_t goal_;
  std::vector<Tube>& tubes_;
  std::vector<TracedPoint> points_;
  std::vector<TracedPiece> pieces_;
};

}  // namespace

TracedArc chain(const Equation& equation, const std::vector<TracedPoint>& points, std::size_t first_tube,
                std::size_t last_tube, std::vector<Tube>& tubes) {
  return Chain(equation, points, last_tube, tubes).run(first_tube);
}

}  // namespace exsect::cli
