#include "filter/affine_parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "filter/common_normal.h"
#include "filter/place_on_patch.h"
#include "filter/polynomial.h"

namespace exsect::filter {

namespace {

constexpr std::size_t kSamples = 5;  // in each parameter
/// Of pairs of samples, the nearest first.
constexpr std::size_t kMostTries = 4;
/// Directions in the tangent plane that differ by less are the same.
constexpr double kSameDirection = 0x1p-24;
/// How far a ratio is from the simple number that it is meant to be, relative to it.
constexpr double kRatioError = 0x1p-32;
constexpr double kGreatestRatio = 0x1p10;

struct Sample {
  Place at;
  Vec3 point;
};

template <class K>
std::vector<Sample> samples(const PatchOf<K>& patch) {
  std::vector<Sample> result;
  for (std::size_t k = 0; k < kSamples * kSamples; ++k) {
    const auto centred = [](std::size_t i) { return static_cast<double>(i) / (kSamples - 1) - 0.5; };
    const Place at = {centred(k / kSamples), centred(k % kSamples)};
    result.push_back({at, affine(value_at<K>(patch.power, at[0], at[1]))});
  }
  return result;
}

/// A point of y near x, and a place on x near that point.
struct Start {
  double distance;
  Place on_x;
  Sample of_y;
};

template <class K>
std::vector<Start> nearest_samples(const PairOf<K>& pair) {
  std::vector<Start> starts;
  const std::vector<Sample> of_x = samples(pair.x);
  for (const Sample& y : samples(pair.y)) {
    for (const Sample& x : of_x) {
      const Vec3 gap = x.point - y.point;
      starts.push_back({dot(gap, gap), x.at, y});
    }
  }
  const auto end = starts.begin() + kMostTries;
  std::partial_sort(starts.begin(), end, starts.end(),
                    [](const Start& a, const Start& b) { return a.distance < b.distance; });
  starts.erase(end, starts.end());
  return starts;
}

/// One of y's parameters t near a common point: a parameter p of x, with p' and p''/2 by t. Empty if both of
/// x's parameters change with t. `first` and `second` are y's derivative and half of its second one by t.
struct Rate {
  std::size_t of_x;
  double first;
  double second;
};
std::optional<Rate> rate_along(const SecondOrder& x, const Vec3& first, const Vec3& second) {
  const Place direction = coordinates(x.u, x.v, first);
  const std::size_t p = std::fabs(direction[0]) > std::fabs(direction[1]) ? 0 : 1;
  if (!(std::fabs(direction[1 - p]) < kSameDirection * std::fabs(direction[p]))) return std::nullopt;
  const double square = direction[p] * direction[p];
  const Vec3 rest = second - square * (p == 0 ? x.uu : x.vv);
  return Rate{p, direction[p], coordinates(x.u, x.v, rest)[p]};
}

/// A Moebius map is p + p' h / (1 - q h) about t, q = p'' / (2 p'). The ratio of its denominator at the end
/// t = 1/2 of the centred parameter to that at -1/2: a simple number near it.
std::optional<Rational> ratio_of(const Rate& rate, double t) {
  const double q = rate.second / rate.first;
  const double ratio = (1 - q * (0.5 - t)) / (1 + q * (0.5 + t));
  if (!(ratio > 1 / kGreatestRatio && ratio < kGreatestRatio)) return std::nullopt;
  return simplest_between(from_double(ratio * (1 - kRatioError)), from_double(ratio * (1 + kRatioError)));
}

/// How x's parameters change with y's at a point of both.
struct CommonPlace {
  Place on_y;
  Rate along_r;
  Rate along_s;
};
template <class K>
std::optional<CommonPlace> common_place_near(const PairOf<K>& pair, const Start& start) {
  Place at = start.on_x;
  if (!improve_place(pair.x, at, start.of_y.point)) return std::nullopt;
  const SecondOrder x = second_order(pair.x, at[0], at[1]);
  const SecondOrder y = second_order(pair.y, start.of_y.at[0], start.of_y.at[1]);
  const auto along_r = rate_along(x, y.u, y.uu);
  const auto along_s = rate_along(x, y.v, y.vv);
  if (!along_r || !along_s || along_r->of_x == along_s->of_x) return std::nullopt;
  return CommonPlace{start.of_y.at, *along_r, *along_s};
}
template <class K>
std::optional<CommonPlace> common_place(const PairOf<K>& pair) {
  for (const Start& start : nearest_samples(pair))
    if (const auto found = common_place_near(pair, start)) return found;
  return std::nullopt;
}

}  // namespace

template <class K>
bool seem_to_be_pieces(const PairOf<K>& pair) {
  return common_place(pair).has_value();
}

template <class K>
std::optional<std::array<Rational, 2>> parameter_ratios(const PairOf<K>& pair) requires K::weighted {
  const auto place = common_place(pair);
  if (!place) return std::nullopt;
  const auto k = ratio_of(place->along_r, place->on_y[0]);
  const auto l = ratio_of(place->along_s, place->on_y[1]);
  return k && l && (*k != 1 || *l != 1) ? std::optional(std::array{*k, *l}) : std::nullopt;
}

template <class K>
ElevatedPatch<K> in_other_parameters(const ElevatedPatch<K>& patch, const std::array<Rational, 2>& ratios) {
  const RationalPatch given = rational_patch(patch);
  const RationalPatch& own = given.reduced();
  std::vector<std::vector<HomogeneousPoint>> net(static_cast<std::size_t>(own.degree_u()) + 1);
  Rational in_first = 1;
  for (std::size_t i = 0; i < net.size(); ++i) {
    Rational factor = in_first;
    for (int j = 0; j <= own.degree_v(); ++j) {
      HomogeneousPoint p = own.homogeneous(static_cast<int>(i), j);
      for (Rational& c : p) c *= factor;
      net[i].push_back(std::move(p));
      factor /= ratios[1];
    }
    in_first /= ratios[0];
  }
  return elevated<K>(RationalPatch::from_homogeneous(net));
}

#define EXSECT_INSTANTIATE(K) template bool seem_to_be_pieces<K>(const PairOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

#define EXSECT_INSTANTIATE(K)                                                            \
  template std::optional<std::array<Rational, 2>> parameter_ratios<K>(const PairOf<K>&); \
  template ElevatedPatch<K> in_other_parameters<K>(const ElevatedPatch<K>&, const std::array<Rational, 2>&);
EXSECT_INSTANTIATE(WeightedBiquadratic)
EXSECT_INSTANTIATE(WeightedBicubic)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
