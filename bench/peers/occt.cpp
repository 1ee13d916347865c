// Open CASCADE on pairs of patches and of round surfaces: --method surfaces (GeomAPI_IntSS) or section
// (BRepAlgoAPI_Section); with
// --lines GeomAPI_IntCS intersects parameter lines with the second patch.
#include <BRepAlgoAPI_Section.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_IntCS.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomInt_IntSS.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Standard_Failure.hxx>
#include <Standard_NoSuchObject.hxx>
#include <Standard_Version.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "harness.h"

namespace peers {
namespace {

constexpr double flatness = 2e-5;  // of polylines, relative to the size of the pair
constexpr double face_tolerance = 1e-7;

gp_Pnt to_point(const Point& p) { return {p[0], p[1], p[2]}; }

Handle(Geom_Surface) surface(const Patch& patch) {
  const auto rows = static_cast<int>(patch.rows), columns = static_cast<int>(patch.columns);
  TColgp_Array2OfPnt points(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const std::size_t at = patch.index(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      points.SetValue(i + 1, j + 1, to_point(patch.points[at]));
      weights.SetValue(i + 1, j + 1, patch.weights.empty() ? 1 : patch.weights[at]);
    }
  if (patch.weights.empty()) return new Geom_BezierSurface(points);
  return new Geom_BezierSurface(points, weights);
}

/// Unbounded ones are cut off at a distance that the intersections of the families do not reach, because
/// faces and marching need bounds.
Handle(Geom_Surface) surface(const RoundSurface& round) {
  const gp_Ax3 axes(to_point(round.point), gp_Dir(round.axis[0], round.axis[1], round.axis[2]));
  const double far = 16, turn = 2 * M_PI;
  if (round.type == "sphere") return new Geom_SphericalSurface(axes, round.radius);
  if (round.type == "torus") return new Geom_ToroidalSurface(axes, round.radius, round.minor);
  if (round.type == "plane")
    return new Geom_RectangularTrimmedSurface(new Geom_Plane(axes), -far, far, -far, far);
  if (round.type == "cylinder")
    return new Geom_RectangularTrimmedSurface(new Geom_CylindricalSurface(axes, round.radius), 0, turn, -far,
                                              far);
  return new Geom_RectangularTrimmedSurface(new Geom_ConicalSurface(axes, std::atan(round.radius), 0), 0,
                                            turn, 0, far);
}

Handle(Geom_Surface) surface(const Surface& either) {
  return std::visit([](const auto& one) { return surface(one); }, either);
}

/// A curve with its images in both parameter squares, all over [from,to].
struct Traced {
  Handle(Geom_Curve) space;
  Handle(Geom2d_Curve) first;
  Handle(Geom2d_Curve) second;
  double from;
  double to;
};

Curve sampled(const Traced& curve, double flat) {
  const auto at = [&](double t) {
    const gp_Pnt p = curve.space->Value(t);
    const gp_Pnt2d a = curve.first->Value(t);
    const gp_Pnt2d b = curve.second->Value(t);
    return Vertex{{p.X(), p.Y(), p.Z()}, {a.X(), a.Y(), b.X(), b.Y()}};
  };
  return peers::sampled(at, curve.from, curve.to, flat);
}

/// With the bound that Open CASCADE claims for the curves.
nlohmann::ordered_json with_bound(const Answer& answer, double bound) {
  nlohmann::ordered_json result = to_json(answer);
  result["bound"] = bound;
  return result;
}

/// The same intersection as in GeomAPI_IntSS, which keeps points and parameters to itself.
nlohmann::ordered_json surfaces_answer(const SurfacePair& pair, double tolerance) {
  GeomInt_IntSS intersection;
  intersection.Perform(surface(pair.x), surface(pair.y), tolerance, Standard_True, Standard_True,
                       Standard_True);
  if (!intersection.IsDone()) throw std::runtime_error("GeomInt_IntSS is not done");
  Answer answer;
  for (int i = 1; i <= intersection.NbLines(); ++i) {
    if (!intersection.HasLineOnS1(i) || !intersection.HasLineOnS2(i)) continue;
    const Handle(Geom_Curve)& line = intersection.Line(i);
    answer.curves.push_back(sampled({line, intersection.LineOnS1(i), intersection.LineOnS2(i),
                                     line->FirstParameter(), line->LastParameter()},
                                    flatness * pair.size()));
  }
  for (int i = 1; i <= intersection.NbPoints(); ++i) {
    const gp_Pnt p = intersection.Point(i);
    const gp_Pnt2d a = intersection.Pnt2d(i, Standard_True);
    const gp_Pnt2d b = intersection.Pnt2d(i, Standard_False);
    answer.points.push_back({{p.X(), p.Y(), p.Z()}, {a.X(), a.Y(), b.X(), b.Y()}});
  }
  return with_bound(answer, intersection.TolReached3d());
}

TopoDS_Face face(const Surface& one) { return BRepBuilderAPI_MakeFace(surface(one), face_tolerance).Face(); }

/// Two faces and their section.
struct Section {
  TopoDS_Face x;
  TopoDS_Face y;
  std::unique_ptr<BRepAlgoAPI_Section> section;
};

void build(BRepAlgoAPI_Section& section) {
  section.ComputePCurveOn1(Standard_True);
  section.ComputePCurveOn2(Standard_True);
  section.Approximation(Standard_True);
  section.Build();
  if (!section.IsDone()) throw std::runtime_error("BRepAlgoAPI_Section is not done");
}

/// Not numbers where the vertex does not say.
std::array<double, 4> parameters(const TopoDS_Vertex& point, const TopoDS_Face& x, const TopoDS_Face& y) {
  try {
    const gp_Pnt2d a = BRep_Tool::Parameters(point, x);
    const gp_Pnt2d b = BRep_Tool::Parameters(point, y);
    return {a.X(), a.Y(), b.X(), b.Y()};
  } catch (const Standard_NoSuchObject&) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none};
  }
}

nlohmann::ordered_json section_answer(const Section& found, double flat) {
  const TopoDS_Face& x = found.x;
  const TopoDS_Face& y = found.y;
  Answer answer;
  double bound = 0;
  for (TopExp_Explorer edges(found.section->Shape(), TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    Traced curve{};
    curve.space = BRep_Tool::Curve(edge, curve.from, curve.to);
    double from = 0;
    double to = 0;
    curve.first = BRep_Tool::CurveOnSurface(edge, x, from, to);
    curve.second = BRep_Tool::CurveOnSurface(edge, y, from, to);
    if (curve.space.IsNull() || curve.first.IsNull() || curve.second.IsNull()) continue;
    answer.curves.push_back(sampled(curve, flat));
    bound = std::max(bound, BRep_Tool::Tolerance(edge));
  }
  for (TopExp_Explorer points(found.section->Shape(), TopAbs_VERTEX, TopAbs_EDGE); points.More();
       points.Next()) {
    const TopoDS_Vertex point = TopoDS::Vertex(points.Current());
    const gp_Pnt p = BRep_Tool::Pnt(point);
    answer.points.push_back({{p.X(), p.Y(), p.Z()}, parameters(point, x, y)});
  }
  return with_bound(answer, bound);
}

Handle(Geom_BezierCurve) parameter_curve(const Patch& patch, double u) {
  const Row row = parameter_line(patch, u);
  const auto count = static_cast<int>(row.points.size());
  TColgp_Array1OfPnt points(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int j = 0; j < count; ++j) {
    points.SetValue(j + 1, to_point(row.points[static_cast<std::size_t>(j)]));
    weights.SetValue(j + 1, row.weights.empty() ? 1 : row.weights[static_cast<std::size_t>(j)]);
  }
  if (row.weights.empty()) return new Geom_BezierCurve(points);
  return new Geom_BezierCurve(points, weights);
}

/// Triples (v,r,s) of each line.
std::vector<std::vector<Point>> line_points(const SurfacePair& pair) {
  std::vector<std::vector<Point>> result;
  const Handle(Geom_Surface) y = surface(pair.second_patch());
  for (int k = 1; k <= line_queries; ++k) {
    const GeomAPI_IntCS intersection(parameter_curve(pair.first_patch(), line_parameter(k)), y);
    if (!intersection.IsDone()) throw std::runtime_error("GeomAPI_IntCS is not done");
    std::vector<Point> points;
    for (int i = 1; i <= intersection.NbPoints(); ++i) {
      Point p{};
      intersection.Parameters(i, p[1], p[2], p[0]);
      points.push_back(p);
    }
    result.push_back(std::move(points));
  }
  return result;
}

/// Open CASCADE's exceptions are not derived from std::exception.
template <class Work>
auto translated(Work work) {
  return [work] {
    try {
      return work();
    } catch (const Standard_Failure& failure) {
      throw std::runtime_error(failure.DynamicType()->Name());
    }
  };
}

Task task(const SurfacePair& pair, const Settings& settings) {
  const double tolerance = settings.tolerance * pair.size();
  if (settings.lines) {
    return {translated([=] { line_points(pair); }), translated([=] {
              return nlohmann::ordered_json{{"lines", line_points(pair)}};
            })};
  }
  if (settings.method == "section") {
    const auto state = std::make_shared<Section>();
    return {translated([=] {
              state->x = face(pair.x);
              state->y = face(pair.y);
              state->section = std::make_unique<BRepAlgoAPI_Section>(state->x, state->y, Standard_False);
              build(*state->section);
            }),
            translated([=] { return section_answer(*state, flatness * pair.size()); })};
  }
  return {translated([=] {
            const GeomAPI_IntSS intersection(surface(pair.x), surface(pair.y), tolerance);
            if (!intersection.IsDone()) throw std::runtime_error("GeomAPI_IntSS is not done");
          }),
          translated([=] { return surfaces_answer(pair, tolerance); })};
}

}  // namespace
}  // namespace peers

int main(int argc, char** argv) {
  return peers::run(
      argc, argv,
      [](const peers::Settings& settings) {
        const std::string name = "Open CASCADE " OCC_VERSION_COMPLETE " ";
        if (settings.lines) return name + "GeomAPI_IntCS";
        return name + (settings.method == "section" ? "BRepAlgoAPI_Section" : "GeomAPI_IntSS");
      },
      peers::task);
}
