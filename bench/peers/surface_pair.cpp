#include "surface_pair.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace peers {
namespace {

using nlohmann::json;

double number(const json& value) {
  if (value.is_number()) return value.get<double>();
  const std::string text = value.get<std::string>();
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::strtod(text.c_str(), nullptr);
  return std::strtod(text.substr(0, slash).c_str(), nullptr) /
         std::strtod(text.substr(slash + 1).c_str(), nullptr);
}

Point point(const json& coordinates) {
  return {number(coordinates.at(0)), number(coordinates.at(1)), number(coordinates.at(2))};
}

Patch read_patch(const json& entry) {
  const json& rows = entry.at("points");
  Patch patch = {rows.size(), rows.at(0).size(), {}, {}};
  for (const json& row : rows)
    for (const json& p : row) patch.points.push_back(point(p));
  if (!entry.contains("weights")) return patch;
  for (const json& row : entry.at("weights"))
    for (const json& w : row) patch.weights.push_back(number(w));
  return patch;
}

RoundSurface read_round(const json& entry) {
  RoundSurface surface = {entry.at("type").get<std::string>(), {}, {0, 0, 1}, 0, 0};
  for (const char* key : {"point", "apex", "centre"})
    if (entry.contains(key)) surface.point = point(entry.at(key));
  for (const char* key : {"axis", "normal"})
    if (entry.contains(key)) surface.axis = point(entry.at(key));
  for (const char* key : {"radius", "slope", "major"})
    if (entry.contains(key)) surface.radius = number(entry.at(key));
  if (entry.contains("minor")) surface.minor = number(entry.at("minor"));
  return surface;
}

Surface read_surface(const json& entry) {
  if (entry.contains("type")) return read_round(entry);
  return read_patch(entry);
}

/// Values of the Bernstein polynomials of degree n.
std::vector<double> basis(std::size_t n, double t) {
  std::vector<double> values = {1};
  for (std::size_t degree = 1; degree <= n; ++degree) {
    values.push_back(0);
    for (std::size_t i = degree; i > 0; --i) values[i] = (1 - t) * values[i] + t * values[i - 1];
    values[0] *= 1 - t;
  }
  return values;
}

double length(const Curve& curve) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Point& a = curve[i - 1].point;
    const Point& b = curve[i].point;
    sum += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return sum;
}

/// Appends the vertices after `a` up to `b`.
void bisect(const std::function<Vertex(double)>& at, double from, const Vertex& a, double to, const Vertex& b,
            int depth, double flat, Curve& curve) {
  constexpr int least = 6;
  constexpr int most = 14;
  const double middle = (from + to) / 2;
  const Vertex m = at(middle);
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double difference = m.point[k] - (a.point[k] + b.point[k]) / 2;
    square += difference * difference;
  }
  if (depth >= least && (depth == most || square <= flat * flat)) {
    curve.push_back(b);
    return;
  }
  bisect(at, from, a, middle, m, depth + 1, flat, curve);
  bisect(at, middle, m, to, b, depth + 1, flat, curve);
}

}  // namespace

Curve sampled(const std::function<Vertex(double)>& at, double from, double to, double flat) {
  Curve result = {at(from)};
  const Vertex first = result.front();
  bisect(at, from, first, to, at(to), 0, flat, result);
  return result;
}

double SurfacePair::size() const {
  std::vector<Point> points;
  for (const Surface* surface : {&x, &y})
    if (const auto* patch = std::get_if<Patch>(surface))
      points.insert(points.end(), patch->points.begin(), patch->points.end());
  if (points.empty()) return 4;
  double result = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [lowest, highest] = std::minmax_element(
        points.begin(), points.end(), [k](const Point& a, const Point& b) { return a[k] < b[k]; });
    result = std::max(result, (*highest)[k] - (*lowest)[k]);
  }
  return result;
}

namespace {

const Patch& patch_of(const Surface& surface, const std::string& pair) {
  const auto* patch = std::get_if<Patch>(&surface);
  if (patch == nullptr) throw std::runtime_error(pair + ": only patches are taken here");
  return *patch;
}

}  // namespace

const Patch& SurfacePair::first_patch() const { return patch_of(x, name); }
const Patch& SurfacePair::second_patch() const { return patch_of(y, name); }

std::vector<SurfacePair> read_pairs(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<SurfacePair> pairs;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    try {
      const json pair = json::parse(line);
      const json& patches = pair.at("patches");
      pairs.push_back(
          {pair.at("title").get<std::string>(), read_surface(patches.at(0)), read_surface(patches.at(1))});
    } catch (const json::exception& error) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  return pairs;
}

Row parameter_line(const Patch& patch, double first) {
  const std::vector<double> a = basis(patch.rows - 1, first);
  Row row;
  for (std::size_t j = 0; j < patch.columns; ++j) {
    Point sum{};
    double weight = 0;
    for (std::size_t i = 0; i < patch.rows; ++i) {
      const std::size_t at = patch.index(i, j);
      const double w = a[i] * (patch.weights.empty() ? 1 : patch.weights[at]);
      weight += w;
      for (std::size_t k = 0; k < 3; ++k) sum[k] += w * patch.points[at][k];
    }
    if (!patch.weights.empty()) {
      for (double& c : sum) c /= weight;
      row.weights.push_back(weight);
    }
    row.points.push_back(sum);
  }
  return row;
}

Point evaluate(const Patch& patch, double first, double second) {
  const Row row = parameter_line(patch, first);
  return parameter_line({patch.columns, 1, row.points, row.weights}, second).points.front();
}

nlohmann::ordered_json to_json(const Answer& answer) {
  nlohmann::ordered_json result;
  result["curves"] = nlohmann::ordered_json::array();
  for (const Curve& curve : answer.curves) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    nlohmann::ordered_json first = points;
    nlohmann::ordered_json second = points;
    for (const Vertex& v : curve) {
      points.push_back(v.point);
      first.push_back({v.parameters[0], v.parameters[1]});
      second.push_back({v.parameters[2], v.parameters[3]});
    }
    result["curves"].push_back({{"points", points}, {"first", first}, {"second", second}});
  }
  double whole = 0;
  for (const Curve& curve : answer.curves) whole += length(curve);
  result["length"] = whole;
  result["points"] = nlohmann::ordered_json::array();
  for (const Vertex& v : answer.points) {
    nlohmann::ordered_json& point = result["points"].emplace_back();
    point["point"] = v.point;
    if (std::isnan(v.parameters[0])) continue;
    point["first"] = {v.parameters[0], v.parameters[1]};
    point["second"] = {v.parameters[2], v.parameters[3]};
  }
  return result;
}

}  // namespace peers
