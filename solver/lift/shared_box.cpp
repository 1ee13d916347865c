#include "lift/shared_box.h"

#include <exsect/geometry/surface_box.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "lift/pair_region.h"
#include "lift/shared_arcs.h"

namespace exsect {
namespace {

Rational at_origin(const SpacePolynomial& f) { return f.coefficient({0, 0, 0}); }

SpacePolynomial linear_form(const Point& normal, const Point& through) {
  return SpacePolynomial({{{1, 0, 0}, normal[0]},
                          {{0, 1, 0}, normal[1]},
                          {{0, 0, 1}, normal[2]},
                          {{0, 0, 0}, -dot(normal, through)}});
}

SurfaceRegion where(SpacePolynomial form) {
  return {{{"", std::move(form), SpacePolynomial::constant(1)}}, {{0}}};
}

ImplicitSurface surface_of(const SpacePolynomial& form) {
  if (form.degree() > 1) return ImplicitSurface::polynomial(form);
  const Point normal = gradient(form);
  return ImplicitSurface::plane(-at_origin(form) / dot(normal, normal) * normal, normal);
}

/// 2R (rho - R) on the torus (17.8).
SpacePolynomial outwards_on(const SurfaceData& torus) {
  SpacePolynomial sum = SpacePolynomial::constant(-torus.squared - torus.minor_squared);
  for (std::size_t k = 0; k < 3; ++k) {
    const SpacePolynomial q = SpacePolynomial::variable(k) - SpacePolynomial::constant(torus.point[k]);
    sum += q * q;
  }
  return sum;
}

Rational signed_square(const Rational& q) { return q * abs(q); }

/// Where an arc of directions about a tube may end: the circle where the form is 0 and `where` is not
/// negative.
struct TubeEnd {
  PlaneDirection direction;
  SpacePolynomial form;
  SpacePolynomial where;
};

/// Heights, turns about the axis and turns about the circle of a torus's tube, of both boxes. Heights are
/// values of axis . P, on a torus they are turns about the tube. Directions about the axis are counted in two
/// vectors orthogonal to it. Those about the tube are squares with the signs of c and s of (17.8), whose
/// determinants and scalar products have the same signs.
class SharedTurns {
 public:
  /// The axis is that of both; `surface` has data.
  SharedTurns(const ImplicitSurface& surface, const Point& axis)
      : surface_(surface), data_(*surface.data()), axis_(axis) {
    across_[0] = cross(axis, least_parallel_axis(axis));
    across_[1] = cross(axis, across_[0]);
  }

  /// False if the box is about another axis.
  bool add(const ImplicitSurface& boxed) {
    const SurfaceRegion region = boxed.region();
    Point own = axis_;
    if (surface_.kind() == SurfaceKind::sphere)
      own = axis_of_box(boxed).value_or(axis_);
    else if (boxed.data())
      own = boxed.data()->axis;
    if (!is_zero(cross(own, axis_))) return false;
    std::vector<PlaneDirection> turns, tubes;
    for (const SurfaceBound& bound : region.bounds) {
      if (bound.kind == BoundKind::tube) {
        tubes.push_back(tube_direction(bound));
        tube_ends_.push_back({tubes.back(), bound.form, bound.where});
      } else if (bound.kind == BoundKind::sector)
        turns.push_back(turn_direction(gradient(bound.where)));
      else if (surface_.kind() == SurfaceKind::torus)
        add_tube_height(bound.form);
      else
        add_height(gradient(bound.form), at_origin(bound.form));
    }
    const bool is_reversed = dot(own, axis_) < 0;  // and runs clockwise about the axis
    add_sector(turns, sectors_, is_reversed);
    add_sector(tubes, tubes_, is_reversed);
    return true;
  }

  SharedBox shared() const {
    if (is_beyond_tube_) return SharedBox{};
    if (const auto level = only_height())
      return level->empty() ? SharedBox{} : SharedBox{false, {plane_at(level->front())}};
    const std::vector<CircleArc> turns = parts_of_all(sectors_), tubes = parts_of_all(tubes_);
    if (!tubes_.empty() && tubes.empty()) return SharedBox{};
    if (!sectors_.empty() && turns.empty()) return apexes();
    const auto is_arc = [](const CircleArc& part) { return !part.is_point(); };
    const bool has_turns = sectors_.empty() || std::ranges::any_of(turns, is_arc);
    SharedBox result{has_turns && (tubes_.empty() || std::ranges::any_of(tubes, is_arc))};
    for (const CircleArc& arc : turns)
      if (arc.is_point()) result.cuts.push_back(half_plane(arc.from));
    if (result.cuts.size() == 2) join_half_planes(turns, result);
    if (has_turns)
      for (const CircleArc& arc : tubes)
        if (arc.is_point()) result.cuts.push_back(tube_circle(arc.from, turns));
    return result;
  }

 private:
  static void add_sector(const std::vector<PlaneDirection>& ends, std::vector<CircleArc>& to,
                         bool is_reversed) {
    if (ends.size() == 2)
      to.push_back(is_reversed ? CircleArc{ends[1], ends[0]} : CircleArc{ends[0], ends[1]});
  }

  PlaneDirection turn_direction(const Point& a) const { return {dot(a, across_[0]), dot(a, across_[1])}; }

  /// c and s of `where` = c (|q|^2 - R^2 - r^2) / 2 + s (q . axis), as below (17.8).
  PlaneDirection tube_direction(const SurfaceBound& bound) const {
    const Rational c = 2 * bound.where.coefficient({2, 0, 0});
    const Point along = gradient(bound.where) + c * data_.point;
    return {signed_square(c), signed_square(dot(along, axis_) / dot(axis_, axis_))};
  }

  /// The part of a torus over or under a plane orthogonal to its axis: an arc about the tube.
  void add_tube_height(const SpacePolynomial& form) {
    const Rational rate = dot(gradient(form), axis_), height = -form(data_.point) / rate,
                   square = (data_.minor_squared - height * height * dot(axis_, axis_)) / data_.squared;
    const int side = sign(rate);
    if (square <= 0 && side * height < 0) return;  // all of the torus
    is_beyond_tube_ = is_beyond_tube_ || square < 0;
    if (square < 0) return;
    const PlaneDirection out = {square, signed_square(height)}, in = {-square, signed_square(height)};
    tubes_.push_back(side > 0 ? CircleArc{out, in} : CircleArc{in, out});
    const SpacePolynomial outwards = outwards_on(data_);
    tube_ends_.push_back({out, form, outwards});
    tube_ends_.push_back({in, form, Rational(-1) * outwards});
  }

  void add_height(const Point& normal, const Rational& constant) {
    const Rational rate = dot(normal, axis_) / dot(axis_, axis_), at = -constant / rate;
    std::optional<Rational>& end = rate > 0 ? lower_ : upper_;
    if (!end || (rate > 0 ? *end < at : at < *end)) end = at;
  }

  /// Of a sphere the sign of at - c . axis - the radius |axis|, for the side of greater values, and the same
  /// for that of smaller ones.
  int beyond(const Rational& at, int side) const {
    const Rational off = side * (at - dot(data_.point, axis_));
    return off < 0 ? -1 : sign(Rational(off * off - data_.squared * dot(axis_, axis_)));
  }

  /// The one height that is shared, or none in the list; empty where there are inner ones.
  std::optional<std::vector<Rational>> only_height() const {
    if (lower_ && upper_ && *lower_ >= *upper_)
      return *lower_ == *upper_ ? std::vector{*lower_} : std::vector<Rational>{};
    if (surface_.kind() != SurfaceKind::sphere) return std::nullopt;
    for (const auto& [end, side] : {std::pair(lower_, 1), std::pair(upper_, -1)}) {
      if (!end) continue;
      const int s = beyond(*end, side);
      if (s >= 0) return s == 0 ? std::vector{*end} : std::vector<Rational>{};
    }
    return std::nullopt;
  }

  SharedCut plane_at(const Rational& height) const {
    return {ImplicitSurface::plane(height / dot(axis_, axis_) * axis_, axis_)};
  }

  Point in_space(const PlaneDirection& a) const {
    return a[0] / dot(across_[0], across_[0]) * across_[0] + a[1] / dot(across_[1], across_[1]) * across_[1];
  }

  SharedCut half_plane(const PlaneDirection& a) const {
    const Point direction = in_space(a);
    return {ImplicitSurface::plane(data_.point, cross(axis_, direction)),
            where(linear_form(direction, data_.point))};
  }

  /// Opposite half planes are one plane; others may meet in apexes and poles, so both planes are one surface.
  /// The boxes share nothing else of the planes.
  void join_half_planes(const std::vector<CircleArc>& turns, SharedBox& box) const {
    const PlaneDirection &a = turns[0].from, &b = turns[1].from;
    if (a[0] * b[1] == a[1] * b[0])
      box.cuts = {{box.cuts[0].surface}};
    else if (has_apex())
      box.cuts = {
          {ImplicitSurface::polynomial(box.cuts[0].surface.equation() * box.cuts[1].surface.equation())}};
  }

  /// Whether an apex or a pole has a shared height, which is not the only one.
  bool has_apex() const {
    if (surface_.kind() == SurfaceKind::cone) {
      const Rational at = dot(data_.point, axis_);
      return (!lower_ || *lower_ <= at) && (!upper_ || at <= *upper_);
    }
    if (surface_.kind() != SurfaceKind::sphere) return false;
    return !upper_ || beyond(*upper_, 1) >= 0 || !lower_ || beyond(*lower_, -1) >= 0;
  }

  /// Boxes that share no half plane have apexes and poles in common, which any plane through the axis shows.
  SharedBox apexes() const {
    if (!has_apex()) return {};
    return {false, {{ImplicitSurface::plane(data_.point, across_[0])}}};
  }

  /// In the one turn that is no point, if there is one that is: its half plane shows what it has.
  SharedCut tube_circle(const PlaneDirection& direction, const std::vector<CircleArc>& turns) const {
    const TubeEnd* end = nullptr;
    for (const TubeEnd& each : tube_ends_)
      if (CircleArc{each.direction, direction}.is_point() &&
          (!end || each.form.degree() < end->form.degree()))
        end = &each;
    if (!end) throw std::logic_error("shared_box: an end of neither box");
    SharedCut cut{surface_of(end->form), where(end->where)};
    if (std::ranges::none_of(turns, &CircleArc::is_point)) return cut;
    const CircleArc& turn = turns[turns[0].is_point() ? 1 : 0];
    SurfaceBox box;
    box.sector = AxisSector{in_space(turn.from), in_space(turn.to)};
    cut.region = within({cut.region, 0}, boxed(surface_.part_in({}), box).box()).all;
    return cut;
  }

  const ImplicitSurface& surface_;
  const SurfaceData& data_;
  Point axis_;
  std::array<Point, 2> across_;  // orthogonal, counter-clockwise about the axis
  std::optional<Rational> lower_, upper_;
  std::vector<CircleArc> sectors_, tubes_;
  bool is_beyond_tube_ = false;  // a height that nothing is at
  std::vector<TubeEnd> tube_ends_;
};

/// The polygon's part where the form is not negative, by Sutherland and Hodgman.
std::vector<Point> clipped(const std::vector<Point>& polygon, const SpacePolynomial& form) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational a = form(p), b = form(q);
    if (a >= 0) result.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) result.push_back(p + a / (a - b) * (q - p));
  }
  return result;
}

/// The corners of a parallelogram with four bounds in its plane.
std::vector<Point> corners(const SurfaceRegion& box, const SurfaceData& plane) {
  const Point n = plane.axis;
  std::vector<Point> result;
  for (const auto& [i, j] : {std::pair(0, 2), std::pair(1, 2), std::pair(1, 3), std::pair(0, 3)}) {
    const SpacePolynomial &f = box.bounds[static_cast<std::size_t>(i)].form,
                          &g = box.bounds[static_cast<std::size_t>(j)].form;
    const Point a = gradient(f), b = gradient(g);
    const Rational whole = determinant(a, b, n);
    result.push_back((1 / whole) * (-at_origin(f) * cross(b, n) - at_origin(g) * cross(n, a) +
                                    dot(n, plane.point) * cross(a, b)));
  }
  return result;
}

SharedBox shared_parallelograms(const ImplicitSurface& first, const ImplicitSurface& second,
                                const SurfaceData& plane) {
  std::vector<Point> polygon = corners(first.box(), plane);
  for (const SurfaceBound& bound : second.box().bounds) polygon = clipped(polygon, bound.form);
  if (polygon.empty()) return {};
  const Point& p = polygon.front();
  const auto other = std::ranges::find_if(polygon, [&](const Point& q) { return !is_zero(q - p); });
  const Point along = other != polygon.end() ? *other - p : gradient(first.box().bounds[0].form);
  if (other != polygon.end() &&
      std::ranges::any_of(polygon, [&](const Point& q) { return !is_zero(cross(along, q - p)); }))
    return {true};
  return {false, {{ImplicitSurface::plane(p, cross(plane.axis, along))}}};
}

}  // namespace

std::optional<SharedBox> shared_box(const ImplicitSurface& first, const ImplicitSurface& second) {
  const ImplicitSurface& known = first.data() ? first : second;
  if (first.region().clauses.empty() && second.region().clauses.empty()) return SharedBox{true};
  if (known.kind() == SurfaceKind::plane) {
    if (first.box().clauses.empty() || second.box().clauses.empty()) return SharedBox{true};
    return shared_parallelograms(first, second, *known.data());
  }
  Point axis = known.data()->axis;
  if (known.kind() == SurfaceKind::sphere) {
    const std::optional<Point> of_first = axis_of_box(first);
    axis = of_first ? *of_first : *axis_of_box(second);
  }
  SharedTurns turns(known, axis);
  for (const ImplicitSurface* surface : {&first, &second})
    if (!turns.add(*surface)) return std::nullopt;
  return turns.shared();
}

}  // namespace exsect
