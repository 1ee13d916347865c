// Charts of round surfaces against their equations: points, values and derivatives.
#include "filter/round_chart.h"

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::round_chart_test {
namespace {

using S = ImplicitSurface;
const Point up = {0, 0, 1}, oblique = {1, 2, -2};

const std::vector<S>& charted() {
  static const std::vector<S> all = {S::torus({1, 0, -1}, {1, 2, 3}, 3, 1),
                                     S::cylinder({1, 1, 0}, oblique, 2),
                                     S::cone({Rational(1, 3), 0, 2}, {1, 0, 1}, 1, 2),
                                     S::torus({0, 0, 0}, up, Length::of_squared(7), Length::of_squared(2))};
  return all;
}
const std::vector<S>& others() {
  static const std::vector<S> all = {S::sphere({1, 2, 3}, 2),
                                     S::torus({2, 1, 1}, {0, 1, 1}, 2, Rational(1, 2)),
                                     S::cylinder({0, 1, 0}, {3, 1, 1}, 1)};
  return all;
}

double value_at(const S& surface, const std::array<DoubleBall, 3>& p) {
  return to_double(surface.equation()({from_double(p[0].approximation()), from_double(p[1].approximation()),
                                       from_double(p[2].approximation())}));
}

RoundPlace random_place(const RoundChart& chart, std::mt19937_64& generator) {
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(generator); };
  RoundPlace place{{turned({1, 0}, number()),
                    chart.is_closed() ? turned({0, 1}, number()) : RoundCoordinate{number(), 0}}};
  return chart.moved(place, 0, number());
}

}  // namespace

TEST_CASE("round chart: points are on the surface, and f is the equation of the other one") {
  std::mt19937_64 generator(7);
  int charts = 0;
  for (const S& first : charted())
    for (const S& second : others()) {
      const auto chart = RoundChart::of(first, second);
      if (!chart) continue;
      ++charts;
      // Which of both has the chart: the one of the greater rank, or the first.
      const bool is_swapped =
          std::fabs(value_at(first, chart->position({random_place(*chart, generator), {}}))) > 1e-6;
      const S &on = is_swapped ? second : first, &other = is_swapped ? first : second;
      double ratio = 0;
      for (int i = 0; i < 20; ++i) {
        const RoundPlace place = random_place(*chart, generator);
        const auto p = chart->position({place, {}});
        CHECK(std::fabs(value_at(on, p)) < 1e-9);
        const DoubleBall f = chart->jet(place).value;
        CHECK((chart->value(place) - f).lower_magnitude() == 0);
        CHECK(f.radius() < 1e-10);
        const double exact = value_at(other, p);
        if (i == 0) ratio = exact / f.approximation();
        CHECK(std::fabs(exact - ratio * f.approximation()) < 1e-7 * std::fabs(ratio));
      }
    }
  CHECK(charts == 12);
}

TEST_CASE("round chart: boxes contain values and derivatives, which are those of differences") {
  std::mt19937_64 generator(8);
  for (const S& first : charted())
    for (const S& second : others()) {
      const auto chart = RoundChart::of(first, second);
      if (!chart) continue;
      for (int i = 0; i < 20; ++i) {
        const RoundBox box{random_place(*chart, generator), {0.3, 0.2}};
        const RoundJet over = chart->jet(box);
        const auto speeds = chart->speeds(box);
        const auto unit = [&](double a) { return std::uniform_real_distribution<double>(-a, a)(generator); };
        const RoundPlace inside = chart->moved(chart->moved(box.centre, 0, unit(0.3)), 1, unit(0.2));
        const RoundJet at = chart->jet(inside);
        CHECK((over.value - at.value).lower_magnitude() == 0);
        for (std::size_t k = 0; k < 3; ++k) CHECK((over.second[k] - at.second[k]).lower_magnitude() == 0);
        for (std::size_t k = 0; k < 2; ++k) {
          CHECK((over.first[k] - at.first[k]).lower_magnitude() == 0);
          const double h = 0x1p-16;
          const RoundPlace next = chart->moved(inside, k, h), last = chart->moved(inside, k, -h);
          const RoundJet b = chart->jet(next), a = chart->jet(last);
          const auto rate = [&](const DoubleBall& y, const DoubleBall& x) {
            return (y.approximation() - x.approximation()) / (2 * h);
          };
          const double scale = 1e-4 * (1 + at.second[0].upper_magnitude() + at.second[2].upper_magnitude());
          CHECK(std::fabs(rate(b.value, a.value) - at.first[k].approximation()) < scale);
          CHECK(std::fabs(rate(b.first[0], a.first[0]) - at.second[k].approximation()) < 10 * scale);
          CHECK(std::fabs(rate(b.first[1], a.first[1]) - at.second[k + 1].approximation()) < 10 * scale);
          double moved = 0;
          const auto p = chart->position({next, {}}), q = chart->position({last, {}});
          for (std::size_t c = 0; c < 3; ++c) moved += std::pow(rate(p[c], q[c]), 2);
          CHECK(std::sqrt(moved) < speeds[k] * (1 + 1e-6));
          CHECK((chart->difference(k, next, last) - DoubleBall(2 * h)).upper_magnitude() < 0x1p-45);
        }
      }
    }
}

TEST_CASE("round chart: quick values, derivatives and positions are those of balls, with their own radii") {
  std::mt19937_64 generator(10);
  for (const S& first : charted())
    for (const S& second : others()) {
      const auto chart = RoundChart::of(first, second);
      if (!chart) continue;
      for (int i = 0; i < 40; ++i) {
        RoundPlace place = random_place(*chart, generator);
        // The last ones are out of the range.
        if (!chart->is_closed() && i > 30) place.at[1][0] = 70 * (i % 2 == 0 ? 1 : -1);
        const auto apart = [](const DoubleBall& a, const DoubleBall& b) { return (a - b).lower_magnitude(); };
        const RoundJet exact = chart->jet(place), quick = chart->quick_jet(place);
        CHECK(apart(chart->quick_value(place), exact.value) == 0);
        CHECK(apart(quick.value, exact.value) == 0);
        for (std::size_t k = 0; k < 2; ++k) CHECK(apart(quick.first[k], exact.first[k]) == 0);
        for (std::size_t k = 0; k < 3; ++k) CHECK(apart(quick.second[k], exact.second[k]) == 0);
        const auto p = chart->position({place, {}}), q = chart->quick_position(place);
        for (std::size_t k = 0; k < 3; ++k) CHECK(apart(p[k], q[k]) == 0);
        // The radius of a ball at one place is no larger, but for the last bits.
        CHECK(quick.value.radius() > (1 - 1e-9) * exact.value.radius());
        CHECK(quick.second[1].radius() > (1 - 1e-9) * exact.second[1].radius());
        CHECK(q[2].radius() > (1 - 1e-9) * p[2].radius());
        // And not much smaller.
        CHECK(quick.value.radius() < 1e-11 * (1 + exact.value.upper_magnitude()) + 32 * exact.value.radius());
        CHECK(q[0].radius() < 1e-13 + 16 * p[0].radius());
      }
    }
}

TEST_CASE("round chart: motion along paths, by its lengths and the angle between both") {
  std::mt19937_64 generator(9);
  for (const S& first : charted()) {
    const auto chart = RoundChart::of(first, others()[1]).value();
    for (const std::size_t axis : {0U, 1U})
      for (int i = 0; i < 10; ++i) {
        const RoundPlace place = random_place(chart, generator);
        const double slope = std::uniform_real_distribution<double>(-2, 2)(generator),
                     bend = std::uniform_real_distribution<double>(-2, 2)(generator), h = 1e-4;
        const auto at = [&](double s) {
          return chart.position(
              {chart.moved(chart.moved(place, axis, s), 1 - axis, slope * s + bend * s * s / 2), {}});
        };
        const auto a = at(-h), b = at(0), c = at(h);
        const RoundMotion motion = chart.motion({place, {}}, axis, slope, bend);
        double vv = 0, vw = 0, ww = 0;
        DoubleBall expected_vv(0), expected_vw(0), expected_ww(0);
        for (std::size_t k = 0; k < 3; ++k) {
          const double v = (c[k].approximation() - a[k].approximation()) / (2 * h),
                       w = (a[k].approximation() - 2 * b[k].approximation() + c[k].approximation()) / (h * h);
          vv += v * v, vw += v * w, ww += w * w;
          expected_vv += motion.velocity[k] * motion.velocity[k];
          expected_vw += motion.velocity[k] * motion.acceleration[k];
          expected_ww += motion.acceleration[k] * motion.acceleration[k];
        }
        CHECK(std::fabs(vv - expected_vv.approximation()) < 1e-4 * (1 + vv));
        CHECK(std::fabs(vw - expected_vw.approximation()) < 1e-4 * (1 + vv + ww));
        CHECK(std::fabs(ww - expected_ww.approximation()) < 1e-4 * (1 + ww));
      }
  }
}

TEST_CASE("round chart: differences of angles, and those that are far") {
  const auto chart = RoundChart::of(charted()[0], others()[0]).value();
  const RoundPlace zero{{RoundCoordinate{1, 0}, RoundCoordinate{0.6, 0.8}}};
  for (const double x : {0.0, 1e-9, 0.1, 0.5, -0.75, 1.0})
    for (const std::size_t k : {0U, 1U}) {
      const DoubleBall found = chart.difference(k, chart.moved(zero, k, x), zero);
      CHECK(std::fabs(found.approximation() - x) <= found.radius() + 1e-15);
      CHECK(found.radius() < (std::fabs(x) < 0.2 ? 1e-12 : 0.06));
    }
  CHECK(std::isinf(chart.difference(0, chart.moved(chart.moved(zero, 0, 1), 0, 0.5), zero).radius()));
}

TEST_CASE("round chart: turned directions are cosines and sines, of length 1") {
  for (const double x :
       {0.0, 1e-200, 1e-9, 0.1, 0.2499999, 0.25, 0.2500001, -0.25, 0.5, -0.75, 0.999, 1.0, -1.0})
    for (const double start : {0.0, 0.7, 2.5, -1.6}) {
      const long double angle = static_cast<long double>(start) + static_cast<long double>(x);
      const auto [a, b] = turned({std::cos(start), std::sin(start)}, x);
      // The start is rounded by 2^-53.
      CHECK(std::fabs(static_cast<double>(std::cos(angle) - static_cast<long double>(a))) < 0x1p-49);
      CHECK(std::fabs(static_cast<double>(std::sin(angle) - static_cast<long double>(b))) < 0x1p-49);
      CHECK(std::fabs(a * a + b * b - 1) < 0x1p-50);
    }
}

TEST_CASE("round chart: coordinates that differ") {
  for (const auto& chart : {RoundChart::of(charted()[0], others()[0]).value(),
                            RoundChart::of(charted()[1], others()[0]).value()}) {
    std::mt19937_64 generator(12);
    int count = 0;
    for (int i = 0; i < 400; ++i) {
      const RoundPlace a = random_place(chart, generator);
      const auto number = [&](double most) {
        return std::uniform_real_distribution<double>(-most, most)(generator);
      };
      const double apart = number(1), reach = std::fabs(number(0.99));
      for (const std::size_t k : {0U, 1U}) {
        const RoundPlace b = chart.moved(a, k, apart);
        if (chart.differ(k, a, b, reach)) {
          CHECK(std::fabs(apart) > reach);
          ++count;
        } else {
          CHECK(std::fabs(apart) < 1.3 * reach + 1e-9);
        }
        CHECK_FALSE(chart.differ(k, a, chart.moved(a, k, reach * (1 - 1e-12)), reach));
        CHECK(chart.differ(k, b, a, reach) == chart.differ(k, a, b, reach));
      }
    }
    CHECK(count > 200);
    // Far angles differ, numbers that are none do not.
    CHECK(chart.differ(0, {{RoundCoordinate{1, 0}, RoundCoordinate{1, 0}}},
                       {{RoundCoordinate{-1, 0}, RoundCoordinate{1, 0}}}, 0.9));
    CHECK_FALSE(chart.differ(0, {{RoundCoordinate{std::nan(""), 0}, RoundCoordinate{1, 0}}},
                             {{RoundCoordinate{-1, 0}, RoundCoordinate{1, 0}}}, 0.9));
  }
}

TEST_CASE("round chart: there is nothing at the ends of the range") {
  for (const S& second : {S::cylinder({0, 1, 0}, {3, 1, 1}, 1), S::cone({4, 1, 0}, {0, 1, 3}, Rational(1, 3)),
                          S::sphere({1, 1, 4}, 3)}) {
    const auto chart = RoundChart::of(S::cylinder({1, 1, 0}, oblique, 2), second).value();
    for (const double end : chart.range()) {
      RoundPlace place{{RoundCoordinate{1, 0}, RoundCoordinate{end, 0}}};
      for (int i = 0; i < 64; ++i, place.at[0] = turned(place.at[0], 0.1))
        CHECK(chart.value(place).certain_sign() != 0);
    }
  }
}

TEST_CASE("round chart: none for planes and spheres, common apexes and curves that are not bounded") {
  const S cone = S::cone({0, 0, 0}, up, 1), cylinder = S::cylinder({0, 0, 0}, up, 1);
  CHECK_FALSE(RoundChart::of(S::plane({0, 0, 0}, up), S::sphere({0, 0, 0}, 1)));
  CHECK_FALSE(RoundChart::of(S::plane({0, 0, 0}, {0, 1, 1}), cylinder));
  CHECK_FALSE(RoundChart::of(cone, S::sphere({0, 0, 1}, 1)));
  CHECK_FALSE(RoundChart::of(cylinder, S::cylinder({1, 0, 0}, {0, 0, -2}, 1)));
  CHECK_FALSE(
      RoundChart::of(cylinder, S::cone({5, 0, 0}, {1, 0, 1}, 1)));  // a line of the cone's is parallel
  CHECK_FALSE(RoundChart::of(cone, S::cone({5, 0, 1}, {1, 0, 0}, 1)));
  CHECK_FALSE(RoundChart::of(cone, S::polynomial(SpacePolynomial::variable(0))));
  CHECK(RoundChart::of(cone, S::cone({5, 0, 1}, {0, 0, -1}, 2)));
}

}  // namespace exsect::round_chart_test
