// Places on arcs of a shadow: in doubles and in sums of two against exact ones, beside other arcs too.
#include "lift/middle_places.h"

#include <exsect/algebra/nearest_rounding.h>

#include <cmath>
#include <random>
#include <utility>

#include "curve/curve_place.h"
#include "lift/pair_region.h"
#include "support/catch.h"

namespace exsect::middle_places_test {
namespace {

using S = ImplicitSurface;

/// An arc of the shadow and the rectangle of its nodes, in balls.
struct BoxedArc {
  DrawnArc arc;
  DoubleBall from, to;  // u
  DoubleBall range;     // of v
};

std::vector<BoxedArc> boxed_arcs(const LiftedCurve& curve) {
  std::vector<BoxedArc> result;
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const DrawnArc arc{curve, i, 1e-6};
    if (arc.is_vertical()) continue;
    const auto [u0, v0] = place_of(curve.below, arc.branch().from, fine_width());
    const auto [u1, v1] = place_of(curve.below, arc.branch().to, fine_width());
    result.push_back({arc, DoubleBall::enclosing(u0), DoubleBall::enclosing(u1),
                      hull(DoubleBall::enclosing(v0), DoubleBall::enclosing(v1))});
  }
  return result;
}

std::vector<LiftedCurve> curves() {
  std::vector<LiftedCurve> result;
  const S ring = S::torus({Rational(-3, 16), Rational(-5, 16), Rational(1, 4)}, {-3, 0, 2}, Rational(19, 16),
                          Rational(7, 16)),
          cone = S::cone({0, Rational(15, 8), Rational(5, 16)}, {1, -4, -1}, Rational(1, 2));
  result.push_back(lifted_curve(cone, ring, pair_region(cone, ring).all).value());
  const S tube = S::cylinder({Rational(1, 8), 0, 0}, {1, -1, 1}, Rational(2, 3)),
          ball = S::sphere({0, 0, 0}, 1);
  result.push_back(lifted_curve(tube, ball, pair_region(tube, ball).all).value());
  return result;
}

bool overlap(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

}  // namespace

TEST_CASE("middle places: balls enclose what the exact isolation of all zeros finds", "[lift]") {
  const unsigned seed = 21;
  INFO("seed " << seed);
  in_nearest_rounding([] {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> place(0, 1);
    int found = 0, one_of_two = 0;
    const std::vector<LiftedCurve> all = curves();
    for (const LiftedCurve& curve : all) {
      const PlaneZeros<DoubleDoubleBall> strip(curve.below.swept);
      for (const BoxedArc& at : boxed_arcs(curve)) {
        const MiddlePlaces<DoubleBall> places(at.arc);
        const auto exact = [&](double share) -> std::optional<std::pair<DoubleBall, RationalInterval>> {
          const auto u = places.between(at.from, at.to, share);
          if (!u) return std::nullopt;
          const Rational over = from_double(u->approximation());
          const auto v = arc_over(curve.below, at.arc.lifted().below, over, fine_width());
          return v ? std::optional{std::pair{*u, *v}} : std::nullopt;
        };
        for (int k = 0; k < 12; ++k) {
          const double width = std::ldexp(0.5, -k), share = width + (1 - 2 * width) * place(generator);
          const auto a = exact(share - width / 2), here = exact(share), b = exact(share + width / 2);
          if (!a || !here || !b) continue;
          ++found;
          const DoubleBall range = hull(DoubleBall::enclosing(a->second), DoubleBall::enclosing(b->second));
          const auto near = places.on_arc(here->first, range),
                     nearest = places.nearest_on_arc(here->first, range);
          REQUIRE(near);
          REQUIRE(nearest);
          CHECK(overlap((*near)[1].interval(), here->second));
          CHECK(overlap((*nearest)[1].interval(), here->second));
          CHECK((*nearest)[1].radius() < 0x1p-48);
          const DoubleDoubleBall over = here->first.approximation(),
                                 among(range.approximation(), range.radius());
          if (strip.only_zero(over, among)) continue;
          const auto told = strip.only_zero(over, among, at.arc.sign_below());
          if (!told) continue;
          ++one_of_two;
          CHECK(overlap(told->interval(), here->second));
        }
      }
    }
    INFO(found << " places, " << one_of_two << " with another zero beside them");
    CHECK(found > 100);
    CHECK(one_of_two > 5);
    return 0;
  });
}

TEST_CASE("middle places: exact places are on the arc and between the ends", "[lift]") {
  in_nearest_rounding([] {
    const std::vector<LiftedCurve> all = curves();
    for (const LiftedCurve& curve : all)
      for (const BoxedArc& at : boxed_arcs(curve)) {
        const MiddlePlaces<RationalInterval> places(at.arc);
        const RationalInterval from = at.from.interval(), to = at.to.interval();
        const auto u = places.between(from, to, 0.25).value();
        const bool up = from.upper < to.lower;
        CHECK((up ? from.upper < u.lower && u.upper < to.lower : to.upper < u.lower && u.upper < from.lower));
        const auto [on_u, v] = places.on_arc(u, at.range.interval(), to).value();
        const Rational sign = Rational(at.arc.sign_below());
        CHECK(curve.below.swept(on_u.lower, v.lower) * sign >= 0);
        CHECK(curve.below.swept(on_u.lower, v.upper) * sign <= 0);
      }
    return 0;
  });
}

}  // namespace exsect::middle_places_test
