#include <exsect/geometry/implicit_curve.h>
#include <exsect/implicit/revolve.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "geometry/curve_specimens.h"
#include "support/catch.h"

namespace exsect::revolve_test {
namespace {

using Json = nlohmann::json;

const Json& chapter12() {
  static const Json cases = Json::parse(std::ifstream(EXSECT_CASES "/chapter12.expected.json"));
  return cases;
}

RevolveOptions cubic(RevolutionMethod method) {
  RevolveOptions options;
  options.method = method;
  options.degree = 3;
  options.region = Rectangle{{0, 2}, {0, 2}};
  return options;
}

double number(const Json& text) { return std::stod(text.get<std::string>()); }

bool holds(const RationalInterval& interval, double value, double slack) {
  return to_double(interval.lower) - slack <= value && value <= to_double(interval.upper) + slack;
}

std::vector<std::array<int, 2>> counts(const BranchAudit& audit) {
  std::vector<std::array<int, 2>> result;
  for (const BranchCount& count : audit.gaps) result.push_back({count.own, count.mirrored});
  return result;
}

using Counts = std::vector<std::array<int, 2>>;

TEST_CASE("the cubic profile revolved by elimination and by product", "[revolve]") {
  const Json& expected = chapter12()["revolution_profile"];
  for (const RevolutionMethod method : {RevolutionMethod::elimination, RevolutionMethod::product}) {
    const Revolution result = revolve(profile_cubic(), cubic(method));
    CHECK_FALSE(result.exact);
    REQUIRE(result.rings->rings.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      const SingularRing& ring = result.rings->rings[i];
      // the coefficients are rounded to six digits
      CHECK(holds(ring.r, number(expected["singular_rings_of_g_(r,z)"][i][0]), 1e-5));
      CHECK(holds(ring.z, number(expected["singular_rings_of_g_(r,z)"][i][1]), 1e-5));
      CHECK(ring.r.width() < power_of_two(-30));
    }
    CHECK(counts(*result.audit) == Counts{{1, 0}, {1, 2}, {1, 0}, {0, 1}});
    const double critical[] = {0.78623, 0.99290, 1.7771};
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(result.audit->critical[i].to_double() - critical[i]) < 5e-5);
    CHECK(to_double(*result.bounds.one_sided.distance) <= 0.0085112);
    CHECK(to_double(result.bounds.two_sided.strip->distance) <= 0.00976);
    CHECK(result.surfaces.front().degree_r() == 3);
    CHECK(result.surfaces.front().degree_s() == 6);
  }
}

TEST_CASE("the cubic profile revolved by substitution has no ring and no mirrored branch", "[revolve]") {
  const Revolution result = revolve(profile_cubic(), cubic(RevolutionMethod::substitution));
  CHECK(result.rings->rings.empty());
  CHECK(counts(*result.audit) == Counts{{1, 0}, {0, 0}});
  CHECK(std::abs(result.audit->critical.front().to_double() - 1.6315) < 5e-5);
  CHECK(to_double(*result.bounds.one_sided.distance) <= 0.0051141);
  CHECK(to_double(result.bounds.two_sided.strip->distance) <= 0.00601);
  CHECK(result.profile.polynomial().degree_r() == 6);
  CHECK(result.profile.polynomial().degree_s() == 3);
  const SpacePolynomial surface = surface_of_revolution(result.surfaces.front());
  CHECK(surface.degree_in(0) == 6);
  CHECK(surface.degree_in(1) == 6);
  CHECK(surface.degree_in(2) == 3);
}

TEST_CASE("fits have the coefficients of the independent computation", "[revolve]") {
  const Json& expected = chapter12()["revolution_profile"];
  const auto check = [](const BivariatePolynomial& f, const Json& coefficients, bool squares) {
    for (const auto& [monomial, value] : coefficients.items()) {
      int i = 0, j = 0;
      for (const std::string factor : {"r^6", "r^4", "r^3", "r^2", "r"})
        if (monomial == factor || monomial.starts_with(factor + "*")) {
          i = factor == "r" ? 1 : factor[2] - '0';
          break;
        }
      if (const std::size_t at = monomial.find('z'); at != std::string::npos)
        j = at + 1 < monomial.size() ? monomial[at + 2] - '0' : 1;
      INFO(monomial);
      CHECK(std::abs(to_double(f.coefficient(i, j)) - number(value)) < 2e-6);
      CHECK((!squares || i % 2 == 0));
    }
  };
  check(revolve(profile_cubic(), cubic(RevolutionMethod::product)).profile.polynomial(),
        expected["f_total_degree_3"], false);
  check(revolve(profile_cubic(), cubic(RevolutionMethod::substitution)).profile.polynomial(),
        expected["F_total_degree_3_in_r2_z"], true);
}

TEST_CASE("exact profiles: the cubic, one with a ring, and the torus", "[revolve]") {
  RevolveOptions exact;
  const Revolution clean = revolve(profile_cubic(), exact);
  CHECK(clean.exact);
  CHECK(*clean.bounds.one_sided.distance == 0);
  const Json& expected = chapter12()["exact_profile_with_ring"];
  std::vector<std::vector<Rational>> points;
  for (const Json& p : expected["control_points_rz"]) {
    points.emplace_back();
    for (const Json& c : p) points.back().emplace_back(c.get<std::string>());
  }
  const Revolution ring = revolve(BezierCurve(points), exact);
  REQUIRE(ring.rings->rings.size() == 1);
  CHECK(holds(ring.rings->rings[0].r, number(expected["singular_rings_of_exact_g_(r,z)"][0][0]), 1e-14));
  CHECK(holds(ring.rings->rings[0].z, number(expected["singular_rings_of_exact_g_(r,z)"][0][1]), 1e-14));
  // a quarter of the circle (r - 2)^2 + z^2 = 1
  const BezierCurve quarter({{3, 0}, {3, 1}, {2, 1}}, {1, 1, 2});
  const Revolution torus = revolve(quarter, exact);
  const SpacePolynomial surface = surface_of_revolution(torus.surfaces.front());
  CHECK(surface({3, 0, 0}) == 0);
  CHECK(surface({0, -1, 0}) == 0);
  CHECK(surface.degree() == 4);
  CHECK(torus.rings->rings.empty());
}

TEST_CASE("a bi-quartic fit gives a surface of degrees (8,8,8)", "[revolve]") {
  RevolveOptions options = cubic(RevolutionMethod::elimination);
  options.degree = 4;
  options.degree_z = 4;
  options.weights.w2 = Rational(1, 1000);
  const SpacePolynomial surface = surface_of_revolution(revolve(profile_cubic(), options).surfaces.front());
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(surface.degree_in(axis) == 8);
}

TEST_CASE("spline profiles stay splines under substitution", "[revolve]") {
  RevolveOptions options = cubic(RevolutionMethod::substitution);
  options.degree = 2;
  options.cells = {{6, 6}};
  options.weights.w2 = Rational(1, 1000);
  const Revolution result = revolve(profile_cubic(), options);
  CHECK_FALSE(result.profile.is_polynomial());
  CHECK(result.surfaces.size() > 4);
  REQUIRE(result.bounds.one_sided.distance);
  CHECK(to_double(*result.bounds.one_sided.distance) < 0.005);
  CHECK_FALSE(result.rings);
}

TEST_CASE("profiles that cannot be revolved are refused with the reason", "[revolve]") {
  const auto reason = [](const BezierCurve& curve, const RevolveOptions& options) {
    try {
      revolve(curve, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const RevolveOptions substitution = cubic(RevolutionMethod::substitution);
  const BezierCurve oblique({{0, 0}, {1, 1}, {2, 0}});
  CHECK(reason(oblique, substitution).find("not orthogonal to the axis") != std::string::npos);
  CHECK(reason(BezierCurve({{0, 0}, {0, 1}, {1, 1}}), substitution).find("t = 0") != std::string::npos);
  CHECK(reason(BezierCurve({{0, 0}, {1, 0}, {1, 1}}), substitution).empty());  // at right angles
  CHECK(reason(oblique, cubic(RevolutionMethod::product)).empty());
  CHECK(reason(BezierCurve({{-1, 0}, {1, 0}}), {}).find("r >= 0") != std::string::npos);
  CHECK(reason(BezierCurve({{1, 0}, {-3, 0}, {1, 1}}), {}).find("r >= 0") != std::string::npos);
  CHECK(reason(BezierCurve({{0, 0}, {0, 1}}), {}).find("axis") != std::string::npos);
  CHECK(reason(BezierCurve({{1, 1}, {1, 1}}), {}).find("equal") != std::string::npos);
  CHECK(reason(BezierCurve({{1, 1, 1}, {1, 1, 2}}), {}).find("planar") != std::string::npos);
  const auto with = [&](auto change) {
    RevolveOptions options = cubic(RevolutionMethod::product);
    change(options);
    return reason(profile_cubic(), options);
  };
  CHECK(with([](RevolveOptions& o) { o.degree = 0; }).find("degree") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.degree_z = 11; }).find("degree") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.samples = 1; }).find("samples") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.samples = 2; }).find("determine") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.weights.w1 = 0; }).find("w1") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.weights.w2 = -1; }).find("w2") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.region->r.upper = 0; }).find("region") != std::string::npos);
  CHECK(with([](RevolveOptions& o) { o.cells = {{4, 4}}; }).find("substitution") != std::string::npos);
  CHECK(with([](RevolveOptions& o) {
          o.method = RevolutionMethod::substitution;
          o.degree.reset();
        }).find("degree") != std::string::npos);
}

}  // namespace
}  // namespace exsect::revolve_test
