#include "filter/mean_derivatives.h"

#include <cmath>

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::mean_derivatives_test {
namespace {

using namespace exsect::filter;

double in(random_pairs::Generator& generator, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(random_pairs::integer(generator, 0, 64)) / 64;
}

/// x of the pair in its scaled coordinates, at centred parameters, exactly.
Vec3 scaled(const Pair& pair, const BezierPatch& x, double h, double k) {
  const Point p = x(from_double(h) + Rational(1, 2), from_double(k) + Rational(1, 2));
  Vec3 result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = to_double((p[c] - from_double(pair.frame.origin[c])) * power_of_two(-pair.frame.exponent));
  return result;
}

}  // namespace

TEST_CASE("mean derivatives: difference quotients over segments, and values, are within them", "[filter]") {
  const unsigned seed = 8;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  double used = 0;  // how much of the deviation is needed, at most
  for (int round = 0; round < 30; ++round) {
    const random_pairs::Pair p = random_pairs::scattered(generator);
    const Pair pair = make_pair(p.x, p.y).value();
    filter::Rectangle where{};
    for (std::size_t j = 0; j < 2; ++j) {
      where.lower[j] = in(generator, -0.5, 0.25);
      where.upper[j] = where.lower[j] + 0.25;
    }
    const auto expansion = expand<Biquadratic>(pair.x, where);
    REQUIRE(expansion);
    const Row<Biquadratic> row = {in(generator, -1, 1), in(generator, -1, 1), in(generator, -1, 1)};
    const MeanDerivative first = mean_first<Biquadratic>(*expansion, row),
                         second = mean_second<Biquadratic>(*expansion, row),
                         value = mean_value<Biquadratic>(*expansion, row);
    const double error = 1e-14;
    for (int k = 0; k < 20; ++k) {
      const double a = in(generator, where.lower[0], where.upper[0] - 0.0625),
                   b = in(generator, where.lower[1], where.upper[1] - 0.0625);
      const double da = where.upper[0] - a, db = where.upper[1] - b;
      const Vec3 at = scaled(pair, p.x, a, b);
      const double in_u = filter::dot(row, scaled(pair, p.x, a + da, b) - at) / da;
      const double in_v = filter::dot(row, scaled(pair, p.x, a, b + db) - at) / db;
      CHECK(std::fabs(in_u - first.middle) <= first.deviation + error / da);
      CHECK(std::fabs(in_v - second.middle) <= second.deviation + error / db);
      CHECK(std::fabs(filter::dot(row, at) - value.middle) <= value.deviation + error);
      used = std::max(used, std::fabs(in_u - first.middle) / first.deviation);
    }
  }
  CHECK(used > 0.3);
}

}  // namespace exsect::mean_derivatives_test
