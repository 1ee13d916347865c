#include "output/text/implicit_json.h"

#include <cmath>
#include <limits>

namespace exsect::cli {
namespace {

constexpr const char* vanishes = "the equation vanishes on the curve";
constexpr const char* residual = "|f| is at most this on the curve";
constexpr const char* one_sided = "every point of the curve is within this distance of the zero set";
constexpr const char* two_sided =
    "in the strip of all p(t) + s N(t), |s| <= half-width, that the proof uses, the zero set is one regular "
    "arc, a graph over the curve; arc and curve are within this distance of each other";
constexpr const char* half_width =
    "half-width of the strip: no other point of the zero set in it, with N = W (-y', x')";
constexpr const char* regular = "the zero set has no singular point in the box";

Json where_t(const RationalInterval& t) { return {{"t", json_interval(t)}}; }

Json spline_json(const PlanarFunction& f, const std::vector<std::string>& variables) {
  const PlanarFunction::Grid& grid = f.grid();
  Json cells = Json::array();
  for (std::size_t i = 0; i < f.cells().size(); ++i) {
    for (std::size_t j = 0; j < f.cells()[i].size(); ++j) {
      if (!f.cells()[i][j]) continue;
      const PlanarBox box = {{grid.breaks_x[i], grid.breaks_x[i + 1]},
                             {grid.breaks_y[j], grid.breaks_y[j + 1]}};
      const PolynomialTerms terms = terms_of(*f.cells()[i][j], variables[0], variables[1]);
      cells.push_back(
          {{"box", planar_box_json(box, variables)}, {"terms", equation_json("", terms)["terms"]}});
    }
  }
  return cells;
}

}  // namespace

bool PlanarStatements::is_complete() const {
  return std::any_of(proved.begin(), proved.end(),
                     [](const Proved& statement) { return statement.name == "one-sided"; });
}

PlanarStatements statements(const PlanarImplicit& implicit, const std::vector<std::string>& variables) {
  PlanarStatements result;
  const DistanceBounds& bounds = implicit.bounds;
  if (implicit.is_exact) result.proved.push_back({"exact", vanishes, std::nullopt});
  if (bounds.one_sided.residual) result.proved.push_back({"residual", residual, *bounds.one_sided.residual});
  if (bounds.one_sided.distance)
    result.proved.push_back({"one-sided", one_sided, *bounds.one_sided.distance});
  for (const Unproved& gap : bounds.one_sided.unproved)
    result.not_proved.push_back({"one-sided", where_t(gap.t), gap.why});
  if (const auto& strip = bounds.two_sided.strip) {
    result.proved.push_back({"two-sided", two_sided, strip->distance});
    result.proved.push_back({"half-width", half_width, strip->half_width});
  }
  for (const Unproved& gap : bounds.two_sided.unproved)
    result.not_proved.push_back({"two-sided", where_t(gap.t), gap.why});
  if (implicit.possibly_singular.empty()) {
    result.proved.push_back({"no-singular-point", regular, std::nullopt});
  } else {
    PlanarBox hull = implicit.possibly_singular.front();
    for (const PlanarBox& box : implicit.possibly_singular)
      hull = {{std::min(hull.x.lower, box.x.lower), std::max(hull.x.upper, box.x.upper)},
              {std::min(hull.y.lower, box.y.lower), std::max(hull.y.upper, box.y.upper)}};
    result.not_proved.push_back({"no-singular-point", planar_box_json(hull, variables),
                                 "all singular points of the zero set in the box, if any, lie there"});
  }
  return result;
}

double double_not_below(const Rational& q) {
  const double nearest = to_double(q);
  if (!std::isfinite(nearest) || from_double(nearest) >= q) return nearest;
  return std::nextafter(nearest, std::numeric_limits<double>::infinity());
}

Json equation_json(const std::string& name, const PolynomialTerms& polynomial) {
  Json terms = Json::array();
  for (const PolynomialTerm& term : polynomial.terms)
    terms.push_back(Json::array({json_number(term.coefficient), term.exponents}));
  return {{"name", name},
          {"degree", polynomial.total_degree()},
          {"degrees", polynomial.degrees()},
          {"text", to_text(polynomial)},
          {"terms", std::move(terms)}};
}

Json proved_json(const std::vector<Proved>& proved) {
  Json list = Json::array();
  for (const Proved& statement : proved) {
    Json json = {{"name", statement.name}, {"statement", statement.statement}};
    if (statement.value) {
      json["value"] = json_number(*statement.value);
      json["approx"] = decimal_not_below(double_not_below(*statement.value));
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json not_proved_json(const std::vector<NotProved>& not_proved) {
  Json list = Json::array();
  for (const NotProved& statement : not_proved)
    list.push_back({{"name", statement.name}, {"where", statement.where}, {"why", statement.why}});
  return list;
}

Json planar_box_json(const PlanarBox& box, const std::vector<std::string>& variables) {
  Json json = Json::object();
  json[variables[0]] = json_interval(box.x);
  json[variables[1]] = json_interval(box.y);
  return json;
}

Json planar_implicit_json(const PlanarImplicit& implicit, const PlanarOptions& options,
                          const std::vector<std::string>& variables) {
  const PlanarStatements known = statements(implicit, variables);
  const bool spline = !implicit.function.is_polynomial();
  Json json = {{"exsect", "implicit/1"},     {"status", known.is_complete() ? "complete" : "incomplete"},
               {"kind", "planar-curve"},     {"method", name(options.method)},
               {"exact", implicit.is_exact}, {"variables", variables}};
  json["equations"] = Json::array();
  if (!spline)
    json["equations"].push_back(
        equation_json("f", terms_of(implicit.function.polynomial(), variables[0], variables[1])));
  if (spline) json["cells"] = spline_json(implicit.function, variables);
  json["parametrisation"] = {{"power", implicit.power}, {"exact_degree", implicit.exact_degree}};
  if (options.method != PlanarMethod::exact) {
    json["space"] = {{"kind", name(options.space)},
                     {"dimension", implicit.dimension},
                     {"box", planar_box_json(implicit.box, variables)}};
    json["unique"] = implicit.is_unique;
    json["digits"] = implicit.digits ? Json(*implicit.digits) : Json();
    if (implicit.singular_value) json["singular_value"] = *implicit.singular_value;
  }
  json["proved"] = proved_json(known.proved);
  json["not_proved"] = not_proved_json(known.not_proved);
  return json;
}

}  // namespace exsect::cli
