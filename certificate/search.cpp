#include "certificate/search.h"

#include <exsect/checker/factors.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace exsect::cli {
namespace {

using checker::Matrix3;
using checker::others;

double largest(const Matrix3<double>& m) {
  double most = 0;
  for (const auto& row : m)
    for (const double a : row) most = std::max(most, std::abs(a));
  return most;
}

/// a rounded to a multiple of 2^-bits.
double rounded(double a, int bits) { return std::ldexp(std::nearbyint(std::ldexp(a, bits)), -bits); }

/// w_axis held: w - C F(w).
Parameters newton_step(const Map& map, Parameters w, std::size_t axis) {
  const Map local = map.at(w);
  const auto c = inverse(local, axis);
  if (!c) throw NoCertificate("a point where Newton's method fails");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 3; ++d) w[others(axis)[i]] -= (*c)[i][d] * local.value(d);
  return w;
}

/// Nothing else vanishes in the tube; the parameters that are constant in it.
std::optional<std::array<bool, 4>> factored(const Equation& equation, const Tube& tube) {
  if (!equation.factor) return equation.constant;
  checker::Box<double> box;
  const Parameters extent = tube.extent();
  for (std::size_t i = 0; i < 4; ++i) box[i] = {tube.centre[i], extent[i] * (1 + 0x1p-20)};
  if (!checker::independent<double>(equation.factor->columns, box)) return std::nullopt;
  return checker::constant_in<double>(equation.factor->exact.map, box);
}

constexpr double more = 1 + 1e-3;  // a margin for rounding
bool definite(const checker::Ball<double>& b) {
  return std::abs(b.middle) > more * b.radius && std::abs(b.middle) > 1e-11;
}

/// Every condition of the check, with a margin for rounding.
bool holds(const Tube& tube, const Equation& equation, const Map& local, Turns turns) {
  for (const double slack : checker::contraction(tube, local))
    if (!(slack > 0.05 * tube.width)) return false;
  const Parameters extent = tube.extent();
  const auto bounds = checker::curve_bounds(local, tube.axis, extent);
  if (tube.chart != Chart::pair)
    return checker::monotone_pairs(tube, bounds, more * (tube.centre[3] + tube.reach));
  const auto constant = factored(equation, tube);
  if (!constant) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool inside = tube.centre[i] >= extent[i] && tube.centre[i] + extent[i] <= 1;
    const bool may_turn = inside && (turns == Turns::often || definite(bounds.second[i]));
    if (!(*constant)[i] && !definite(bounds.first[i]) && !may_turn) return false;
  }
  return true;
}

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
      while (!arrived() && last + 1 < points_.size() && in(tube, last + 1)) ++last;
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
    const auto signs = checker::slope_signs(equation_.map, k, over, middle, near, more * length + near);
    bool result = more * over.defect < 1;
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
  /// Of two points: in the parameter in which they are furthest apart.
  double distance(std::size_t a, std::size_t b) const {
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) most = std::max(most, std::abs(points_[a].at[i] - points_[b].at[i]));
    return most;
  }

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

std::optional<Matrix3<double>> inverse(const Map& local, std::size_t k) {
  const auto o = others(k);
  const std::array<Vector, 3> c = {column(local, o[0]), column(local, o[1]), column(local, o[2])};
  const double det = checker::dot(c[0], checker::cross(c[1], c[2]));
  if (!std::isfinite(1 / det)) return std::nullopt;
  Matrix3<double> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& a = c[(i + 1) % 3];
    const Vector& b = c[(i + 2) % 3];
    for (std::size_t d = 0; d < 3; ++d)
      m[i][d] = (a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3]) / det;
  }
  return m;
}

Vector column(const Map& local, std::size_t j) {
  const auto c = local.first(j, {});
  return {c[0].middle, c[1].middle, c[2].middle};
}

Parameters tangent(const Map& map, const Parameters& w) {
  const Map local = map.at(w);
  Parameters t;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto o = others(k);
    t[k] = (k % 2 == 0 ? 1 : -1) *
           checker::dot(column(local, o[0]), checker::cross(column(local, o[1]), column(local, o[2])));
  }
  return t;
}

std::size_t best_axis(const Map& map, const Parameters& w) {
  const Parameters t = tangent(map, w);
  std::size_t k = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::abs(t[i]) > std::abs(t[k])) k = i;
  return k;
}

Parameters on_curve(const Map& map, Parameters w, std::size_t fixed) {
  for (int i = 0; i < 6; ++i) w = newton_step(map, w, fixed);
  return w;
}

Parameters turning_point(const Map& map, Parameters w, std::size_t axis, std::size_t i) {
  for (int n = 0; n < 8; ++n) {
    const Map local = map.at(w);
    const auto c = inverse(local, axis);
    if (!c) throw NoCertificate("a turning point where Newton's method fails");
    const auto bounds = checker::curve_bounds(local.times(*c), axis, {});
    const double step = -bounds.first[i].middle / bounds.second[i].middle;
    if (!std::isfinite(step)) throw NoCertificate("a turning point of higher order");
    for (std::size_t j = 0; j < 4; ++j) w[j] += step * bounds.first[j].middle;
    w = newton_step(map, newton_step(map, w, axis), axis);
  }
  return w;
}

Tube tube_at(const Equation& equation, const Parameters& w, std::size_t axis, Turns turns, double limit) {
  const auto& [map, chart, number, factor, constant] = equation;
  const Map here = map.at(w);
  auto c = inverse(here, axis);
  if (!c) throw NoCertificate("a point where the patches touch");
  // Short numbers, but C DF is to be 1 to 12 bits.
  double steps = 1;
  for (std::size_t j = 0; j < 4; ++j)
    for (const double a : column(here, j)) steps = std::max(steps, std::abs(a));
  const int more = std::max(0, std::ilogb(steps * largest(*c)));
  for (auto& row : *c)
    for (double& a : row) a = rounded(a, 12 + std::ilogb(steps) + 1);
  const auto slope = checker::curve_bounds(here.times(*c), axis, {}).first;
  double steepest = 1;
  for (const auto& b : slope) steepest = std::max(steepest, std::abs(b.middle));
  const int flat = std::ilogb(steepest);
  // The curve runs through the middle of a cube, but for the places of the centre's last bits.
  const auto tube_of = [&](double size) {
    Tube tube = {{chart}, w, axis, {}, std::ldexp(size, -flat), size, *c, number};
    for (std::size_t i = 0; i < 4; ++i) tube.slope[i] = i == axis ? 1 : rounded(slope[i].middle, 10);
    return tube;
  };
  const Map near = here.times(*c);
  const auto found = [&](Tube& tube) {
    if (!holds(tube, equation, near, turns)) return false;
    for (double& at : tube.centre) at = rounded(at, 12 + more - std::ilogb(tube.width));
    // m of the cuspidal point is that of the middle line.
    if (chart != Chart::pair) tube.centre = {tube.centre[0], tube.centre[1], w[2], 0};
    return holds(tube, equation, map.at(tube.centre).times(*c), turns);
  };
  for (double size = limit / 2; size > 0x1p-46; size /= 2) {
    Tube tube = tube_of(size);
    if (!found(tube)) continue;
    for (const double larger : {1.75, 1.5, 1.25}) {
      Tube other = tube_of(larger * size);
      if (found(other)) return other;
    }
    return tube;
  }
  throw NoCertificate("a point where no tube was found");
}

checker::CurveBounds<double> bounds_in(const Map& map, const Tube& tube) {
  return checker::curve_bounds(map.at(tube.centre).times(tube.inverse), tube.axis, tube.extent());
}

namespace {

// Of long maps the errors of the check in doubles count, and are computed as it does.

checker::Map<checker::Enclosure> in_enclosures(const Map& map) {
  checker::Map<checker::Enclosure> result;
  result.set_long(map.is_long());
  for (const auto& term : map.terms())
    for (std::size_t d = 0; d < 3; ++d) result.coefficient(term.power)[d] = checker::Enclosure(term.c[d]);
  return result;
}
checker::Vector4<checker::Enclosure> in_enclosures(const Parameters& w) {
  checker::Vector4<checker::Enclosure> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = checker::Enclosure(w[i]);
  return result;
}

/// At least |C F(w)|, component by component, in the check.
double checked_distance(const Map& map, const Tube& tube, const Parameters& w) {
  const checker::Vector3<checker::Enclosure> f = in_enclosures(map).value(in_enclosures(w));
  checker::Enclosure most = 0;
  for (const auto& row : tube.inverse) {
    checker::Vector3<checker::Enclosure> c;
    for (std::size_t d = 0; d < 3; ++d) c[d] = checker::Enclosure(row[d]);
    most = larger(most, magnitude(checker::dot(c, f)));
  }
  return 2 * most.above();  // coefficients are rounded there
}

}  // namespace

checker::Box<double> tangent_near(const Map& map, const Parameters& w, double near) {
  if (!map.is_long()) return checker::tangent(map.at(w), {near, near, near, near});
  const checker::Enclosure h(near);
  const auto t = checker::tangent(in_enclosures(map).at(in_enclosures(w)), {h, h, h, h});
  checker::Box<double> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double middle = approximate(t[i].middle);
    result[i] = {middle, 2 * (t[i].magnitude().above() - std::abs(middle))};
  }
  return result;
}

double distance(const Map& map, const Tube& tube, const Parameters& w) {
  if (map.is_long()) return checked_distance(map, tube, w) / (1 - bounds_in(map, tube).defect);
  const Map local = map.at(w).times(tube.inverse);
  const double defect = bounds_in(map, tube).defect;
  double most = 0;
  for (std::size_t d = 0; d < 3; ++d) most = std::max(most, std::abs(local.value(d)));
  return (most + 4e-15 * largest(tube.inverse)) / (1 - defect);
}

Parameters pair_of(Chart chart, const Parameters& z, int side) {
  const double t = side * std::sqrt(z[3]);
  const double m = z[2] * t;
  return chart == Chart::first ? Parameters{z[0] + t, z[1] + m, z[0] - t, z[1] - m}
                               : Parameters{z[1] + m, z[0] + t, z[1] - m, z[0] - t};
}

Parameters in_chart(Chart chart, const Parameters& w) {
  const std::size_t p = chart == Chart::first ? 0 : 1;
  const double t = (w[p] - w[p + 2]) / 2;
  return {(w[p] + w[p + 2]) / 2, (w[1 - p] + w[3 - p]) / 2, (w[1 - p] - w[3 - p]) / (2 * t), t * t};
}

TracedArc chain(const Equation& equation, const std::vector<TracedPoint>& points, std::size_t first_tube,
                std::size_t last_tube, std::vector<Tube>& tubes) {
  return Chain(equation, points, last_tube, tubes).run(first_tube);
}

}  // namespace exsect::cli
