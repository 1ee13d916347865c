#include "output/text/revolution_output.h"

#include <exsect/geometry/number.h>
#include <exsect/geometry/polynomial_terms.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/text/implicit_json.h"
#include "output/text/implicit_summary.h"
#include "output/text/node_place.h"
#include "output/text/proved_decimal.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr const char* profile_vanishes = "the equation vanishes on the profile";
constexpr const char* profile_residual = "|f| is at most this on the profile";
constexpr const char* profile_one_sided =
    "every point of the revolved profile is within this distance of the surface";
constexpr const char* profile_two_sided =
    "near the profile the zero set is one regular arc; its surface and that of the profile are within this "
    "distance of each other";

struct Statements {
  std::vector<Proved> proved;
  std::vector<NotProved> not_proved;
};

Statements revolution_statements(const Revolution& revolution) {
  Statements result;
  const DistanceBounds& bounds = revolution.bounds;
  const auto where = [](const RationalInterval& t) { return Json{{"t", json_interval(t)}}; };
  if (revolution.exact) result.proved.push_back({"exact", profile_vanishes, std::nullopt});
  if (bounds.one_sided.residual)
    result.proved.push_back({"residual", profile_residual, *bounds.one_sided.residual});
  if (bounds.one_sided.distance)
    result.proved.push_back({"one-sided", profile_one_sided, *bounds.one_sided.distance});
  if (bounds.two_sided.strip)
    result.proved.push_back({"two-sided", profile_two_sided, bounds.two_sided.strip->distance});
  for (const Unproved& gap : bounds.one_sided.unproved)
    result.not_proved.push_back({"one-sided", where(gap.t), gap.why});
  for (const Unproved& gap : bounds.two_sided.unproved)
    result.not_proved.push_back({"two-sided", where(gap.t), gap.why});
  return result;
}

/// Proved digits of a coordinate.
std::string shown_number(const RationalInterval& interval) {
  const Rational largest = std::max(abs(interval.lower), abs(interval.upper));
  const long scale = largest == 0 ? 0 : decimal_exponent(largest);
  return proved_decimal(interval, scale - shown_decimals(false), scale);
}

std::string shown_number(const Rational& value) { return shown_number(RationalInterval{value, value}); }
std::string shown_number(const RealAlgebraic& value) {
  return shown_number(value.refined_to(shown_width()).interval());
}

std::string degrees_text(const std::vector<int>& degrees) {
  std::vector<std::string> texts;
  for (const int degree : degrees) texts.push_back(std::to_string(degree));
  return "(" + joined(texts, ",") + ")";
}

std::string text_or_length(const std::string& text) {
  constexpr std::size_t longest = 2000;
  return text.size() <= longest ? text : fmt::format("{} characters, see --json", text.size());
}

std::string equations_text(const Revolution& revolution) {
  if (!revolution.profile.is_polynomial())
    return fmt::format("spline of {} in (r^2,z)\n", counted(revolution.surfaces.size(), "cell"));
  const PolynomialTerms f = terms_of(revolution.profile.polynomial(), "r", "z");
  const PolynomialTerms g = terms_of(surface_of_revolution(revolution.surfaces.front()));
  return fmt::format("profile, degrees {} in r, z: {}\nsurface, degrees {} in x, y, z: {}\n",
                     degrees_text(f.degrees()), text_or_length(to_text(f)), degrees_text(g.degrees()),
                     text_or_length(to_text(g)));
}

std::string rings_text(const SingularRings& rings) {
  std::vector<std::vector<std::string>> rows;
  for (const SingularRing& ring : rings.rings) rows.push_back({shown_number(ring.r), shown_number(ring.z)});
  std::string text = counted(rows.size(), "singular ring") + "\n" + table({"r", "z"}, rows);
  if (rings.common_factor) text += "even and odd part have a common factor: its zeros are singular\n";
  return text;
}

std::string audit_text(const BranchAudit& audit, const Rectangle& region) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < audit.gaps.size(); ++i) {
    const auto end = [&](bool first) {
      if (first ? i == 0 : i == audit.critical.size())
        return shown_number(first ? region.s.lower : region.s.upper);
      return shown_number(audit.critical[first ? i - 1 : i]);
    };
    rows.push_back(
        {end(true), end(false), std::to_string(audit.gaps[i].own), std::to_string(audit.gaps[i].mirrored)});
  }
  return "branches with 0 < r < " + shown_number(region.r.upper) + "\n" +
         table({"from z", "to z", "own", "mirrored"}, rows);
}

struct CurveCounts {
  std::size_t open = 0, closed = 0, branched = 0;
};

CurveCounts counts(const RevolutionPatchCurve& curve) {
  CurveCounts result;
  for (const CurveComponent& c : components(curve.arcs, std::vector<bool>(curve.arcs.arcs.size(), true)))
    ++(c.branched ? result.branched : c.closed ? result.closed : result.open);
  return result;
}

bool is_resolved(const RevolutionPatchCurve& curve) {
  for (const CurveEvent& event : curve.arcs.events)
    for (const CurveMeeting& meeting : event.meetings)
      if (meeting.kind == MeetingKind::unresolved) return false;
  return true;
}

std::string patch_text(const ShownRevolutionPatch& patch) {
  if (patch.curve.equation.is_zero())
    return fmt::format("patch {}: lies on the surface\n", printable(patch.name));
  const CurveCounts n = counts(patch.curve);
  std::string text = fmt::format(
      "patch {}: curve of bidegree ({},{}), {} open, {} closed, {} branched; {}\n", printable(patch.name),
      patch.curve.equation.degree_r(), patch.curve.equation.degree_s(), n.open, n.closed, n.branched,
      is_resolved(patch.curve) ? "complete up to isolated points" : "some meetings not resolved");
  for (const ShownRevolutionLine& line : patch.lines) {
    std::vector<std::vector<std::string>> rows;
    for (const RevolutionPatchPoint& p : line.line.points) rows.push_back({shown_number(p.v), name(p.sheet)});
    text += fmt::format("u = {}: {}\n", to_string(line.u),
                        line.line.whole_line ? "lies on the surface" : counted(rows.size(), "point")) +
            table({"v", "sheet"}, rows);
  }
  return text;
}

Json interval_json(const RationalInterval& interval) {
  return {{"box", json_interval(interval)}, {"approx", to_double(interval.midpoint())}};
}

Json algebraic_json(const RealAlgebraic& value) {
  return {{"box", json_interval(value.refined_to(shown_width()).interval())}, {"approx", value.to_double()}};
}

Json surface_json(const Revolution& revolution) {
  Json list = Json::array();
  if (revolution.profile.is_polynomial()) {
    list.push_back(equation_json("profile", terms_of(revolution.profile.polynomial(), "r", "z")));
    list.push_back(equation_json("surface", terms_of(surface_of_revolution(revolution.surfaces.front()))));
  }
  return list;
}

Json cells_json(const PlanarFunction& f) {
  Json cells = Json::array();
  for (std::size_t i = 0; i < f.cells().size(); ++i)
    for (std::size_t j = 0; j < f.cells()[i].size(); ++j) {
      if (!f.cells()[i][j]) continue;
      const SpacePolynomial surface = surface_of_revolution(revolved_by_substitution(*f.cells()[i][j]));
      cells.push_back({{"R", json_interval({f.grid().breaks_x[i], f.grid().breaks_x[i + 1]})},
                       {"z", json_interval({f.grid().breaks_y[j], f.grid().breaks_y[j + 1]})},
                       {"terms", equation_json("", terms_of(surface))["terms"]}});
    }
  return cells;
}

Json rings_json(const SingularRings& rings) {
  Json list = Json::array();
  for (const SingularRing& ring : rings.rings)
    list.push_back({{"r", interval_json(ring.r)}, {"z", interval_json(ring.z)}});
  return list;
}

Json audit_json(const BranchAudit& audit) {
  Json json = {{"critical", Json::array()}, {"counts", Json::array()}};
  for (const RealAlgebraic& z : audit.critical) json["critical"].push_back(algebraic_json(z));
  for (const BranchCount& count : audit.gaps)
    json["counts"].push_back(
        {{"z", json_number(count.sample)}, {"own", count.own}, {"mirrored", count.mirrored}});
  return json;
}

const char* meeting_name(MeetingKind kind) {
  constexpr std::array<const char*, 5> names = {"passes", "folds", "ends", "crosses", "unresolved"};
  return names[static_cast<std::size_t>(kind)];
}

Json arcs_json(const RevolutionPatchCurve& curve) {
  Json list = Json::array();
  for (std::size_t i = 0; i < curve.arcs.arcs.size(); ++i) {
    const CurveArc& arc = curve.arcs.arcs[i];
    list.push_back(
        {{"id", i},
         {"u", json_interval({curve.arcs.events[arc.gap].u.lower, curve.arcs.events[arc.gap + 1].u.upper})},
         {"sample", {{"u", json_number(curve.arcs.gaps[arc.gap].sample)}, {"v", interval_json(arc.v)}}},
         {"sheet", exsect::name(curve.sheets[i])}});
  }
  return list;
}

Json meetings_json(const CurveArcs& arcs) {
  Json list = Json::array();
  for (const CurveEvent& event : arcs.events)
    for (const CurveMeeting& meeting : event.meetings)
      list.push_back({{"kind", meeting_name(meeting.kind)},
                      {"u", json_interval(event.u)},
                      {"v", json_interval(meeting.v)},
                      {"left", meeting.left},
                      {"right", meeting.right}});
  return list;
}

Json patch_json(const ShownRevolutionPatch& patch) {
  Json json = {{"name", patch.name},
               {"on_surface", patch.curve.equation.is_zero()},
               {"bidegree", {patch.curve.equation.degree_r(), patch.curve.equation.degree_s()}},
               {"whole_sides", patch.curve.whole_sides},
               {"arcs", arcs_json(patch.curve)},
               {"meetings", meetings_json(patch.curve.arcs)},
               {"components", Json::array()},
               {"vertical", Json::array()},
               {"lines", Json::array()}};
  for (const CurveComponent& c :
       components(patch.curve.arcs, std::vector<bool>(patch.curve.arcs.arcs.size(), true)))
    json["components"].push_back({{"shape", c.branched ? "branched"
                                            : c.closed ? "closed"
                                                       : "open"},
                                  {"arcs", c.arcs}});
  for (const RealAlgebraic& u : patch.curve.arcs.vertical) json["vertical"].push_back(algebraic_json(u));
  for (const ShownRevolutionLine& line : patch.lines) {
    Json points = Json::array();
    for (const RevolutionPatchPoint& p : line.line.points) {
      Json point = {{"v", algebraic_json(p.v)}, {"sheet", exsect::name(p.sheet)}};
      points.push_back(std::move(point));
    }
    json["lines"].push_back(
        {{"u", json_number(line.u)}, {"whole_line", line.line.whole_line}, {"points", points}});
  }
  return json;
}

}  // namespace

bool ShownRevolution::is_complete() const {
  return revolution.bounds.one_sided.distance && (!patch || is_resolved(patch->curve));
}

std::string revolution_summary(const ShownRevolution& shown) {
  const Revolution& revolution = shown.revolution;
  std::string text = fmt::format("revolution by {}, {} profile\n", name(shown.method),
                                 revolution.exact ? "exact" : "approximate");
  text += equations_text(revolution);
  if (revolution.rings) text += rings_text(*revolution.rings);
  if (revolution.audit) text += audit_text(*revolution.audit, revolution.region);
  const Statements known = revolution_statements(revolution);
  text += statements_text(known.proved, known.not_proved);
  return shown.patch ? text + patch_text(*shown.patch) : text;
}

Json revolution_json(const ShownRevolution& shown) {
  const Revolution& revolution = shown.revolution;
  const Statements known = revolution_statements(revolution);
  Json json = {
      {"exsect", "revolution/1"},
      {"status", shown.is_complete() ? "complete" : "incomplete"},
      {"method", name(shown.method)},
      {"exact", revolution.exact},
      {"region", {{"r", json_interval(revolution.region.r)}, {"z", json_interval(revolution.region.s)}}},
      {"equations", surface_json(revolution)}};
  if (!revolution.profile.is_polynomial()) json["cells"] = cells_json(revolution.profile);
  json["rings"] = revolution.rings ? rings_json(*revolution.rings) : Json();
  json["common_factor"] = revolution.rings && revolution.rings->common_factor;
  json["branches"] = revolution.audit ? audit_json(*revolution.audit) : Json();
  json["proved"] = proved_json(known.proved);
  json["not_proved"] = not_proved_json(known.not_proved);
  json["patch"] = shown.patch ? patch_json(*shown.patch) : Json();
  return json;
}

}  // namespace exsect::cli
