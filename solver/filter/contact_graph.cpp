#include "filter/contact_graph.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "answer/chord_count.h"
#include "answer/rim_arc.h"

namespace exsect::filter {

namespace {

using exsect::operator+;
using exsect::operator-;
using exsect::operator*;
using exsect::cross;
using exsect::determinant;
using exsect::dot;
using filter::operator+;
using filter::operator-;
using filter::operator*;
using filter::cross;
using filter::dot;

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }
double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); }

Vec3 difference(const Patch& patch, std::size_t a, std::size_t b) { return patch.net[a] - patch.net[b]; }
Point difference(const BezierPatch& patch, std::size_t a, std::size_t b) {
  return patch.net()[a / 3][a % 3] - patch.net()[b / 3][b % 3];
}

/// The determinants of the first derivatives, three by three, at a common corner, up to positive factors:
/// zero if and only if the tangent (5.1) is.
template <class Vector, class Net>
auto tangent_at(const Net& x, const Net& y, const CornerContact& at) {
  const auto neighbour = [](std::size_t corner, std::size_t across) {
    const bool upper = across == 3 ? corner >= 6 : corner % 3 == 2;
    return upper ? corner - across : corner + across;
  };
  const Vector u = difference(x, neighbour(at.x, 3), at.x);
  const Vector v = difference(x, neighbour(at.x, 1), at.x);
  const Vector r = difference(y, neighbour(at.y, 3), at.y);
  const Vector s = difference(y, neighbour(at.y, 1), at.y);
  return std::array{determinant(v, r, s), determinant(u, r, s), determinant(u, v, s), determinant(u, v, r)};
}

/// The Bernstein coefficients, times 10, of det(C, x_across, y_across) along a common side: degree 5.
template <class Number, class Vector>
std::array<Number, 6> tangent_along(const std::array<Vector, 2>& direction, const std::array<Vector, 3>& x,
                                    const std::array<Vector, 3>& y) {
  constexpr std::array<int, 3> binomial = {1, 2, 1};
  constexpr std::array<int, 6> inverse = {10, 2, 1, 1, 2, 10};  // 10 / (5 over k)
  std::array<Number, 6> sum;
  sum.fill(Number(0));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Vector normal = cross(x[i], y[j]);
      for (std::size_t k = 0; k < 2; ++k) {
        sum[i + j + k] += Number(binomial[i] * binomial[j] * inverse[i + j + k]) * dot(direction[k], normal);
      }
    }
  }
  return sum;
}

template <class Number>
Number as(const Rational& q) {
  if constexpr (std::is_same_v<Number, double>) {
    return to_double(q);
  } else {
    return q;
  }
}

/// Control vectors of a polynomial of degree one or two on the interval.
template <class Number, class Vector>
std::array<Vector, 2> restricted(const std::array<Vector, 2>& c, const std::array<Number, 2>& to) {
  const auto at = [&](const Number& t) { return (1 - t) * c[0] + t * c[1]; };
  return {at(to[0]), at(to[1])};
}
template <class Number, class Vector>
std::array<Vector, 3> restricted(const std::array<Vector, 3>& c, const std::array<Number, 2>& to) {
  const auto at = [&](const Number& a, const Number& b) {
    const Vector first = (1 - a) * c[0] + a * c[1];
    const Vector last = (1 - a) * c[1] + a * c[2];
    return (1 - b) * first + b * last;
  };
  return {at(to[0], to[0]), at(to[0], to[1]), at(to[1], to[1])};
}

/// The ends of the common part of two sides, as the views of x and of y count.
std::array<std::array<Rational, 2>, 2> common_part(const SideContact& side, const SidePath& path) {
  std::array<std::array<Rational, 4>, 2> ends = {path.at(path.common.lower), path.at(path.common.upper)};
  const std::size_t along_x = 1 - side.x.side.parameter;
  const std::size_t along_y = 3 - side.y.side.parameter;
  if (ends[1][along_x] < ends[0][along_x]) {
    std::swap(ends[0], ends[1]);
  }
  const auto on_y = [&](const Rational& t) { return side.y.reversed ? 1 - t : t; };
  return {{{ends[0][along_x], ends[1][along_x]}, {on_y(ends[0][along_y]), on_y(ends[1][along_y])}}};
}

class ContactGraph {
 public:
  ContactGraph(const BezierPatch& x, const BezierPatch& y, const Pair& pair, double tolerance,
               GraphBuilder& graph)
      : x_(x),
        y_(y),
        pair_(pair),
        scale_(std::ldexp(1.0, static_cast<int>(pair.frame.exponent))),
        tolerance_(tolerance),
        graph_(graph) {}

  void add(const CornerContact& corner) {
    const int id = add_node(corner);
    if (touches(corner)) {
      graph_.add_kind(id, NodeKind::touch);
    }
    graph_.add_isolated(id);
  }

  bool add(const SideContact& side) {
    if (side.path) {
      return add(*side.path, contact_along(side));
    }
    Arc arc{};
    arc.from = add_node({side.x.index(0, 0), side.y.index(0, 0)});
    arc.to = add_node({side.x.index(0, 2), side.y.index(0, 2)});
    arc.place = ArcPlace::patch_boundary;
    arc.contact = contact_along(side);
    add_polyline(side, arc);
    const bool proved = arc.error_bound <= tolerance_;
    graph_.add_arc(std::move(arc));
    return proved;
  }

  bool add(const SidePath& path, Contact contact) {
    const RimEnd from = {path.at(path.common.lower), 0};
    const RimEnd to = {path.at(path.common.upper), 0};
    Arc arc = rim_arc(x_, from, to, ArcPlace::patch_boundary, tolerance_);
    arc.from = add_end(from, arc.polyline.front());
    arc.to = add_end(to, arc.polyline.back());
    arc.contact = contact;
    const bool proved = arc.error_bound <= tolerance_;
    graph_.add_arc(std::move(arc));
    return proved;
  }

 private:
  int add_end(const RimEnd& end, const PolylineVertex& vertex) {
    Node node = rim_node(end.at);
    node.point = vertex.point;
    return graph_.add_node(std::move(node));
  }

  int add_node(const CornerContact& corner) {
    Node node{};
    node.kinds = {NodeKind::boundary, NodeKind::corner};
    const std::array<bool, 4> upper = {corner.x >= 6, corner.x % 3 == 2, corner.y >= 6, corner.y % 3 == 2};
    for (std::size_t j = 0; j < 4; ++j) {
      const int value = upper[j] ? 1 : 0;
      node.on.push_back({static_cast<Parameter>(j), value});
      node.box[j] = {value, value};
      node.approx[j] = value;
    }
    node.point = position(pair_.x.net[corner.x]);
    return graph_.add_node(std::move(node), 0);
  }

  std::array<double, 3> position(const Vec3& scaled) const {
    std::array<double, 3> point;
    for (std::size_t c = 0; c < 3; ++c) {
      point[c] = pair_.frame.origin[c] + scale_ * scaled[c];
    }
    return point;
  }

  /// The tangent planes are the same, or there is none.
  bool touches(const CornerContact& corner) const {
    const auto certain = [&](double t) { return std::fabs(t) > kDeterminantError * pair_.net_error; };
    const auto rounded = tangent_at<Vec3>(pair_.x, pair_.y, corner);
    if (std::any_of(rounded.begin(), rounded.end(), certain)) {
      return false;
    }
    const auto exact = tangent_at<Point>(x_, y_, corner);
    return std::all_of(exact.begin(), exact.end(), [](const Rational& t) { return t == 0; });
  }

  /// Tangential if (14.15) vanishes all along the side; exactly, where doubles do not tell, as on nearly
  /// smooth edges. The weights in each of the sums of `tangent_along` add up to 10.
  Contact contact_along(const SideContact& side) const {
    const double error = 10 * (side.path ? kPartDeterminantError : kDeterminantError) * pair_.net_error;
    const auto rounded = along<double, Vec3>(pair_.x, pair_.y, side);
    if (std::any_of(rounded.begin(), rounded.end(), [&](double t) { return std::fabs(t) > error; })) {
      return Contact::transversal;
    }
    const auto exact = along<Rational, Point>(x_, y_, side);
    const bool touch = std::all_of(exact.begin(), exact.end(), [](const Rational& t) { return t == 0; });
    return touch ? Contact::tangential : Contact::transversal;
  }

  /// On the part that both sides have in common.
  template <class Number, class Vector, class Net>
  static std::array<Number, 6> along(const Net& x, const Net& y, const SideContact& side) {
    std::array<Vector, 2> direction;
    std::array<Vector, 3> across_x;
    std::array<Vector, 3> across_y;
    for (std::size_t j = 0; j < 3; ++j) {
      across_x[j] = difference(x, side.x.index(1, j), side.x.index(0, j));
      across_y[j] = difference(y, side.y.index(1, j), side.y.index(0, j));
      if (j < 2) {
        direction[j] = difference(x, side.x.index(0, j + 1), side.x.index(0, j));
      }
    }
    if (side.path) {
      const auto [on_x, on_y] = common_part(side, *side.path);
      const std::array<Number, 2> t = {as<Number>(on_x[0]), as<Number>(on_x[1])};
      direction = restricted(direction, t);
      across_x = restricted(across_x, t);
      across_y = restricted(across_y, std::array<Number, 2>{as<Number>(on_y[0]), as<Number>(on_y[1])});
    }
    return tangent_along<Number>(direction, across_x, across_y);
  }

  /// Chords of a parabola with second derivative X'' over steps h keep within |X''| h²/8. A vertex errs by
  /// e0 and, after two means a + t (b - a), by 12 u in each coordinate, less than net_error; and by 2 u times
  /// the coordinate when it is moved to its place.
  void add_polyline(const SideContact& side, Arc& arc) const {
    const Vec3& a = pair_.x.net[side.x.index(0, 0)];
    const Vec3& b = pair_.x.net[side.x.index(0, 1)];
    const Vec3& c = pair_.x.net[side.x.index(0, 2)];
    const auto& o = pair_.frame.origin;
    const double size = std::max({std::fabs(o[0]), std::fabs(o[1]), std::fabs(o[2])}) / scale_ + 2;
    const double vertex_error = kDiagonal * (pair_.net_error + 2 * kUnit * size);
    const double second = 2 * length((a - b) + (c - b)) + 16 * pair_.net_error;
    const double wanted = std::ceil(std::sqrt(second * scale_ / (8 * 0.95 * tolerance_)));
    const int n = chord_count(wanted);
    arc.polyline.reserve(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const Vec3 first = a + t * (b - a);
      const Vec3 last = b + t * (c - b);
      PolylineVertex& vertex = arc.polyline.emplace_back();
      vertex.point = position(i == n ? c : first + t * (last - first));
      place(side.x, t, &vertex.parameters[0]);
      place(side.y, t, &vertex.parameters[2]);
    }
    const double step = 1.0 / n + kSumRounding;
    arc.error_bound = kSlack * scale_ * (second * step * step / 8 + 2 * vertex_error);
  }

  static void place(const SideView& view, double t, double* parameters) {
    parameters[view.side.parameter] = view.side.upper ? 1 : 0;
    parameters[1 - view.side.parameter] = view.reversed ? 1 - t : t;
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Pair& pair_;
  double scale_;
  double tolerance_;
  GraphBuilder& graph_;
};

}  // namespace

bool append_contacts(const BezierPatch& x, const BezierPatch& y, const Pair& pair, const Contacts& contacts,
                     double tolerance, GraphBuilder& graph) {
  ContactGraph maker(x, y, pair, tolerance, graph);
  for (const CornerContact& corner : contacts.corners) {
    maker.add(corner);
  }
  return std::all_of(contacts.sides.begin(), contacts.sides.end(),
                     [&](const SideContact& side) { return maker.add(side); }) &&
         std::all_of(contacts.paths.begin(), contacts.paths.end(), [&](const PathContact& contact) {
           return maker.add(contact.path, Contact::transversal);
         });
}

}  // namespace exsect::filter
