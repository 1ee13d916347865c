#include "surface_box.h"

#include <string>
#include <utility>

#include "space_forms.h"

namespace exsect {
namespace {

/// Of a half line of a plane, at every point: on which side of its line it lies, to the left positive, and
/// before or behind its end.
struct HalfLine {
  SpacePolynomial beside;
  SpacePolynomial along;
};

void require_member(bool is_given, bool is_known, const char* key, SurfaceKind kind) {
  if (is_given && !is_known)
    throw SurfaceError("box." + std::string(key),
                       "a box on a surface of type " + std::string(name(kind)) + " has no such member");
}

/// What boxes on this kind of surface have.
void require_members(const SurfaceBox& box, SurfaceKind kind) {
  if (kind == SurfaceKind::polynomial)
    throw SurfaceError("box", "a surface of type implicit has no parameters to be bounded");
  const bool is_plane = kind == SurfaceKind::plane;
  require_member(box.axis.has_value(), kind == SurfaceKind::sphere, "axis", kind);
  require_member(box.sector.has_value(), !is_plane, "sector", kind);
  require_member(box.height.has_value(), !is_plane, "height", kind);
  require_member(box.tube.has_value(), kind == SurfaceKind::torus, "tube", kind);
  require_member(box.sides.has_value(), is_plane, "sides", kind);
  if (!box.sector && !box.height && !box.tube && !box.sides) throw SurfaceError("box", "bounds nothing");
  if (kind == SurfaceKind::sphere && !box.axis)
    throw SurfaceError("box", "the axis of a box on a sphere is missing");
}

/// Adds the clauses of one box.
class BoxRegion {
 public:
  BoxRegion(const SurfaceData& data, const Point& axis) : data_(data), axis_(axis), length_(dot(axis, axis)) {
    along_ = height_form(data.point, axis);
  }

  void add(const AxisSector& sector) {
    const Point from = orthogonal("box.sector.from", sector.from),
                to = orthogonal("box.sector.to", sector.to);
    add_sector(BoundKind::sector, "sector", half_line(from), half_line(to),
               sign(determinant(axis_, from, to)), sign(dot(from, to)));
  }

  void add(const HeightRange& height) {
    if (height.from >= height.to) throw SurfaceError("box.height", "does not ascend");
    add_clause({add_bound(BoundKind::height, "height=from", along_ - number(height.from * length_))});
    add_clause({add_bound(BoundKind::height, "height=to", number(height.to * length_) - along_)});
  }

  void add(const TubeSector& tube) {
    const auto& [c, s] = tube.from;
    const auto& [e, t] = tube.to;
    if (c == 0 && s == 0) throw SurfaceError("box.tube.from", "the direction is zero");
    if (e == 0 && t == 0) throw SurfaceError("box.tube.to", "the direction is zero");
    add_sector(BoundKind::tube, "tube", tube_half_line(tube.from), tube_half_line(tube.to),
               sign(Rational(c * t - s * e)), sign(Rational(c * e + s * t)));
  }

  void add(const std::array<Point, 2>& sides) {
    const auto place = [](std::size_t k) { return "box.sides[" + std::to_string(k) + "]"; };
    for (std::size_t k = 0; k < 2; ++k) {
      if (is_zero(sides[k])) throw SurfaceError(place(k), "the vector is zero");
      if (dot(sides[k], axis_) != 0) throw SurfaceError(place(k), "not orthogonal to the normal");
    }
    if (is_zero(cross(sides[0], sides[1]))) throw SurfaceError("box.sides", "parallel to each other");
    for (std::size_t k = 0; k < 2; ++k) {
      const Point across = cross(sides[1 - k], axis_);
      const Rational whole = dot(sides[k], across);
      const SpacePolynomial share = (1 / whole) * height_form(data_.point, across);
      const std::string name = k == 0 ? "first" : "second";
      add_clause({add_bound(BoundKind::side, name + "=0", share)});
      add_clause({add_bound(BoundKind::side, name + "=1", number(1) - share)});
    }
  }

  SurfaceRegion region() && { return std::move(region_); }

 private:
  static SpacePolynomial number(const Rational& q) { return SpacePolynomial::constant(q); }

  std::size_t add_bound(BoundKind kind, const std::string& name, SpacePolynomial form,
                        SpacePolynomial where = number(1)) {
    region_.bounds.push_back({name, std::move(form), std::move(where), kind});
    return region_.bounds.size() - 1;
  }
  void add_clause(std::vector<std::size_t> bounds) { region_.clauses.push_back(std::move(bounds)); }

  /// |d|^2 times the part of a direction that is orthogonal to the axis.
  Point orthogonal(const char* key, const Point& direction) const {
    Point part = length_ * direction - dot(axis_, direction) * axis_;
    if (is_zero(part)) throw SurfaceError(key, "zero or parallel to the axis");
    return part;
  }
  HalfLine half_line(const Point& direction) const {
    return {height_form(data_.point, cross(axis_, direction)), height_form(data_.point, direction)};
  }

  /// (17.8): 2R (rho - R) is the polynomial `outwards` on the torus.
  HalfLine tube_half_line(const std::array<Rational, 2>& direction) const {
    const auto& [c, s] = direction;
    const SpacePolynomial outwards =
        squared_distance(data_.point) - number(data_.squared + data_.minor_squared);
    return {Rational(2 * c * data_.squared) * along_ - Rational(s * length_) * outwards,
            Rational(c / 2) * outwards + s * along_};
  }

  /// (17.7); turn, along: the signs of sine and cosine of the angle between the half lines.
  void add_sector(BoundKind kind, const std::string& name, HalfLine from, HalfLine to, int turn, int along) {
    if (turn == 0 && along > 0)
      throw SurfaceError("box." + name,
                         "from and to are one direction; a whole turn has no \"" + name + "\"");
    const std::size_t first = add_bound(kind, name + "=from", std::move(from.beside), std::move(from.along));
    const std::size_t last = add_bound(kind, name + "=to", Rational(-1) * to.beside, std::move(to.along));
    if (turn < 0) return add_clause({first, last});
    add_clause({first});
    add_clause({last});
  }

  const SurfaceData& data_;
  Point axis_;
  Rational length_;        // |d|^2
  SpacePolynomial along_;  // q.d
  SurfaceRegion region_;
};

}  // namespace

ImplicitSurface boxed(const ImplicitSurface& whole, const SurfaceBox& box) {
  if (!whole.box().clauses.empty()) throw std::invalid_argument("boxed: the surface is in a box already");
  require_members(box, whole.kind());
  const Point axis = box.axis ? *box.axis : whole.data()->axis;
  if (is_zero(axis)) throw SurfaceError("box.axis", "the vector is zero");
  BoxRegion region(*whole.data(), axis);
  if (box.sector) region.add(*box.sector);
  if (box.height) region.add(*box.height);
  if (box.tube) region.add(*box.tube);
  if (box.sides) region.add(*box.sides);
  return whole.part_in(std::move(region).region());
}

Point gradient(const SpacePolynomial& linear) {
  return {linear.coefficient({1, 0, 0}), linear.coefficient({0, 1, 0}), linear.coefficient({0, 0, 1})};
}

std::optional<Point> axis_of_box(const ImplicitSurface& surface) {
  const std::vector<SurfaceBound>& bounds = surface.box().bounds;
  if (surface.kind() != SurfaceKind::sphere || bounds.empty()) return std::nullopt;
  const SurfaceBound& first = bounds.front();
  if (first.kind == BoundKind::height) return gradient(first.form);
  const Point across = gradient(first.where);  // the form has the gradient d x across
  return 1 / dot(across, across) * cross(across, gradient(first.form));
}

}  // namespace exsect
