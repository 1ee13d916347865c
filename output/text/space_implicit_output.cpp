#include "output/text/space_implicit_output.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>

#include "output/text/implicit_summary.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

const std::vector<std::string> coordinates = {"x", "y", "z"};

std::string coordinate(int axis) { return coordinates[static_cast<std::size_t>(axis)]; }
int second(const SpaceImplicit& implicit) { return other_axes(implicit)[0]; }
int third(const SpaceImplicit& implicit) { return other_axes(implicit)[1]; }

Json space_box_json(const SpaceBox& box) {
  Json json = Json::object();
  for (std::size_t k = 0; k < 3; ++k) json[coordinates[k]] = json_interval(box[k]);
  return json;
}

/// Adds the statements on the plane curve f or g.
void add_projection(const PlanarImplicit& projection, const std::string& name,
                    const std::vector<std::string>& variables, PlanarStatements& to) {
  PlanarStatements of = statements(projection, variables);
  for (Proved& statement : of.proved) {
    if (statement.name != "residual" && statement.name != "one-sided" && statement.name != "two-sided")
      continue;
    if (projection.is_exact) continue;
    statement.name = name + "-" + statement.name;
    to.proved.push_back(std::move(statement));
  }
  for (NotProved& statement : of.not_proved) {
    if (projection.is_exact || statement.name == "no-singular-point") continue;
    statement.name = name + "-" + statement.name;
    to.not_proved.push_back(std::move(statement));
  }
}

}  // namespace

std::array<int, 2> other_axes(const SpaceImplicit& implicit) {
  return {implicit.axis == 0 ? 1 : 0, implicit.axis == 2 ? 1 : 2};
}

PlanarStatements space_statements(const SpaceImplicit& implicit) {
  PlanarStatements result;
  const std::string axis = coordinate(implicit.axis);
  if (implicit.is_exact())
    result.proved.push_back({"exact", "both equations vanish on the curve", std::nullopt});
  add_projection(implicit.projections[0], "f", {axis, coordinate(second(implicit))}, result);
  add_projection(implicit.projections[1], "g", {axis, coordinate(third(implicit))}, result);
  if (implicit.is_regular)
    result.proved.push_back({"regular", axis + " is strictly monotone along the curve", std::nullopt});
  if (implicit.norms && implicit.norms_are_positive)
    result.proved.push_back(
        {"norms", "the polynomial norms are positive in the box: the surfaces meet where f = g = 0 only",
         std::nullopt});
  if (implicit.norms && !implicit.norms_are_positive)
    result.not_proved.push_back({"norms", space_box_json(implicit.box),
                                 "the polynomial norms may vanish: the surfaces may meet elsewhere"});
  if (implicit.angle.upper)
    result.proved.push_back({"cosine",
                             "|cos| of the angle between the gradients is at most this on the curve",
                             *implicit.angle.upper});
  else
    result.not_proved.push_back(
        {"cosine", Json{{"t", json_interval({0, 1})}}, "a gradient vanishes on the curve or may do so"});
  result.proved.push_back(
      {"cosine-attained", "|cos| is at least this somewhere on the curve", implicit.angle.lower});
  const std::size_t proved_points = static_cast<std::size_t>(
      std::count_if(implicit.further.branches.begin(), implicit.further.branches.end(),
                    [](const FurtherBranch& branch) { return branch.point.has_value(); }));
  const std::string in_tube =
      "in the box the surfaces meet only in the tube around the curve, one point for each " + axis;
  if (implicit.further.has_tube && implicit.further.branches.empty())
    result.proved.push_back({"tube", in_tube, std::nullopt});
  else if (implicit.further.has_tube)
    result.proved.push_back(
        {"tube",
         in_tube + fmt::format(
                       ", and perhaps in the boxes of further branches, {}, of which {} hold a proved point",
                       implicit.further.branches.size(), proved_points),
         std::nullopt});
  else
    result.not_proved.push_back({"tube", space_box_json(implicit.box),
                                 "no coordinate is monotone: the curve is not told from further branches"});
  return result;
}

bool is_complete(const SpaceImplicit& implicit) {
  const auto bounded = [](const PlanarImplicit& projection) {
    return projection.is_exact || projection.bounds.one_sided.distance.has_value();
  };
  return bounded(implicit.projections[0]) && bounded(implicit.projections[1]) && implicit.angle.upper &&
         implicit.further.has_tube;
}

std::string space_implicit_summary(const SpaceImplicit& implicit, const SpaceOptions& options) {
  std::string text =
      fmt::format("{}: two surfaces over the ({},{}) and the ({},{}) plane\n", name(options.method),
                  coordinate(implicit.axis), coordinate(second(implicit)), coordinate(implicit.axis),
                  coordinate(third(implicit)));
  const auto show = [&](const std::string& name, const SpacePolynomial& f) {
    const PolynomialTerms terms = terms_of(f);
    constexpr std::size_t most_terms = 40;
    text += terms.terms.size() <= most_terms
                ? equation_text(name, terms)
                : fmt::format("  {} has degree {} and {} terms; --json writes them\n", name, f.degree(),
                              terms.terms.size());
  };
  show("f", implicit.surfaces.first);
  show("g", implicit.surfaces.second);
  const PlanarStatements known = space_statements(implicit);
  text += statements_text(known.proved, known.not_proved);
  for (const FurtherBranch& branch : implicit.further.branches) {
    std::vector<std::string> sides;
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back(fmt::format("{} in [{:.4g}, {:.4g}]", coordinates[k], to_double(branch.box[k].lower),
                                  to_double(branch.box[k].upper)));
    text +=
        fmt::format("  {}  {}\n", branch.point ? "further branch " : "further branch?", joined(sides, ", "));
  }
  return text;
}

Json space_implicit_json(const SpaceImplicit& implicit, const SpaceOptions& options) {
  const PlanarStatements known = space_statements(implicit);
  Json further = Json::array();
  for (const FurtherBranch& branch : implicit.further.branches)
    further.push_back({{"box", space_box_json(branch.box)},
                       {"proved_point", branch.point ? space_box_json(*branch.point) : Json()}});
  return {{"exsect", "implicit/1"},
          {"status", is_complete(implicit) ? "complete" : "incomplete"},
          {"kind", "space-curve"},
          {"method", name(options.method)},
          {"exact", implicit.is_exact()},
          {"variables", coordinates},
          {"equations", Json::array({equation_json("f", terms_of(implicit.surfaces.first)),
                                     equation_json("g", terms_of(implicit.surfaces.second))})},
          {"axis", coordinate(implicit.axis)},
          {"regular", implicit.is_regular},
          {"box", space_box_json(implicit.box)},
          {"further_branches", std::move(further)},
          {"proved", proved_json(known.proved)},
          {"not_proved", not_proved_json(known.not_proved)}};
}

}  // namespace exsect::cli
