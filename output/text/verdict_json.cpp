#include "output/text/verdict_json.h"

#include <fmt/format.h>

#include <cmath>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

Json bounds_json(const DistanceEnclosure& bounds) {
  if (!std::isfinite(bounds.upper)) return nullptr;
  return Json::array({std::max(0.0, std::nextafter(bounds.lower, 0.0)), decimal_not_below(bounds.upper)});
}

Json part_json(const CandidatePart& part) {
  return {{"curve", part.curve}, {"in", name(part.representation)}, {"from", part.from}, {"to", part.to}};
}

Json gap_json(const ArcGap& gap) {
  if (!gap.parameter) return {{"vertices", gap.vertices}};
  return {{"parameter", name(*gap.parameter)},
          {"from", json_number(gap.from)},
          {"to", json_number(gap.to)},
          {"vertices", gap.vertices}};
}

Json judged_overlap_json(int overlap) { return overlap < 0 ? Json() : Json(overlap); }

Json difference_json(const Difference& difference) {
  Json json = {
      {"kind", name(difference.kind)}, {"text", difference.text}, {"components", difference.components}};
  if (difference.curve) json["curve"] = *difference.curve;
  if (difference.point) json["point"] = *difference.point;
  if (difference.node) json["node"] = *difference.node;
  if (difference.part) json["part"] = part_json(*difference.part);
  if (difference.gap) {
    json["arc"] = difference.gap->arc;
    json["overlap"] = judged_overlap_json(difference.gap->overlap);
    json["gap"] = gap_json(*difference.gap);
  }
  return json;
}

Json judged_arc_json(const ArcFinding& arc) {
  Json gaps = Json::array();
  for (const ArcGap& gap : arc.gaps) gaps.push_back(gap_json(gap));
  return {{"arc", arc.arc},
          {"overlap", judged_overlap_json(arc.overlap)},
          {"component", arc.component},
          {"coverage", name(arc.coverage)},
          {"gaps", gaps},
          {"distance", bounds_json(arc.distance)}};
}

Json curve_json(std::size_t index, const CurveFinding& curve) {
  Json spurious = Json::array();
  for (const CandidatePart& part : curve.spurious) spurious.push_back(part_json(part));
  return {{"curve", index},
          {"components", curve.components},
          {"spurious", spurious},
          {"distance", bounds_json(curve.distance)},
          {"true_distance", bounds_json(curve.true_distance)}};
}

}  // namespace

Json verdict_json(const Verification& verification, const Candidate& candidate, const PatchNames& names) {
  const Verdict& verdict = verification.verdict;
  Json json = {{"exsect", "verdict/1"},
               {"status", verdict.agreement == Agreement::undecided ? "incomplete" : "complete"},
               {"verdict", name(verdict.agreement)},
               {"first", names.first},
               {"second", names.second},
               {"source", candidate.source},
               {"tolerance", verdict.tolerance},
               {"exact", verification.exact.status == Status::complete ? "complete" : "incomplete"},
               {"exact_tolerance", verification.exact_tolerance},
               {"exact_turning", Json::array()},
               {"differences", Json::array()},
               {"undecided", verdict.undecided},
               {"components", Json::array()},
               {"arcs", Json::array()},
               {"curves", Json::array()}};
  for (const Parameter p : verification.exact_turning) json["exact_turning"].push_back(name(p));
  for (const Difference& difference : verdict.differences)
    json["differences"].push_back(difference_json(difference));
  for (const ComponentFinding& component : verdict.components)
    json["components"].push_back(
        {{"component", component.component},
         {"shape",
          name(verification.exact.graph.components[static_cast<std::size_t>(component.component)].shape)},
         {"coverage", name(component.coverage)},
         {"curves", component.curves}});
  for (const ArcFinding& arc : verdict.arcs) json["arcs"].push_back(judged_arc_json(arc));
  for (std::size_t c = 0; c < verdict.curves.size(); ++c)
    json["curves"].push_back(curve_json(c, verdict.curves[c]));
  return json;
}

}  // namespace exsect::cli
