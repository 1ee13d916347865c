#include "signs_beside.h"

#include <exsect/algebra/nearest_double.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "answer/arc_joints.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/proof.h"
#include "trace/patch_jet.h"

namespace exsect {

namespace {

using TangentSigns = std::array<int, 4>;

/// Signs of T (5.1) that are certain in the box of a node, 0 where none is.
template <class Ball>
TangentSigns tangent_signs(const PatchJet<Ball>& x, const PatchJet<Ball>& y) {
  const BallVector<Ball> nx = x.normal(), ny = y.normal();
  return {dot(x.v, ny).certain_sign(), (-dot(x.u, ny)).certain_sign(), (-dot(y.v, nx)).certain_sign(),
          dot(y.u, nx).certain_sign()};
}

/// The form (8.3) times a positive number.
template <class Ball>
struct HeightForm {
  Ball uu, uv, vv;

  /// Of a form that is not zero and has one sign.
  int sign() const { return uu.certain_sign() != 0 ? uu.certain_sign() : vv.certain_sign(); }
  bool is_definite() const { return (uu * vv - uv * uv).is_positive(); }
};

template <class Ball>
HeightForm<Ball> height_form(const PatchJet<Ball>& x, const PatchJet<Ball>& y) {
  const BallVector<Ball> n = y.normal();
  const Ball square = dot(n, n);
  const auto in_y = [&](const BallVector<Ball>& d) {
    return std::array{dot(cross(d, y.v), n), dot(cross(y.u, d), n)};
  };
  const std::array<Ball, 2> a = in_y(x.u), b = in_y(x.v);
  const Ball rr = dot(n, y.uu), rs = dot(n, y.uv), ss = dot(n, y.vv);
  const Ball of_x = x.weight * x.weight * square * square, of_y = y.weight * y.weight;
  const auto entry = [&](const BallVector<Ball>& d, const std::array<Ball, 2>& p,
                         const std::array<Ball, 2>& q) {
    return of_x * dot(n, d) - of_y * (rr * p[0] * q[0] + rs * (p[0] * q[1] + p[1] * q[0]) + ss * p[1] * q[1]);
  };
  return {entry(x.uu, a, a), entry(x.uv, a, b), entry(x.vv, b, b)};
}

template <class Ball>
bool is_nonzero(const BallVector<Ball>& v) {
  return std::ranges::any_of(v, [](const Ball& c) { return c.certain_sign() != 0; });
}

/// The box of a node, exactly or in doubles.
template <class Ball>
class NodeBox {
 public:
  explicit NodeBox(const ParameterBox& box) : box_(box) {}

  Ball at(std::size_t p) const { return Ball::enclosing(box_[p]); }
  /// 1 if `other` is certainly above in p, -1 if below.
  int order(const NodeBox& other, std::size_t p) const {
    return box_[p].upper < other.box_[p].lower ? 1 : other.box_[p].upper < box_[p].lower ? -1 : 0;
  }

 private:
  const ParameterBox& box_;
};

/// Its ends are rounded to nearest, which keeps their order, where they are asked for.
template <>
class NodeBox<DoubleBall> {
 public:
  explicit NodeBox(const ParameterBox& box) : box_(box) {}

  /// Ends are in [0,1], rounded by 2^-54 at most, as are their mean and its distances from them.
  DoubleBall at(std::size_t p) const {
    const auto [lower, upper] = ends(p);
    const double middle = lower == upper ? lower : 0.5 * (lower + upper);
    return DoubleBall(middle).widened(std::max(upper - middle, middle - lower) + 0x1p-52);
  }
  int order(const NodeBox& other, std::size_t p) const {
    const auto [lower, upper] = ends(p);
    const auto [low, high] = other.ends(p);
    return upper < low ? 1 : high < lower ? -1 : 0;
  }

 private:
  const std::array<double, 2>& ends(std::size_t p) const {
    if (!ends_[p]) ends_[p] = {nearest_double(box_[p].lower).value, nearest_double(box_[p].upper).value};
    return *ends_[p];
  }

  const ParameterBox& box_;
  mutable std::array<std::optional<std::array<double, 2>>, 4> ends_;
};

template <class Ball>
class SideFinder {
 public:
  template <class Patch>
  SideFinder(IntersectionGraph& graph, const Patch& x, const Patch& y, const std::vector<Parameter>& turning)
      : graph_(graph),
        x_(x),
        y_(y),
        turning_(turning),
        tangents_(graph.nodes.size()),
        ends_(graph.nodes.size()) {
    boxes_.reserve(graph.nodes.size());
    for (const Node& node : graph.nodes) boxes_.emplace_back(node.box);
    for (std::size_t i = 0; i < graph.arcs.size(); ++i)
      for (const int node : {graph.arcs[i].from, graph.arcs[i].to}) {
        Ends& ends = ends_[static_cast<std::size_t>(node)];
        if (ends.count < 2) ends.arcs[static_cast<std::size_t>(ends.count)] = i;
        ++ends.count;
      }
  }

  /// Returns whether all is decided.
  bool run() {
    for (Arc& arc : graph_.arcs)
      if (is_open(arc)) find(arc);
    while (std::ranges::any_of(graph_.arcs, is_open) && pass_on()) continue;
    for (const int id : graph_.isolated_points) find_around(graph_.nodes[static_cast<std::size_t>(id)]);
    for (Overlap& overlap : graph_.overlaps) find_normals(overlap);
    return is_done_ && std::ranges::none_of(graph_.arcs, is_open);
  }

 private:
  struct Ends {
    int count = 0;
    std::array<std::size_t, 2> arcs = {};
  };

  static bool is_open(const Arc& arc) { return !arc.beside && arc.free.empty(); }
  const Node& node(int id) const { return graph_.nodes[static_cast<std::size_t>(id)]; }

  PatchJet<Ball> jet(const PatchNet<Ball>& of, const Node& at, std::size_t first, int order) const {
    const NodeBox<Ball>& box = boxes_[static_cast<std::size_t>(at.id)];
    return of.at(box.at(first), box.at(first + 1), order);
  }

  const TangentSigns& tangent(int id) {
    std::optional<TangentSigns>& known = tangents_[static_cast<std::size_t>(id)];
    if (!known)
      known = node(id).free.empty() ? tangent_signs(jet(x_, node(id), 0, 1), jet(y_, node(id), 2, 1))
                                    : TangentSigns{};
    return *known;
  }

  void find(Arc& arc) {
    if (arc.contact == Contact::tangential) return find_touching(arc);
    // The node at which the next arc begins is of use again.
    const bool from_is_known = tangents_[static_cast<std::size_t>(arc.from)].has_value();
    const bool to_is_known = tangents_[static_cast<std::size_t>(arc.to)].has_value();
    int along = direction_in(arc, from_is_known && !to_is_known);
    if (along == 0) along = direction_in(arc, !from_is_known || to_is_known);
    for (const bool leaving : {true, false})
      if (along == 0) along = direction_at_side(arc, leaving);
    if (along != 0) arc.beside = {along, -along};
  }

  /// By (8.2): 1 if the arc runs along T, -1 if against it, where (8.1) says so at an end; else 0.
  int direction_at_side(const Arc& arc, bool leaving) {
    const int id = leaving ? arc.from : arc.to;
    for (const Side& side : node(id).on) {
      const int inwards = side.value == 0 ? 1 : -1;
      const int sign = tangent(id)[index(side.parameter)] * inwards;
      if (sign != 0) return leaving ? sign : -sign;
    }
    return 0;
  }

  /// The same from the boxes of both ends in a parameter that is monotone on the arc, and T at one end.
  int direction_in(const Arc& arc, bool at_from) {
    const TangentSigns& signs = tangent(at_from ? arc.from : arc.to);
    const auto from = static_cast<std::size_t>(arc.from), to = static_cast<std::size_t>(arc.to);
    for (const Parameter p : all_parameters) {
      if (signs[index(p)] == 0) continue;
      const int change = boxes_[from].order(boxes_[to], index(p));
      if (change != 0 && is_monotone(arc, p)) return change * signs[index(p)];
    }
    return 0;
  }

  /// On a closed curve without any turning point that was asked for, all of them are nodes.
  bool is_monotone(const Arc& arc, Parameter p) const {
    if (std::ranges::count(turning_, p) > 0) return true;
    const Component& component = graph_.components[static_cast<std::size_t>(arc.component)];
    return component.shape == ComponentShape::closed && std::ranges::any_of(component.arcs, [&](int id) {
             return std::ranges::count(node(graph_.arcs[static_cast<std::size_t>(id)].from).wrt, p) > 0;
           });
  }

  /// Through regular points in which two arcs end: one comes and one goes along T. False if nothing is new.
  bool pass_on() {
    bool found = false;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Ends& ends = ends_[i];
      if (ends.count != 2 || ends.arcs[0] == ends.arcs[1]) continue;
      for (const std::size_t k : {0, 1}) {
        const Arc& known = graph_.arcs[ends.arcs[k]];
        Arc& open = graph_.arcs[ends.arcs[1 - k]];
        if (!known.beside || !is_open(open) || known.contact != open.contact ||
            known.contact == Contact::tangential)
          continue;
        const int id = static_cast<int>(i);
        if (std::ranges::all_of(tangent(id), [](int sign) { return sign == 0; })) continue;
        const bool is_reversed = (known.to == id) == (open.to == id);
        const int along = is_reversed ? known.beside->right : known.beside->left;
        open.beside = {along, -along};
        found = true;
      }
    }
    return found;
  }

  std::optional<HeightForm<Ball>> form_at(const Node& at) const {
    if (!at.free.empty()) return std::nullopt;
    const PatchJet<Ball> x = jet(x_, at, 0, 2), y = jet(y_, at, 2, 2);
    if (!is_nonzero(x.normal()) || !is_nonzero(y.normal())) return std::nullopt;
    return height_form(x, y);
  }

  void find_touching(Arc& arc) {
    for (const int id : {arc.from, arc.to}) {
      const auto form = form_at(node(id));
      const int sign = form ? form->sign() : 0;
      if (sign == 0) continue;
      arc.beside = {sign, sign};
      return;
    }
  }

  void find_around(Node& at) {
    if (at.around || !at.on.empty()) return;
    const auto form = form_at(at);
    if (form && form->is_definite())
      at.around = form->sign();
    else
      is_done_ = false;
  }

  void find_normals(Overlap& overlap) {
    if (overlap.normals) return;
    bool same = false, opposite = false;
    for (const std::vector<Arc>& chain : overlap.chains)
      for (const Arc& arc : chain) {
        const Node& at = node(arc.from);
        if (!at.free.empty()) continue;
        const int sign = dot(jet(x_, at, 0, 1).normal(), jet(y_, at, 2, 1).normal()).certain_sign();
        same = same || sign > 0;
        opposite = opposite || sign < 0;
      }
    if (same != opposite)
      overlap.normals = same ? 1 : -1;
    else
      is_done_ = false;
  }

  IntersectionGraph& graph_;
  PatchNet<Ball> x_, y_;
  const std::vector<Parameter>& turning_;
  std::vector<NodeBox<Ball>> boxes_;
  std::vector<std::optional<TangentSigns>> tangents_;
  std::vector<Ends> ends_;
  bool is_done_ = true;
};

bool is_transversal(const Arc& arc) { return arc.contact == Contact::transversal && arc.free.empty(); }

bool is_answer(const IntersectResult& result) {
  return result.status == Status::complete && !result.graph.nodes.empty();
}

template <class Patch>
void add_signs(IntersectionGraph& graph, const Patch& x, const Patch& y,
               const std::vector<Parameter>& turning) {
  if (!SideFinder<DoubleBall>(graph, x, y, turning).run())
    SideFinder<ArbBall<256>>(graph, x, y, turning).run();
}

/// All transversal arcs have their signs.
bool has_signs(const IntersectionGraph& graph) {
  return std::ranges::all_of(graph.arcs, [](const Arc& arc) { return arc.beside || !is_transversal(arc); });
}

/// Without the turning points that are not asked for.
IntersectResult joined(IntersectResult result, const std::vector<Parameter>& turning) {
  GraphBuilder graph(std::move(result.graph));
  join_at_other_turning_points(graph, 0, 0, turning);
  IntersectResult other = finished(std::move(graph), {turning}, std::move(result.incomplete));
  other.coarse = result.coarse;
  return other;
}

template <class Patch>
IntersectResult with_signs(const Patch& x, const Patch& y, const Run& run,
                           const std::function<IntersectResult(const Run&)>& solve) {
  const std::vector<Parameter> all(all_parameters.begin(), all_parameters.end());
  IntersectResult result = changed(solve(run), run, [x, y](IntersectResult& of, const Run& asked) {
    if (is_answer(of)) add_signs(of.graph, x, y, asked.turning());
  });
  if (!is_answer(result) || has_signs(result.graph) || run.turning().size() == all.size()) return result;
  const auto add_and_join = [x, y, all](IntersectResult& of, const Run& asked) {
    if (!is_answer(of)) return;
    add_signs(of.graph, x, y, all);
    of = joined(std::move(of), asked.turning());
  };
  IntersectResult again = changed(solve(run.with_turning(all)), run, add_and_join,
                                  [all](const Run& asked) { return asked.with_turning(all); });
  return again.status == Status::complete && has_signs(again.graph) ? again : result;
}

}  // namespace

IntersectResult with_signs_beside(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                  const std::function<IntersectResult(const Run&)>& solve) {
  return with_signs(x, y, run, solve);
}

IntersectResult with_signs_beside(const RationalPatch& x, const RationalPatch& y, const Run& run,
                                  const std::function<IntersectResult(const Run&)>& solve) {
  return with_signs(x.reduced(), y.reduced(), run, solve);
}

}  // namespace exsect
