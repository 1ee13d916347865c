// Contact along parameter lines: the line and its path, the proof around it, and where it has to fail.
#include "filter/contact_line.h"

#include <cmath>

#include "filter/pieces.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::filter::contact_line_test {
namespace {

using K = WeightedBicubic;

/// The graph over the unit square of a function of (u,v) of bidegree (3,3), by its values at thirds.
template <class Function>
RationalPatch graph(const Function& f) {
  const auto control = [](const std::array<Rational, 4>& values) -> std::array<Rational, 4> {
    return {values[0], (-5 * values[0] + 18 * values[1] - 9 * values[2] + 2 * values[3]) / 6,
            (2 * values[0] - 9 * values[1] + 18 * values[2] - 5 * values[3]) / 6, values[3]};
  };
  std::array<std::array<Rational, 4>, 4> rows;
  for (int i = 0; i < 4; ++i) {
    std::array<Rational, 4> values;
    for (int j = 0; j < 4; ++j) values[static_cast<std::size_t>(j)] = f(Rational(i, 3), Rational(j, 3));
    rows[static_cast<std::size_t>(i)] = control(values);
  }
  std::vector<std::vector<Point>> net(4, std::vector<Point>(4));
  for (std::size_t j = 0; j < 4; ++j) {
    const auto column = control({rows[0][j], rows[1][j], rows[2][j], rows[3][j]});
    for (std::size_t i = 0; i < 4; ++i)
      net[i][j] = {Rational(static_cast<long>(i), 3), Rational(static_cast<long>(j), 3), column[i]};
  }
  return RationalPatch(net);
}

/// (r - 1/4, s, 0) after a turn: u = 1/2 is a straight line in (r,s).
RationalPatch plane() {
  const Rational half(1, 2);
  return RationalPatch({{{0, -half, 0}, {-half, 1, 0}}, {{Rational(3, 2), 0, 0}, {1, Rational(3, 2), 0}}});
}

struct Found {
  PairOf<K> pair;
  std::optional<ContactLineOf<K>> line;
};
Found found(const RationalPatch& x, const RationalPatch& y, const Vec4& near) {
  const auto of_x = elevated<K>(x), of_y = elevated<K>(y);
  const auto pair = make_pair_of<K>(of_x, of_y);
  REQUIRE(pair);
  return {*pair, contact_line_near<K>(of_x, of_y, *pair, near)};
}

Part part(double u0, double u1, double v0, double v1) { return {{{{u0, u1}, {v0, v1}}}, {}}; }

Rational a(const Rational& u) { return u - Rational(1, 2); }

}  // namespace

TEST_CASE("contact line: of a graph and a plane, in both orders", "[filter]") {
  const RationalPatch bent =
      graph([](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) * (2 + u + v * v); });
  const auto [pair, line] = found(bent, plane(), {1e-4, 0.1, -0.1, 0.05});
  REQUIRE(line);
  CHECK(line->path.of_x);
  CHECK(line->path.parameter == 0);
  CHECK(line->path.value == Rational(1, 2));
  CHECK(line->path.ratio == 1);
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
    const auto at = line->path.at(t);
    CHECK(bent(at[0], at[1]) == plane()(at[2], at[3]));
  }
  CHECK(found(plane(), bent, {-0.1, 0.05, 1e-4, 0.1}).line->path.of_x == false);
  CHECK_FALSE(found(bent, plane(), {0.25, 0.1, 0.1, 0.05}).line);
}

TEST_CASE("contact line: the ratio of its parameters", "[filter]") {
  // A quarter of a cylinder with the weights 1, 1, 2 and, inside of it, one with 2, 1, 1 that touches along
  // the same quarter of a circle: a paraboloid would do as well.
  const auto quarter = [](const std::vector<Rational>& w, const Rational& bulge) {
    std::vector<std::vector<HomogeneousPoint>> net;
    const std::array<std::array<long, 2>, 3> arc = {{{1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 3; ++i) {
      net.emplace_back();
      for (const long z : {-1, 0, 1}) {
        // radius 1 - bulge z^2, in Bernstein form: 1 - bulge, 1 + bulge, 1 - bulge.
        const Rational radius = z == 0 ? Rational(1 + bulge) : Rational(1 - bulge);
        net.back().push_back({w[i] * radius * arc[i][0], w[i] * radius * arc[i][1], w[i] * z, w[i]});
      }
    }
    return RationalPatch::from_homogeneous(net);
  };
  const auto [pair, line] =
      found(quarter({1, 1, 2}, 0), quarter({2, 1, 1}, Rational(1, 8)), {0.1, 1e-5, -0.05, 0});
  REQUIRE(line);
  CHECK(line->path.ratio != 1);
  CHECK(line->path.value == Rational(1, 2));
  const auto on = line->path.at(Rational(9, 32));
  const double r = to_double(on[2]), s = to_double(on[3]);
  const Part near = part(r - 0x1p-6, r + 0x1p-6, s - 0x1p-6, s + 0x1p-6);
  CHECK(meet_on_line(*line, part(0.265625, 0.296875, 0.484375, 0.515625), near));
}

TEST_CASE("contact line: parts around it meet nowhere else", "[filter]") {
  const RationalPatch bent =
      graph([](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) * (2 + u + v * v); });
  const auto [pair, line] = found(bent, plane(), {0, 0.1, -0.1, 0.05});
  REQUIRE(line);
  random_pairs::Generator generator(7);
  int proved = 0;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.03125 * static_cast<double>(random_pairs::integer(generator, 0, 28));
    const auto on = line->path.at(from_double(t));
    const double r = std::floor(to_double(on[2]) * 16) / 16, s = std::floor(to_double(on[3]) * 16) / 16;
    const Part x = part(0.4375, 0.5625, t, t + 0.0625), y = part(r, r + 0.0625, s, s + 0.0625);
    CHECK(may_touch(*line, x, y));
    if (meet_on_line(*line, x, y)) ++proved;
  }
  CHECK(proved == 200);
  CHECK_FALSE(may_touch(*line, part(0.5, 0.625, 0, 0.125), part(0, 0.125, 0.875, 1)));
  CHECK_FALSE(may_touch(*line, part(0.5625, 0.625, 0, 1), part(0, 1, 0, 1)));
}

TEST_CASE("contact line: not where sheets cross along it, nor where another curve does", "[filter]") {
  const Part x = part(0.46875, 0.53125, 0.5, 0.53125);
  const auto is_proved = [&](const auto& height) {
    const auto [pair, line] = found(graph(height), plane(), {0, 0.02, -0.1, 0.02});
    REQUIRE(line);
    const auto on = line->path.at(Rational(33, 64));
    const double r = to_double(on[2]), s = to_double(on[3]);
    return meet_on_line(*line, x, part(r - 0x1p-6, r + 0x1p-6, s - 0x1p-6, s + 0x1p-6));
  };
  CHECK(is_proved([](const Rational& u, const Rational&) -> Rational { return a(u) * a(u); }));
  CHECK(is_proved(
      [](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) * (v - Rational(1, 3)); }));
  CHECK_FALSE(is_proved([](const Rational& u, const Rational&) -> Rational { return a(u) * a(u) * a(u); }));
  CHECK_FALSE(is_proved(
      [](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) * (v - Rational(33, 64)); }));
  CHECK_FALSE(is_proved([](const Rational& u, const Rational& v) -> Rational {
    return a(u) * a(u) * (a(u) + v - Rational(1, 2));
  }));
}

TEST_CASE("contact line: both sheets are bent", "[filter]") {
  const auto is_proved = [&](const auto& height, const auto& other) {
    const auto [pair, line] = found(graph(height), graph(other), {0, 0.02, 0, 0.02});
    REQUIRE(line);
    const Part at = part(0.46875, 0.53125, 0.5, 0.53125);
    return meet_on_line(*line, at, at);
  };
  const auto up = [](const Rational& u, const Rational&) -> Rational { return a(u) * a(u); };
  const auto down = [](const Rational& u, const Rational&) -> Rational { return -a(u) * a(u); };
  const auto more = [](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) * (1 + v); };
  const auto equal_once = [](const Rational& u, const Rational& v) -> Rational {
    return a(u) * a(u) * (v + Rational(31, 64));
  };
  CHECK(is_proved(up, down));
  CHECK(is_proved(up, more));
  CHECK(is_proved(more, up));
  CHECK_FALSE(is_proved(up, equal_once));
  CHECK_FALSE(is_proved(equal_once, up));
}

TEST_CASE("contact line: lines that cross, or nearly touch, are none", "[filter]") {
  const auto crossing =
      graph([](const Rational& u, const Rational& v) -> Rational { return a(u) * (1 + v); });
  CHECK_FALSE(found(crossing, plane(), {0, 0.1, -0.1, 0.05}).line);
  for (const int digits : {3, 9, 20, 60}) {
    const Rational e = 1 / Rational(pow(Integer(10), static_cast<unsigned>(digits)));
    const auto raised =
        graph([&](const Rational& u, const Rational&) -> Rational { return a(u) * a(u) + e; });
    CHECK_FALSE(found(raised, plane(), {0, 0.1, -0.1, 0.05}).line);
    const auto turned =
        graph([&](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) + e * a(u) * v; });
    CHECK_FALSE(found(turned, plane(), {0, 0.1, -0.1, 0.05}).line);
  }
}

TEST_CASE("contact line: its arc", "[filter]") {
  const RationalPatch bent =
      graph([](const Rational& u, const Rational& v) -> Rational { return a(u) * a(u) + a(u) * a(u) * v; });
  const auto x = elevated<K>(bent), y = elevated<K>(plane());
  const auto [pair, line] = found(bent, plane(), {0, 0.1, -0.1, 0.05});
  REQUIRE(line);
  const ContactArc drawn = contact_arc<K>(x, y, line->path, 1e-6);
  CHECK(drawn.arc.contact == Contact::tangential);
  CHECK(drawn.arc.place == ArcPlace::interior);
  CHECK(drawn.arc.error_bound <= 1e-6);
  for (const PolylineVertex& vertex : drawn.arc.polyline) {
    const auto& w = vertex.parameters;
    const Point p = bent(from_double(w[0]), from_double(w[1])),
                q = plane()(from_double(w[2]), from_double(w[3]));
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(std::fabs(to_double(p[c]) - vertex.point[c]) < 1e-12);
      CHECK(std::fabs(to_double(q[c]) - vertex.point[c]) < 1e-12);
    }
  }
  const ContactArc back = contact_arc<K>(y, x, found(plane(), bent, {-0.1, 0.05, 0, 0.1}).line->path, 1e-6);
  CHECK(back.ends[0].approx[2] == 0.5);
  CHECK(back.arc.polyline.front().parameters == back.ends[0].approx);
}

}  // namespace exsect::filter::contact_line_test
