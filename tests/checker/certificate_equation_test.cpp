// Certificates of a surface given by its equation and a patch: written, accepted, and rejected after a
// change.
#include <exsect/solver/intersect_surface.h>

#include "certificate_changes.h"
#include "support/families.h"
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
  CHECK(summary.branched == static_cast<std::size_t>(result.graph.count(ComponentShape::branched)));
  CHECK(summary.isolated == result.graph.isolated_points.size());
  const auto on_side = [&](const Node& node) {
    const auto has = [&](NodeKind kind) {
      return std::count(node.kinds.begin(), node.kinds.end(), kind) > 0;
    };
    return !node.on.empty() && !has(NodeKind::touch) && !has(NodeKind::crossing);
  };
  const auto& nodes = result.graph.nodes;
  CHECK(summary.boundary == static_cast<std::size_t>(std::count_if(nodes.begin(), nodes.end(), on_side)));
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

namespace {

/// What the summary of a certificate says of special places.
std::array<std::size_t, 5> special(const checker::Summary& s) {
  return {s.closed, s.open, s.branched, s.isolated, s.tangential};
}
std::array<std::size_t, 5> special(const Json& json) {
  return special(check_certificate(json.dump()).summary);
}

ImplicitSurface polynomial(const std::map<std::array<int, 3>, Rational>& terms) {
  return ImplicitSurface::polynomial(SpacePolynomial(terms));
}
/// z - f for the product f of c_0 + c_1 x + c_2 x² and d_0 + d_1 y + d_2 y².
ImplicitSurface over(const Point& c, const Point& d) {
  std::map<std::array<int, 3>, Rational> terms = {{{0, 0, 1}, 1}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      terms[{i, j, 0}] = -c[static_cast<std::size_t>(i)] * d[static_cast<std::size_t>(j)];
  return polynomial(terms);
}
RationalPatch square(const Point& at, const Point& a, const Point& b) {
  return RationalPatch({{at, at + b}, {at + a, at + a + b}});
}
/// A quarter of the cylinder of radius 1 about the z axis.
RationalPatch quarter() {
  const std::vector<std::vector<Rational>> weights = {{1, 1}, {1, 1}, {2, 2}};
  return RationalPatch({{{1, 0, -1}, {1, 0, 1}}, {{1, 1, -1}, {1, 1, 1}}, {{0, 1, -1}, {0, 1, 1}}}, weights);
}

}  // namespace

TEST_CASE("special positions to a plane have the certificates that they have with the plane as a patch") {
  using families::Plane;
  const ImplicitSurface plane = ImplicitSurface::plane(origin, {0, 0, 1});
  for (const ExactCase& c :
       {families::cap(0, Plane::square), families::crossing(Plane::square),
        families::irrational_lines(Plane::square), families::three_irrational_lines(),
        families::tangent_curve(q(1, 4), Plane::square), families::curve_cusp(Plane::square),
        families::tangent_branches(Plane::square), families::line_and_arc(), families::side_and_arc(),
        families::tangent_and_transversal(Plane::square)}) {
    INFO(c.name);
    const auto as_patches = special(check_certificate(certificates::certificate(c.x, c.y)).summary);
    CHECK(special(accepted(plane, c.x)) == as_patches);
  }
}

TEST_CASE("touch points, crossings and curves of contact with equations have certificates") {
  const RationalPatch level = square({-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
  const RationalPatch ground = square({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  const auto torus = [](const Rational& minor) {
    return ImplicitSurface::torus(origin, {0, 0, 1}, 1, minor);
  };
  const auto found = [](const ImplicitSurface& f, const RationalPatch& x) { return special(accepted(f, x)); };
  using Counts = std::array<std::size_t, 5>;  // closed, open, branched, isolated, tangential
  CHECK(found(ImplicitSurface::sphere(origin, 1), level) == Counts{0, 0, 0, 1, 0});
  CHECK(found(ImplicitSurface::sphere({-1, 0, 0}, 1), level) == Counts{0, 0, 0, 1, 0});  // on a side
  CHECK(found(ImplicitSurface::cylinder(origin, {0, 1, 0}, 1), level) == Counts{0, 1, 0, 0, 1});
  CHECK(found(ImplicitSurface::cone(origin, {1, 0, 0}, q(1, 2), 2), ground) == Counts{0, 0, 1, 0, 0});
  CHECK(found(torus(q(1, 2)), square({-3, -3, q(1, 2)}, {6, 0, 0}, {0, 6, 0})) == Counts{1, 0, 0, 0, 4});
  CHECK(found(torus(q(1, 2)), square({q(1, 2), -1, -1}, {0, 2, 0}, {0, 0, 2})) == Counts{0, 0, 1, 0, 0});
  // Villarceau's circles cross in two points.
  CHECK(found(torus(q(3, 5)), square({-2, -2, q(-3, 2)}, {4, 0, 3}, {0, 4, 0})) == Counts{0, 0, 1, 0, 0});
  // A curved line of contact, of a patch with weights.
  CHECK(found(ImplicitSurface::sphere(origin, 1), quarter()) == Counts{0, 1, 0, 0, 1});
  // Points with parameters of degree 4, isolated and crossings.
  const auto quartic = [](int sign) {
    return polynomial({{{0, 0, 1}, 4},
                       {{4, 0, 0}, 1},
                       {{2, 0, 0}, -1},
                       {{0, 4, 0}, sign},
                       {{0, 2, 0}, q(-2 * sign, 3)},
                       {{0, 0, 0}, q(1, 4) + q(sign, 9)}});
  };
  CHECK(found(quartic(1), ground) == Counts{0, 0, 0, 4, 0});
  CHECK(found(quartic(-1), ground) == Counts{0, 0, 1, 0, 0});
  // Lines that cross, one of which is one of contact.
  CHECK(found(over({q(1, 4), 1, 1}, {q(1, 3), 1, 0}), ground) == Counts{0, 0, 1, 0, 2});
}

TEST_CASE("contacts in other places and beside near misses") {
  // A rotation, and the units of another model.
  const Point a = {q(50, 3) * q(2, 3), q(50, 3) * q(2, 3), q(50, 3) * q(1, 3)};
  const Point b = {q(50, 3) * q(-2, 3), q(50, 3) * q(1, 3), q(50, 3) * q(2, 3)};
  const Point normal = {q(1, 3), q(-2, 3), q(2, 3)};
  for (const Rational& far : {Rational(0), Rational(100000000)}) {
    const Point centre = {far, -far, far + q(1, 7)};
    for (const int k : {0, 3, 10}) {
      INFO(far << ", " << k);
      const Rational miss = k == 0 ? Rational(0) : power_of_two(-k);
      const auto at = [&](const Rational& height) {
        return square(centre + height * normal - q(1, 2) * a - q(4, 9) * b, a, b);
      };
      const ImplicitSurface sphere = ImplicitSurface::sphere(centre, 5);
      CHECK(accepted(sphere, at(5 + miss))["summary"]["isolated"] == (k == 0 ? 1 : 0));
      if (k > 0) CHECK(accepted(sphere, at(5 - miss))["summary"]["closed"] == 1);
      const ImplicitSurface cylinder = ImplicitSurface::cylinder(centre, a, 5);
      CHECK(accepted(cylinder, at(5 + miss))["summary"]["tangential"] == (k == 0 ? 1 : 0));
      if (k > 0) CHECK(accepted(cylinder, at(5 - miss))["summary"]["open"] == 2);
    }
  }
}

TEST_CASE("no change of claims about contacts with an equation is accepted") {
  Generator generator(57);
  INFO("seed 57");
  const std::string crossing =
      certificate(over({q(1, 4), 1, 1}, {q(1, 3), 1, 0}), square({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  reject_changes(crossing, generator, 40);
  CHECK(rejected_forgeries(crossing, {"stars", "factors", "tubes"}, generator, 60) > 20);
  const std::string contact = certificate(ImplicitSurface::sphere(origin, 1), quarter());
  reason(contact, "$.factors[0]: not a sum", [](Json& j) { j["factors"][0]["powers"] = {1, 1, 1}; });
  reason(contact, "$.tubes[", [](Json& j) {
    for (Json& tube : j["tubes"]) tube["curve"] = "pair";
  });
  reason(contact, "$.factors[0]: not a sum", [](Json& j) { j["second"]["equation"][0][0] = "7/9"; });
  const std::string touch =
      certificate(ImplicitSurface::sphere(origin, 1), square({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}));
  reason(touch, "$.stars[0]", [](Json& j) { j["stars"][0]["at"][0] = "1/3"; });
  reason(touch, "$.stars[0]", [](Json& j) { j["stars"][0]["at"][2] = "1/3"; });  // r is 1/2
  reason(touch, "$.stars[0]: its last row",
         [](Json& j) { std::swap(j["stars"][0]["rows"][0], j["stars"][0]["rows"][2]); });
  reason(touch, "$.", [](Json& j) { j["stars"] = Json::array(); });
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
  CHECK(refused(ImplicitSurface::plane({0, 0, 1}, {0, 0, 1}), level) == "a patch on the surface");
  CHECK(refused(ImplicitSurface::cone(origin, {0, 0, 1}, q(1, 2)), level) == "a surface with bounds");
}

}  // namespace exsect::certificate_equation_test
