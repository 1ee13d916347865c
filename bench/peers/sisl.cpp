// SISL on pairs of patches: s1859 finds points and guide points of the curves, s1310 marches along each
// curve. With --lines s1858 intersects parameter lines with the second patch.
#include <sisl.h>

#include <memory>
#include <optional>
#include <stdexcept>

#include "harness.h"

namespace peers {
namespace {

constexpr double flatness = 2e-5;  // of polylines, relative to the size of the pair

std::array<double, 6> bezier_knots() { return {0, 0, 0, 1, 1, 1}; }

class Surface {
 public:
  explicit Surface(const Net& net) {
    std::vector<double> points;  // the first parameter runs fastest
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) points.insert(points.end(), net[i][j].begin(), net[i][j].end());
    auto first = bezier_knots();
    auto second = bezier_knots();
    surface_ = newSurf(3, 3, 3, 3, first.data(), second.data(), points.data(), 1, 3, 1);
    if (surface_ == nullptr) throw std::runtime_error("newSurf");
  }
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;
  ~Surface() { freeSurf(surface_); }
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
void intersect(const Surface& x, const Surface& y, double tolerance, Found& found) {
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

Curve guide_points(const SISLIntcurve& curve, const Net& x) {
  Curve result;
  for (int i = 0; i < curve.ipoint; ++i) {
    const double* a = curve.epar1 + 2 * static_cast<std::ptrdiff_t>(i);
    const double* b = curve.epar2 + 2 * static_cast<std::ptrdiff_t>(i);
    result.push_back({evaluate(x, a[0], a[1]), {a[0], a[1], b[0], b[1]}});
  }
  return result;
}

Curve sampled(const SISLIntcurve& curve, const Net& x, double flat) {
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

nlohmann::ordered_json answer(const PatchPair& pair, const Found& found) {
  Answer result;
  for (int i = 0; i < found.curve_count; ++i)
    result.curves.push_back(sampled(*found.curves[i], pair.x, flatness * pair.size()));
  for (int i = 0; i < found.point_count; ++i) {
    const double* a = found.first + 2 * static_cast<std::ptrdiff_t>(i);
    const double* b = found.second + 2 * static_cast<std::ptrdiff_t>(i);
    result.points.push_back({evaluate(pair.x, a[0], a[1]), {a[0], a[1], b[0], b[1]}});
  }
  return to_json(result);
}

SISLCurve* parameter_line(const Net& net, double u) {
  std::vector<double> points;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 3; ++k) {
      points.push_back((1 - u) * (1 - u) * net[0][j][k] + 2 * u * (1 - u) * net[1][j][k] +
                       u * u * net[2][j][k]);
    }
  }
  auto knots = bezier_knots();
  return newCurve(3, 3, knots.data(), points.data(), 1, 3, 1);
}

/// Triples (v,r,s) of each line.
std::vector<std::vector<Point>> line_points(const PatchPair& pair, double tolerance) {
  std::vector<std::vector<Point>> result;
  const Surface y(pair.y);
  for (int k = 1; k <= line_queries; ++k) {
    Found found;
    int status = 0;
    SISLCurve* line = parameter_line(pair.x, line_parameter(k));
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

Task task(const PatchPair& pair, const Settings& settings) {
  const double tolerance = settings.tolerance * pair.size();
  if (settings.lines) {
    return {[=] { line_points(pair, tolerance); },
            [=] {
              return nlohmann::ordered_json{{"lines", line_points(pair, tolerance)}};
            }};
  }
  // Destroyed in the opposite order: curves refer to the surfaces.
  struct State {
    std::optional<Surface> x;
    std::optional<Surface> y;
    std::optional<Found> found;
  };
  const auto state = std::make_shared<State>();
  return {[=] {
            state->found.emplace();
            state->x.emplace(pair.x);
            state->y.emplace(pair.y);
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
