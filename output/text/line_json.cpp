#include "output/text/line_json.h"

#include <map>
#include <string>

#include "output/text/shown_line.h"

namespace exsect::cli {
namespace {

Json affine_json(const AffineForm& form) {
  Json normal = Json::array();
  for (const Rational& coordinate : form.normal) normal.push_back(json_number(coordinate));
  return {{"normal", std::move(normal)}, {"constant", json_number(form.constant)}};
}

/// Coefficients of a polynomial in x, y, z by exponents.
using Terms = std::map<std::array<int, 3>, Rational>;

/// Adds factor * f * g.
void add_product(const AffineForm& f, const AffineForm& g, const Rational& factor, Terms& terms) {
  const std::array<Rational, 4> a = {f.normal[0], f.normal[1], f.normal[2], f.constant};
  const std::array<Rational, 4> b = {g.normal[0], g.normal[1], g.normal[2], g.constant};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      std::array<int, 3> exponents = {0, 0, 0};
      if (i < 3) ++exponents[i];
      if (j < 3) ++exponents[j];
      terms[exponents] += factor * a[i] * b[j];
    }
  }
}

/// e0 e2 - e1^2, highest exponents first.
Json cylinder_json(const LineForms& forms) {
  Terms terms;
  add_product(forms.e0, forms.e2, 1, terms);
  add_product(forms.e1, forms.e1, -1, terms);
  Json list = Json::array();
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) {
    if (term->second != 0) list.push_back(Json::array({json_number(term->second), term->first}));
  }
  return {{"terms", std::move(list)}};
}

Json bidegree_json(const BivariatePolynomial& f) {
  return {{"bidegree", Json::array({f.degree_r(), f.degree_s()})}};
}

/// A point and a twisted cubic have no plane of their own.
bool has_plane(const LineIntersection& line) {
  return line.shape != LineShape::point && line.shape != LineShape::twisted_cubic;
}

/// Plane and cylinder of a conic, the two planes of a straight line, the equations of a cubic; null where
/// there is none.
Json pullback_json(const LineIntersection& line) {
  Json json = {{"plane", has_plane(line) ? bidegree_json(line.pullback.plane) : Json()}};
  if (line.second) json["second_plane"] = bidegree_json(line.pullback.m);
  json["cylinder"] = line.forms ? bidegree_json(line.pullback.cylinder()) : Json();
  for (const BivariatePolynomial& f : line.cubic) json["cubic"].push_back(bidegree_json(f));
  return json;
}

Json eliminant_json(const LineIntersection& line) {
  Json coefficients = Json::array();
  for (const Rational& c : line.eliminant.coefficients()) coefficients.push_back(json_number(c));
  return {{"variable", name(line.eliminant_variable)},
          {"degree", line.eliminant.degree()},
          {"coefficients", std::move(coefficients)}};
}

Json feasible_json(const std::vector<FeasibleBranch>& branches) {
  Json list = Json::array();
  for (const FeasibleBranch& branch : branches) {
    Json intervals = Json::array();
    for (const FeasibleInterval& interval : branch.intervals) {
      intervals.push_back({{"from", json_end(interval.from, interval.from_closed)},
                           {"to", json_end(interval.to, interval.to_closed)}});
    }
    list.push_back({{"branch", branch.branch}, {"intervals", std::move(intervals)}});
  }
  return list;
}

Json point_json(const ShownPoint& shown, Parameter fixed) {
  Json box = json_box(shown.point.box());
  box.erase(name(fixed));
  Json on = Json::array();
  for (Side side : shown.point.sides()) on.push_back(side_name(side));
  return {{"box", std::move(box)},
          {"on", std::move(on)},
          {"approx", json_approx(shown.parameters, shown.space)},
          {"multiplicity", shown.point.multiplicity()},
          {"branch", shown.point.branch()}};
}

Json on_patch_json(const std::vector<AlgebraicInterval>& intervals) {
  Json list = Json::array();
  for (const AlgebraicInterval& interval : intervals) {
    list.push_back({{"from", json_end(interval.from, true)}, {"to", json_end(interval.to, true)}});
  }
  return list;
}

/// Where a line query is undecided: the whole line.
Json incomplete_json(const LineIntersection& line) {
  Json list = Json::array();
  if (line.solution.incomplete) {
    ParameterBox box = {{{0, 1}, {0, 1}, {0, 1}, {0, 1}}};
    box[index(line.query.fixed)] = {line.query.value, line.query.value};
    list.push_back({{"where", json_box(box)},
                    {"why", *line.solution.incomplete},
                    {"reason", name(Reason::not_decided)}});
  }
  return list;
}

}  // namespace

Json line_json(const LineIntersection& line, const RationalPatch& x) {
  Json points = Json::array();
  for (const ShownPoint& shown : shown_points(line.solution, x))
    points.push_back(point_json(shown, line.query.fixed));
  Json json = {{"exsect", "line/1"}, {"status", line.solution.incomplete ? "incomplete" : "complete"}};
  json["fixed"] = {{name(line.query.fixed), json_number(line.query.value)}};
  json["shape"] = name(line.shape);
  json["plane"] = has_plane(line) ? affine_json(line.plane) : Json();
  if (line.second) json["second_plane"] = affine_json(*line.second);
  json["cylinder"] = line.forms ? cylinder_json(*line.forms) : Json();
  json["pullback"] = pullback_json(line);
  json["eliminant"] = eliminant_json(line);
  json["feasible"] = feasible_json(line.feasible);
  json["points"] = std::move(points);
  json["on_patch"] = on_patch_json(line.solution.on_patch);
  json["incomplete"] = incomplete_json(line);
  return json;
}

}  // namespace exsect::cli
