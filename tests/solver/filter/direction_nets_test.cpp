#include "filter/direction_nets.h"

#include <algorithm>
#include <cmath>

#include "filter/exact_patch.h"
#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::direction_nets_test {
namespace {

using filter::Vec;
using random_pairs::Generator;

double binomial(std::size_t n, std::size_t k) {
  double result = 1;
  for (std::size_t i = 1; i <= k; ++i)
    result = result * static_cast<double>(n + 1 - i) / static_cast<double>(i);
  return result;
}

double bernstein(std::size_t n, std::size_t i, double t) {
  return binomial(n, i) * std::pow(t, static_cast<double>(i)) * std::pow(1 - t, static_cast<double>(n - i));
}

/// The vector polynomial of bidegree (m,n) with these control vectors.
template <std::size_t Rows, std::size_t Count>
Vec<Rows> value(const std::array<Vec<Rows>, Count>& net, std::size_t m, std::size_t n, double s, double t) {
  Vec<Rows> sum{};
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t c = 0; c < Rows; ++c)
        sum[c] += bernstein(m, i, s) * bernstein(n, j, t) * net[(n + 1) * i + j][c];
  return sum;
}

/// Its derivative by s (0) or t (1), divided by the degree.
template <std::size_t Rows, std::size_t Count>
Vec<Rows> derivative(const std::array<Vec<Rows>, Count>& net, std::size_t n, std::size_t by, double s,
                     double t) {
  Vec<Rows> sum{};
  for (std::size_t i = 0; i + (by == 0) <= n; ++i)
    for (std::size_t j = 0; j + (by == 1) <= n; ++j) {
      const auto& from = net[(n + 1) * i + j];
      const auto& to = by == 0 ? net[(n + 1) * (i + 1) + j] : net[(n + 1) * i + j + 1];
      const double weight = bernstein(by == 0 ? n - 1 : n, i, s) * bernstein(by == 1 ? n - 1 : n, j, t);
      for (std::size_t c = 0; c < Rows; ++c) sum[c] += weight * (to[c] - from[c]);
    }
  return sum;
}

/// By Leibniz' formula.
template <std::size_t N>
double determinant(const std::array<Vec<N>, N>& rows) {
  std::array<std::size_t, N> order;
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  double sum = 0;
  do {
    double term = 1;
    for (std::size_t i = 0; i < N; ++i) {
      term *= rows[i][order[i]];
      for (std::size_t k = 0; k < i; ++k) term = order[k] > order[i] ? -term : term;
    }
    sum += term;
  } while (std::next_permutation(order.begin(), order.end()));
  return sum;
}

template <class K>
filter::ExactPatch<K> exact_patch(const RationalPatch& patch) {
  if constexpr (std::is_same_v<K, filter::Biquadratic>) {
    return *patch.biquadratic();
  } else {
    return filter::elevated<K>(patch);
  }
}

template <class K>
std::array<filter::Row<K>, filter::NormalNetOf<K>::count> vectors_of(const filter::NormalNetOf<K>& net) {
  std::array<filter::Row<K>, filter::NormalNetOf<K>::count> result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = net.vector(k);
  return result;
}

/// Corners of the net of normals are those computed from the corners alone, in the order of the net; a change
/// of sign there is one among all products, found here one by one.
template <class K>
void check_corners(const filter::DirectionNetOf<K>& d, const filter::NormalNetOf<K>& net,
                   const std::array<filter::Row<K>, 4>& normals) {
  constexpr std::size_t n = K::degree;
  constexpr std::size_t m = filter::NormalNetOf<K>::side;  // vectors along one
  constexpr std::array<std::size_t, 4> last = {0, m - 1, m * (m - 1), m * m - 1};
  bool positive = false, negative = false;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t c = 0; c < K::rows; ++c)
      CHECK(std::fabs(normals[k][c] - net.coordinate[c][last[k]]) <= net.error + 1e-13);
    for (const std::size_t corner : {std::size_t{0}, n, (n + 1) * n, (n + 1) * (n + 1) - 1}) {
      const double product = filter::dot(d.vectors[corner], normals[k]);
      positive = positive || product > 0;
      negative = negative || product < 0;
    }
  }
  CHECK(filter::changes_sign<K>(d, normals) == (positive && negative));
  if (positive && negative) CHECK_FALSE(filter::never_orthogonal<K>(d, net));
}

template <class K>
void check_nets(std::array<int, 4> degrees) {
  constexpr std::size_t n = K::degree;
  constexpr std::size_t normal_degree = (K::weighted ? 3 * n - 2 : 2 * n - 1);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_nets::Nets nets = random_nets::scattered(generator, degrees);
    const auto patch = [&](const random_nets::Net& net) {
      return K::weighted ? random_nets::weighted(generator, net) : RationalPatch(net);
    };
    const auto pair = filter::make_pair_of<K>(exact_patch<K>(patch(nets.x)), exact_patch<K>(patch(nets.y)));
    REQUIRE(pair);
    filter::PatchTreeOf<K> xs(pair->x, pair->net_error);
    filter::PatchTreeOf<K> ys(pair->y, pair->net_error);
    std::size_t node = 0;
    for (std::uint64_t level = 0; level < seed % 4; ++level) {
      xs.split(node);
      node = ys.split(node) + generator() % 4;
    }
    const filter::SubPatchOf<K> y = ys[node];
    const filter::SubPatchOf<K> x = xs[0];
    const std::array<double, 2> c = {0.6, seed % 2 == 0 ? 0.8 : -0.8};
    const auto d = filter::direction_net<K>(x, c, pair->net_error);
    const auto normals = filter::normal_net<K>(y, pair->net_error);
    check_corners<K>(d, normals, filter::corner_normals<K>(y));
    for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.25}, {0.3125, 0.6875}, {0.75, 1.0}, {0.5, 0.5}}) {
      CAPTURE(s, t);
      const auto along = value<K::rows>(d.vectors, n, n, s, t);
      const auto xu = derivative<K::rows>(x.net, n, 0, s, t);
      const auto xv = derivative<K::rows>(x.net, n, 1, s, t);
      for (std::size_t i = 0; i < K::rows; ++i)
        CHECK(std::fabs(along[i] - (c[0] * xv[i] - c[1] * xu[i])) <= d.error + 1e-14);
      const auto normal = value<K::rows>(vectors_of<K>(normals), normal_degree, normal_degree, s, t);
      for (std::size_t i = 0; i < K::rows; ++i) {
        std::array<Vec<K::rows>, K::rows> rows{};
        rows[0][i] = 1;
        if constexpr (K::weighted) rows[1] = value<K::rows>(y.net, n, n, s, t);
        rows[K::rows - 2] = derivative<K::rows>(y.net, n, 0, s, t);
        rows[K::rows - 1] = derivative<K::rows>(y.net, n, 1, s, t);
        CHECK(std::fabs(normal[i] - determinant(rows)) <= normals.error + 1e-13);
        CHECK(std::fabs(normal[i]) <= normals.size + 1e-13);
      }
    }
  }
}

}  // namespace

TEST_CASE("filter direction nets: polynomials agree with derivatives and determinants") {
  check_nets<filter::Biquadratic>({2, 2, 2, 2});
  check_nets<filter::Bicubic>({3, 3, 3, 2});
  check_nets<filter::WeightedBiquadratic>({2, 2, 2, 1});
  check_nets<filter::WeightedBicubic>({3, 3, 2, 3});
}

}  // namespace exsect::direction_nets_test
