#include "filter/tube_columns.h"

#include <cmath>
#include <random>

#include "known_curve.h"

namespace exsect::tube_columns_test {
namespace {

using namespace filter;  // NOLINT(google-build-using-namespace): kinds and vectors

template <std::size_t N>
std::array<Vec<N>, N> random_columns(std::mt19937& generator) {
  std::uniform_real_distribution<double> any(-1, 1);
  std::array<Vec<N>, N> columns;
  for (auto& column : columns)
    for (double& c : column) c = any(generator);
  return columns;
}

template <std::size_t N>
void check_inverses(unsigned seed) {
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  for (int round = 0; round < 100; ++round) {
    auto columns = random_columns<N>(generator);
    std::array<Vec<N>, N> rows;
    REQUIRE(invert(columns, rows));
    double size = 0;
    for (const auto& row : rows) size = std::max(size, largest(row));
    for (std::size_t j = 0; j < N; ++j) {
      const Vec<N> unit = product(rows, columns[j]);
      for (std::size_t i = 0; i < N; ++i) CHECK(std::fabs(unit[i] - (i == j ? 1 : 0)) < 1e-12 * (1 + size));
    }
    columns[N - 1] = columns[0];
    CHECK_FALSE((invert(columns, rows) && largest(rows[0]) < 1e12));  // dependent: refused, or of no use
    columns[N - 1] = {};
    CHECK_FALSE(invert(columns, rows));
    columns[N - 1] = std::nan("") * columns[0];
    CHECK_FALSE(invert(columns, rows));
  }
}

}  // namespace

TEST_CASE("tube columns: inverses of three and of four columns", "[filter]") {
  check_inverses<3>(20321);
  check_inverses<4>(20322);
}

TEST_CASE("tube columns: the other unknowns are those but the axis, in order", "[filter]") {
  for (std::size_t axis = 0; axis < 4; ++axis) {
    std::size_t next = 0;
    for (const std::size_t j : kOthers<WeightedBicubic>[axis]) {
      if (next == axis) ++next;
      CHECK(j == next++);
    }
    CHECK(kOthers<Biquadratic>[axis].size() == 3);
  }
}

TEST_CASE("tube columns: C makes unit vectors of the columns but the axis", "[filter]") {
  const testing::KnownCurve curve(testing::kHyperbola);
  const Vec4 at = testing::KnownCurve::centred(0.5, 0.5);
  const auto x = expand(curve.pair.x, at[0], at[1]), y = expand(curve.pair.y, at[2], at[3]);
  const auto columns = columns_of<Biquadratic>(x[3], x[1], y[0], y[3], y[1], at);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    std::array<Vec3, 3> c;
    REQUIRE(invert_others<Biquadratic>(columns, axis, c));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 unit = product(c, columns[kOthers<Biquadratic>[axis][i]]);
      for (std::size_t row = 0; row < 3; ++row) CHECK(unit[row] == Approx(row == i ? 1 : 0).margin(1e-14));
    }
  }
  CHECK(within_reach<Biquadratic>(at));
  CHECK_FALSE(within_reach<Biquadratic>({0, 0.76, 0, 0}));
  CHECK_FALSE(within_reach<Biquadratic>({0, std::nan(""), 0, 0}));
}

}  // namespace exsect::tube_columns_test
