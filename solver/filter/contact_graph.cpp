#include "filter/contact_graph.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "answer/chord_count.h"
#include "answer/rim_arc.h"
#include "filter/common_side.h"
#include "filter/homogeneous.h"

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

double bend_length(const Vec3& v) { return std::sqrt(dot(v, v)); }
double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); }

/// The determinants of the first derivatives, three by three, at a common corner, up to positive factors:
/// zero if and only if the tangent (5.1) is.
template <class K, class Vector, class Net>
auto tangent_at(const Net& x, const Net& y, const CornerContact& at) {
  const auto neighbour = [](std::size_t corner, std::size_t across) {
    const bool upper = corner_ends<K>(corner)[across == kFirst<K> ? 0 : 1];
    return upper ? corner - across : corner + across;
  };
  const Vector u = step_between(x, neighbour(at.x, kFirst<K>), at.x);
  const Vector v = step_between(x, neighbour(at.x, 1), at.x);
  const Vector r = step_between(y, neighbour(at.y, kFirst<K>), at.y);
  const Vector s = step_between(y, neighbour(at.y, 1), at.y);
  return std::array{determinant(v, r, s), determinant(u, r, s), determinant(u, v, s), determinant(u, v, r)};
}

template <class K>
class ContactGraph {
 public:
  ContactGraph(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair, double tolerance,
               double accepted, GraphBuilder& graph)
      : x_(x),
        y_(y),
        pair_(pair),
        scale_(std::ldexp(1.0, static_cast<int>(pair.frame.exponent))),
        tolerance_(tolerance),
        accepted_(accepted),
        graph_(graph) {}

  void add(const CornerContact& corner) {
    const int id = node(corner);
    if (!corner.is_pole() && touches(corner)) {
      graph_.add_kind(id, NodeKind::touch);
    }
    graph_.add_isolated(id);
  }

  /// A touch point, unless it is at a corner that both patches have in common. Crossings are among the
  /// curves.
  void add(const DoublePointOf<K>& touch) {
    if (touch.forms.crossing) return;
    const auto is_there = [&](const auto& entry) { return place_of<K>(entry.first) == touch.centre; };
    if (std::any_of(nodes_.begin(), nodes_.end(), is_there)) return;
    std::array<Rational, 4> middle;  // on the sides that the point is on
    for (std::size_t j = 0; j < 4; ++j) middle[j] = touch.box[j].midpoint();
    Node at = rim_node(middle);
    at.box = touch.box;
    at.kinds.push_back(NodeKind::touch);
    at.point = position(affine(expand(pair_.x, touch.centre[0], touch.centre[1])[0]));
    const int id = graph_.add_node(std::move(at));
    graph_.add_isolated(id);
  }

  bool add(const SideContactOf<K>& side) {
    if constexpr (std::is_same_v<K, Biquadratic>) {
      if (side.path) {
        return add(*side.path, contact_along<K>(x_, y_, pair_, side));
      }
    }
    Arc arc{};
    arc.place = ArcPlace::patch_boundary;
    arc.contact = contact_along<K>(x_, y_, pair_, side);
    if (side.path) {
      const auto part = common_part<K>(side, *side.path);
      add_polyline(side, {rounded(part[0]), rounded(part[1])}, arc);
      const auto ends = ends_of_part<K>(side, *side.path);
      arc.from = add_end({ends[0], 0}, arc.polyline.front());
      arc.to = add_end({ends[1], 0}, arc.polyline.back());
    } else {
      add_polyline(side, {{{0, 1}, {0, 1}}}, arc);
    }
    if (!side.ends.empty()) {
      arc.from = node(side.ends[0]);
      arc.to = node(side.ends[1]);
    }
    const bool proved = arc.error_bound <= accepted_;
    graph_.add_arc(std::move(arc));
    return proved;
  }

  bool add(const ContactLineOf<K>& line) requires(!std::is_same_v<K, Biquadratic>) {
    ContactArc found = contact_arc<K>(x_, y_, line.path, tolerance_);
    found.arc.from = graph_.add_node(std::move(found.ends[0]));
    found.arc.to = graph_.add_node(std::move(found.ends[1]));
    const bool proved = found.arc.error_bound <= accepted_;
    graph_.add_arc(std::move(found.arc));
    return proved;
  }

  bool add(const SidePath& path, Contact contact) requires std::is_same_v<K, Biquadratic> {
    const RimEnd from = {path.at(path.common.lower), 0};
    const RimEnd to = {path.at(path.common.upper), 0};
    Arc arc = rim_arc(x_, from, to, ArcPlace::patch_boundary, tolerance_);
    arc.from = add_end(from, arc.polyline.front());
    arc.to = add_end(to, arc.polyline.back());
    arc.contact = contact;
    const bool proved = arc.error_bound <= accepted_;
    graph_.add_arc(std::move(arc));
    return proved;
  }

 private:
  static Part::Interval rounded(const std::array<Rational, 2>& ends) {
    return {to_double(ends[0]), to_double(ends[1])};
  }
  int add_end(const RimEnd& end, const PolylineVertex& vertex) {
    Node node = rim_node(end.at);
    node.point = vertex.point;
    const auto known = node_in_corner(node.on);
    return known ? *known : graph_.add_node(std::move(node));
  }

  /// That of these four sides, which is there if arcs end in the corner.
  std::optional<int> node_in_corner(const std::vector<Side>& on) const {
    const auto& nodes = graph_.nodes();
    const auto known = std::ranges::find_if(nodes, [&](const Node& node) { return node.on == on; });
    if (on.size() < 4 || known == nodes.end()) return std::nullopt;
    return static_cast<int>(known - nodes.begin());
  }

  /// That of the corner; a new one where sides do not have it already.
  int node(const CornerContact& corner) {
    const auto known = std::find_if(nodes_.begin(), nodes_.end(), [&](const auto& entry) {
      return entry.first.x == corner.x && entry.first.y == corner.y;
    });
    if (known != nodes_.end()) return known->second;
    nodes_.emplace_back(corner, add_node(corner));
    return nodes_.back().second;
  }

  int add_node(const CornerContact& corner) {
    Node node{};
    const auto [u, v] = corner_ends<K>(corner.x);
    const auto [r, s] = corner_ends<K>(corner.y);
    const std::array<bool, 4> upper = {u, v, r, s};
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& pole = j < 2 ? corner.pole_of_x : corner.pole_of_y;
      const Parameter parameter = static_cast<Parameter>(j);
      if (pole && pole->parameter != j % 2) {
        node.free.push_back(parameter);
        node.box[j] = {0, 1};
        node.approx[j] = 0.5;
        continue;
      }
      const int value = upper[j] ? 1 : 0;
      node.on.push_back({parameter, value});
      node.box[j] = {value, value};
      node.approx[j] = value;
    }
    node.kinds = {NodeKind::boundary};
    if (!corner.pole_of_x || !corner.pole_of_y) node.kinds.push_back(NodeKind::corner);
    node.point = position(affine(pair_.x.net[corner.x]));
    const auto known = node_in_corner(node.on);
    return known ? *known : graph_.add_node(std::move(node), 0);
  }

  std::array<double, 3> position(const Vec3& scaled) const {
    std::array<double, 3> point;
    for (std::size_t c = 0; c < 3; ++c) {
      point[c] = pair_.frame.origin[c] + scale_ * scaled[c];
    }
    return point;
  }

  /// The tangent planes are the same, or there is none.
  bool touches(const CornerContact& corner) const requires K::weighted {
    const auto exactly = [](bool upper) { return Rational(upper ? 1 : 0); };
    const auto [u, v] = corner_ends<K>(corner.x);
    const auto [r, s] = corner_ends<K>(corner.y);
    const FirstOrder<K> x(x_, exactly(u), exactly(v));
    const FirstOrder<K> y(y_, exactly(r), exactly(s));
    for (std::size_t i = 0; i < 2; ++i) {
      if (filter::determinant(x.value, x.derivative[i], y.derivative[0], y.derivative[1]) != 0 ||
          filter::determinant(x.value, y.derivative[i], x.derivative[0], x.derivative[1]) != 0) {
        return false;
      }
    }
    return true;
  }
  bool touches(const CornerContact& corner) const requires(!K::weighted) {
    const auto certain = [&](double t) { return std::fabs(t) > kDeterminantError * pair_.net_error; };
    const auto rounded = tangent_at<K, Vec3>(pair_.x, pair_.y, corner);
    if (std::any_of(rounded.begin(), rounded.end(), certain)) {
      return false;
    }
    const auto exact = tangent_at<K, Point>(x_, y_, corner);
    return std::all_of(exact.begin(), exact.end(), [](const Rational& t) { return t == 0; });
  }

  /// Chords of a curve with second derivative X'' over steps h keep within |X''| h²/8. A vertex errs by e0
  /// and, after n means a + t (b - a), by 6 n u in each coordinate, and by 6 n u for t of a part, less than
  /// net_error; and by 2 u times the coordinate when it is moved to its place. X'' is a mean of n (n-1) times
  /// second differences, each of which errs by 7 net_error in length.
  void add_polyline(const SideContactOf<K>& side, const std::array<Part::Interval, 2>& part, Arc& arc) const
      requires(!K::weighted) {
    constexpr std::size_t n = K::degree;
    std::array<Vec3, K::side> points;
    for (std::size_t j = 0; j <= n; ++j) points[j] = pair_.x.net[side.x.index(0, j)];
    const auto& o = pair_.frame.origin;
    const double size = larger_bound(std::fabs(o[0]), std::fabs(o[1]), std::fabs(o[2])) / scale_ + 2;
    const double vertex_error = kDiagonal * (pair_.net_error + 2 * kUnit * size);
    double bend = 0;
    for (std::size_t j = 1; j < n; ++j) {
      bend = larger_bound(bend, bend_length((points[j - 1] - points[j]) + (points[j + 1] - points[j])));
    }
    const double second = static_cast<double>(n * (n - 1)) * (bend + 8 * pair_.net_error);
    const double length = part[0].upper - part[0].lower;
    const double wanted = std::ceil(length * std::sqrt(second * scale_ / (8 * 0.95 * tolerance_)));
    const int count = chord_count(wanted);
    arc.polyline.reserve(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i <= count; ++i) {
      const double t = part_of_way(part[0], i, count);
      std::array<Vec3, K::side> p = points;
      for (std::size_t level = 1; level <= n; ++level) {
        for (std::size_t j = 0; j + level <= n; ++j) p[j] = p[j] + t * (p[j + 1] - p[j]);
      }
      PolylineVertex& vertex = arc.polyline.emplace_back();
      vertex.point = position(t == 1 ? points[n] : p[0]);
      place(side.x, t, &vertex.parameters[0]);
      place(side.y, part_of_way(part[1], i, count), &vertex.parameters[2]);
    }
    const double step = length / count + 2 * kSumRounding;
    arc.error_bound = kSlack * scale_ * (second * step * step / 8 + 2 * vertex_error);
  }

  /// (14.38): the side in 16 pieces, each about its middle. Control vectors err by e = 8 net_error where they
  /// are moved, first and second differences by two and four times that.
  double second_derivative(const SideContactOf<K>& side) const requires K::weighted {
    constexpr std::size_t n = K::degree;
    constexpr int kPieces = 16;
    double most = 0;
    for (int piece = 0; piece < kPieces; ++piece) {
      const Part::Interval range = {static_cast<double>(piece) / kPieces,
                                    static_cast<double>(piece + 1) / kPieces};
      std::array<Row<K>, K::side> c;
      for (std::size_t k = 0; k <= n; ++k) c[k] = restricted_point(side.own, range, k);
      const Vec3 middle = affine(c[n / 2]);
      const double e = 8 * pair_.net_error * (1 + largest(middle));
      for (Row<K>& p : c) {
        for (std::size_t i = 0; i < 3; ++i) p[i] -= middle[i] * p[3];
      }
      double least = c[0][3];
      std::array<double, 3> space{};   // of N, N', N''
      std::array<double, 3> weight{};  // of w, w', w''
      double factor = 1;
      for (std::size_t order = 0; order < 3; ++order) {
        for (std::size_t k = 0; k + order <= n; ++k) {
          space[order] = larger_bound(space[order], bend_length({c[k][0], c[k][1], c[k][2]}));
          weight[order] = larger_bound(weight[order], std::fabs(c[k][3]));
          if (order == 0) least = std::min(least, c[k][3]);
        }
        const double error = std::ldexp(e, static_cast<int>(order));
        space[order] = factor * (space[order] + 2 * error);
        weight[order] = factor * (weight[order] + error);
        factor *= kPieces * static_cast<double>(n - order);
        for (std::size_t k = 0; k + 1 + order <= n; ++k) c[k] = c[k + 1] - c[k];
      }
      const double w = least - e;
      if (!(w > kLeastWeight)) return HUGE_VAL;
      const double rate = (space[1] + weight[1] * space[0] / w) / w;
      most = larger_bound(most, (space[2] + 2 * weight[1] * rate + weight[2] * space[0] / w) / w);
    }
    return kSlack * most;
  }

  /// A vertex errs by e (1 + |x|) / w and its rounding, (14.28).
  void add_polyline(const SideContactOf<K>& side, const std::array<Part::Interval, 2>& part,
                    Arc& arc) const requires K::weighted {
    const double second = second_derivative(side);
    const double length = part[0].upper - part[0].lower;
    const double wanted = std::ceil(length * std::sqrt(second * scale_ / (8 * 0.95 * tolerance_)));
    const int count = chord_count(wanted);
    arc.polyline.reserve(static_cast<std::size_t>(count) + 1);
    const auto& o = pair_.frame.origin;
    const double size = larger_bound(std::fabs(o[0]), std::fabs(o[1]), std::fabs(o[2])) / scale_;
    double vertex_error = 0;
    for (int i = 0; i <= count; ++i) {
      const double t = part_of_way(part[0], i, count);
      const Row<K> c = t == 1 ? side.own.back() : restricted_point(side.own, {t, t}, 0);
      const Vec3 x = affine(c);
      vertex_error =
          larger_bound(vertex_error, pair_.net_error * (1 + largest(x)) / (c[3] - pair_.net_error) +
                                         4 * kUnit * (size + largest(x)));
      PolylineVertex& vertex = arc.polyline.emplace_back();
      vertex.point = position(x);
      place(side.x, t, &vertex.parameters[0]);
      const double on_other = i == 0 || i == count ? part_of_way(part[1], i, count)
                                                   : to_double(inverse(side.to_x, from_double(t)));
      place(side.y, std::clamp(on_other, part[1].lower, part[1].upper), &vertex.parameters[2]);
    }
    const double step = length / count + 2 * kSumRounding;
    arc.error_bound = kSlack * scale_ * (second * step * step / 8 + 2 * kDiagonal * vertex_error);
  }

  static double part_of_way(const Part::Interval& range, int i, int count) {
    return i == count ? range.upper
                      : range.lower + (range.upper - range.lower) * (static_cast<double>(i) / count);
  }

  static void place(const SideView& view, double t, double* parameters) {
    parameters[view.side.parameter] = view.side.upper ? 1 : 0;
    parameters[1 - view.side.parameter] = view.reversed ? 1 - t : t;
  }

  const ExactPatch<K>& x_;
  const ExactPatch<K>& y_;
  const PairOf<K>& pair_;
  double scale_;
  double tolerance_;
  double accepted_;
  GraphBuilder& graph_;
  std::vector<std::pair<CornerContact, int>> nodes_;
};

}  // namespace

template <class K>
bool append_contacts(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                     const ContactsOf<K>& contacts, double tolerance, double accepted, GraphBuilder& graph) {
  ContactGraph<K> maker(x, y, pair, tolerance, accepted, graph);
  for (const CornerContact& corner : contacts.corners) {
    maker.add(corner);
  }
  for (const DoublePointOf<K>& touch : contacts.double_points) {
    maker.add(touch);
  }
  bool proved = std::all_of(contacts.sides.begin(), contacts.sides.end(),
                            [&](const SideContactOf<K>& side) { return maker.add(side); });
  if constexpr (std::is_same_v<K, Biquadratic>) {
    proved =
        proved && std::all_of(contacts.paths.begin(), contacts.paths.end(), [&](const PathContact& contact) {
          return maker.add(contact.path, Contact::transversal);
        });
  } else {
    proved = proved && std::all_of(contacts.lines.begin(), contacts.lines.end(),
                                   [&](const ContactLineOf<K>& line) { return maker.add(line); });
  }
  return proved;
}

#define EXSECT_INSTANTIATE(K)                                                                    \
  template bool append_contacts<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, \
                                   const ContactsOf<K>&, double, double, GraphBuilder&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
