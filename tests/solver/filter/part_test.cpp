#include "filter/part.h"

#include <cmath>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::part_test {
namespace {

using namespace exsect::filter;

/// The curve's value by Bernstein's polynomials, exactly, rounded.
template <std::size_t Count>
Vec3 value(const std::array<Vec3, Count>& p, double t) {
  Vec3 sum{};
  for (std::size_t c = 0; c < 3; ++c) {
    Rational exact = 0, binomial = 1;
    for (std::size_t i = 0; i < Count; ++i) {
      Rational b = binomial;
      for (std::size_t k = 0; k + 1 < Count; ++k) b *= k < i ? from_double(t) : 1 - from_double(t);
      exact += b * from_double(p[i][c]);
      binomial = binomial * static_cast<int>(Count - 1 - i) / static_cast<int>(i + 1);
    }
    sum[c] = to_double(exact);
  }
  return sum;
}

double eighths(random_pairs::Generator& generator, long most) {
  return static_cast<double>(random_pairs::integer(generator, -most, most)) / 8;
}

template <std::size_t Count>
void check_restriction(random_pairs::Generator& generator) {
  std::array<Vec3, Count> p, part;
  for (Vec3& point : p)
    for (double& c : point) c = eighths(generator, 8);
  const double lower = std::fabs(eighths(generator, 4)), upper = lower + 0.5;
  for (std::size_t k = 0; k < Count; ++k) part[k] = restricted_point(p, {lower, upper}, k);
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const Vec3 a = value(part, t), b = value(p, lower + t * (upper - lower));
    for (std::size_t c = 0; c < 3; ++c) CHECK(a[c] == Approx(b[c]).margin(1e-14));
  }
}

/// Row i of the net of bidegree (n,n) for a at the side's place: (x(a,t) - x(0,t)) / a, as the view counts.
template <class K>
void check_field(random_pairs::Generator& generator) {
  CoefficientsOf<K> net;
  for (Row<K>& point : net)
    for (double& c : point) c = eighths(generator, 8);
  for (const std::size_t parameter : {0, 1})
    for (const bool upper : {false, true})
      for (const bool reversed : {false, true}) {
        const SideView view = {{parameter, upper}, reversed, K::degree};
        const AcrossFieldOf<K> field = across_field<K>(net, view);
        const auto row = [&](std::size_t across, double t) {
          std::array<Vec3, K::side> points;
          for (std::size_t j = 0; j < K::side; ++j) points[j] = net[view.index(across, j)];
          return value(points, t);
        };
        for (const double a : {0.125, 0.5, 1.0})
          for (const double t : {0.0, 0.375, 1.0}) {
            std::array<Vec3, K::side> across;
            for (std::size_t i = 0; i < K::side; ++i) across[i] = row(i, t);
            std::array<Vec3, K::degree> of_field;
            for (std::size_t i = 0; i < K::degree; ++i) {
              std::array<Vec3, K::side> points;
              for (std::size_t j = 0; j < K::side; ++j) points[j] = field[K::side * i + j];
              of_field[i] = value(points, t);
            }
            const Vec3 x = value(across, a), on_side = across[0], f = value(of_field, a);
            for (std::size_t c = 0; c < 3; ++c) CHECK((x[c] - on_side[c]) / a == Approx(f[c]).margin(1e-13));
          }
        // Over the whole square the field is itself; over a corner all of it is one vector.
        const AcrossFieldOf<K> whole = restricted<K>(field, {{0, 1}, {0, 1}});
        const AcrossFieldOf<K> corner = restricted<K>(field, {{0, 0}, {1, 1}});
        for (std::size_t i = 0; i < field.size(); ++i)
          for (std::size_t c = 0; c < 3; ++c) {
            CHECK(whole[i][c] == Approx(field[i][c]).margin(1e-14));
            CHECK(corner[i][c] == Approx(field[K::degree][c]).margin(1e-14));
          }
      }
}

}  // namespace

TEST_CASE("part: control points of a curve on an interval", "[filter]") {
  const unsigned seed = 6;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 20; ++round) {
    check_restriction<3>(generator);
    check_restriction<4>(generator);
  }
}

TEST_CASE("part: the field across a side from every side, forwards and backwards", "[filter]") {
  const unsigned seed = 7;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 3; ++round) {
    check_field<Biquadratic>(generator);
    check_field<Bicubic>(generator);
  }
}

TEST_CASE("part: its intervals counted from the side", "[filter]") {
  const Part part = {{{{0.25, 0.5}, {0, 0.125}}}, {}};
  const SideIntervals from_lower = intervals({{0, false}, false, 2}, part);
  CHECK(from_lower.across.lower == 0.25);
  CHECK(from_lower.along.upper == 0.125);
  const SideIntervals from_upper = intervals({{0, true}, true, 2}, part);
  CHECK(from_upper.across.lower == 0.5);
  CHECK(from_upper.across.upper == 0.75);
  CHECK(from_upper.along.lower == 0.875);
  CHECK(from_upper.along.upper == 1);
}

}  // namespace exsect::part_test
