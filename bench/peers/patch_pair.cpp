#include "patch_pair.h"

#include <algorithm>
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

Net read_net(const json& points) {
  Net net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) net[i][j][k] = number(points.at(i).at(j).at(k));
  return net;
}

/// Values of the quadratic Bernstein polynomials.
std::array<double, 3> basis(double t) { return {(1 - t) * (1 - t), 2 * t * (1 - t), t * t}; }

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

double PatchPair::size() const {
  double result = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double lowest = x[0][0][k];
    double highest = lowest;
    for (const Net* net : {&x, &y}) {
      for (const auto& row : *net) {
        for (const Point& p : row) {
          lowest = std::min(lowest, p[k]);
          highest = std::max(highest, p[k]);
        }
      }
    }
    result = std::max(result, highest - lowest);
  }
  return result;
}

std::vector<PatchPair> read_pairs(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<PatchPair> pairs;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    try {
      const json pair = json::parse(line);
      const json& patches = pair.at("patches");
      pairs.push_back({pair.at("title").get<std::string>(), read_net(patches.at(0).at("points")),
                       read_net(patches.at(1).at("points"))});
    } catch (const json::exception& error) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  return pairs;
}

Point evaluate(const Net& net, double first, double second) {
  const auto a = basis(first);
  const auto b = basis(second);
  Point result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[k] += a[i] * b[j] * net[i][j][k];
  return result;
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
