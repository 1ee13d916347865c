#include "further_branches.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/bernstein_box.h>
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <stdexcept>

#include "curve/positivity.h"
#include "space_bernstein.h"

namespace exsect {
namespace {

using Index = std::array<int, 3>;

/// A cell of the grid of 2^level cells along each side.
struct Cell {
  Index at;
  int level;
  SpaceBox box;
  SpaceBernstein first;
  SpaceBernstein second;
};

std::array<Cell, 2> halves(const Cell& cell, std::size_t axis) {
  auto first = cell.first.split(axis), second = cell.second.split(axis);
  SpaceBox lower = cell.box, upper = cell.box;
  lower[axis].upper = upper[axis].lower = cell.box[axis].midpoint();
  Index below = cell.at, above = cell.at;
  below[axis] = 2 * cell.at[axis];
  above[axis] = 2 * cell.at[axis] + 1;
  return {Cell{below, cell.level, lower, std::move(first.first), std::move(second.first)},
          Cell{above, cell.level, upper, std::move(first.second), std::move(second.second)}};
}

bool is_excluded(const Cell& cell) { return cell.first.sign() != 0 || cell.second.sign() != 0; }

/// The cells of the finest grid in which neither surface is excluded.
std::vector<Cell> cells_met(const SurfacePair& surfaces, const SpaceBox& box, int depth) {
  std::vector<Cell> cells = {
      {{0, 0, 0}, 0, box, SpaceBernstein(surfaces.first, box), SpaceBernstein(surfaces.second, box)}};
  for (int level = 0; level < depth; ++level) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<Cell> next;
      for (const Cell& cell : cells) {
        if (is_excluded(cell)) continue;
        for (Cell& half : halves(cell, axis)) next.push_back(std::move(half));
      }
      cells = std::move(next);
    }
  }
  std::erase_if(cells, is_excluded);
  return cells;
}

/// The box of the control points of a part of the curve.
SpaceBox space_control_box(const HomogeneousCurve& curve, const RationalInterval& t) {
  const int n = curve.degree();
  const std::vector<Rational> w = bernstein_coefficients(curve.denominator, n, t.lower, t.upper);
  SpaceBox box;
  if (*std::min_element(w.begin(), w.end()) <= 0) {
    // No hull without positive weights: those of the halves.
    const SpaceBox a = space_control_box(curve, {t.lower, t.midpoint()});
    const SpaceBox b = space_control_box(curve, {t.midpoint(), t.upper});
    for (std::size_t axis = 0; axis < 3; ++axis)
      box[axis] = {std::min(a[axis].lower, b[axis].lower), std::max(a[axis].upper, b[axis].upper)};
    return box;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Rational> c = bernstein_coefficients(curve.numerators[axis], n, t.lower, t.upper);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] /= w[i];
    const auto [least, greatest] = std::minmax_element(c.begin(), c.end());
    box[axis] = {*least, *greatest};
  }
  return box;
}

bool contains(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.lower && b.upper <= a.upper;
}
bool meets(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}
bool meets(const SpaceBox& a, const SpaceBox& b) {
  return meets(a[0], b[0]) && meets(a[1], b[1]) && meets(a[2], b[2]);
}

RationalInterval product(const RationalInterval& a, const RationalInterval& b) {
  const Rational corners[] = {a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper};
  return {*std::min_element(std::begin(corners), std::end(corners)),
          *std::max_element(std::begin(corners), std::end(corners))};
}
RationalInterval sum(const RationalInterval& a, const RationalInterval& b) {
  return {a.lower + b.lower, a.upper + b.upper};
}
RationalInterval times(const Rational& c, const RationalInterval& a) { return product({c, c}, a); }

using IntervalMatrix = std::array<std::array<RationalInterval, 2>, 2>;
using Matrix = std::array<std::array<Rational, 2>, 2>;

/// An approximate inverse with short entries; nothing if the matrix is nearly singular.
std::optional<Matrix> inverse(const std::array<std::array<double, 2>, 2>& m) {
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  if (!std::isfinite(1 / determinant)) return std::nullopt;
  const auto entry = [&](double q) {
    return from_double(static_cast<double>(static_cast<float>(q / determinant)));
  };
  return Matrix{{{entry(m[1][1]), entry(-m[0][1])}, {entry(-m[1][0]), entry(m[0][0])}}};
}

IntervalMatrix multiplied(const Matrix& y, const IntervalMatrix& j) {
  IntervalMatrix result;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) result[i][k] = sum(times(y[i][0], j[0][k]), times(y[i][1], j[1][k]));
  return result;
}

/// The partial derivatives of both surfaces by the two coordinates other than the axis.
struct Jacobian {
  std::array<std::array<SpacePolynomial, 2>, 2> entries;
  std::array<std::size_t, 2> across;

  Jacobian(const SurfacePair& surfaces, std::size_t axis)
      : across({axis == 0 ? std::size_t{1} : 0, axis == 2 ? std::size_t{1} : 2}) {
    for (std::size_t k = 0; k < 2; ++k) {
      entries[0][k] = surfaces.first.derivative(across[k]);
      entries[1][k] = surfaces.second.derivative(across[k]);
    }
  }

  std::optional<Matrix> inverse_at(const Point& p) const {
    std::array<std::array<double, 2>, 2> m;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) m[i][k] = to_double(entries[i][k](p));
    return inverse(m);
  }

  IntervalMatrix on(const SpaceBox& box) const {
    IntervalMatrix result;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) result[i][k] = SpaceBernstein(entries[i][k], box).range();
    return result;
  }
};

Point midpoint(const SpaceBox& box) { return {box[0].midpoint(), box[1].midpoint(), box[2].midpoint()}; }

/// In the box the surfaces meet in at most one point for each value of the axis coordinate: every matrix of
/// slopes has a determinant other than zero.
bool is_unique_across(const Jacobian& jacobian, const SpaceBox& box) {
  const auto y = jacobian.inverse_at(midpoint(box));
  if (!y) return false;
  const IntervalMatrix m = multiplied(*y, jacobian.on(box));
  const RationalInterval d = sum(product(m[0][0], m[1][1]), times(-1, product(m[0][1], m[1][0])));
  return d.lower > 0 || d.upper < 0;
}

/// A part of the tube: over the axis interval `along` the box holds the curve, at most one meeting point for
/// each value if `is_unique`.
struct TubePart {
  RationalInterval along;
  SpaceBox box;
  bool is_unique;
};

class Tube {
 public:
  Tube(const SurfacePair& surfaces, const BezierCurve& curve, std::size_t axis, const SpaceBox& box,
       int depth)
      : axis_(axis) {
    if (!is_strictly_monotone(curve, static_cast<int>(axis))) return;
    const HomogeneousCurve reduced = homogeneous(curve);
    const Jacobian jacobian(surfaces, axis);
    std::array<Rational, 3> margin;
    SpaceBox reach = box;  // a cell shares values of the axis coordinate with parts a little outside
    for (std::size_t k = 0; k < 3; ++k) {
      margin[k] = box[k].width() / (1 << depth);
      reach[k].lower -= 8 * margin[k];
      reach[k].upper += 8 * margin[k];
    }
    const RationalInterval range = monotone_range(reduced);
    const int parts = std::max(16, 4 << depth);
    const int from = static_cast<int>(Integer(numerator(Rational(range.lower * parts))));
    const int to = static_cast<int>(Integer(numerator(Rational(range.upper * parts))));
    for (int k = from; k < to; ++k) {
      const RationalInterval t = {Rational(k, parts), Rational(k + 1, parts)};
      const SpaceBox part = space_control_box(reduced, t);
      const bool is_near = meets(part, reach);
      RationalInterval along = {coordinate(reduced, t.lower), coordinate(reduced, t.upper)};
      if (along.lower > along.upper) std::swap(along.lower, along.upper);
      parts_.push_back({along, part, false});
      if (is_near) widen(parts_.back(), jacobian, margin);
    }
  }

  bool exists() const { return !parts_.empty(); }

  /// Every meeting point in the box is the one of the tube.
  bool covers(const SpaceBox& box) const {
    Rational least, greatest;
    bool any = false;
    for (const TubePart& part : parts_) {
      if (!meets(part.along, box[axis_])) continue;
      least = any ? std::min(least, part.along.lower) : part.along.lower;
      greatest = any ? std::max(greatest, part.along.upper) : part.along.upper;
      any = true;
      if (!part.is_unique) return false;
      for (std::size_t j = 0; j < 3; ++j)
        if (j != axis_ && !contains(part.box[j], box[j])) return false;
    }
    return any && least <= box[axis_].lower && greatest >= box[axis_].upper;
  }

 private:
  Rational coordinate(const HomogeneousCurve& curve, const Rational& t) const {
    return curve.numerators[axis_](t) / curve.denominator(t);
  }

  /// Enlarges the part by the most of some multiples of the margin for which the meeting points are unique.
  static void widen(TubePart& part, const Jacobian& jacobian, const std::array<Rational, 3>& margin) {
    for (const int multiple : {6, 3, 1}) {
      SpaceBox wide = part.box;
      for (std::size_t j = 0; j < 3; ++j) {
        wide[j].lower -= multiple * margin[j];
        wide[j].upper += multiple * margin[j];
      }
      part.is_unique = is_unique_across(jacobian, wide);
      if (!part.is_unique) continue;
      part.box = wide;
      return;
    }
  }

  /// The largest interval of multiples of 1/16 in [-1,2] around [0,1] on which the axis coordinate is proved
  /// to be monotone and the denominator positive.
  RationalInterval monotone_range(const HomogeneousCurve& curve) const {
    const Polynomial& x = curve.numerators[axis_];
    Polynomial derivative = x.derivative() * curve.denominator - x * curve.denominator.derivative();
    if (derivative(Rational(1, 2)) < 0) derivative = -derivative;
    const auto extends = [&](const RationalInterval& t) {
      return !not_positive(derivative, t) && !not_positive(curve.denominator, t);
    };
    RationalInterval range = {0, 1};
    const Rational step(1, 16);
    while (range.lower > -1 && extends({range.lower - step, range.lower})) range.lower -= step;
    while (range.upper < 2 && extends({range.upper, range.upper + step})) range.upper += step;
    return range;
  }

  std::size_t axis_;
  std::vector<TubePart> parts_;
};

/// The cells in groups of neighbours, corners count.
std::vector<std::vector<Cell>> grouped(std::vector<Cell> cells) {
  std::map<Index, std::size_t> open;
  for (std::size_t i = 0; i < cells.size(); ++i) open[cells[i].at] = i;
  std::vector<std::vector<Cell>> groups;
  while (!open.empty()) {
    std::deque<std::size_t> queue = {open.begin()->second};
    open.erase(open.begin());
    groups.emplace_back();
    while (!queue.empty()) {
      const Index at = cells[queue.front()].at;
      groups.back().push_back(std::move(cells[queue.front()]));
      queue.pop_front();
      for (int n = 0; n < 27; ++n) {
        const auto next = open.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
        if (next == open.end()) continue;
        queue.push_back(next->second);
        open.erase(next);
      }
    }
  }
  return groups;
}

/// Newton's method in doubles for the two coordinates across, from p, then Krawczyk's operator around the
/// result: a box in which both surfaces are proved to meet at the axis coordinate of p.
std::optional<SpaceBox> proved_meeting(const SurfacePair& surfaces, const Jacobian& jacobian, Point p,
                                       const SpaceBox& inside) {
  const auto& across = jacobian.across;
  std::optional<Matrix> y;
  for (int step = 0; step < 12; ++step) {
    y = jacobian.inverse_at(p);
    if (!y) return std::nullopt;
    const Rational f = surfaces.first(p), g = surfaces.second(p);
    for (std::size_t k = 0; k < 2; ++k)
      p[across[k]] = from_double(to_double(Rational(p[across[k]] - (*y)[k][0] * f - (*y)[k][1] * g)));
    for (std::size_t k = 0; k < 2; ++k)
      if (p[across[k]] < inside[across[k]].lower || p[across[k]] > inside[across[k]].upper)
        return std::nullopt;
  }
  SpaceBox box = inside;
  std::array<Rational, 2> radius;
  for (std::size_t k = 0; k < 2; ++k) {
    radius[k] = inside[across[k]].width() * power_of_two(-10);
    box[across[k]] = {p[across[k]] - radius[k], p[across[k]] + radius[k]};
  }
  // All derivatives over an interval of the axis coordinate around that of p: more than needed.
  std::size_t axis = 3 - across[0] - across[1];
  const Rational width = inside[axis].width() * power_of_two(-20);
  box[axis] = {p[axis] - width, p[axis] + width};
  const IntervalMatrix m = multiplied(*y, jacobian.on(box));
  const Rational f = surfaces.first(p), g = surfaces.second(p);
  for (std::size_t k = 0; k < 2; ++k) {
    // |Y F(p)|_k + sum_j |I - Y J|_kj r_j < r_k
    Rational reach = abs(Rational((*y)[k][0] * f + (*y)[k][1] * g));
    for (std::size_t j = 0; j < 2; ++j) {
      const RationalInterval e =
          sum({Rational(k == j ? 1 : 0), Rational(k == j ? 1 : 0)}, times(-1, m[k][j]));
      reach += std::max<Rational>(abs(e.lower), abs(e.upper)) * radius[j];
    }
    if (reach >= radius[k]) return std::nullopt;
  }
  box[axis] = {p[axis], p[axis]};
  return box;
}

/// The box holds no point of the curve.
bool is_off_curve(const HomogeneousCurve& curve, const SpaceBox& box, const RationalInterval& t, int depth) {
  if (!meets(space_control_box(curve, t), box)) return true;
  return depth > 0 && is_off_curve(curve, box, {t.lower, t.midpoint()}, depth - 1) &&
         is_off_curve(curve, box, {t.midpoint(), t.upper}, depth - 1);
}

FurtherBranch branch_of(const std::vector<Cell>& group, const SurfacePair& surfaces,
                        const HomogeneousCurve& curve) {
  FurtherBranch branch = {group.front().box, std::nullopt};
  for (const Cell& cell : group) {
    for (std::size_t k = 0; k < 3; ++k) {
      branch.box[k].lower = std::min(branch.box[k].lower, cell.box[k].lower);
      branch.box[k].upper = std::max(branch.box[k].upper, cell.box[k].upper);
    }
  }
  constexpr std::size_t most_tried = 24;
  const std::size_t step = std::max<std::size_t>(1, group.size() / most_tried);
  for (std::size_t i = 0; i < group.size() && !branch.point; i += step) {
    for (std::size_t axis = 0; axis < 3 && !branch.point; ++axis) {
      const Jacobian jacobian(surfaces, axis);
      const auto point = proved_meeting(surfaces, jacobian, midpoint(group[i].box), group[i].box);
      if (point && is_off_curve(curve, *point, {0, 1}, 14)) branch.point = point;
    }
  }
  return branch;
}

}  // namespace

FurtherBranches further_branches(const SurfacePair& surfaces, const BezierCurve& curve, int axis,
                                 const SpaceBox& box, int depth) {
  return in_nearest_rounding([&]() -> FurtherBranches {
    if (depth < 1 || depth > 7)
      throw std::invalid_argument("further branches: the depth must be from 1 to 7");
    for (const RationalInterval& side : box)
      if (side.lower >= side.upper)
        throw std::invalid_argument("further branches: the box must have positive sides");
    const Tube tube(surfaces, curve, static_cast<std::size_t>(axis), box, depth);
    std::vector<Cell> cells = cells_met(surfaces, box, depth);
    if (tube.exists()) std::erase_if(cells, [&](const Cell& cell) { return tube.covers(cell.box); });
    FurtherBranches result = {{}, tube.exists()};
    const HomogeneousCurve reduced = homogeneous(curve);
    for (const std::vector<Cell>& group : grouped(std::move(cells)))
      result.branches.push_back(branch_of(group, surfaces, reduced));
    return result;
  });
}

}  // namespace exsect
