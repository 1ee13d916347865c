#include "trace/arc_polyline.h"

#include "support/catch.h"

namespace exsect::arc_polyline_test {

TEST_CASE("arc polyline: chords of a parabola are as far away as the bound says", "[trace]") {
  // x = t^2 + t, |x''| = 2, over [1, -3]: a chord over a step h is h^2 / 4 away in its middle.
  const auto vertex_at = [](double t) {
    BoundedVertex v{};
    v.vertex.parameters[0] = t;
    return v;
  };
  for (const double tolerance : {16.0, 1.0, 0x1p-8, 0x1p-20}) {
    ArcPolyline line;
    line.add_vertex(vertex_at(1));
    line.add_chords(2, 1, -3, tolerance, vertex_at);
    line.add_vertex(vertex_at(-3));
    const double bound = line.bound();
    CHECK(bound <= tolerance);
    const auto vertices = line.take_vertices();
    double widest = 0;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const double step = vertices[i - 1].parameters[0] - vertices[i].parameters[0];
      CHECK(step > 0);
      widest = std::max(widest, step);
    }
    CHECK(widest * widest / 4 <= bound);
    CHECK(widest * widest / 4 > bound / 4);  // no more chords than are needed, about
  }
}

TEST_CASE("arc polyline: the bound counts chords, what they cover, and both ends of errors", "[trace]") {
  ArcPolyline line;
  CHECK(line.bound() == 0);
  line.add_vertex({{}, 0.25});
  CHECK(line.bound() == Approx(0.5));
  line.cover(2);
  line.cover(1);
  CHECK(line.bound() == Approx(2.5));
  CHECK(line.size() == 1);
}

}  // namespace exsect::arc_polyline_test
