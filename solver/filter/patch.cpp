#include "filter/patch.h"

#include <algorithm>
#include <cmath>

namespace exsect::filter {

namespace {

/// The control net in doubles; `exact` becomes false if a coordinate is not known to be a double.
std::array<Vec3, 9> rounded(const BezierPatch& patch, bool& exact) {
  std::array<Vec3, 9> net;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const NearestDouble d = nearest_double(patch.net()[i / 3][i % 3][c]);
      net[i][c] = d.value;
      exact = exact && d.exact;
    }
  }
  return net;
}

/// a polynomial in Bernstein form to powers of t - 1/2: (P0 + 2 P1 + P2)/4, P2 - P0, P0 - 2 P1 + P2.
void to_centred_powers(Vec3& c0, Vec3& c1, Vec3& c2) {
  const Vec3 ends = c0 + c2;
  const Vec3 middle = 2.0 * c1;
  const Vec3 difference = c2 - c0;
  c0 = 0.25 * (ends + middle);
  c1 = difference;
  c2 = ends - middle;
}

void shift(Vec3& c0, Vec3& c1, const Vec3& c2, double t) {
  const Vec3 second = t * c2;
  const Vec3 half = c1 + second;
  c0 = c0 + t * half;
  c1 = half + second;
}

/// Magnitude of a coefficient and bound of its error.
struct Bound {
  double size;
  double error;
};

/// What `shift` makes of bounds for |t| <= H = kReach. Computed: a = t c2, b = c1 + a, c1' = b + a, c0' = c0
/// + t b; errors of a, b, c1', t b, c0' from these operations alone, for sizes m: u H m2; + u (m1 + H m2); +
/// u H m2 + u (m1 + 2 H m2) = u (2 m1 + 5 H m2) in all; H u (m1 + 2 H m2) + u H (m1 + H m2); + u (m0 + H m1 +
/// H² m2) = u (m0 + 3 H m1 + 4 H² m2) in all.
void shift(Bound& c0, Bound& c1, const Bound& c2) {
  constexpr double h = kReach;
  c0.error += h * c1.error + h * h * c2.error + kUnit * (c0.size + 3 * h * c1.size + 4 * h * h * c2.size);
  c1.error += 2 * h * c2.error + kUnit * (2 * c1.size + 5 * h * c2.size);
  c0.size += h * c1.size + h * h * c2.size;
  c1.size += 2 * h * c2.size;
}

/// to_centred_powers in one parameter, control points of size m with error e: the coefficients have sizes m,
/// 2 m, 4 m and errors e + 3/2 u m, 2 e + 2 u m, 4 e + 6 u m (the sums are of size 2 m, 4 m, and divided by
/// 4; 2 m; 2 m, 4 m). Twice, from m = 1: sizes s_i s_j, errors growth s_i s_j + u conversion[3 i + j].
constexpr std::array<double, 9> kConversion = {3, 5, 12, 5, 8, 20, 12, 20, 48};
constexpr std::array<double, 3> kSize = {1, 2, 4};

/// Patch::error: kSlack for all terms of second order in u, kTiny for underflow: an expansion and the values
/// from it are fewer than 100 products, which are multiplied by parameters alone.
std::array<double, 9> coefficient_errors(const Coefficients& power, double input_error) {
  std::array<Bound, 9> b;
  for (std::size_t i = 0; i < 9; ++i) {
    b[i] = {largest(power[i]), kConversion[i] * kUnit + kSize[i / 3] * kSize[i % 3] * input_error};
  }
  for (std::size_t i = 0; i < 9; i += 3) {
    shift(b[i], b[i + 1], b[i + 2]);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    shift(b[j], b[3 + j], b[6 + j]);
  }
  std::array<double, 9> error;
  std::transform(b.begin(), b.end(), error.begin(),
                 [](const Bound& c) { return kSlack * (c.error + kValueRounding * kUnit * c.size) + kTiny; });
  return error;
}

void fill(Patch& patch, double input_error) {
  Coefficients& c = patch.power;
  c = patch.net;
  for (std::size_t i = 0; i < 9; i += 3) {
    to_centred_powers(c[i], c[i + 1], c[i + 2]);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    to_centred_powers(c[j], c[3 + j], c[6 + j]);
  }
  patch.error = coefficient_errors(c, input_error);
}

}  // namespace

Coefficients expand(const Patch& patch, double h, double k) {
  Coefficients c = patch.power;
  for (std::size_t i = 0; i < 9; i += 3) {
    shift(c[i], c[i + 1], c[i + 2], k);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    shift(c[j], c[3 + j], c[6 + j], h);
  }
  return c;
}

std::optional<Pair> make_pair(const BezierPatch& x, const BezierPatch& y) {
  Pair pair;
  bool exact = true;
  pair.x.net = rounded(x, exact);
  pair.y.net = rounded(y, exact);
  double size = 0;   // of the unscaled coordinates
  double reach = 0;  // from the origin of the frame
  pair.extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double lower = pair.x.net[0][c];
    double upper = lower;
    for (const Patch* patch : {&pair.x, &pair.y}) {
      for (const Vec3& p : patch->net) {
        lower = std::min(lower, p[c]);
        upper = std::max(upper, p[c]);
        size = std::max(size, std::fabs(p[c]));
      }
    }
    pair.frame.origin[c] = 0.5 * lower + 0.5 * upper;
    reach = std::max({reach, upper - pair.frame.origin[c], pair.frame.origin[c] - lower});
    pair.extent = std::max(pair.extent, upper - lower);
  }
  // Such models are solved about the origin (placement.h).
  if (!(size < 0x1p300) || !(reach > 0x1p-300) || !(size < 0x1p40 * reach)) {
    return std::nullopt;
  }
  // reach <= 2^exponent (1 - u) or the rounded differences are at most 2^exponent all the same.
  const int exponent = std::ilogb(reach) + 1;
  pair.frame.exponent = exponent;
  const double scale = std::ldexp(1.0, -exponent);
  for (Patch* patch : {&pair.x, &pair.y}) {
    for (Vec3& p : patch->net) {
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = (p[c] - pair.frame.origin[c]) * scale;
      }
    }
  }
  const double input_error = kInputError * ((exact ? 0 : size * scale) + 1);
  fill(pair.x, input_error);
  fill(pair.y, input_error);
  pair.net_error = kSlack * (input_error + kNetError);
  pair.order_error = {};
  pair.total_error = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    const double e = pair.x.error[i] + pair.y.error[i];
    pair.order_error[i / 3 + i % 3] += e;
    pair.total_error += static_cast<double>(1 + i / 3 + i % 3) * e;
  }
  return pair;
}

}  // namespace exsect::filter
