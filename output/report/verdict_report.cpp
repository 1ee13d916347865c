#include "output/report/verdict_report.h"

#include <set>
#include <utility>

#include "output/report/candidate_strands.h"
#include "output/report/report_data.h"
#include "output/report/verdict_picture.h"
#include "output/text/verdict_json.h"

namespace exsect::cli {
namespace {

/// Of a polyline in space or in a square; numbers are rounded as they are drawn.
Json points_json(const std::vector<std::array<double, 3>>& points, Representation in) {
  Json list = Json::array();
  for (const auto& p : points) {
    if (in == Representation::space)
      list.push_back(p);
    else
      list.push_back(Json::array({p[0], p[1]}));
  }
  return list;
}

Json candidate_data(const Verification& verification, const Candidate& candidate) {
  Json curves = Json::array();
  for (std::size_t c = 0; c < candidate.curves.size(); ++c) {
    Json curve = Json::array();
    for (const DrawnStrand& strand : strands(candidate.curves[c])) {
      Json spurious = Json::array();
      for (const CandidatePart& part : verification.verdict.curves[c].spurious)
        if (part.representation == strand.in)
          spurious.push_back(points_json(part_of(strand, part.from, part.to), strand.in));
      curve.push_back({{"in", name(strand.in)},
                       {"points", points_json(strand.points, strand.in)},
                       {"spurious", std::move(spurious)}});
    }
    curves.push_back(std::move(curve));
  }
  Json points = Json::array();
  const std::set<std::size_t> wrong = wrong_points(verification.verdict);
  for (std::size_t i = 0; i < candidate.points.size(); ++i) {
    const CandidatePoint& point = candidate.points[i];
    points.push_back({{"space", point.point ? Json(*point.point) : Json()},
                      {"first", point.first ? Json(*point.first) : Json()},
                      {"second", point.second ? Json(*point.second) : Json()},
                      {"wrong", wrong.contains(i)}});
  }
  return {{"curves", std::move(curves)}, {"points", std::move(points)}};
}

/// What every page of a verdict holds beside its surfaces and the exact intersection.
Json verdict_data(const Verification& verification, const Candidate& candidate, const PatchNames& names,
                  const ReportOrigin& origin, const std::vector<const char*>& parameters) {
  Json data = report_data("verify", origin, verdict_json(verification, candidate, names));
  data["parameters"] = parameters;
  data["candidate"] = candidate_data(verification, candidate);
  data["gaps"] = Json::array();
  for (const ArcGap& gap : all_gaps(verification.verdict)) {
    Json line = Json::array();
    for (const PolylineVertex& v : vertices_of(verification.exact.graph, gap)) {
      Json row = Json::array();
      for (std::size_t k = 0; k < parameters.size(); ++k) row.push_back(v.parameters[k]);
      for (const double c : v.point) row.push_back(c);
      line.push_back(std::move(row));
    }
    data["gaps"].push_back(std::move(line));
  }
  return data;
}

}  // namespace

std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                                const ReportOrigin& origin) {
  Json data = verdict_data(verification, candidate, names, origin, {"u", "v", "r", "s"});
  data["patches"] = {patch_data(names.first, x), patch_data(names.second, y)};
  data["graph"] = intersection_json(verification.exact, names);
  return page_of(data, verdict_svg(verification, candidate, names, origin.title));
}

std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const RationalPatch& x, const ImplicitSurface& surface,
                                const PatchNames& names, const ReportOrigin& origin) {
  Json data = verdict_data(verification, candidate, names, origin, {"u", "v"});
  data["patches"] = Json::array({patch_data(names.first, x)});
  data["equations"] = Json::array({equation_data(names.second, surface, points_of(x))});
  data["graph"] = intersection_json(verification.exact, names);
  return page_of(data, verdict_svg(verification, candidate, names, origin.title));
}

std::string verdict_report_html(const Verification& verification, const Candidate& candidate,
                                const DrawnSurfaces& drawn, const ReportOrigin& origin) {
  const PatchNames names = {drawn.names.first, drawn.names.second};
  Json data = verdict_data(verification, candidate, names, origin, {});
  data["patches"] = Json::array();
  data["equations"] = equations_data(drawn);
  data["graph"] = surfaces_json(drawn.result, drawn.names);
  data["components"] = Json::array();
  for (const Component& component : verification.exact.graph.components)
    data["components"].push_back(
        {{"id", component.id}, {"shape", name(component.shape)}, {"arcs", component.arcs}});
  return page_of(data, verdict_svg(verification, candidate, drawn, origin.title));
}

}  // namespace exsect::cli
