#include "filter/vertex_lanes.h"

#include <cmath>
#include <random>

#include "filter/vertex_scalar.h"
#include "support/catch.h"

namespace exsect::vertex_lanes_test {
namespace {

using namespace exsect::filter;

template <int Degree, int Rows>
VertexFormsOf<Degree, Rows> random_forms(std::mt19937& generator) {
  std::uniform_real_distribution<double> any(-1, 1);
  VertexFormsOf<Degree, Rows> forms{};
  for (auto* table : {&forms.g, &forms.h, &forms.space})
    for (auto& row : *table)
      for (double& c : row) c = any(generator);
  for (auto& row : forms.series)
    for (double& c : row) c = any(generator);
  for (double& c : forms.centre) c = 0.5 * any(generator);
  if (Rows == 4) {
    forms.space[0][Rows - 1] = 40;  // the weight is positive
  }
  for (double& c : forms.origin) c = 100 * any(generator);
  forms.scale = std::exp2(3 * any(generator));
  for (int i = 0; i < Rows; ++i) forms.others[i] = i;  // the last unknown is the axis
  for (double& c : forms.farthest) c = 10;
  forms.greatest = 100;
  return forms;
}

template <int Degree, int Rows>
using Table = double[(Degree + 1) * (Degree + 1)][Rows];

/// sum c[side i + j][row] a^i b^j, term by term, from the highest order down.
template <int Degree, int Rows>
long double value(const Table<Degree, Rows>& c, int row, long double a, long double b) {
  long double sum = 0;
  for (int i = 0; i <= Degree; ++i)
    for (int j = 0; j <= Degree; ++j)
      sum += c[(Degree + 1) * i + j][row] * std::pow(a, static_cast<long double>(i)) *
             std::pow(b, static_cast<long double>(j));
  return sum;
}

template <int Degree, int Rows>
void check_block(const VertexFormsOf<Degree, Rows>& forms, const VertexBlock& block) {
  for (int l = 0; l < kVertexBlock; ++l) {
    const long double tau = block.tau[l];
    long double w[Rows + 1];
    for (int j = 0; j <= Rows; ++j) {
      w[j] = 0;
      for (int k = 0; k < kSeriesDegree; ++k)
        w[j] += forms.series[k][j] * std::pow(tau, static_cast<long double>(k + 1));
    }
    long double step[Rows];
    for (int row = 0; row < Rows; ++row) {
      const long double scale = Rows == 4 ? 1 + w[4 % (Rows + 1)] : 1;
      step[row] = value<Degree, Rows>(forms.g, row, w[0], w[1]) +
                  scale * value<Degree, Rows>(forms.h, row, w[2], w[3]);
    }
    for (int row = 0; row < Rows; ++row) w[forms.others[row]] -= step[row];
    for (int j = 0; j < 4; ++j)
      CHECK(block.parameters[j][l] ==
            Approx(static_cast<double>(forms.centre[j] + w[j] + 0.5)).margin(1e-12));
    const long double weight = Rows == 4 ? value<Degree, Rows>(forms.space, Rows - 1, w[0], w[1]) : 1;
    for (int c = 0; c < 3; ++c)
      CHECK(
          block.point[c][l] ==
          Approx(static_cast<double>(forms.origin[c] +
                                     forms.scale * value<Degree, Rows>(forms.space, c, w[0], w[1]) / weight))
              .epsilon(1e-10)
              .margin(1e-10));
    CHECK(block.doubt[l] == 0);
  }
}

template <int Degree, int Rows>
void check(unsigned seed) {
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(-0.25, 0.25);
  for (int round = 0; round < 50; ++round) {
    auto forms = random_forms<Degree, Rows>(generator);
    VertexBlock block{};
    for (double& tau : block.tau) tau = any(generator);
    VertexBlock again = block;
    evaluate_vertices_scalar(forms, block);
    check_block(forms, block);
    // Beyond a limit, or no number: in doubt.
    forms.greatest = 0;
    block.tau[0] = std::nan("");
    evaluate_vertices_scalar(forms, block);
    for (const double doubt : block.doubt) CHECK(doubt == 1);
#ifdef __x86_64__
    if (!__builtin_cpu_supports("avx2")) continue;
    VertexBlock lanes = again;
    forms.greatest = 100;
    evaluate_vertices_scalar(forms, again);
    evaluate_vertices_lanes(forms, lanes);
    for (int l = 0; l < kVertexBlock; ++l) {
      for (int j = 0; j < 4; ++j) CHECK(lanes.parameters[j][l] == again.parameters[j][l]);
      for (int c = 0; c < 3; ++c) CHECK(lanes.point[c][l] == again.point[c][l]);
      CHECK(lanes.doubt[l] == again.doubt[l]);
    }
#endif
  }
}

}  // namespace

TEST_CASE("vertices: one by one and in vector registers the same, and what the formulas say", "[filter]") {
  check<2, 3>(1);
  check<3, 3>(2);
  check<2, 4>(3);
  check<3, 4>(4);
}

}  // namespace exsect::vertex_lanes_test
