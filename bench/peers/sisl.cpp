// SISL on pairs of patches, with weights or without: s1859 finds points and guide points of the curves, s1310
// marches along each curve. With --lines s1858 intersects parameter lines with the second patch.
#include <sisl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "harness.h"

namespace peers {
namespace {

constexpr double flatness = 2e-5;  // of polylines, relative to the size of the pair

std::vector<double> bezier_knots(std::size_t order) {
  std::vector<double> knots(2 * order, 0);
  std::fill(knots.begin() + static_cast<std::ptrdiff_t>(order), knots.end(), 1);
  return knots;
}

/// The point, with weights times its weight and followed by it.
void append(std::vector<double>& coefficients, const Point& p, const std::vector<double>& weights,
            std::size_t at) {
  const double weight = weights.empty() ? 1 : weights[at];
  for (const double c : p) coefficients.push_back(weight * c);
  if (!weights.empty()) coefficients.push_back(weight);
}

/// SISL's kinds of B-splines.
int kind(const std::vector<double>& weights) { return weights.empty() ? 1 : 2; }

class SislSurface {
 public:
  explicit SislSurface(const Patch& patch) {
    std::vector<double> points;  // the first parameter runs fastest
    for (std::size_t j = 0; j < patch.columns; ++j)
      for (std::size_t i = 0; i < patch.rows; ++i)
        append(points, patch.points[patch.index(i, j)], patch.weights, patch.index(i, j));
    const auto m = static_cast<int>(patch.rows);
    const auto n = static_cast<int>(patch.columns);
    auto first = bezier_knots(patch.rows);
    auto second = bezier_knots(patch.columns);
    surface_ = newSurf(m, n, m, n, first.data(), second.data(), points.data(), kind(patch.weights), 3, 1);
    if (surface_ == nullptr) throw std::runtime_error("newSurf");
  }
  SislSurface(const SislSurface&) = delete;
  SislSurface& operator=(const SislSurface&) = delete;
  ~SislSurface() { freeSurf(surface_); }
  SISLSurf* get() const { return surface_; }

 private:
  SISLSurf* surface_;
};

/// Points and curves as SISL returns them.
struct Found {
  int point_count = 0;
  double* first = nullptr;
  double* second = nullptr;
  int curve_count = 0;
  SISLIntcurve** curves = nullptr;

  Found() = default;
  Found(const Found&) = delete;
  Found& operator=(const Found&) = delete;
  ~Found() {
    free(first);
    free(second);
    if (curves != nullptr) freeIntcrvlist(curves, curve_count);
  }
};

void check(int status, const char* routine) {
  if (status < 0) throw std::runtime_error(std::string(routine) + " returns " + std::to_string(status));
}

/// Positions and curves in both parameter squares of each curve; where the marching fails the guide points
/// remain.
void intersect(const SislSurface& x, const SislSurface& y, double tolerance, Found& found) {
  int status = 0;
  s1859(x.get(), y.get(), 0, tolerance, &found.point_count, &found.first, &found.second, &found.curve_count,
        &found.curves, &status);
  check(status, "s1859");
  for (int i = 0; i < found.curve_count; ++i) {
    s1310(x.get(), y.get(), found.curves[i], tolerance, 0, 2, 0, &status);
  }
}

Point value(SISLCurve* curve, double t) {
  Point result{};
  int left = 0;
  int status = 0;
  s1227(curve, 0, t, &left, result.data(), &status);
  check(status, "s1227");
  return result;
}

Curve guide_points(const SISLIntcurve& curve, const Patch& x) {
  Curve result;
  for (int i = 0; i < curve.ipoint; ++i) {
    const double* a = curve.epar1 + 2 * static_cast<std::ptrdiff_t>(i);
    const double* b = curve.epar2 + 2 * static_cast<std::ptrdiff_t>(i);
    result.push_back({evaluate(x, a[0], a[1]), {a[0], a[1], b[0], b[1]}});
  }
  return result;
}

Curve sampled(const SISLIntcurve& curve, const Patch& x, double flat) {
  if (curve.pgeom == nullptr || curve.ppar1 == nullptr || curve.ppar2 == nullptr)
    return guide_points(curve, x);
  const SISLCurve& space = *curve.pgeom;
  const auto at = [&](double t) {
    const Point a = value(curve.ppar1, t);
    const Point b = value(curve.ppar2, t);
    return Vertex{value(curve.pgeom, t), {a[0], a[1], b[0], b[1]}};
  };
  return peers::sampled(at, space.et[space.ik - 1], space.et[space.in], flat);
}

nlohmann::ordered_json answer(const SurfacePair& pair, const Found& found) {
  Answer result;
  for (int i = 0; i < found.curve_count; ++i)
    result.curves.push_back(sampled(*found.curves[i], pair.first_patch(), flatness * pair.size()));
  for (int i = 0; i < found.point_count; ++i) {
    const double* a = found.first + 2 * static_cast<std::ptrdiff_t>(i);
    const double* b = found.second + 2 * static_cast<std::ptrdiff_t>(i);
    result.points.push_back({evaluate(pair.first_patch(), a[0], a[1]), {a[0], a[1], b[0], b[1]}});
  }
  return to_json(result);
}

SISLCurve* parameter_curve(const Patch& patch, double u) {
  const Row row = parameter_line(patch, u);
  std::vector<double> points;
  for (std::size_t j = 0; j < row.points.size(); ++j) append(points, row.points[j], row.weights, j);
  const auto order = static_cast<int>(row.points.size());
  auto knots = bezier_knots(row.points.size());
  return newCurve(order, order, knots.data(), points.data(), kind(row.weights), 3, 1);
}

/// Triples (v,r,s) of each line.
std::vector<std::vector<Point>> line_points(const SurfacePair& pair, double tolerance) {
  std::vector<std::vector<Point>> result;
  const SislSurface y(pair.second_patch());
  for (int k = 1; k <= line_queries; ++k) {
    Found found;
    int status = 0;
    SISLCurve* line = parameter_curve(pair.first_patch(), line_parameter(k));
    s1858(y.get(), line, 0, tolerance, &found.point_count, &found.first, &found.second, &found.curve_count,
          &found.curves, &status);
    freeCurve(line);
    check(status, "s1858");
    std::vector<Point> points;
    for (int i = 0; i < found.point_count; ++i) {
      points.push_back({found.second[i], found.first[2 * i], found.first[2 * i + 1]});
    }
    result.push_back(std::move(points));
  }
  return result;
}

Task task(const SurfacePair& pair, const Settings& settings) {
  const double tolerance = settings.tolerance * pair.size();
  if (settings.lines) {
    return {[=] { line_points(pair, tolerance); },
            [=] {
              return nlohmann::ordered_json{{"lines", line_points(pair, tolerance)}};
            }};
  }
  // Destroyed in the opposite order: curves refer to the surfaces.
  struct State {
    std::optional<SislSurface> x;
    std::optional<SislSurface> y;
    std::optional<Found> found;
  };
  const auto state = std::make_shared<State>();
  return {[=] {
            state->found.emplace();
            state->x.emplace(pair.first_patch());
            state->y.emplace(pair.second_patch());
            intersect(*state->x, *state->y, tolerance, *state->found);
          },
          [=] { return answer(pair, *state->found); }};
}

}  // namespace
}  // namespace peers

int main(int argc, char** argv) {
  return peers::run(
      argc, argv,
      [](const peers::Settings& settings) {
        const std::string tolerance = settings.tolerance < 1e-8 ? "1e-9" : "1e-6";
        return settings.lines ? "SISL 4.6.0 s1858 " + tolerance : "SISL 4.6.0 s1859+s1310 " + tolerance;
      },
      peers::task);
}
