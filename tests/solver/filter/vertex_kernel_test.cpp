#include "filter/vertex_kernel.h"

#include <cmath>
#include <limits>

#include "support/catch.h"

namespace exsect::vertex_kernel_test {
namespace {

using filter::kernel::Lanes;

constexpr int kCount = filter::kVertexBlock;

}  // namespace

TEST_CASE("vertex kernel: what is no number, or beyond the limit, is in doubt, and stays so", "[filter]") {
  Lanes value;
  double doubt[kCount];
  for (int l = 0; l < kCount; ++l) {
    value[l] = 0.5 * (l % 2 == 0 ? 1 : -1);
    doubt[l] = 0;
  }
  value[0] = std::numeric_limits<double>::quiet_NaN();
  value[1] = -1.0000001;
  value[2] = std::numeric_limits<double>::infinity();
  value[3] = -1;
  filter::kernel::mark_beyond(value, 1, doubt);
  for (int l = 0; l < kCount; ++l) CHECK(doubt[l] == (l < 3 ? 1 : 0));
  value = Lanes{};
  filter::kernel::mark_beyond(value, 1, doubt);
  for (int l = 0; l < kCount; ++l) CHECK(doubt[l] == (l < 3 ? 1 : 0));
}

TEST_CASE("vertex kernel: Horner's rule in two variables, exact on small integers", "[filter]") {
  double c[16][3] = {};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) c[4 * i + j][1] = 3 * i - 2 * j + 1;
  Lanes a, b, result;
  for (int l = 0; l < kCount; ++l) {
    a[l] = l - 2;
    b[l] = 3 - l;
  }
  filter::kernel::patch_value<3, 3>(c, 1, a, b, result);
  for (int l = 0; l < kCount; ++l) {
    double sum = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) sum += c[4 * i + j][1] * std::pow(a[l], i) * std::pow(b[l], j);
    const double at = result[l];
    CHECK(at == sum);
  }
}

}  // namespace exsect::vertex_kernel_test
