// Pinch points that are known, of polynomial and weighted patches; what is none.
#include "self/pinch_proof.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>

#include "support/catch.h"
#include "support/interpolated_patch.h"
#include "support/random_nets.h"

namespace exsect::pinch_proof_test {
namespace {

/// Whitney's umbrella (a^2, a b, b), a = u - u0 - (v - v0)/3, b = v - v0 + (u - u0)/5, in oblique
/// coordinates.
RationalPatch umbrella(const Rational& u0, const Rational& v0) {
  return testing::interpolated([&](const Rational& u, const Rational& v) {
    const Rational a = (u - u0 - (v - v0) / 3) / 16, b = (v - v0 + (u - u0) / 5) / 16;
    return Point{a * a + b, a * b - b / 2, b + a * a / 3};
  });
}

bool holds(const DoubleBall& ball, double value, double room = 0) {
  return std::fabs(ball.approximation() - value) <= ball.radius() * (1 + 1e-9) + room;
}

/// The pairs of the umbrella have b = 0 and opposite a.
void check_umbrella(const RationalPatch& x, double u0, double v0) {
  const auto proof = PinchProof::of(x, Point{0, 0, 0});
  REQUIRE(proof);
  const auto cusp = proof->at(0);
  REQUIRE(cusp);
  CHECK(holds(cusp->pair[0], u0));
  CHECK(holds(cusp->pair[1], v0));
  CHECK(cusp->pair[0].radius() < 1e-10);
  for (const double t : {0.01, 0.1, 0.2}) {
    CAPTURE(t);
    const auto place = proof->at(t);
    REQUIRE(place);
    for (std::size_t j = 0; j < 2; ++j)
      CHECK(std::fabs(place->pair[j].approximation() + place->pair[j + 2].approximation() -
                      (j == 0 ? 2 * u0 : 2 * v0)) < 1e-12);
    const double du = place->pair[0].approximation() - u0, dv = place->pair[1].approximation() - v0;
    CHECK(std::fabs(dv + du / 5) < 1e-12);
    CHECK(std::fabs(std::max(std::fabs(du), std::fabs(dv)) - t) < 1e-12);
    // The point of space against the other point of the pair, and its second difference by q.
    const auto other = proof->point({place->pair[2], place->pair[3]});
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(holds(other[c], place->point[c].approximation(), place->point[c].radius()));
  }
}

}  // namespace

TEST_CASE("pinch proof: an umbrella, its image under a projective map, and with exchanged parameters") {
  in_nearest_rounding([] {
    for (const auto& [u0, v0] :
         {std::pair(Rational(1, 2), Rational(1, 2)), std::pair(Rational(3, 7), Rational(5, 9))}) {
      const RationalPatch x = umbrella(u0, v0);
      check_umbrella(x, to_double(u0), to_double(v0));
      random_nets::Generator generator(4);
      check_umbrella(random_nets::image(x, random_nets::projective_map(generator)), to_double(u0),
                     to_double(v0));
      const auto exchanged = PinchProof::of(x.transposed(), Point{0, 0, 0});
      REQUIRE(exchanged);
      CHECK(exchanged->exchanged() != PinchProof::of(x, Point{0, 0, 0})->exchanged());
      CHECK(holds(exchanged->at(0)->pair[0], to_double(v0)));
    }
  });
}

TEST_CASE("pinch proof: the bound of the curve's bend") {
  in_nearest_rounding([] {
    random_nets::Generator generator(7);
    const RationalPatch x =
        random_nets::image(umbrella(Rational(4, 9), Rational(5, 9)), random_nets::projective_map(generator));
    const auto proof = PinchProof::of(x, Point{0, 0, 0});
    REQUIRE(proof);
    const auto at = [&](double q) { return proof->at(std::sqrt(q))->point; };
    const double step = 0x1p-8;
    for (const double q : {0.01, 0.03, 0.05}) {
      const auto a = at(q - step), b = at(q), c = at(q + step);
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double second =
            (a[k].approximation() - 2 * b[k].approximation() + c[k].approximation()) / (step * step);
        square += second * second;
      }
      CHECK(std::sqrt(square) <= proof->bend() + 1e-6);
    }
  });
}

TEST_CASE("pinch proof: none where sheets are regular, where they fold, and where there are two") {
  in_nearest_rounding([] {
    const auto proved = [](const auto& f) {
      return PinchProof::of(RationalPatch(testing::interpolated(f)), Point{0, 0, 0}).has_value();
    };
    const Rational half(1, 2);
    // A fold along a line; a cuspidal edge; two pinch points a^2 = 1/16, of (a^2 - 1/16) (1,0,0) + ...
    CHECK_FALSE(proved([&](const Rational& u, const Rational& v) {
      return Point{(u - half) * (u - half), v, 0};
    }));
    CHECK_FALSE(proved([&](const Rational& u, const Rational& v) {
      return Point{(u - half) * (u - half), v, (u - half) * (u - half) * v};
    }));
    CHECK_FALSE(proved([&](const Rational& u, const Rational& v) {
      const Rational a = u - half, b = v - half;
      return Point{a * a, a * (b * b - Rational(1, 16)), b};
    }));
  });
}

}  // namespace exsect::pinch_proof_test
