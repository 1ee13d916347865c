#include "overlap/overlaps.h"

#include <algorithm>

#include "answer/arc_joints.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "answer/parameter_names.h"
#include "overlap/common_sheet.h"
#include "overlap/identical_patches.h"
#include "overlap/overlap_boundary.h"
#include "overlap/two_piece_clip.h"
#include "self/curves.h"
#include "shape/coincident_parameters.h"
#include "shape/planar_patch.h"
#include "sweep/traced_curves.h"
#include "trace/bounded_vertex.h"
#include "trace/enclose.h"
#include "trace/landmark_node.h"
#include "trace/regular_degree.h"

namespace exsect {

namespace {

class OneSurface {
 public:
  OneSurface(const BezierPatch& x, const BezierPatch& y, const Run& run, const CommonSurface& surface)
      : x_(x),
        y_(y),
        run_(run),
        scale_(model_scale(x, y)),
        tolerance_(run.drawn_tolerance(scale_.extent)),
        surface_(surface),
        sheets_(x, y, scale_, surface) {}

  IntersectResult run() {
    timed("boundary lines", [this] {
      boundary_ = overlap_boundary(x_, y_, sheets_, scale_, tolerance_, stop_);
      result_.incomplete = boundary_.incomplete;
    });
    regular_ = surface_.planar() && !planar_patch_folds(x_) && !planar_patch_folds(y_);
    find_other_curves();
    timed("graph", [this] { add_boundary(); });
    return finished(std::move(graph_), {run_.turning(), RegularDegree(x_, y_)},
                    std::move(result_.incomplete));
  }

 private:
  /// Everything off the common sheets.
  void find_other_curves() {
    for (const BoundaryPoint& point : boundary_.points)
      if (point.kind == BoundaryPointKind::other) sweep_.landmarks.push_back({point.at, std::nullopt});
    sweep_.settled = [this](const SearchRegion& region) { return sheets_.settles(region); };
    sweep_.exact = result_.incomplete.empty();
    timed("tracing", [this] {
      if (clip_curves()) return;
      if (!trace<DoubleBall>(power_of_two(-50), false)) trace<ArbBall<256>>(power_of_two(-200), true);
    });
  }

  template <class Step>
  void timed(const char* step, Step&& body) {
    run_.timed(step, std::forward<Step>(body));
  }

  /// In a plane every solution lies on a common sheet if neither patch is singular anywhere. Otherwise the
  /// search must show that the singular places are no solutions; where it cannot, the fold is named.
  void name_folds() {
    for (const BezierPatch* patch : {&x_, &y_})
      if (planar_patch_folds(*patch))
        result_.incomplete.push_back(
            {whole_domain(), std::string("the patches lie in one plane and the parametrisation of the ") +
                                 (patch == &x_ ? "first" : "second") +
                                 " one folds or is singular there: the region they share is not decided"});
  }

  /// The curves apart from the common surface; false if more precision may help.
  template <class Ball>
  bool trace(const Rational& width, bool last) {
    const PairSystem<Ball> system(x_, y_, scale_.origin, scale_.frame.exponent);
    Landmarks<Ball> landmarks;
    for (const LandmarkPoint& landmark : sweep_.landmarks)
      landmarks.push_back(enclose<Ball>(landmark.point, width));
    TracedCurves<Ball> traced;
    if (!regular_) traced = trace_curves(system, landmarks, sweep_, width, stop_);
    if (!traced.problems.empty() && sweep_.exact && !last && !surface_.planar()) return false;
    if (surface_.planar() && !(traced.problems.empty() && sweep_.exact)) {
      name_folds();
      traced.problems.clear();
    }
    result_.incomplete.insert(result_.incomplete.end(), traced.problems.begin(), traced.problems.end());
    run_.count("searched boxes", static_cast<double>(traced.searched_boxes));
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      const CertifiedPoint& point = sweep_.landmarks[i].point;
      graph_.add_node(landmark_node(system, scale_.frame, landmarks[i], point.box(), point.sides()));
    }
    for (const int id : traced.isolated) graph_.add_isolated(id);
    for (const AnalysedTrace<Ball>& curve : traced.curves)
      append_trace(graph_, curve, landmarks, nodes_of_landmarks(landmarks.size()), scale_.frame,
                   run_.turning(), tolerance_);
    return true;
  }

  /// Two pieces of one polynomial surface, by the self-intersection of the rectangle around both; false if
  /// that does not decide.
  bool clip_curves() {
    if (surface_.planar() || !boundary_.incomplete.empty() || is_stopped(stop_)) return false;
    const auto pieces = two_pieces(x_, y_);
    if (!pieces) return false;
    const BezierPatch hull = pieces->hull();
    const Run for_hull = run_.with_tolerance(0.99 * tolerance_ / model_scale(hull, hull).extent);
    GraphBuilder graph;
    std::vector<int> nodes;
    for (const BoundaryPoint& point : boundary_.points) nodes.push_back(add_node(graph, point));
    const auto divided = append_clipped_curves(graph, *pieces, boundary_, nodes, for_hull);
    if (!divided) return false;
    graph_ = std::move(graph);
    nodes_ = std::move(nodes);
    dividing_ = *divided;
    return true;
  }

  int add_node(GraphBuilder& graph, const BoundaryPoint& point) const {
    const PairSystem<ArbBall<256>> system(x_, y_, scale_.origin, scale_.frame.exponent);
    const auto ball = enclose<ArbBall<256>>(point.at, power_of_two(-200));
    return graph.add_node(landmark_node(system, scale_.frame, ball, point.at.box(), point.at.sides()));
  }

  void add_boundary() {
    if (nodes_.empty()) {
      int ordinary = 0;
      for (const BoundaryPoint& point : boundary_.points)
        nodes_.push_back(point.kind == BoundaryPointKind::other ? ordinary++ : add_node(graph_, point));
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (boundary_.points[i].kind != BoundaryPointKind::touch) continue;
      graph_.add_kind(nodes_[i], NodeKind::touch);
      graph_.add_isolated(nodes_[i]);
    }
    for (const BoundaryArc& arc : boundary_.arcs)
      if (arc.kind == BoundaryArcKind::edge || arc.kind == BoundaryArcKind::branch) graph_.add_arc(made(arc));
    add_chains();
    const PairSystem<DoubleBall> system(x_, y_, scale_.origin, scale_.frame.exponent);
    for (const int id : dividing_) {
      const ParameterBox& box = graph_.node(id).box;
      if (!divide_at(graph_, id, chord_bound(system, scale_.frame, box)))
        result_.incomplete.push_back({box, "a cuspidal point on a side"});
    }
    mark_ends_of_overlaps();
  }

  Arc made(const BoundaryArc& from) {
    Arc arc{};
    arc.from = nodes_[from.from];
    arc.to = nodes_[from.to];
    arc.place = ArcPlace::patch_boundary;
    arc.contact = from.kind == BoundaryArcKind::branch ? Contact::transversal : Contact::tangential;
    arc.polyline = from.polyline;
    arc.error_bound = from.error_bound;
    return arc;
  }

  /// The rim is a closed curve through every one of its points: two arcs meet at each. Where that is not
  /// proved, every arc is a chain of its own.
  void add_chains() {
    std::vector<const BoundaryArc*> rim;
    rim.reserve(boundary_.arcs.size());
    std::vector<int> degree(boundary_.points.size(), 0);
    for (const BoundaryArc& arc : boundary_.arcs) {
      if (arc.kind != BoundaryArcKind::rim) continue;
      rim.push_back(&arc);
      ++degree[arc.from];
      ++degree[arc.to];
    }
    if (rim.empty()) return;
    const auto odd = std::find_if(degree.begin(), degree.end(), [](int d) { return d != 0 && d != 2; });
    if (odd == degree.end() && boundary_.incomplete.empty()) {
      std::vector<Chain> chains;
      while (!rim.empty()) chains.push_back(closed_chain(rim));
      if (chains.size() > 1 && !bound_different_regions(chains))
        result_.incomplete.push_back(
            {whole_domain(), "it is not decided which chains of boundary arcs bound the same overlap"});
      for (Chain& chain : chains) graph_.add_overlap({std::move(chain.arcs)});
      return;
    }
    if (result_.incomplete.empty())
      result_.incomplete.push_back({boundary_.points[static_cast<std::size_t>(odd - degree.begin())].at.box(),
                                    "the boundary arcs of overlaps that meet here could not be joined"});
    std::vector<std::vector<Arc>> pieces;
    for (const BoundaryArc* arc : rim) pieces.push_back({made(*arc)});
    graph_.add_overlap(std::move(pieces));
  }

  /// A closed chain of the rim, and whether it has arcs on sides of x, of y.
  struct Chain {
    std::vector<Arc> arcs;
    std::array<bool, 2> on;
  };

  /// Takes one closed chain out of the arcs.
  Chain closed_chain(std::vector<const BoundaryArc*>& left) {
    Chain chain{};
    const std::size_t start = left.front()->from;
    std::size_t at = start;
    do {
      const auto next = std::find_if(
          left.begin(), left.end(), [&](const BoundaryArc* arc) { return arc->from == at || arc->to == at; });
      const BoundaryArc& arc = **next;
      chain.arcs.push_back(made(arc));
      for (const Side& side : arc.inside.sides()) chain.on[index(side.parameter) / 2] = true;
      const bool forward = arc.from == at;
      if (!forward) {
        std::swap(chain.arcs.back().from, chain.arcs.back().to);
        std::reverse(chain.arcs.back().polyline.begin(), chain.arcs.back().polyline.end());
      }
      at = forward ? arc.to : arc.from;
      left.erase(next);
    } while (at != start);
    return chain;
  }

  /// Whether no two of the chains bound one region (docs/method.md, Lemma 6.1b).
  bool bound_different_regions(const std::vector<Chain>& chains) const {
    const std::array<bool, 2> injective = {is_injective(x_), is_injective(y_)};
    if (regular_) return injective[0] || injective[1];
    for (std::size_t i = 0; i < chains.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto apart = [&](std::size_t square) {
          return chains[i].on[square] && chains[j].on[square] && injective[1 - square];
        };
        if (!apart(0) && !apart(1)) return false;
      }
    return true;
  }

  bool is_injective(const BezierPatch& patch) const {
    return is_quickly_injective({patch, scale_.origin, scale_.frame.exponent}, stop_);
  }

  void mark_ends_of_overlaps() {
    std::vector<bool> on_rim(graph_.nodes().size(), false);
    for (const Overlap& overlap : graph_.overlaps())
      for (const std::vector<Arc>& chain : overlap.chains)
        for (const Arc& arc : chain)
          on_rim[static_cast<std::size_t>(arc.from)] = on_rim[static_cast<std::size_t>(arc.to)] = true;
    for (const Arc& arc : graph_.arcs())
      for (const int end : {arc.from, arc.to})
        if (on_rim[static_cast<std::size_t>(end)]) graph_.add_kind(end, NodeKind::end_of_overlap);
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Run& run_;
  ModelScale scale_;
  double tolerance_;
  const CommonSurface& surface_;
  CommonSheets sheets_;
  StopRequest stop_ = run_.stop();
  OverlapBoundary boundary_;
  bool regular_ = false;  // in a plane, and neither patch is singular
  ExactPair pair_{x_, y_, stop_};
  SweepData sweep_{pair_};
  std::vector<int> nodes_;     // of the boundary points
  std::vector<int> dividing_;  // nodes inside arcs on sides
  GraphBuilder graph_;
  IntersectResult result_{};
};

}  // namespace

std::optional<IntersectResult> intersect_on_one_surface(const BezierPatch& x, const BezierPatch& y,
                                                        const Run& run) {
  using enum Parameter;
  if (auto result = intersect_identical(x, y, run)) return result;
  const auto surface = CommonSurface::of(x, y);
  if (!surface) return std::nullopt;
  const BezierPatch exchanged = y.exchanged();
  if (!shifted_copy(x, exchanged)) return OneSurface(x, y, run, *surface).run();
  std::vector<Parameter> turning = run.turning();
  for (Parameter& p : turning) p = p == r ? s : p == s ? r : p;
  const Run renamed = run.with_turning(std::move(turning));
  IntersectResult result = OneSurface(x, exchanged, renamed, *CommonSurface::of(x, exchanged)).run();
  rename_parameters(result, {u, v, s, r});
  return result;
}

}  // namespace exsect
