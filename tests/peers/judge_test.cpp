// Answers with known faults against intersections known by hand.
#include "judge.h"

#include <cmath>
#include <functional>

#include "support/catch.h"

using namespace peers;

namespace {

Net net_of(const std::function<Point(std::size_t, std::size_t)>& point) {
  Net net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = point(i, j);
  return net;
}

double half(std::size_t i) { return static_cast<double>(i) / 2; }

/// (u, v, 0) and (1/2, r, s - 1/2): the segment u = s = 1/2, v = r.
PatchPair crossing_squares() {
  return {"test/0", net_of([](std::size_t i, std::size_t j) {
            return Point{half(i), half(j), 0};
          }),
          net_of([](std::size_t i, std::size_t j) {
            return Point{0.5, half(i), half(j) - 0.5};
          })};
}

/// ((2u-1)^2, v, 0) and (1/4, r, s - 1/2): two arcs, u = 1/4 and u = 3/4, over one segment.
PatchPair double_cover() {
  const std::array<double, 3> square = {1, -1, 1};  // (2u-1)^2 in Bernstein form
  return {"test/1", net_of([&](std::size_t i, std::size_t j) {
            return Point{square[i], half(j), 0};
          }),
          net_of([](std::size_t i, std::size_t j) {
            return Point{0.25, half(i), half(j) - 0.5};
          })};
}

/// The curve u = const from v = `from` to v = `to`.
Curve line(double u, double x, double from, double to) {
  Curve result;
  for (int i = 0; i <= 100; ++i) {
    const double v = from + (to - from) * i / 100;
    result.push_back({{x, v, 0}, {u, v, v, 0.5}});
  }
  return result;
}

Reference one_segment() { return {true, {{"open", {line(0.5, 0.5, 0, 1)}}}, {}, {}}; }

Reference two_arcs() {
  return {true, {{"open", {line(0.25, 0.25, 0, 1)}}, {"open", {line(0.75, 0.25, 0, 1)}}}, {}, {}};
}

Curve moved(Curve curve, double by) {
  for (Vertex& v : curve) v.point[2] += by;
  return curve;
}

}  // namespace

TEST_CASE("the truth in pieces is right") {
  const Verdict v =
      judge(crossing_squares(), one_segment(), {{line(0.5, 0.5, 1, 0.4), line(0.5, 0.5, 0, 0.4)}, {}});
  CHECK(v.right());
  CHECK(v.found == 1);
  CHECK(v.residual < 1e-15);
  CHECK(v.distance < 1e-15);
}

TEST_CASE("nothing, half of a curve, and a point in its place") {
  const Verdict nothing = judge(crossing_squares(), one_segment(), {});
  CHECK(nothing.lost == 1);
  CHECK(nothing.as_points == 0);
  CHECK_FALSE(nothing.right());
  const Verdict part = judge(crossing_squares(), one_segment(), {{line(0.5, 0.5, 0, 0.5)}, {}});
  CHECK(part.partly == 1);
  const Verdict point =
      judge(crossing_squares(), one_segment(), {{}, {{{0.5, 0.3, 0}, {0.5, 0.3, 0.3, 0.5}}}});
  CHECK(point.lost == 1);
  CHECK(point.as_points == 1);
  CHECK(point.invented_points == 0);
}

TEST_CASE("invented curves and points") {
  const Verdict v = judge(crossing_squares(), one_segment(),
                          {{line(0.5, 0.5, 0, 1), line(0.7, 0.7, 0, 1)}, {{{0, 0, 0}, {0, 0, 0, 0.5}}}});
  CHECK(v.found == 1);
  CHECK(v.invented_curves == 1);
  CHECK(v.invented_points == 1);
}

TEST_CASE("distances are those of the vertices") {
  const Verdict v = judge(crossing_squares(), one_segment(), {{moved(line(0.5, 0.5, 0, 1), 1e-7)}, {}});
  CHECK(v.right());
  CHECK(v.distance == Approx(1e-7).epsilon(1e-6));
}

TEST_CASE("arcs over one segment are told apart") {
  const PatchPair pair = double_cover();
  const Verdict one = judge(pair, two_arcs(), {{line(0.25, 0.25, 0, 1)}, {}});
  CHECK(one.found == 1);
  CHECK(one.lost == 1);
  Curve jump = line(0.25, 0.25, 0, 0.5);
  const Curve rest = line(0.75, 0.25, 0.5, 1);
  jump.insert(jump.end(), rest.begin(), rest.end());
  const Verdict wrong = judge(pair, two_arcs(), {{jump}, {}});
  CHECK(wrong.partly == 2);
  CHECK(wrong.wrong_connections == 1);
}

TEST_CASE("a closed curve with a chord across is partly found") {
  // z = 1/16 - (u - 1/2)^2 - (v - 1/2)^2 and the plane z = 0: a circle of radius 1/4.
  const std::array<double, 3> square = {0.25, -0.25, 0.25};  // (u - 1/2)^2 in Bernstein form
  const PatchPair pair = {"test/2", net_of([&](std::size_t i, std::size_t j) {
                            return Point{half(i), half(j), 0.0625 - square[i] - square[j]};
                          }),
                          net_of([](std::size_t i, std::size_t j) {
                            return Point{half(i), half(j), 0};
                          })};
  const auto circle = [](double from, double to) {
    Curve result;
    for (int i = 0; i <= 400; ++i) {
      const double t = 6.283185307179586 * (from + (to - from) * i / 400);
      const double u = 0.5 + std::cos(t) / 4;
      const double v = 0.5 + std::sin(t) / 4;
      result.push_back({{u, v, 0}, {u, v, u, v}});
    }
    return result;
  };
  const Reference reference = {true, {{"closed", {circle(0, 1)}}}, {}, {}};
  CHECK(judge(pair, reference, {{circle(0.2, 1.2)}, {}}).right());
  Curve cut = circle(0, 0.25);
  const Curve rest = circle(0.5, 1);
  cut.insert(cut.end(), rest.begin(), rest.end());
  const Verdict v = judge(pair, reference, {{cut}, {}});
  CHECK(v.partly == 1);
  CHECK(v.wrong_connections == 0);  // a chord as long as the curve it replaces is a gap
}

TEST_CASE("points of lines are matched one to one") {
  const LineVerdict v = judge_lines({{{0.1, 0.2, 0.3}, {0.5, 0.5, 0.5}}, {}},
                                    {{{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}}, {{0.9, 0.9, 0.9}}});
  CHECK(v.points == 2);
  CHECK(v.lost == 1);
  CHECK(v.invented == 2);
}
