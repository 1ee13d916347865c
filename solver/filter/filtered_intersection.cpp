#include "filter/filtered_intersection.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "answer/parameter_box.h"
#include "answer/proof.h"
#include "filter/added_path.h"
#include "filter/contact_finder.h"
#include "filter/exact_turning.h"
#include "filter/known_pair.h"
#include "filter/loops.h"
#include "filter/proved_by_eliminant.h"
#include "filter/side_point_search.h"
#include "trace/turning_points.h"

namespace exsect::filter {

namespace {

constexpr std::size_t kMostDoublePoints = 8;
/// Of the tolerance, for the chords from ports to double points.
constexpr double kPortShare = 0.9;
constexpr std::array<std::size_t, 4> kNoneCoincident = {0, 1, 2, 3};

template <class K>
class FilteredIntersection {
 public:
  FilteredIntersection(const ExactPatch<K>& x, const ExactPatch<K>& y, const Run& run, bool with_stations,
                       std::vector<ParameterBox> boxes)
      : x_(x), y_(y), run_(run), with_stations_(with_stations), known_boxes_(std::move(boxes)) {}

  Filtered solved() {
    Filtered known;
    known.result = run();
    if (!known.result) known.stuck = stuck();
    known.among_closed = among_closed_;
    known.stations = std::move(stations_.curves);
    return known;
  }

 private:
  std::optional<IntersectResult> run() {
    const auto pair = make_pair_of<K>(x_, y_);
    if (!pair) {
      return std::nullopt;
    }
    TreesOf<K> trees{PatchTreeOf<K>(pair->x, pair->net_error), PatchTreeOf<K>(pair->y, pair->net_error)};
    if (auto overlap = overlap_of_pieces(*pair, trees)) {
      return overlap;
    }
    auto contacts = find_contacts(x_, y_, *pair);
    if (!contacts || (with_stations_ && !contacts->empty())) {
      return std::nullopt;
    }
    for (const ParameterBox& box : known_boxes_) contacts->boxes.push_back(known_box(box));
    if (!contacts->empty() && meet_in_contacts_only(*pair, trees, *contacts)) {
      return drawn(known(*pair, *std::move(contacts)));
    }
    auto points = boundary_points(*pair, *contacts, trees);
    if (!points && !with_stations_ && add_side_paths(*pair, trees, *contacts)) {
      boxes_ = 0;
      if (meet_in_contacts_only(*pair, trees, *contacts)) {
        return drawn(known(*pair, *std::move(contacts)));
      }
      points = boundary_points(*pair, *contacts, trees);
    }
    std::vector<TraceOf<K>> traces;
    while (!points || !find_curves(*pair, *contacts, trees, *points, traces)) {
      if (!points) stuck_ = undecided_on_sides(*pair, trees, *contacts);
      const bool is_added =
          add_contact_line(*pair, *contacts) ||
          (!points && stuck_ &&
           (add_side_point(x_, y_, *pair, *stuck_, *contacts) || add_side_double_point(*pair, *contacts)));
      if (!is_added && !add_corner_points(x_, y_, *pair, *contacts) &&
          !find_corners<K>(x_, y_, *pair, *contacts, centres_)) {
        if (!points || !loops_open_) return std::nullopt;
        break;
      }
      points = boundary_points(*pair, *contacts, trees);
      traces.clear();
    }
    std::vector<AnalysedTraceOf<K>> curves;
    if (!find_turns(*pair, *contacts, *points, traces, curves)) {
      return std::nullopt;
    }
    if (all_turns_wanted()) {
      stations_ =
          known_stations<K>(curves, *points, centres_, double_points_, contacts->double_points, coincident_);
    }
    if ((loops_open_ || needs_eliminant()) && !proved_by_eliminant(*pair, *contacts, trees)) {
      return std::nullopt;
    }
    KnownPair<K> all = known(*pair, *std::move(contacts));
    all.points = *std::move(points);
    all.centres = centres_;
    all.curves = std::move(curves);
    all.coincident = coincident_;
    all.finest_vertices = with_stations_ || needs_eliminant();
    return drawn(std::move(all));
  }

  /// Where the search ended undecided, centred; empty if that is no place.
  std::optional<Vec4> stuck() const {
    const auto is_inside = [](double w) { return std::fabs(w) <= 0.5; };
    const bool is_place = stuck_ && std::all_of(stuck_->begin(), stuck_->end(), is_inside);
    return is_place ? stuck_ : std::nullopt;
  }

  /// Whether the questions are answered that need exact forms of the patches.
  static constexpr bool kExactBehind = std::is_same_v<K, Biquadratic>;

  /// In exact mode the search for closed curves proves nothing.
  bool needs_eliminant() const { return !kExactBehind && run_.exact(); }

  /// In exact mode only if the patches are pieces of one surface.
  bool meet_in_contacts_only(const PairOf<K>& pair, TreesOf<K>& trees, const ContactsOf<K>& contacts) {
    if (!needs_eliminant()) return filter::meet_in_contacts_only(pair, trees, contacts, boxes_);
    const bool is_one = contacts.sides.size() + contacts.corners.size() == 1;
    return is_one && meet_as_neighbours<K>(contacts.sides.empty() ? Common::corner : Common::side, x_, y_,
                                           pair, trees, boxes_);
  }

  /// With the ports of the centres.
  std::optional<std::vector<BoundaryPointOf<K>>> boundary_points(const PairOf<K>& pair,
                                                                 const ContactsOf<K>& contacts,
                                                                 TreesOf<K>& trees) {
    auto points = filter::boundary_points(pair, contacts, trees, boxes_);
    for (std::size_t i = 0; points && i < centres_.size(); ++i) append_ports(i, *points);
    return points;
  }

  void append_ports(std::size_t centre, std::vector<BoundaryPointOf<K>>& points) const {
    const auto& ports = centres_[centre].ports;
    for (std::size_t i = 0; i < ports.size(); ++i)
      points.push_back({ports[i].ball, ports[i].parameter, ports[i].side, static_cast<int>(centre), i});
  }

  /// Of chords from ports to double points, in scaled space.
  double port_tolerance(const PairOf<K>& pair) const {
    return std::ldexp(kPortShare * run_.drawn_tolerance(pair.extent), -static_cast<int>(pair.frame.exponent));
  }

  bool add_contact_line(const PairOf<K>& pair, ContactsOf<K>& contacts) const {
    if constexpr (!kExactBehind) {
      const auto line =
          stuck_ && !with_stations_ ? contact_line_near<K>(x_, y_, pair, *stuck_) : std::nullopt;
      return line && filter::add_contact_line<K>(*line, contacts);
    }
    return false;
  }

  bool add_side_double_point(const PairOf<K>& pair, ContactsOf<K>& contacts) {
    if (!filter::add_side_double_point<K>(x_, y_, pair, *stuck_, port_tolerance(pair), contacts))
      return false;
    const DoublePointOf<K>& point = contacts.double_points.back();
    if (point.forms.crossing) add_centre(point);
    return true;
  }

  void add_centre(DoublePointOf<K> point) {
    centres_.push_back(point);
    double_points_.push_back(std::move(point));
  }

  bool add_side_paths(const PairOf<K>& pair, TreesOf<K>& trees, ContactsOf<K>& contacts) const {
    return filter::add_side_paths<K>(x_, y_, pair, trees, contacts);
  }

  std::optional<IntersectResult> overlap_of_pieces(const PairOf<K>& pair, TreesOf<K>& trees) {
    if (with_stations_) {
      return std::nullopt;
    }
    auto overlap = filter::overlap_of_pieces<K>(x_, y_, pair, trees, boxes_);
    if (!overlap) return std::nullopt;
    return drawn(known(pair, {}, std::move(overlap)));
  }

  KnownPair<K> known(const PairOf<K>& pair, ContactsOf<K> contacts,
                     std::optional<OverlapOfPieces> overlap = {}) const {
    std::optional<typename KnownPair<K>::Exact> exact;
    if (overlap || !contacts.empty()) exact = {x_, y_};
    return {std::move(exact), pair, std::move(overlap), std::move(contacts), {}, {}, {},
            kNoneCoincident,  false};
  }

  std::optional<IntersectResult> drawn(KnownPair<K> all) const {
    for (AnalysedTraceOf<K>& curve : all.curves) curve.trace.pieces.shrink_to_fit();  // it stays as it is
    const auto kept = std::make_shared<const KnownPair<K>>(std::move(all));
    auto result = first_drawn([kept](const Run& run) { return filter::drawn(*kept, run); }, run_);
    if (result) record(kept->curves, result->graph);
    return result;
  }

  /// Anew after each double point that is found where this fails.
  bool find_curves(const PairOf<K>& pair, const ContactsOf<K>& contacts, TreesOf<K>& trees,
                   std::vector<BoundaryPointOf<K>>& points, std::vector<TraceOf<K>>& traces) {
    for (;;) {
      Vec4 stuck = {1, 1, 1, 1};
      const bool has_arcs = trace_arcs(pair, points, traces, stuck);
      if (has_arcs && add_loops(pair, contacts, double_points_, trees, points, traces, boxes_, stuck)) {
        loops_open_ = false;
        return !needs_eliminant() || has_eliminant(contacts);
      }
      stuck_ = stuck;
      among_closed_ = has_arcs;
      loops_open_ = has_arcs && is_general(contacts, points) && has_eliminant(contacts);
      if (with_stations_ || double_points_.size() == kMostDoublePoints ||
          !add_double_point(pair, stuck, points)) {
        return false;
      }
      traces.clear();
    }
  }

  /// False only if the point is none of the others, and in none of the boxes.
  bool may_be_known(const DoublePointOf<K>& point) const {
    return std::ranges::any_of(double_points_,
                               [&](const DoublePointOf<K>& known) { return may_be_same(known, point); }) ||
           std::ranges::any_of(known_boxes_, [&](const ParameterBox& box) { return meet(box, point.box); });
  }

  bool add_double_point(const PairOf<K>& pair, const Vec4& stuck, std::vector<BoundaryPointOf<K>>& points) {
    auto point = double_point_near<K>(x_, y_, pair, stuck, port_tolerance(pair));
    if (!point || is_on_side(*point) || may_be_known(*point)) {
      return false;
    }
    add_centre(*std::move(point));
    append_ports(centres_.size() - 1, points);
    return true;
  }

  /// Every boundary point, and every port, is an end of exactly one arc.
  static bool trace_arcs(const PairOf<K>& pair, const std::vector<BoundaryPointOf<K>>& points,
                         std::vector<TraceOf<K>>& traces, Vec4& stuck) {
    std::vector<bool> used(points.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (used[i] || points[i].isolated) {
        continue;
      }
      auto trace = trace_arc(pair, points, i, &stuck);
      if (!trace || used[static_cast<std::size_t>(trace->end)] ||
          points[static_cast<std::size_t>(trace->end)].isolated) {
        return false;
      }
      used[i] = used[static_cast<std::size_t>(trace->end)] = true;
      traces.push_back(std::move(*trace));
    }
    return true;
  }

  /// Where the search for closed curves does not end, the proof by an eliminant is worth its time: in special
  /// positions another double point is the likelier reason.
  bool is_general(const ContactsOf<K>& contacts, const std::vector<BoundaryPointOf<K>>& points) const {
    return contacts.empty() && double_points_.empty() &&
           std::ranges::none_of(points, &BoundaryPointOf<K>::isolated);
  }

  /// Whether an eliminant can prove that no curve is missing. It is zero where the patches touch along a
  /// curve.
  bool has_eliminant(const ContactsOf<K>& contacts) const {
    return contacts.lines.empty() && contacts.boxes.empty() && contacts.branched.empty() &&
           filter::has_eliminant(rational_patch(x_), rational_patch(y_));
  }

  bool proved_by_eliminant(const PairOf<K>& pair, const ContactsOf<K>& contacts, TreesOf<K>& trees) {
    bool is_proved = false;
    run_.timed("turning eliminant", [&] {
      is_proved = filter::proved_by_eliminant<K>(x_, y_, pair, contacts, stations_, trees, boxes_);
    });
    return is_proved && !run_.out_of_time();
  }

  /// Also those with respect to parameters that were not asked for.
  bool all_turns_wanted() const { return with_stations_ || needs_eliminant() || loops_open_; }

  /// Without exact arithmetic. Of an open curve all that are not asked for are left out; a closed one needs a
  /// node.
  KnownTurning<K> known_turning(const TraceOf<K>& trace, const ContactsOf<K>& contacts,
                                const std::vector<BoundaryPointOf<K>>& points) const {
    KnownTurning<K> known{coincident_};
    if (trace.start < 0) return known;
    const BoundaryPointOf<K>& start = points[static_cast<std::size_t>(trace.start)];
    const BoundaryPointOf<K>& end = points[static_cast<std::size_t>(trace.end)];
    const auto side_point = [&](const BoundaryPointOf<K>& point) {
      return point.side_point < 0 ? nullptr : &contacts.points[static_cast<std::size_t>(point.side_point)];
    };
    known.start_at = side_point(start);
    known.end_at = side_point(end);
    if (known.start_at != nullptr) known.at_start = known.start_at->still;
    if (known.end_at != nullptr) known.at_end = known.end_at->still;
    known.start = start.ball;
    known.end = end.ball;
    if (all_turns_wanted() || !moves(trace)) return known;
    known.unasked.fill(true);
    for (const Parameter p : run_.turning()) known.unasked[index(p)] = false;
    return known;
  }

  bool find_turns(const PairOf<K>& pair, const ContactsOf<K>& contacts,
                  const std::vector<BoundaryPointOf<K>>& points, std::vector<TraceOf<K>>& traces,
                  std::vector<AnalysedTraceOf<K>>& curves) {
    coincident_ = kNoneCoincident;
    ExactTurning<K> exact(x_, y_);
    for (TraceOf<K>& trace : traces) {
      AnalysedTraceOf<K>& curve = curves.emplace_back(AnalysedTraceOf<K>{std::move(trace), {}});
      if (run_.turning().empty() && curve.trace.start >= 0 && !all_turns_wanted() && moves(curve.trace)) {
        continue;
      }
      KnownTurning<K> known = known_turning(curve.trace, contacts, points);
      auto found = filter::find_turns(pair, curve.trace, known, curve.turns);
      if (found != TurnSearch::done) {
        exact.add_to(known, curve.trace, points);
        if (known.is_one_point()) {
          return false;
        }
        coincident_ = known.coincident;
        curve.turns.clear();
        found = filter::find_turns(pair, curve.trace, known, curve.turns);
      }
      if constexpr (!kExactBehind) {
        if (found != TurnSearch::done) {
          const auto directions = exact_directions<K>(x_, y_, pair);
          curve.turns.clear();
          found = filter::find_turns(pair, curve.trace, known, curve.turns, &directions);
        }
      }
      if (found != TurnSearch::done) {
        among_closed_ = curve.trace.start < 0;
        if (among_closed_) stuck_ = first_four<K>(curve.trace.pieces.front().tube.centre);
        return false;
      }
    }
    return true;
  }

  void record(const std::vector<AnalysedTraceOf<K>>& curves, const IntersectionGraph& graph) const {
    std::size_t tubes = 0;
    for (const AnalysedTraceOf<K>& curve : curves) {
      tubes += curve.trace.pieces.size();
    }
    std::size_t vertices = 0;
    for (const Arc& arc : graph.arcs) {
      vertices += arc.polyline.size();
    }
    if (!all_turns_wanted()) run_.count("filtered", 1);
    run_.count("searched boxes", static_cast<double>(boxes_));
    run_.count("tubes", static_cast<double>(tubes));
    run_.count("vertices", static_cast<double>(vertices));
  }

  const ExactPatch<K>& x_;
  const ExactPatch<K>& y_;
  const Run& run_;
  const bool with_stations_;
  const std::vector<ParameterBox> known_boxes_;
  bool among_closed_ = false;  // where the search ended
  long boxes_ = 0;
  std::optional<Vec4> stuck_;
  std::array<std::size_t, 4> coincident_ = kNoneCoincident;
  std::vector<DoublePointOf<K>> double_points_;
  std::vector<CentreOf<K>> centres_;  // double points and branched corners
  bool loops_open_ = false;           // all arcs are traced, the search for closed curves did not end
  KnownStations stations_;
};

}  // namespace

template <class K>
Filtered filtered_intersection(const ExactPatch<K>& x, const ExactPatch<K>& y, const Run& run,
                               bool with_stations, std::vector<ParameterBox> boxes) {
  return FilteredIntersection<K>(x, y, run, with_stations, std::move(boxes)).solved();
}

#define EXSECT_INSTANTIATE(K)                                                                              \
  template Filtered filtered_intersection<K>(const ExactPatch<K>&, const ExactPatch<K>&, const Run&, bool, \
                                             std::vector<ParameterBox>);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
