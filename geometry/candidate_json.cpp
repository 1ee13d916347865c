#include "candidate_json.h"

#include <cmath>

#include "json_value.h"
#include "number.h"

namespace exsect {
namespace {

constexpr const char* candidate_version = "candidate/1";

double read_double(const JsonValue& value) { return to_double(read_number(value, parse_binary64)); }

/// A point of the given dimension; parameters have to be in [-1,2].
std::array<double, 3> read_vertex(const JsonValue& value, std::size_t dimension) {
  value.require_size(dimension, "coordinates");
  std::array<double, 3> point = {0, 0, 0};
  for (std::size_t k = 0; k < dimension; ++k) {
    point[k] = read_double(value.at(k));
    if (!(std::fabs(point[k]) <= max_candidate_number)) value.at(k).fail("a coordinate is beyond 2^500");
    if (dimension == 2 && !(point[k] >= -1 && point[k] <= 2))
      value.at(k).fail("a parameter must be in [-1,2]");
  }
  return point;
}

std::vector<std::array<double, 3>> read_vertices(const JsonValue& values, std::size_t dimension) {
  std::vector<std::array<double, 3>> result;
  for (std::size_t i = 0; i < values.size(); ++i) result.push_back(read_vertex(values.at(i), dimension));
  return result;
}

std::vector<double> read_doubles(const JsonValue& values) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i) result.push_back(read_double(values.at(i)));
  return result;
}

/// A list of vertices, or {"degree", "knots", "points", "weights"}.
SplineCurve read_spline(const JsonValue& value, std::size_t dimension) {
  if (value.is_array()) {
    std::vector<std::array<double, 3>> vertices = read_vertices(value, dimension);
    if (vertices.size() < 2) value.fail("a polyline must have at least 2 vertices");
    return polyline(std::move(vertices));
  }
  value.require_object({"degree", "knots", "points", "weights"});
  SplineCurve curve;
  curve.degree = value.member("degree").small_integer(1, max_spline_degree, "the degree of a curve");
  curve.knots = read_doubles(value.member("knots"));
  curve.points = read_vertices(value.member("points"), dimension);
  if (value.has("weights")) curve.weights = read_doubles(value.member("weights"));
  const std::string wrong = violation(curve);
  if (!wrong.empty()) value.fail(wrong);
  return curve;
}

bool read_flag(const JsonValue& value, const char* yes, const char* no) {
  if (value.string() == yes) return true;
  if (value.string() == no) return false;
  value.fail("must be \"" + std::string(yes) + "\" or \"" + no + "\"");
}

CandidateCurve read_curve(const JsonValue& value) {
  value.require_object({"points", "first", "second", "closed", "contact"});
  CandidateCurve curve;
  if (value.has("points")) curve.space = read_spline(value.member("points"), 3);
  if (value.has("first")) curve.first = read_spline(value.member("first"), 2);
  if (value.has("second")) curve.second = read_spline(value.member("second"), 2);
  std::size_t vertices = 0;
  for (const auto* line : {&curve.space, &curve.first, &curve.second}) {
    if (!*line || (*line)->degree != 1 || !(*line)->weights.empty()) continue;
    if (vertices != 0 && vertices != (*line)->points.size())
      value.fail("the lists of vertices must have the same length");
    vertices = (*line)->points.size();
  }
  if (!curve.space && !curve.first && !curve.second)
    value.fail("one of \"points\", \"first\", \"second\" must be there");
  if (value.has("closed")) curve.closed = value.member("closed").boolean();
  if (value.has("contact"))
    curve.tangential = read_flag(value.member("contact"), "tangential", "transversal");
  return curve;
}

std::array<double, 2> read_pair(const JsonValue& value) {
  const auto point = read_vertex(value, 2);
  return {point[0], point[1]};
}

CandidatePoint read_candidate_point(const JsonValue& value) {
  value.require_object({"point", "first", "second"});
  CandidatePoint point;
  if (value.has("point")) point.point = read_vertex(value.member("point"), 3);
  if (value.has("first")) point.first = read_pair(value.member("first"));
  if (value.has("second")) point.second = read_pair(value.member("second"));
  if (!point.point && !point.first && !point.second)
    value.fail("one of \"point\", \"first\", \"second\" must be there");
  return point;
}

}  // namespace

Candidate parse_json_candidate(const std::string& text, const std::string& filename) {
  const JsonTree tree = parse_json(text, filename, max_depth_of_files);
  const JsonValue root(tree, filename, "$");
  root.require_form(candidate_version);
  root.require_object({"exsect", "patches", "source", "curves", "points"});
  Candidate candidate;
  const JsonValue patches = root.member("patches");
  patches.require_size(2, "names");
  for (std::size_t i = 0; i < 2; ++i) {
    candidate.patches[i] = patches.at(i).string();
    if (candidate.patches[i].empty()) patches.at(i).fail("must not be empty");
  }
  if (root.has("source")) candidate.source = root.member("source").string();
  const JsonValue curves = root.member("curves");
  for (std::size_t i = 0; i < curves.size(); ++i) candidate.curves.push_back(read_curve(curves.at(i)));
  if (!root.has("points")) return candidate;
  const JsonValue points = root.member("points");
  for (std::size_t i = 0; i < points.size(); ++i)
    candidate.points.push_back(read_candidate_point(points.at(i)));
  return candidate;
}

}  // namespace exsect
