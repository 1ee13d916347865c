#include "filter/moebius_ratios.h"

#include "filter/exact_taylor.h"
#include "filter/second_order.h"

namespace exsect::filter {

namespace {

/// Places are kept to this many bits, and Newton's method has arrived where its steps are smaller than half
/// of them say.
constexpr long kBits = 1200;
constexpr int kRefiningSteps = 8;
/// A ratio is the simplest rational number within 2^-kRatioBits of what is computed, relative to it; with
/// about as many bits itself it is no rational number that is meant.
constexpr long kRatioBits = 600;
constexpr unsigned kMostBits = 540;  // of numerator and denominator

using RationalPlace = std::array<Rational, 2>;

template <class K>
ExactSecondOrder second_order(const ExactPatch<K>& patch, const RationalPlace& at) {
  return in_space<K>(exact_taylor<K>(patch, at[0], at[1]));
}

/// The (a,b) for which a p + b q is nearest to v; empty if p and q are dependent.
std::optional<RationalPlace> coordinates(const Point& p, const Point& q, const Point& v) {
  using exsect::dot;
  const Rational pp = dot(p, p), pq = dot(p, q), qq = dot(q, q), det = pp * qq - pq * pq;
  if (det == 0) return std::nullopt;
  return RationalPlace{(qq * dot(p, v) - pq * dot(q, v)) / det, (pp * dot(q, v) - pq * dot(p, v)) / det};
}

Rational shortened(const Rational& q) {
  const Rational scaled = q * power_of_two(kBits);
  return Rational(Integer(numerator(scaled) / denominator(scaled))) * power_of_two(-kBits);
}

RationalPlace from_corner(const Place& centred) {
  return {from_double(centred[0]) + Rational(1, 2), from_double(centred[1]) + Rational(1, 2)};
}

/// Newton's method from `at` for the place of a point of space.
template <class K>
std::optional<RationalPlace> place_of(const ExactPatch<K>& patch, RationalPlace at, const Point& point) {
  using exsect::operator-;
  for (int step = 0; step < kRefiningSteps; ++step) {
    const ExactSecondOrder x = second_order<K>(patch, at);
    const auto by = coordinates(x.u, x.v, point - x.value);
    if (!by || abs((*by)[0]) + abs((*by)[1]) > 1) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) at[k] = shortened(at[k] + (*by)[k]);
    if (abs((*by)[0]) + abs((*by)[1]) < power_of_two(-kBits / 2)) return at;
  }
  return std::nullopt;
}

/// A Moebius map is p + p' h / (1 - q h) about t, q = p'' / (2 p'). The ratio of its denominator at t = 1 to
/// that at 0, for the parameter of x with index p along y's derivative `first` and half of the second one.
std::optional<Rational> ratio_along(const ExactSecondOrder& x, std::size_t p, const Rational& t,
                                    const Point& first, const Point& second) {
  using exsect::operator*, exsect::operator-;
  const auto direction = coordinates(x.u, x.v, first);
  if (!direction || (*direction)[p] == 0) return std::nullopt;
  const Rational rate = (*direction)[p];
  const auto rest = coordinates(x.u, x.v, second - rate * rate * (p == 0 ? x.uu : x.vv));
  const Rational q = (*rest)[p] / rate, at_0 = 1 + q * t, at_1 = 1 - q * (1 - t);
  if (at_0 <= 0 || at_1 <= 0) return std::nullopt;
  const Rational ratio = at_1 / at_0, error = ratio * power_of_two(-kRatioBits);
  const Rational simple = simplest_between(ratio - error, ratio + error);
  if (msb(numerator(simple)) + msb(denominator(simple)) > kMostBits) return std::nullopt;
  return simple;
}

}  // namespace

template <class K>
std::optional<std::array<Rational, 2>> moebius_ratios(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                      const Place& on_x, const Place& on_y,
                                                      std::size_t with_first) requires K::weighted {
  const RationalPlace there = from_corner(on_y);
  const ExactSecondOrder of_y = second_order<K>(y, there);
  const auto at = place_of<K>(x, from_corner(on_x), of_y.value);
  if (!at) return std::nullopt;
  const ExactSecondOrder of_x = second_order<K>(x, *at);
  const auto k = ratio_along(of_x, with_first, there[0], of_y.u, of_y.uu);
  const auto l = ratio_along(of_x, 1 - with_first, there[1], of_y.v, of_y.vv);
  return k && l ? std::optional(std::array{*k, *l}) : std::nullopt;
}

#define EXSECT_INSTANTIATE(K)                                        \
  template std::optional<std::array<Rational, 2>> moebius_ratios<K>( \
      const ExactPatch<K>&, const ExactPatch<K>&, const Place&, const Place&, std::size_t);
EXSECT_INSTANTIATE(WeightedBiquadratic)
EXSECT_INSTANTIATE(WeightedBicubic)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
