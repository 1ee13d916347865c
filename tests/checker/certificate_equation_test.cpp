// Certificates of a surface given by its equation and a patch: written, accepted, and rejected after a
// change.
#include <exsect/solver/intersect_surface.h>

#include "certificate_changes.h"
#include "support/random_nets.h"

namespace exsect::certificate_equation_test {
namespace {

using namespace certificates;

const Point origin = {0, 0, 0};
Rational q(long a, long b) { return Rational(a, b); }

std::string certificate(const ImplicitSurface& surface, const RationalPatch& x) {
  return cli::certificate_text(surface, x, {"x", "f"}, intersect(surface, x, coarse()));
}
/// The certificate, which is accepted, of all that was found.
Json accepted(const ImplicitSurface& surface, const RationalPatch& x) {
  const IntersectResult result = intersect(surface, x, coarse());
  REQUIRE(result.status == Status::complete);
  const std::string text = cli::certificate_text(surface, x, {"x", "f"}, result);
  const checker::Summary summary = check_certificate(text).summary;
  CHECK(summary.components == result.graph.components.size());
  CHECK(summary.closed == static_cast<std::size_t>(result.graph.count(ComponentShape::closed)));
  CHECK(summary.boundary == static_cast<std::size_t>(result.graph.boundary_points()));
  for (const Parameter p : {Parameter::u, Parameter::v})
    CHECK(summary.turning[index(p)] == static_cast<std::size_t>(result.graph.turning_points(p)));
  CHECK((summary.turning[2] == 0 && summary.turning[3] == 0));
  return Json::parse(text);
}
/// What does not depend on r and s.
Json in_square(const Json& json) {
  const Json& s = json["summary"];
  return {s["components"], s["closed"], s["open"], s["boundary"], s["turning"][0], s["turning"][1]};
}

/// Numbers of 53 bits around a net of the square [-1,1]^2 of the plane z = 0.
RationalPatch wavy(Generator& generator, int m, int n, bool weighted) {
  std::vector<std::vector<Point>> net(static_cast<std::size_t>(m) + 1);
  const auto some = [&](double size) {
    return from_double(
        size * std::ldexp(static_cast<double>(random_pairs::integer(generator, -(1L << 52), 1L << 52)), -52));
  };
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      net[static_cast<std::size_t>(i)].push_back(
          {q(2 * i - m, m) + some(0.2), q(2 * j - n, n) + some(0.2), some(0.6)});
  return weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
}

std::vector<ImplicitSurface> surfaces() {
  return {
      ImplicitSurface::plane({0, 0, q(1, 9)}, {q(1, 7), q(1, 5), 1}),
      ImplicitSurface::cylinder(origin, {q(1, 9), q(1, 8), 1}, q(3, 5)),
      ImplicitSurface::cone({0, 0, -1}, {q(1, 7), 0, 1}, q(2, 3), 2),
      ImplicitSurface::sphere({0, 0, q(1, 9)}, q(3, 4)),
      ImplicitSurface::torus(origin, {1, 2, 3}, q(3, 5), q(1, 5)),
      ImplicitSurface::polynomial(SpacePolynomial(
          {{{4, 0, 0}, 1}, {{0, 4, 0}, 1}, {{1, 1, 1}, 1}, {{0, 0, 1}, q(1, 3)}, {{0, 0, 0}, q(-1, 3)}}))};
}

}  // namespace

TEST_CASE("every kind of equation with patches of every kind has certificates") {
  Generator generator(52);
  INFO("seed 52");
  std::size_t curves = 0;
  const std::vector<ImplicitSurface> all = surfaces();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      INFO(name(all[i].kind()) << ", " << k);
      const RationalPatch x = wavy(generator, 1 + k, 1 + (k + static_cast<int>(i)) % 3, k % 2 == 1);
      curves += accepted(all[i], x)["summary"]["components"].get<std::size_t>();
    }
  }
  CHECK(curves > 15);
}

TEST_CASE(
    "a plane by its equation and as a patch have certificates of the "
    "same curves") {
  Generator generator(53);
  INFO("seed 53");
  for (int i = 0; i < 6; ++i) {
    INFO(i);
    const RationalPatch x = wavy(generator, 1 + i % 3, 2, i % 2 == 1);
    const auto point = [&](long a, long b) { return Point{a, b, q(1, 9) - q(a, 7) - q(b, 5)}; };
    const RationalPatch plane({{point(-9, -9), point(-9, 9)}, {point(9, -9), point(9, 9)}});
    const IntersectResult result = intersect(x, plane, coarse());
    const Json other = Json::parse(cli::certificate_text(x, plane, names, result));
    CHECK(in_square(accepted(surfaces()[0], x)) == in_square(other));
    // Exchanged parameters.
    Json expected = in_square(other);
    std::swap(expected[4], expected[5]);
    CHECK(in_square(accepted(surfaces()[0], x.transposed())) == expected);
  }
}

TEST_CASE(
    "equations of other scales and places have certificates of the same "
    "curves") {
  Generator generator(54);
  INFO("seed 54");
  const RationalPatch x = wavy(generator, 2, 2, false);
  const ImplicitSurface sphere = ImplicitSurface::sphere({0, 0, q(1, 9)}, q(3, 4));
  const Json expected = in_square(accepted(sphere, x));
  const auto moved = [&](const Rational& scale, const Point& by) {
    std::vector<std::vector<Point>> net;
    for (int i = 0; i <= 2; ++i) {
      net.emplace_back();
      for (int j = 0; j <= 2; ++j) net.back().push_back(scale * x.point(i, j) + by);
    }
    return RationalPatch(net);
  };
  CHECK(in_square(accepted(ImplicitSurface::sphere({0, 0, q(127, 45)}, q(381, 20)),
                           moved(q(127, 5), origin))) == expected);
  const Rational far = 100000000;
  CHECK(in_square(accepted(ImplicitSurface::sphere({far, far, far + q(1, 9)}, q(3, 4)),
                           moved(1, {far, far, far}))) == expected);
}

TEST_CASE(
    "no change of a certificate of an equation is accepted, and no false "
    "claim") {
  Generator generator(55);
  INFO("seed 55");
  const std::string truth = certificate(surfaces()[3], wavy(generator, 2, 1, true));
  reject_changes(truth, generator, 40);
  CHECK(rejected_forgeries(truth, {"tubes", "nodes", "arcs"}, generator, 60) > 20);
  const auto terms = [](Json& j) -> Json& { return j["second"]["equation"]; };
  reason(truth, "$.", [&](Json& j) { terms(j)[0][0] = "7/9"; });
  reason(truth, "$.", [&](Json& j) { terms(j)[1][1] = 1; });
  reason(truth, "$.", [&](Json& j) { terms(j).erase(0); });
  reason(truth, "$.", [&](Json& j) { j["first"]["points"][1][1][2] = "3"; });
  reason(truth, "$.", [&](Json& j) { terms(j) = Json::array(); });
  reason(truth, "$.", [](Json& j) { j["tubes"].erase(1); });
  reason(truth, "$.cover", [](Json& j) { j["cover"].erase(j["cover"].size() - 1); });
  reason(truth, "$.first: its denominator", [](Json& j) { j["first"]["weights"][0][0] = "-1"; });
  // Cells that are halved in r, and excluded by what is 0.
  const auto with_cover = [](const char* entries) {
    return [entries](Json& j) { j["cover"] = Json::array({std::string(entries) + " #"}); };
  };
  reason(truth, "$.cover[0]: a half edge", with_cover("r 1,0,0 1,0,0"));
  reason(truth, "$.cover[0]: the direction", with_cover("0,1,1"));
  // Of another form.
  reason(truth, "$.second.equation[0]", [&](Json& j) { terms(j)[0].push_back(1); });
  reason(truth, "$.second.equation[0]", [&](Json& j) { terms(j)[0] = "1"; });
  reason(truth, "$.second.equation[0]", [&](Json& j) { terms(j)[0].erase(3); });
  reason(truth, "$.second.equation[0]", [&](Json& j) { terms(j)[0] = {"1", 3, 2, 0}; });
  reason(truth, "$.second", [](Json& j) { j["second"]["points"] = j["first"]["points"]; });
  reason(truth, "$.second", [](Json& j) { j["second"].erase("equation"); });
  reason(truth, "$.first", [](Json& j) { j["first"] = j["second"]; });
}

TEST_CASE("what an equation has no certificate for is named") {
  const RationalPatch level({{{-1, -1, 1}, {-1, 1, 1}}, {{1, -1, 1}, {1, 1, 1}}});
  const auto refused = [](const ImplicitSurface& surface, const RationalPatch& x) {
    try {
      certificate(surface, x);
    } catch (const cli::NoCertificate& no) {
      return std::string(no.what());
    }
    return std::string();
  };
  CHECK(refused(ImplicitSurface::sphere(origin, 1), level) == "a point where the patch touches the surface");
  CHECK(refused(ImplicitSurface::plane({0, 0, 1}, {0, 0, 1}), level) == "a patch on the surface");
  CHECK(refused(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1), level) ==
        "an arc along which the patch touches the surface");
  CHECK(refused(ImplicitSurface::cone(origin, {0, 0, 1}, q(1, 2)), level) == "a surface with bounds");
}

}  // namespace exsect::certificate_equation_test
