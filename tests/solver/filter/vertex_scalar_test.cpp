#include "filter/vertex_scalar.h"

#include <cmath>

#include "support/catch.h"

namespace exsect::vertex_scalar_test {

TEST_CASE("vertices one by one: a straight line on a plane, exactly", "[filter]") {
  // w(tau) = (tau, 2 tau, tau, 2 tau), x = (1/2 + h, 1/4 + k, 0) scaled by 4 about (10, 20, 30).
  filter::VertexFormsOf<2, 3> forms{};
  const double along[4] = {1, 2, 1, 2};
  for (int j = 0; j < 4; ++j) forms.series[0][j] = along[j];
  forms.space[0][0] = 0.5;
  forms.space[0][1] = 0.25;
  forms.space[3][0] = 1;
  forms.space[1][1] = 1;
  forms.origin[0] = 10;
  forms.origin[1] = 20;
  forms.origin[2] = 30;
  forms.scale = 4;
  for (int i = 0; i < 3; ++i) forms.others[i] = i + 1;
  for (double& c : forms.farthest) c = 1;
  forms.greatest = 1;
  filter::VertexBlock block{};
  for (int l = 0; l < filter::kVertexBlock; ++l) block.tau[l] = 0.03125 * l;
  filter::evaluate_vertices_scalar(forms, block);
  for (int l = 0; l < filter::kVertexBlock; ++l) {
    const double tau = block.tau[l];
    for (int j = 0; j < 4; ++j) CHECK(block.parameters[j][l] == 0.5 + along[j] * tau);
    CHECK(block.point[0][l] == 10 + 4 * (0.5 + tau));
    CHECK(block.point[1][l] == 20 + 4 * (0.25 + 2 * tau));
    CHECK(block.point[2][l] == 30);
    CHECK(block.doubt[l] == 0);
  }
}

}  // namespace exsect::vertex_scalar_test
