#include "filter/patch.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace exsect::filter {

namespace {

/// The control net in doubles; `exact` becomes false if a coordinate is not known to be a double.
template <class K>
CoefficientsOf<K> rounded(const ExactPatch<K>& patch, bool& exact) {
  CoefficientsOf<K> net;
  for (std::size_t i = 0; i < K::count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const NearestDouble d = nearest_double(control_point(patch, i)[c]);
      net[i][c] = d.value;
      exact = exact && d.exact;
    }
  }
  return net;
}

/// The rounded net, moved and scaled. Elevated control points are hardly ever doubles: their exact
/// differences from the origin are rounded, unless these are given.
template <class K>
void place(const ExactPatch<K>& patch, const ModelFrame& frame, bool exact, CoefficientsOf<K>& net) {
  const double scale = std::ldexp(1.0, -static_cast<int>(frame.exponent));
  for (std::size_t i = 0; i < K::count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (exact) {
        net[i][c] = (net[i][c] - frame.origin[c]) * scale;
      } else {
        const Rational moved = control_point(patch, i)[c] - from_double(frame.origin[c]);
        net[i][c] = to_double(moved * power_of_two(-frame.exponent));
      }
    }
  }
}

/// A polynomial in Bernstein form to powers of t - 1/2; the coefficients stand `step` apart.
template <class K>
void to_centred_powers(Row<K>* c, std::size_t step) {
  if constexpr (K::degree == 2) {  // (P0 + 2 P1 + P2)/4, P2 - P0, P0 - 2 P1 + P2
    Row<K>&c0 = c[0], &c1 = c[step], &c2 = c[2 * step];
    const Row<K> ends = c0 + c2;
    const Row<K> middle = 2.0 * c1;
    const Row<K> difference = c2 - c0;
    c0 = 0.25 * (ends + middle);
    c1 = difference;
    c2 = ends - middle;
  } else {  // (P0 + 3 P1 + 3 P2 + P3)/8, 3 (P3 - P0 + P2 - P1)/4, 3 (P0 + P3 - P1 - P2)/2, P3 - P0 - 3 (P2 -
            // P1)
    static_assert(K::degree == 3);
    Row<K>&c0 = c[0], &c1 = c[step], &c2 = c[2 * step], &c3 = c[3 * step];
    const Row<K> ends = c0 + c3;
    const Row<K> inner = c1 + c2;
    const Row<K> far = c3 - c0;
    const Row<K> near = c2 - c1;
    c0 = 0.125 * (ends + 3.0 * inner);
    c1 = 0.75 * (far + near);
    c2 = 1.5 * (ends - inner);
    c3 = far - 3.0 * near;
  }
}

/// The powers of t - 1/2 to those of t - 1/2 - `by`, by repeated synthetic division.
template <class K>
void shift(Row<K>* c, std::size_t step, double by) {
  for (std::size_t pass = 0; pass < K::degree; ++pass) {
    for (std::size_t i = K::degree; i-- > pass;) {
      c[i * step] = c[i * step] + by * c[(i + 1) * step];
    }
  }
}

/// Magnitude of a coefficient and bound of its error.
struct Bound {
  double size;
  double error;
};

/// What `shift` makes of bounds for |t| <= H = kReach, (14.3): each sum c_i + t c_(i+1) adds u H m_(i+1) and
/// u (m_i + H m_(i+1)).
template <class K>
void shift(Bound* c, std::size_t step) {
  for (std::size_t pass = 0; pass < K::degree; ++pass) {
    for (std::size_t i = K::degree; i-- > pass;) {
      Bound& low = c[i * step];
      const Bound& high = c[(i + 1) * step];
      low.error += kReach * high.error + kUnit * (low.size + 2 * kReach * high.size);
      low.size += kReach * high.size;
    }
  }
}

/// to_centred_powers in one parameter, control points of size m with error e: the coefficients have sizes
/// kSize m and errors kSize e + kConversion u m. For n = 2 the sums are of size 2 m, 4 m, and divided by 4; 2
/// m; 2 m, 4 m. For n = 3 they are 2 m, 2 m, 6 m, 8 m, in all 22 u m / 8; 3/4 (2 m, 2 m, 4 m) and 3 m; 3/2 of
/// these and 6 m; 2 m, 3 times 2 m, 6 m, 8 m.
template <std::size_t Degree>
constexpr std::array<double, Degree + 1> kSize;
template <>
constexpr std::array<double, 3> kSize<2> = {1, 2, 4};
template <>
constexpr std::array<double, 4> kSize<3> = {1, 3, 6, 8};
template <std::size_t Degree>
constexpr std::array<double, Degree + 1> kConversion;
template <>
constexpr std::array<double, 3> kConversion<2> = {1.5, 2, 6};
template <>
constexpr std::array<double, 4> kConversion<3> = {3, 9, 18, 22};

/// Patch::error: kSlack for all terms of second order in u, kTiny for underflow: an expansion and the values
/// from it are fewer than 100 products, which are multiplied by parameters alone.
template <class K>
std::array<double, K::count> coefficient_errors(const CoefficientsOf<K>& power, double input_error) {
  constexpr auto& size = kSize<K::degree>;
  constexpr auto& conversion = kConversion<K::degree>;
  std::array<Bound, K::count> b;
  for (std::size_t k = 0; k < K::count; ++k) {
    const std::size_t i = k / K::side;
    const std::size_t j = k % K::side;
    b[k] = {largest(power[k]),
            (size[i] * conversion[j] + size[j] * conversion[i]) * kUnit + size[i] * size[j] * input_error};
  }
  for (std::size_t i = 0; i < K::side; ++i) {
    shift<K>(&b[K::side * i], 1);
  }
  for (std::size_t j = 0; j < K::side; ++j) {
    shift<K>(&b[j], K::side);
  }
  std::array<double, K::count> error;
  std::transform(b.begin(), b.end(), error.begin(), [](const Bound& c) {
    return kSlack * (c.error + kValueRounding<K::degree, K::rows> * kUnit * c.size) + kTiny;
  });
  return error;
}

template <class K>
void fill(PatchOf<K>& patch, double input_error) {
  CoefficientsOf<K>& c = patch.power;
  c = patch.net;
  for (std::size_t i = 0; i < K::side; ++i) {
    to_centred_powers<K>(&c[K::side * i], 1);
  }
  for (std::size_t j = 0; j < K::side; ++j) {
    to_centred_powers<K>(&c[j], K::side);
  }
  patch.error = coefficient_errors<K>(c, input_error);
}

}  // namespace

template <class K>
CoefficientsOf<K> expand(const PatchOf<K>& patch, double h, double k) {
  CoefficientsOf<K> c = patch.power;
  for (std::size_t i = 0; i < K::side; ++i) {
    shift<K>(&c[K::side * i], 1, k);
  }
  for (std::size_t j = 0; j < K::side; ++j) {
    shift<K>(&c[j], K::side, h);
  }
  return c;
}

namespace {

template <class K>
void finish(PairOf<K>& pair, double input_error) {
  fill<K>(pair.x, input_error);
  fill<K>(pair.y, input_error);
  pair.net_error = kSlack * (input_error + kDegreeNetError<K::degree>);
  pair.order_error = {};
  pair.x_order_error = pair.y_order_error = {};
  pair.total_error = pair.x_total_error = pair.y_total_error = 0;
  for (std::size_t i = 0; i < K::count; ++i) {
    const double e = pair.x.error[i] + pair.y.error[i];
    const std::size_t order = i / K::side + i % K::side;
    pair.order_error[order] += e;
    pair.total_error += static_cast<double>(1 + order) * e;
    if constexpr (K::weighted) {
      pair.x_order_error[order] += pair.x.error[i];
      pair.y_order_error[order] += pair.y.error[i];
      pair.x_total_error += static_cast<double>(1 + order) * pair.x.error[i];
      pair.y_total_error += static_cast<double>(1 + order) * pair.y.error[i];
    }
  }
}

template <class K>
std::optional<PairOf<K>> polynomial_pair(const ExactPatch<K>& x, const ExactPatch<K>& y) {
  PairOf<K> pair;
  bool exact = true;
  pair.x.net = rounded<K>(x, exact);
  pair.y.net = rounded<K>(y, exact);
  double size = 0;   // of the unscaled coordinates
  double reach = 0;  // from the origin of the frame
  pair.extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double lower = pair.x.net[0][c];
    double upper = lower;
    for (const PatchOf<K>* patch : {&pair.x, &pair.y}) {
      for (const Row<K>& p : patch->net) {
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
  // reach <= 2^exponent (1 - u) or the rounded differences are at most 2^exponent all the same. Where they
  // are rounded after the subtraction, reach is too small by 2^-12 of itself at most.
  constexpr bool is_given = std::is_same_v<K, Biquadratic>;  // and not elevated
  const int exponent = std::ilogb(reach) + (exact || is_given ? 1 : 2);
  pair.frame.exponent = exponent;
  place<K>(x, pair.frame, exact || is_given, pair.x.net);
  place<K>(y, pair.frame, exact || is_given, pair.y.net);
  const double inexact = exact || !is_given ? 0 : std::ldexp(size, -exponent);
  const double input_error = kInputError * (inexact + 1);
  finish<K>(pair, input_error);
  return pair;
}

/// The homogeneous control points, each coordinate rounded once.
template <class K>
CoefficientsOf<K> approximate(const ExactPatch<K>& patch) {
  CoefficientsOf<K> net;
  for (std::size_t i = 0; i < K::count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) net[i][c] = to_double(patch.points[i][c]);
    net[i][3] = to_double(patch.weights[i]);
  }
  return net;
}

/// The least k for which 2^-k x_4 / y_4 is at most kScaleUnit, as far as the weights tell, and allowed.
template <class K>
int reduction(const PatchOf<K>& x, const PatchOf<K>& y) {
  double greatest = 0;
  double least = HUGE_VAL;
  for (const Row<K>& p : x.net) greatest = std::max(greatest, p[3]);
  for (const Row<K>& p : y.net) {
    if (p[3] > 0) least = std::min(least, p[3]);
  }
  int k = 0;
  while (k < kMostReduction && std::ldexp(greatest, -k) > kScaleUnit * least) ++k;
  return k;
}

/// Of rounded homogeneous control points those about the origin, exactly, times 2^-exponent in space, and all
/// of that times 2^-reduced; rounded once.
template <class K>
void round_net(const ExactPatch<K>& patch, const ModelFrame& frame, int reduced, CoefficientsOf<K>& net) {
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational origin = from_double(frame.origin[c]);
    for (std::size_t i = 0; i < K::count; ++i) {
      if (origin != 0) net[i][c] = to_double(patch.points[i][c] - patch.weights[i] * origin);
      net[i][c] = std::ldexp(net[i][c], -static_cast<int>(frame.exponent) - reduced);
    }
  }
  for (Row<K>& p : net) p[3] = std::ldexp(p[3], -reduced);
}

/// The frame is that of the control points with positive weights, its scale such that all homogeneous
/// coordinates about its origin are at most 1. They are rounded once. The origin is that of space where it is
/// so near that coordinates are at most twice as great: these need no exact differences.
template <class K>
std::optional<PairOf<K>> weighted_pair(const ExactPatch<K>& x, const ExactPatch<K>& y) {
  PairOf<K> pair;
  pair.x.net = approximate<K>(x);
  pair.y.net = approximate<K>(y);
  double size = 0;
  pair.extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double lower = HUGE_VAL;
    double upper = -HUGE_VAL;
    for (const PatchOf<K>* patch : {&pair.x, &pair.y}) {
      for (const Row<K>& p : patch->net) {
        if (!(p[3] > 0)) continue;
        lower = std::min(lower, p[c] / p[3]);
        upper = std::max(upper, p[c] / p[3]);
      }
    }
    pair.frame.origin[c] = 0.5 * lower + 0.5 * upper;
    size = std::max({size, std::fabs(lower), std::fabs(upper)});
    pair.extent = std::max(pair.extent, upper - lower);
  }
  if (!(size < 0x1p300)) {
    return std::nullopt;
  }
  if (size <= pair.extent) pair.frame.origin = {};
  // At least the size of all coordinates about the origin: the two roundings and those of p and w o are u
  // each.
  double reach = 0;
  for (const PatchOf<K>* patch : {&pair.x, &pair.y}) {
    for (const Row<K>& p : patch->net) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double turned = p[3] * pair.frame.origin[c];
        reach = std::max(reach, std::fabs(p[c] - turned) + 8 * kUnit * (std::fabs(p[c]) + std::fabs(turned)));
      }
    }
  }
  if (!(reach > 0x1p-300) || !(size < 0x1p40 * reach)) {
    return std::nullopt;
  }
  pair.frame.exponent = std::ilogb(reach) + 1;
  round_net<K>(x, pair.frame, reduction<K>(pair.x, pair.y), pair.x.net);
  round_net<K>(y, pair.frame, 0, pair.y.net);
  finish<K>(pair, kInputError);
  return pair;
}

}  // namespace

template <class K>
std::optional<PairOf<K>> make_pair_of(const ExactPatch<K>& x, const ExactPatch<K>& y) {
  if constexpr (K::weighted) {
    return weighted_pair<K>(x, y);
  } else {
    return polynomial_pair<K>(x, y);
  }
}

#define EXSECT_INSTANTIATE(K)                                              \
  template CoefficientsOf<K> expand<K>(const PatchOf<K>&, double, double); \
  template std::optional<PairOf<K>> make_pair_of<K>(const ExactPatch<K>&, const ExactPatch<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
