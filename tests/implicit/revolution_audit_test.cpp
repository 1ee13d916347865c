#include <exsect/implicit/revolution_audit.h>

#include <cmath>

#include "geometry/random_shapes.h"
#include "support/catch.h"

namespace exsect::revolution_audit_test {
namespace {

const BivariatePolynomial r = BivariatePolynomial::r();
const BivariatePolynomial z = BivariatePolynomial::s();
BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }

TEST_CASE("audits and rings: bad input") {
  const Rectangle good = {{0, 1}, {0, 1}};
  CHECK_THROWS_AS(singular_rings({}, good), std::domain_error);
  CHECK_THROWS_AS(audit_branches({}, good), std::domain_error);
  CHECK_THROWS_AS(singular_rings(r, {{1, 2}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(audit_branches(r, {{0, 0}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(audit_branches(r, {{0, 1}, {1, 1}}), std::invalid_argument);
}

TEST_CASE("a spindle torus has the points of the axis, no ring; a common factor is told") {
  const Rectangle on = {{0, 3}, {-3, 3}};
  // (r-1)^2 + z^2 = 2 meets its mirror image on the axis only
  const BivariatePolynomial spindle = (r - number(1)) * (r - number(1)) + z * z - number(2);
  CHECK(singular_rings(spindle, on).rings.empty());
  const SingularRings even = singular_rings(r * r + z * z - number(1), on);
  CHECK(even.rings.empty());
  CHECK(even.common_factor);
  CHECK_FALSE(singular_rings(spindle, on).common_factor);
}

TEST_CASE("rings of a product of lines are where a line meets a mirrored one") {
  // z = r - 1 and z = 2 - r... mirrored: z = -r - 1, z = 2 + r: no ring; z = r and z = 2 + r... each pair by
  // hand: (z - r + 1) (z + r - 2): own lines z = r - 1 and z = 2 - r; z = r - 1 meets the mirrored z = 2 + r
  // nowhere, z = 2 - r meets the mirrored z = -r - 1 nowhere.
  const Rectangle on = {{0, 4}, {-4, 4}};
  CHECK(singular_rings((z - r + number(1)) * (z + r - number(2)), on).rings.empty());
  // z = 2 r - 1 meets the mirrored copy z = -r of z = r... never for r > 0 but at r = 1/3, z = -1/3.
  const SingularRings rings = singular_rings((z - number(2) * r + number(1)) * (z - r), on);
  REQUIRE(rings.rings.size() == 1);
  CHECK(rings.rings[0].r.lower <= Rational(1, 3));
  CHECK(Rational(1, 3) <= rings.rings[0].r.upper);
  CHECK(rings.rings[0].z.lower <= Rational(-1, 3));
  CHECK(Rational(-1, 3) <= rings.rings[0].z.upper);
  CHECK(rings.rings[0].r.width() < power_of_two(-30));
}

TEST_CASE("branches of a circle are counted") {
  // (r - 1)^2 + z^2 = 1/4
  const BivariatePolynomial f = (r - number(1)) * (r - number(1)) + z * z - number(Rational(1, 4));
  const BranchAudit audit = audit_branches(f, {{0, 2}, {-1, 1}});
  REQUIRE(audit.critical.size() == 2);
  CHECK(audit.critical[0] == RealAlgebraic(Rational(-1, 2)));
  CHECK(audit.gaps[0].own == 0);
  CHECK(audit.gaps[1].own == 2);
  CHECK(audit.gaps[2].own == 0);
  CHECK(audit.has_unwanted());
  // the mirrored circle, and a region whose wall r = 1 cuts it
  const BranchAudit mirrored = audit_branches(f.exchanged().exchanged(), {{0, 1}, {-1, 1}});
  CHECK(mirrored.gaps.size() == 3);
  CHECK(mirrored.gaps[1].own == 1);
  const BivariatePolynomial other = (r + number(1)) * (r + number(1)) + z * z - number(Rational(1, 4));
  CHECK(audit_branches(other, {{0, 2}, {-1, 1}}).gaps[1].mirrored == 2);
  CHECK(audit_branches(other, {{0, 2}, {-1, 1}}).gaps[1].own == 0);
}

TEST_CASE("the counts are those of the sheets of the surface") {
  const std::uint64_t seed = 20260115;
  INFO("seed " << seed);
  Random random(seed);
  const Rational b = 3;
  for (int round = 0; round < 10; ++round) {
    std::vector<Polynomial> rows;
    for (int i = 0; i <= 3; ++i)
      rows.push_back(Polynomial({random_rational(random), random_rational(random), random_rational(random)}));
    const BivariatePolynomial f(rows);
    const ParityParts parts = parity_parts(f);
    const BivariatePolynomial g = revolved_by_product(f), sheet = parts.even * parts.odd;
    for (const BranchCount& count : audit_branches(f, {{0, b}, {-2, 2}}).gaps) {
      int own = 0, mirrored = 0;
      for (const RealAlgebraic& squared : real_roots(g.at_s(count.sample), 0, b * b)) {
        if (squared.compare(0) == 0 || squared.compare(b * b) == 0) continue;
        const Sheet at = sheet_of_sign(sign_at(sheet.at_s(count.sample), squared));
        own += at == Sheet::own ? 1 : 0;
        mirrored += at == Sheet::mirrored ? 1 : 0;
      }
      CHECK(own == count.own);
      CHECK(mirrored == count.mirrored);
    }
  }
}

}  // namespace
}  // namespace exsect::revolution_audit_test
