#include "confirmed_curves.h"

#include <exsect/solver/line_points_filtered.h>
#include <exsect/solver/line_query.h>
#include <exsect/solver/turning_eliminant.h>

#include <algorithm>

#include "answer/finished_result.h"
#include "answer/parameter_box.h"
#include "answer/proof.h"
#include "eliminant/critical_values.h"
#include "filter/filter.h"
#include "line/exact_line_points.h"
#include "side/boundary_lines.h"

namespace exsect {

namespace {

/// Denominators; a box of doubles holds such a number by chance once in millions.
constexpr int kShort = 1 << 12;
constexpr long kRefined = 40;

class Confirmation {
 public:
  Confirmation(const BezierPatch& x, const BezierPatch& y, const Run& run, ExactPair& pair)
      : x_(x), y_(y), run_(run), pair_(pair) {}

  std::optional<IntersectResult> run() {
    auto found = filtered_curves(x_, y_, run_);
    if (!found || !(confirmed_by_enclosure(found->stations[0]) || confirmed_exactly(found->stations)) ||
        run_.out_of_time()) {
      return std::nullopt;
    }
    for (Node& node : found->result.graph.nodes) {
      find_short_values(node);
    }
    const std::vector<Incomplete> contradictions = compare_with_exchanged(found->result.graph);
    if (contradictions.empty()) {
      return with_these_boxes(std::move(found->result));
    }
    return finished(GraphBuilder(std::move(found->result.graph)), {}, contradictions);
  }

 private:
  template <class Step>
  auto timed(const char* step, Step&& body) {
    std::optional<decltype(body())> result;
    run_.timed(step, [&] { result = body(); });
    return std::move(*result);
  }

  /// By enclosures of E(u).
  bool confirmed_by_enclosure(const std::vector<Stations>& curves) {
    const auto roots = timed("turning eliminant", [&] { return enclosed_turning_roots(x_, y_); });
    return roots && no_curve_is_missing_between(*roots, curves, Parameter::u);
  }

  bool confirmed_exactly(const std::array<std::vector<Stations>, 4>& curves) {
    if (run_.out_of_time()) {
      return false;
    }
    const auto turning = timed("turning eliminant", [&] { return pair_.choice().turning; });
    if (!turning || turning->touching ||
        std::any_of(turning->values.begin(), turning->values.end(),
                    [](const TurningValue& turn) { return turn.multiplicity != 1; })) {
      return false;
    }
    const Parameter sweep = turning->sweep;
    std::vector<RationalInterval> roots;
    for (const TurningValue& turn : turning->values) {
      roots.push_back(turn.value.refined_to(power_of_two(-kRefined)).interval());
    }
    return no_curve_is_missing_between(roots, curves[index(sweep)], sweep);
  }

  bool no_curve_is_missing_between(const std::vector<RationalInterval>& roots,
                                   const std::vector<Stations>& curves, Parameter sweep) {
    return timed("fibres", [&] {
      return no_curve_is_missing(
          simple_roots(roots), curves,
          [&](const RationalInterval& at) {
            return at.width() == 0 ? fibre_count({sweep, at.lower}) : std::nullopt;
          },
          sweep);
    });
  }

  std::optional<std::size_t> fibre_count(const LineQuery& query) {
    const LinePoints fibre = line_points_filtered(x_, y_, query);
    run_.count("fibres", 1);
    if (fibre.incomplete || !fibre.on_patch.empty()) {
      return std::nullopt;
    }
    return fibre.points.size();
  }

  /// Doubles decide the exchanged pair as well in most cases: a tenth of what the proof costs.
  std::vector<Incomplete> compare_with_exchanged(const IntersectionGraph& graph) const {
    IntersectOptions exchanged;  // of a call of its own: its work is not on this call's record
    exchanged.tolerance = run_.tolerance(1);
    exchanged.turning = run_.turning();
    for (Parameter& p : exchanged.turning) {
      p = all_parameters[index(p) ^ 2];
    }
    const auto other = intersect_filtered(y_, x_, exchanged);
    if (!other || have_same_counts(graph, other->graph)) {
      return {};
    }
    return {
        {whole_domain(), "the patches exchanged have another number of components, nodes or turning points"}};
  }

  /// A boundary point with a parameter that may be a short rational gets the box of the exact point, of width
  /// zero where a parameter is known to be rational.
  void find_short_values(Node& node) const {
    const auto may_be_short = [&](const RationalInterval& at) {
      return at.lower < at.upper && denominator(simplest_between(at.lower, at.upper)) <= kShort;
    };
    if (node.on.empty() || std::none_of(node.box.begin(), node.box.end(), may_be_short)) {
      return;
    }
    const Side& side = node.on.front();
    for (const CertifiedPoint& point : exact_line_points(x_, y_, {side.parameter, side.value}).points) {
      const ParameterBox box = point.refined_to(power_of_two(-50)).box();
      if (meet(box, node.box)) {
        node.box = box;
        return;
      }
    }
  }

  /// Whenever it is drawn.
  IntersectResult with_these_boxes(IntersectResult result) const {
    std::vector<ParameterBox> boxes;
    for (const Node& node : result.graph.nodes) boxes.push_back(node.box);
    return changed(std::move(result), run_, [boxes = std::move(boxes)](IntersectResult& drawn, const Run&) {
      for (std::size_t i = 0; i < boxes.size(); ++i) drawn.graph.nodes[i].box = boxes[i];
    });
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  const Run& run_;
  ExactPair& pair_;
};

}  // namespace

std::optional<IntersectResult> confirmed_curves(const BezierPatch& x, const BezierPatch& y, const Run& run,
                                                ExactPair& pair) {
  return Confirmation(x, y, run, pair).run();
}

}  // namespace exsect
