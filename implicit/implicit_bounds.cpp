#include "implicit_bounds.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/bernstein_box.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/homogeneous_composition.h>
#include <exsect/geometry/implicit_curve.h>
#include <exsect/geometry/planar_space.h>

#include <algorithm>
#include <array>
#include <deque>
#include <stdexcept>

#include "curve/positivity.h"
#include "curve/short_rational.h"

namespace exsect {
namespace {

constexpr int first_segments = 8;
constexpr int most_segments = 256;
const char* const undefined_there = "the spline is not defined on a neighbourhood of the curve";
const char* const gradient_vanishes = "no positive lower bound of |grad f| near the curve";

/// A polynomial of f with what the bound needs of it.
struct Piece {
  BivariatePolynomial f;
  int degree;
  Polynomial along;           // W^degree f(p(t))
  BivariatePolynomial slope;  // |grad f|^2
};

/// Bounds of one segment of the curve.
struct Segment {
  RationalInterval t;
  std::optional<Rational> residual;
  std::optional<Rational> distance;
  const char* why = nullptr;
};

PlanarBox inflated(const PlanarBox& box, const Rational& by) {
  return {{box.x.lower - by, box.x.upper + by}, {box.y.lower - by, box.y.upper + by}};
}

/// A lower bound of f on the box: Bernstein coefficients after `levels` divisions of both sides.
Rational lower_bound(const BernsteinBox& f, int levels) {
  const Rational here = f.lower();
  if (levels == 0) return here;
  const auto [a, b] = f.split_r();
  const auto [aa, ab] = a.split_s();
  const auto [ba, bb] = b.split_s();
  return std::max(here, std::min({lower_bound(aa, levels - 1), lower_bound(ab, levels - 1),
                                  lower_bound(ba, levels - 1), lower_bound(bb, levels - 1)}));
}

/// The larger of two bounds; none if one is missing.
std::optional<Rational> larger(const std::optional<Rational>& a, const std::optional<Rational>& b) {
  return a && b ? std::optional(std::max(*a, *b)) : std::nullopt;
}

class OneSided {
 public:
  OneSided(const PlanarFunction& f, const HomogeneousCurve& curve) : f_(f), curve_(curve) {}

  OneSidedBound bound();

 private:
  const Piece& piece(const BivariatePolynomial& f);
  Segment examine(const RationalInterval& t);
  std::vector<Segment> segments();
  std::optional<Rational> residual(const RationalInterval& t);
  std::optional<Rational> distance(const RationalInterval& t, const Rational& residual, const char*& why);
  std::optional<Rational> slope_below(const PlanarBox& box, const char*& why);

  const PlanarFunction& f_;
  const HomogeneousCurve& curve_;
  std::deque<Piece> pieces_;
};

const Piece& OneSided::piece(const BivariatePolynomial& f) {
  for (const Piece& known : pieces_)
    if (known.f == f) return known;
  const BivariatePolynomial dx = f.derivative_r(), dy = f.derivative_s();
  pieces_.push_back({f, std::max(f.total_degree(), 0), composed(f, curve_), dx * dx + dy * dy});
  return pieces_.back();
}

/// An upper bound of |f(p(t))| over the segment.
std::optional<Rational> OneSided::residual(const RationalInterval& t) {
  const std::vector<BivariatePolynomial> polynomials =
      f_.polynomials_on(control_box(curve_, t.lower, t.upper));
  if (polynomials.empty()) return std::nullopt;
  const Rational least = positive_lower_bound(curve_.denominator, t);
  Rational bound = 0;
  for (const BivariatePolynomial& f : polynomials) {
    const Piece& known = piece(f);
    if (known.along.is_zero()) continue;
    Rational largest = 0;
    for (const Rational& b : bernstein_coefficients(known.along, known.along.degree(), t.lower, t.upper))
      largest = std::max<Rational>(largest, abs(b));
    for (int k = 0; k < known.degree && least != 1; ++k) largest /= least;
    bound = std::max(bound, largest);
  }
  return rounded_up(bound);
}

/// A lower bound of |grad f| on the box, positive; else nothing and the reason.
std::optional<Rational> OneSided::slope_below(const PlanarBox& box, const char*& why) {
  const std::vector<BivariatePolynomial> polynomials = f_.polynomials_on(box);
  why = polynomials.empty() ? undefined_there : gradient_vanishes;
  std::optional<Rational> least;
  for (const BivariatePolynomial& f : polynomials) {
    const Rational here = lower_bound(BernsteinBox(piece(f).slope, box.x, box.y), 1);
    if (here <= 0) return std::nullopt;
    if (!least || here < *least) least = here;
  }
  if (!least) return std::nullopt;
  return rounded_down(root_below(*least));
}

/// If |f| <= e at a point and |grad f| >= m > 0 within w >= e/m of it, the gradient flow reaches a zero
/// within e/m (10.9).
std::optional<Rational> OneSided::distance(const RationalInterval& t, const Rational& residual,
                                           const char*& why) {
  if (residual == 0) return Rational(0);
  const PlanarBox box = control_box(curve_, t.lower, t.upper);
  const auto narrow = slope_below(inflated(box, residual), why);
  if (!narrow) return std::nullopt;
  Rational w = rounded_up(residual / *narrow * Rational(17, 16));
  for (int attempt = 0; attempt < 4; ++attempt) {
    const auto slope = slope_below(inflated(box, w), why);
    if (!slope) return std::nullopt;
    const Rational reach = rounded_up(residual / *slope);
    if (reach <= w) return reach;
    w = rounded_up(reach * Rational(9, 8));
  }
  return std::nullopt;
}

Segment OneSided::examine(const RationalInterval& t) {
  Segment segment = {t, residual(t), std::nullopt, undefined_there};
  if (segment.residual) segment.distance = distance(t, *segment.residual, segment.why);
  return segment;
}

/// a needs to be divided less than b: undecided segments come last, wide ones after narrow ones.
bool is_better(const Segment& a, const Segment& b) {
  if (a.distance.has_value() != b.distance.has_value()) return a.distance.has_value();
  return a.distance ? *a.distance < *b.distance : a.t.width() < b.t.width();
}

/// The worst segment is divided while that lowers its bound by a five hundredth.
std::vector<Segment> OneSided::segments() {
  const Rational least_width = power_of_two(-12);
  std::vector<Segment> list;
  for (int k = 0; k < first_segments; ++k)
    list.push_back(examine({Rational(k, first_segments), Rational(k + 1, first_segments)}));
  while (list.size() < most_segments) {
    const auto worst = std::max_element(list.begin(), list.end(), is_better);
    const Segment parent = *worst;
    if (parent.t.width() <= least_width || (parent.distance && *parent.distance == 0)) break;
    const Segment left = examine({parent.t.lower, parent.t.midpoint()});
    const Segment right = examine({parent.t.midpoint(), parent.t.upper});
    *worst = left;
    list.push_back(right);
    const Segment& now = is_better(left, right) ? right : left;
    if (parent.distance && now.distance && *now.distance * 500 > *parent.distance * 499) break;
  }
  std::sort(list.begin(), list.end(),
            [](const Segment& a, const Segment& b) { return a.t.lower < b.t.lower; });
  return list;
}

OneSidedBound OneSided::bound() {
  OneSidedBound result;
  result.residual = result.distance = Rational(0);
  for (const Segment& segment : segments()) {
    result.residual = larger(result.residual, segment.residual);
    result.distance = larger(result.distance, segment.distance);
    if (segment.distance) continue;
    if (!result.unproved.empty() && result.unproved.back().t.upper == segment.t.lower)
      result.unproved.back().t.upper = segment.t.upper;
    else
      result.unproved.push_back({segment.t, segment.why});
  }
  return result;
}

HomogeneousCurve planar(const BezierCurve& curve) {
  if (curve.dimension() != 2) throw std::invalid_argument("distance bound: the curve must be planar");
  if (curve.is_point()) throw std::invalid_argument("distance bound: all points are equal");
  return homogeneous(curve);
}

/// f, f_x and f_y on a box.
struct Candidate {
  std::array<BernsteinBox, 3> functions;
  PlanarBox box;

  bool is_excluded() const {
    return std::any_of(functions.begin(), functions.end(),
                       [](const BernsteinBox& f) { return f.sign() != 0; });
  }
};

/// The lower and the upper half along the longer side.
std::array<Candidate, 2> halves_of(const Candidate& c) {
  const bool across = c.box.x.width() >= c.box.y.width();
  const auto divide = [&](std::size_t i) {
    return across ? c.functions[i].split_r() : c.functions[i].split_s();
  };
  const auto f = divide(0), dx = divide(1), dy = divide(2);
  PlanarBox lower = c.box, upper = c.box;
  const Rational middle = (across ? c.box.x : c.box.y).midpoint();
  (across ? lower.x : lower.y).upper = middle;
  (across ? upper.x : upper.y).lower = middle;
  return {Candidate{{f.first, dx.first, dy.first}, lower},
          Candidate{{f.second, dx.second, dy.second}, upper}};
}

/// The boxes that may hold a common zero of f, f_x, f_y, of those inside `box`.
std::vector<PlanarBox> undecided(const BivariatePolynomial& f, const PlanarBox& box, int max_boxes) {
  const auto on = [&](const BivariatePolynomial& g) { return BernsteinBox(g, box.x, box.y); };
  const Rational least_width = std::max(box.x.width(), box.y.width()) * power_of_two(-24);
  std::deque<Candidate> queue = {{{on(f), on(f.derivative_r()), on(f.derivative_s())}, box}};
  std::vector<PlanarBox> left;
  for (int examined = 0; !queue.empty(); ++examined) {
    const Candidate next = std::move(queue.front());
    queue.pop_front();
    if (next.is_excluded()) continue;
    if (examined >= max_boxes || std::max(next.box.x.width(), next.box.y.width()) <= least_width) {
      left.push_back(next.box);
      continue;
    }
    for (Candidate& half : halves_of(next)) queue.push_back(std::move(half));
  }
  return left;
}

RationalInterval common_part(const RationalInterval& a, const RationalInterval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

/// The parts of the box that lie in the cell given by intervals of x (or of x^2) and y.
std::vector<PlanarBox> parts_in_cell(const PlanarBox& box, const RationalInterval& x,
                                     const RationalInterval& y, bool squared) {
  std::vector<RationalInterval> sides = {x};
  if (squared) {
    // Outer bounds of the square roots: the polynomial is defined everywhere, so more is proved, not less.
    const RationalInterval roots = {root_below(std::max<Rational>(x.lower, 0)),
                                    root_above(std::max<Rational>(x.upper, 0))};
    sides = {roots, {-roots.upper, -roots.lower}};
  }
  std::vector<PlanarBox> parts;
  for (const RationalInterval& side : sides) {
    const PlanarBox part = {common_part(box.x, side), common_part(box.y, y)};
    if (part.x.lower < part.x.upper && part.y.lower < part.y.upper) parts.push_back(part);
  }
  return parts;
}

}  // namespace

OneSidedBound one_sided_bound(const PlanarFunction& f, const BezierCurve& curve) {
  return in_nearest_rounding([&] {
    const HomogeneousCurve reduced = planar(curve);
    return OneSided(f, reduced).bound();
  });
}

std::vector<PlanarBox> possibly_singular(const PlanarFunction& f, const PlanarBox& box, int max_boxes) {
  return in_nearest_rounding([&]() -> std::vector<PlanarBox> {
    if (f.is_polynomial()) return undecided(f.polynomial(), box, max_boxes);
    std::vector<PlanarBox> result;
    const PlanarFunction::Grid& grid = f.grid();
    for (std::size_t i = 0; i < f.cells().size(); ++i) {
      for (std::size_t j = 0; j < f.cells()[i].size(); ++j) {
        if (!f.cells()[i][j]) continue;
        const RationalInterval x = {grid.breaks_x[i], grid.breaks_x[i + 1]};
        const RationalInterval y = {grid.breaks_y[j], grid.breaks_y[j + 1]};
        for (const PlanarBox& part : parts_in_cell(box, x, y, grid.squared))
          for (const PlanarBox& left : undecided(*f.cells()[i][j], part, max_boxes)) result.push_back(left);
      }
    }
    return result;
  });
}

DistanceBounds distance_bounds(const PlanarFunction& f, const BezierCurve& curve) {
  return in_nearest_rounding([&] {
    DistanceBounds bounds = {one_sided_bound(f, curve), two_sided_bound(f, curve)};
    // The strip bounds the distance in both directions.
    const auto& strip = bounds.two_sided.strip;
    std::optional<Rational>& distance = bounds.one_sided.distance;
    if (strip && (!distance || strip->distance < *distance)) {
      distance = strip->distance;
      bounds.one_sided.unproved.clear();
    }
    return bounds;
  });
}

}  // namespace exsect
