#include "filter/homogeneous.h"

#include "filter/exact_taylor.h"
#include "support/catch.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"

namespace exsect::homogeneous_test {
namespace {

using namespace exsect::filter;

Rational place(random_pairs::Generator& generator) { return {random_pairs::integer(generator, 0, 64), 64}; }

/// Of bidegree (n,n), points and weights multiples of 1/8, the weights positive.
template <class K>
ElevatedPatch<K> random_patch(random_pairs::Generator& generator) {
  ElevatedPatch<K> patch;
  for (std::size_t i = 0; i < K::count; ++i) {
    for (Rational& c : patch.points[i]) c = Rational(random_pairs::integer(generator, -16, 16), 8);
    patch.weights[i] = K::weighted ? Rational(random_pairs::integer(generator, 1, 8), 8) : Rational(1);
  }
  return patch;
}

/// The homogeneous value by Bernstein's polynomials.
template <class K>
HomogeneousPoint value(const ElevatedPatch<K>& patch, const Rational& u, const Rational& v) {
  const auto bernstein = [](std::size_t i, const Rational& t) {
    Rational b = K::degree == 2 ? (i == 1 ? 2 : 1) : (i == 1 || i == 2 ? 3 : 1);
    for (std::size_t k = 0; k < K::degree; ++k) b *= k < i ? t : 1 - t;
    return b;
  };
  HomogeneousPoint sum{};
  for (std::size_t i = 0; i < K::side; ++i)
    for (std::size_t j = 0; j < K::side; ++j)
      sum = combined(1, sum, bernstein(i, u) * bernstein(j, v), homogeneous<K>(patch, K::side * i + j));
  return sum;
}

template <class K>
void check_kind(unsigned seed) {
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 10; ++round) {
    const ElevatedPatch<K> patch = random_patch<K>(generator);
    const Rational u = place(generator), v = place(generator);
    const FirstOrder<K> first(patch, u, v);
    CHECK(first.value == value<K>(patch, u, v));
    // The Taylor polynomial is the patch, exactly, at any distance; its linear terms are n times the
    // tangents.
    const ExactTaylor<K> taylor = exact_taylor<K>(patch, u, v);
    const Rational h = place(generator), k = place(generator) * 3;
    const HomogeneousPoint there = value<K>(patch, u + h, v + k);
    for (std::size_t c = 0; c < K::rows; ++c) {
      Rational sum = 0, h_i = 1;
      for (std::size_t i = 0; i < K::side; ++i, h_i *= h) {
        Rational term = h_i;
        for (std::size_t j = 0; j < K::side; ++j, term *= k) sum += taylor[K::side * i + j][c] * term;
      }
      CHECK(sum == there[c]);
      CHECK(taylor[kFirst<K>][c] == static_cast<int>(K::degree) * first.derivative[0][c]);
      CHECK(taylor[kSecond][c] == static_cast<int>(K::degree) * first.derivative[1][c]);
    }
  }
}

}  // namespace

TEST_CASE("homogeneous: values, tangents and Taylor polynomials, exactly", "[filter]") {
  check_kind<Bicubic>(1);
  check_kind<WeightedBiquadratic>(2);
  check_kind<WeightedBicubic>(3);
}

TEST_CASE("homogeneous: the determinant, and when two vectors are one point", "[filter]") {
  const unsigned seed = 4;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int round = 0; round < 50; ++round) {
    std::array<HomogeneousPoint, 4> a;
    for (HomogeneousPoint& p : a)
      for (Rational& c : p) c = random_pairs::integer(generator, -9, 9);
    // By the first column.
    const auto det3 = [](const HomogeneousPoint& p, const HomogeneousPoint& q, const HomogeneousPoint& r) {
      return p[1] * (q[2] * r[3] - q[3] * r[2]) - p[2] * (q[1] * r[3] - q[3] * r[1]) +
             p[3] * (q[1] * r[2] - q[2] * r[1]);
    };
    const Rational right = a[0][0] * det3(a[1], a[2], a[3]) - a[1][0] * det3(a[0], a[2], a[3]) +
                           a[2][0] * det3(a[0], a[1], a[3]) - a[3][0] * det3(a[0], a[1], a[2]);
    CHECK(determinant(a[0], a[1], a[2], a[3]) == right);
    CHECK(determinant(a[1], a[0], a[2], a[3]) == -right);
    CHECK(determinant(a[0], combined(1, a[1], 3, a[0]), a[2], a[3]) == right);
    a[0][3] = 2;
    CHECK(is_same_point(a[0], combined(Rational(-7, 3), a[0], 0, a[0])));
    CHECK_FALSE(is_same_point(a[0], combined(1, a[0], 1, {1, 0, 0, 0})));
  }
}

}  // namespace exsect::homogeneous_test
