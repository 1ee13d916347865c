#include "output/report/report_data.h"

#include <exsect/geometry/number.h>

#include <algorithm>

#include "output/report/report_page.h"
#include "output/text/implicit_json.h"
#include "output/text/line_json.h"
#include "output/text/shown_line.h"

namespace exsect::cli {
namespace {

constexpr std::size_t longest_polynomials = 8000;
constexpr int sampled_cells = 48;

Rational largest_of_coefficients(const BivariatePolynomial& f) {
  Rational largest = 0;
  for (int i = 0; i <= f.degree_r(); ++i)
    for (const Rational& c : f.coefficient(i).coefficients()) largest = std::max<Rational>(largest, abs(c));
  return largest;
}

/// f / scale in doubles; [] for the zero polynomial.
Json form_data(const BivariatePolynomial& f, const Rational& scale) {
  Json rows = Json::array();
  for (int i = 0; i <= f.degree_r(); ++i) {
    Json row = Json::array();
    for (const Rational& c : f.coefficient(i).coefficients()) row.push_back(to_double(c / scale));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json forms_data(const LineIntersection& found) {
  const PullBack& pullback = found.pullback;
  const auto positive = [](const Rational& scale) { return scale > 0 ? scale : Rational(1); };
  Json cubic = Json::array();
  for (const BivariatePolynomial& f : found.cubic)
    cubic.push_back(form_data(f, positive(largest_of_coefficients(f))));
  const Rational plane = positive(largest_of_coefficients(pullback.plane));
  const Rational line =
      positive(std::max({largest_of_coefficients(pullback.u), largest_of_coefficients(pullback.l),
                         largest_of_coefficients(pullback.m)}));
  return {{"plane", form_data(pullback.plane, plane)},
          {"u", form_data(pullback.u, line)},
          {"l", form_data(pullback.l, line)},
          {"m", form_data(pullback.m, line)},
          {"cubic", std::move(cubic)}};
}

/// A root is a phantom if its interval is apart from the box of every point; both are at most 2^-64 wide.
Json phantom_roots(const LineIntersection& line) {
  Json roots = Json::array();
  if (line.eliminant.is_zero()) return roots;
  const std::size_t variable = index(line.eliminant_variable);
  for (const RealAlgebraic& root : real_roots(line.eliminant, 0, 1)) {
    const RationalInterval interval = root.refined_to(shown_width()).interval();
    const bool is_point =
        std::any_of(line.solution.points.begin(), line.solution.points.end(), [&](const CertifiedPoint& p) {
          const RationalInterval box = p.refined_to(shown_width()).box()[variable];
          return interval.lower <= box.upper && box.lower <= interval.upper;
        });
    if (!is_point) roots.push_back(root.to_double());
  }
  return roots;
}

}  // namespace

Json report_data(const std::string& command, const ReportOrigin& origin, Json result) {
  Json inputs = Json::array();
  for (const ReportInput& input : origin.inputs)
    inputs.push_back({{"file", input.file}, {"sha256", input.sha256}});
  return {{"command", command},         {"program", "exsect " EXSECT_VERSION},
          {"title", origin.title},      {"file", origin.file},
          {"line", origin.command},     {"inputs", std::move(inputs)},
          {"result", std::move(result)}};
}

Json patch_data(const std::string& name, const RationalPatch& patch) {
  Json net = Json::array(), points = Json::array(), weights = Json::array();
  bool weighted = false;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    Json exact_row = Json::array(), row_in_doubles = Json::array(), weight_row = Json::array();
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const Point point = patch.point(i, j);
      exact_row.push_back({json_number(point[0]), json_number(point[1]), json_number(point[2])});
      row_in_doubles.push_back({to_double(point[0]), to_double(point[1]), to_double(point[2])});
      weight_row.push_back(json_number(patch.weight(i, j)));
      weighted = weighted || patch.weight(i, j) != 1;
    }
    net.push_back(std::move(exact_row));
    points.push_back(std::move(row_in_doubles));
    weights.push_back(std::move(weight_row));
  }
  Json data = {{"name", name}, {"net", std::move(net)}, {"points", std::move(points)}};
  if (!weighted) return data;
  data["weights"] = std::move(weights);
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
      data["points"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].push_back(
          to_double(patch.weight(i, j)));
  return data;
}

SpacePoints points_of(const RationalPatch& x) {
  constexpr int n = 8;
  SpacePoints points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const Point p = x(Rational(i, n), Rational(j, n));
      points.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
    }
  return points;
}

Json equation_data(const std::string& name, const ImplicitSurface& surface, const SpacePoints& around) {
  Json data = {{"name", name},
               {"kind", exsect::name(surface.kind())},
               {"terms", equation_json(name, terms_of(surface.equation()))["terms"]}};
  const std::optional<SceneMesh> mesh = sampled(surface, name, around, sampled_cells);
  if (!mesh) return data;
  Json points = Json::array();
  for (const PolylineVertex& vertex : mesh->vertices) points.push_back(vertex.point);
  data["mesh"] = {{"points", std::move(points)}, {"faces", mesh->faces}};
  return data;
}

Json equations_data(const DrawnSurfaces& drawn) {
  const SpacePoints around = drawn_points(drawn);
  return Json::array({equation_data(drawn.names.first, drawn.first, around),
                      equation_data(drawn.names.second, drawn.second, around)});
}

Json fibre_data(const LineIntersection& line, const RationalPatch& x) {
  Json result = line_json(line, x);
  const bool polynomials =
      result["eliminant"].dump().size() + result["cylinder"].dump().size() <= longest_polynomials;
  if (!polynomials) {
    result["eliminant"].erase("coefficients");
    result["cylinder"] = Json();
  }
  return {{"result", std::move(result)},
          {"polynomials", polynomials},
          {"forms", forms_data(line)},
          {"phantoms", phantom_roots(line)}};
}

std::string page_of(const Json& data, const std::string& picture) {
  const std::string title = data["title"].get<std::string>();
  return report_page(title.empty() ? "exsect " + data["command"].get<std::string>() : title, data, picture);
}

}  // namespace exsect::cli
