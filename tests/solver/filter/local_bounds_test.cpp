// The local equations at singular solutions of pairs of every kind: against the patches themselves, and their
// bounds against the solution by Newton's method.
#include "filter/local_bounds.h"

#include <cmath>

#include "filter/exact_patch.h"
#include "support/catch.h"
#include "support/power_nets.h"
#include "support/random_nets.h"

namespace exsect::local_bounds_test {
namespace {

using filter::LocalBounds;
using filter::LocalFormsOf;
using random_pairs::Generator;
using random_pairs::integer;
using testing::PowerNet;
using Vector2 = std::array<double, 2>;

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}

HomogeneousPoint combination(const Rational& a, const HomogeneousPoint& p, const Rational& b,
                             const HomogeneousPoint& q) {
  HomogeneousPoint r;
  for (std::size_t k = 0; k < 4; ++k) r[k] = a * p[k] + b * q[k];
  return r;
}

/// Patches with one point and one tangent plane in their middles, by Taylor coefficients there.
struct Tangent {
  PowerNet x;
  PowerNet y;
  RationalPatch first() const { return testing::power_patch(x, Rational(-1, 2), Rational(1, 2)); }
  RationalPatch second() const { return testing::power_patch(y, Rational(-1, 2), Rational(1, 2)); }
};

template <class K>
Tangent tangent_patches(Generator& generator) {
  const auto weight = [&] { return K::weighted ? sixteenths(generator, 2) : Rational(0); };
  const auto vector = [&] {
    return HomogeneousPoint{sixteenths(generator, 4), sixteenths(generator, 4), sixteenths(generator, 4),
                            weight()};
  };
  const auto net = [&] {
    PowerNet c(K::side);
    for (auto& row : c)
      for (std::size_t j = 0; j < K::side; ++j) row.push_back(vector());
    return c;
  };
  Tangent pair{net(), net()};
  pair.x[0][0] = {sixteenths(generator, 8), sixteenths(generator, 8), sixteenths(generator, 8), 1};
  pair.x[1][0][0] += 1;
  pair.x[0][1][1] += 1;
  const Rational scale = K::weighted ? Rational(5, 4) : Rational(1);
  pair.y[0][0] = combination(scale, pair.x[0][0], 0, pair.x[0][0]);
  pair.y[1][0] = combination(Rational(1), pair.x[1][0], sixteenths(generator, 8), pair.x[0][1]);
  pair.y[0][1] = combination(sixteenths(generator, 8), pair.x[1][0], Rational(3, 4), pair.x[0][1]);
  pair.y[1][0] = combination(1, pair.y[1][0], weight(), pair.x[0][0]);
  pair.y[0][1] = combination(1, pair.y[0][1], weight(), pair.x[0][0]);
  return pair;
}

template <class K>
filter::ExactPatch<K> exact_patch(const RationalPatch& patch) {
  if constexpr (std::is_same_v<K, filter::Biquadratic>) {
    return patch.biquadratic().value();
  } else {
    return filter::elevated<K>(patch);
  }
}

template <class K>
LocalFormsOf<K> forms_of(const Tangent& pair) {
  const Rational half(1, 2);
  return filter::local_forms<K>(exact_patch<K>(pair.first()), exact_patch<K>(pair.second()),
                                {half, half, half, half})
      .value();
}

struct Value {
  double value = 0;
  double first = 0;
  double second = 0;
};
template <class K>
Value evaluate(const filter::ScalarTableOf<K>& c, std::size_t least, const Vector2& at) {
  Value v;
  for (std::size_t k = 1; k < K::count; ++k) {
    const int i = static_cast<int>(k / K::side);
    const int j = static_cast<int>(k % K::side);
    if (i + j < static_cast<int>(least)) continue;
    v.value += c[k] * std::pow(at[0], i) * std::pow(at[1], j);
    if (i > 0) v.first += c[k] * i * std::pow(at[0], i - 1) * std::pow(at[1], j);
    if (j > 0) v.second += c[k] * j * std::pow(at[0], i) * std::pow(at[1], j - 1);
  }
  return v;
}

/// c and its derivatives by t over one t, by iteration; and g, its derivatives.
struct Local {
  Vector2 a;
  Vector2 c = {};
  std::array<Vector2, 2> slope;
  double g;
  Vector2 g_slope;
};

template <class K>
Local solve(const LocalFormsOf<K>& f, const Vector2& t) {
  Local l;
  l.a = {f.s[0][0] * t[0] + f.s[0][1] * t[1], f.s[1][0] * t[0] + f.s[1][1] * t[1]};
  std::array<Value, 2> x;
  std::array<Value, 2> y;
  Value xi;
  const Value upsilon = evaluate<K>(f.weight_y, 1, l.a);
  for (int step = 0; step < 100; ++step) {
    xi = evaluate<K>(f.weight_x, 2, l.c);
    for (std::size_t i = 0; i < 2; ++i) {
      x[i] = evaluate<K>(f.x[i], 2, l.c);
      y[i] = evaluate<K>(f.y[i], 1, l.a);
    }
    for (std::size_t i = 0; i < 2; ++i)
      l.c[i] = (1 + xi.value) / (1 + upsilon.value) * y[i].value - x[i].value;
  }
  const Value nx = evaluate<K>(f.normal_x, 2, l.c);
  const Value ny = evaluate<K>(f.normal_y, 2, l.a);
  const double of_x = 1 + xi.value;
  const double of_y = 1 + upsilon.value;
  l.g = nx.value * of_y - of_x * ny.value;
  // c_i + X_i - (of_x / of_y) Y_i = 0, differentiated.
  std::array<Vector2, 2> m;
  for (std::size_t i = 0; i < 2; ++i)
    m[i] = {(i == 0 ? 1 : 0) + x[i].first - xi.first * y[i].value / of_y,
            (i == 1 ? 1 : 0) + x[i].second - xi.second * y[i].value / of_y};
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  for (std::size_t k = 0; k < 2; ++k) {
    const auto along = [&](const Value& v) { return v.first * f.s[0][k] + v.second * f.s[1][k]; };
    Vector2 right;
    for (std::size_t i = 0; i < 2; ++i)
      right[i] = of_x / of_y * (along(y[i]) - y[i].value * along(upsilon) / of_y);
    l.slope[0][k] = (m[1][1] * right[0] - m[0][1] * right[1]) / determinant;
    l.slope[1][k] = (m[0][0] * right[1] - m[1][0] * right[0]) / determinant;
    const auto by_c = [&](const Value& v) { return v.first * l.slope[0][k] + v.second * l.slope[1][k]; };
    l.g_slope[k] = by_c(nx) * of_y + nx.value * along(upsilon) - by_c(xi) * ny.value - of_x * along(ny);
  }
  return l;
}

/// The largest of the quotients of what is bounded by its bound, but for rounding.
template <class K>
double sharpness(const LocalFormsOf<K>& f, const LocalBounds& bounds, const Vector2& t) {
  const double size = std::max(std::fabs(t[0]), std::fabs(t[1]));
  const Local l = solve<K>(f, t);
  const double q = f.crossing ? t[0] * t[1] : t[0] * t[0] + t[1] * t[1];
  const Vector2 slope = {f.crossing ? t[1] : 2 * t[0], f.crossing ? t[0] : 2 * t[1]};
  const double rounding = 1e-13;
  double worst = std::fabs(l.g - q) / (bounds.value * size * size * size + f.rest * size * size + rounding);
  for (std::size_t i = 0; i < 2; ++i) {
    worst = std::max(worst, std::fabs(l.c[i]) / (bounds.k[i] * size + rounding));
    worst = std::max(worst, std::fabs(l.g_slope[i] - slope[i]) /
                                (bounds.slope * size * size + 2 * f.rest * size + rounding));
    for (std::size_t j = 0; j < 2; ++j)
      worst = std::max(worst, std::fabs(l.slope[i][j] - f.bs[i][j]) / (bounds.turn[i] * size + rounding));
  }
  return worst;
}

/// Over all t up to reaches for which there are bounds, of which there is one.
template <class K>
double sharpness(const LocalFormsOf<K>& forms, Generator& generator) {
  const auto unit = [&] { return static_cast<double>(integer(generator, -1000, 1000)) / 1000; };
  double worst = 0;
  for (double reach = 0x1p-2; reach > 0x1p-12; reach *= 0.5) {
    const auto bounds = filter::local_bounds<K>(forms, reach);
    for (int i = 0; bounds && i < 20; ++i)
      worst = std::max(worst, sharpness<K>(forms, *bounds, {unit() * reach, unit() * reach}));
  }
  CHECK(worst > 0);
  return worst;
}

/// The homogeneous vector at offsets from the middle, about the pair's point, in three coordinates: along x_u
/// and x_v, and the weight; and along n.
struct Seen {
  std::array<double, 3> tangential;
  double normal;
};
Seen seen(const RationalPatch& patch, const Vector2& offset, const PowerNet& x) {
  const auto p =
      patch.homogeneous_at(Rational(1, 2) + from_double(offset[0]), Rational(1, 2) + from_double(offset[1]));
  const auto about = [&](const HomogeneousPoint& a) {
    Point v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = a[k] - a[3] * x[0][0][k];
    return v;
  };
  const Point u = about(x[1][0]);
  const Point v = about(x[0][1]);
  return {{to_double(dot(about(p), u)), to_double(dot(about(p), v)), to_double(p[3])},
          to_double(dot(about(p), cross(u, v)))};
}

/// At solutions of the first two equations both points are on one line along n, on one side or the other as g
/// says.
template <class K>
void check_against_patches(const Tangent& pair, Generator& generator) {
  const auto forms = forms_of<K>(pair);
  const auto unit = [&] { return static_cast<double>(integer(generator, -1000, 1000)) / 64000; };
  double factor = 0;  // of g
  for (int i = 0; i < 6; ++i) {
    const Local l = solve<K>(forms, {unit() + 1 / 64., unit()});
    const Seen a = seen(pair.first(), l.c, pair.x);
    const Seen b = seen(pair.second(), l.a, pair.x);
    for (std::size_t k = 0; k < 2; ++k)
      CHECK(std::fabs(a.tangential[k] * b.tangential[2] - b.tangential[k] * a.tangential[2]) < 1e-12);
    const double above = a.normal / a.tangential[2] - b.normal / b.tangential[2];
    const double of_x = 1 + evaluate<K>(forms.weight_x, 2, l.c).value;
    const double of_y = 1 + evaluate<K>(forms.weight_y, 1, l.a).value;
    // N X/e0 X - N Y/e0 Y is g/(e0 X e0 Y): affine coordinates with e0 = 0 at infinity and with X_4 = 0 there
    // differ on a line along n by a factor.
    const double ratio = l.g / (of_x * of_y) / (above * a.tangential[2] / of_x);
    if (i > 0) CHECK(ratio == Approx(factor).epsilon(1e-7));
    factor = ratio;
  }
}

template <class K>
void check_kind(int count) {
  for (int seed = 1; seed <= count; ++seed) {
    INFO("seed " << seed << ", degree " << K::degree << ", rows " << K::rows);
    Generator generator(static_cast<std::uint64_t>(seed));
    const Tangent pair = tangent_patches<K>(generator);
    const double worst = sharpness<K>(forms_of<K>(pair), generator);
    CHECK(worst <= 1);
    check_against_patches<K>(pair, generator);
  }
}

}  // namespace

TEST_CASE(
    "filter local bounds: they hold for the solution of the equations, which are those of the patches") {
  check_kind<filter::Biquadratic>(20);
  check_kind<filter::Bicubic>(20);
  check_kind<filter::WeightedBiquadratic>(20);
  check_kind<filter::WeightedBicubic>(20);
}

TEST_CASE("filter local bounds: graphs over the tangent plane, where they are sharp") {
  const HomogeneousPoint zero = {0, 0, 0, 0};
  const auto plane = [&](std::size_t n, const Rational& weight) {
    PowerNet c(n + 1, std::vector<HomogeneousPoint>(n + 1, zero));
    c[0][0] = {0, 0, 0, 1};
    c[1][0] = {1, 0, 0, weight};
    c[0][1] = {0, 1, 0, 0};
    return c;
  };
  const auto check = [&]<class K>(K, const Tangent& pair, double least) {
    for (const Tangent& each : {pair, Tangent{pair.y, pair.x}}) {
      Generator generator(1);
      const double worst = sharpness<K>(forms_of<K>(each), generator);
      CHECK(worst <= 1);
      CHECK(worst > least);
    }
  };
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    Tangent pair{plane(2, 0), plane(2, 0)};
    pair.x[2][0][2] = 1;
    pair.x[0][2][2] = seed % 2 == 0 ? 1 : -1;
    pair.x[1][2][2] = 1 + sixteenths(generator, 8);
    pair.x[2][1][2] = 1 + sixteenths(generator, 8);
    check(filter::Biquadratic(), pair, 0.25);
    pair.x[1][2][2] = pair.x[2][1][2] = 0;
    pair.y = plane(2, Rational(integer(generator, 4, 16), 16));
    check(filter::WeightedBiquadratic(), pair, 0.1);
    pair.y = pair.x;  // on a plane whose weight has second derivatives
    pair.x = plane(2, 0);
    pair.x[2][0][3] = pair.x[0][2][3] = Rational(integer(generator, 4, 16), 16);
    check(filter::WeightedBiquadratic(), pair, 0.1);
    pair = {plane(3, 0), plane(3, 0)};
    pair.x[2][0][2] = 1;
    pair.x[0][2][2] = seed % 2 == 0 ? 1 : -1;
    pair.x[3][0][2] = pair.x[0][3][2] = 1 + sixteenths(generator, 8);
    check(filter::Bicubic(), pair, 0.25);
  }
}

}  // namespace exsect::local_bounds_test
