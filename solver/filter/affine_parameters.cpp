#include "filter/affine_parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "filter/common_normal.h"
#include "filter/moebius_ratios.h"
#include "filter/place_on_patch.h"
#include "filter/polynomial.h"

namespace exsect::filter {

namespace {

constexpr std::size_t kSamples = 5;  // in each parameter
/// Of pairs of samples, the nearest first.
constexpr std::size_t kMostTries = 4;
/// Directions in the tangent plane that differ by less are the same.
constexpr double kSameDirection = 0x1p-24;

/// At points where the area of the tangents is less than this part of the greatest one there is no direction
/// to be compared, as on a side that is one point.
constexpr double kSmallArea = 0x1p-20;

struct Sample {
  Place at;
  Vec3 point;
  double area;
};

template <class K>
std::vector<Sample> samples(const PatchOf<K>& patch) {
  std::vector<Sample> result;
  double greatest = 0;
  for (std::size_t k = 0; k < kSamples * kSamples; ++k) {
    const auto centred = [](std::size_t i) { return static_cast<double>(i) / (kSamples - 1) - 0.5; };
    const Place at = {centred(k / kSamples), centred(k % kSamples)};
    const SecondOrder x = second_order(patch, at[0], at[1]);
    const double area = largest(cross(x.u, x.v));
    result.push_back({at, affine(value_at<K>(patch.power, at[0], at[1])), area});
    greatest = std::max(greatest, area);
  }
  std::erase_if(result, [greatest](const Sample& s) { return !(s.area >= kSmallArea * greatest); });
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
  const auto end = starts.begin() + static_cast<std::ptrdiff_t>(std::min(kMostTries, starts.size()));
  std::partial_sort(starts.begin(), end, starts.end(),
                    [](const Start& a, const Start& b) { return a.distance < b.distance; });
  starts.erase(end, starts.end());
  return starts;
}

/// The parameter of x that changes along a direction in the tangent plane; empty if both do.
std::optional<std::size_t> changing(const SecondOrder& x, const Vec3& along) {
  const Place direction = coordinates(x.u, x.v, along);
  const std::size_t p = std::fabs(direction[0]) > std::fabs(direction[1]) ? 0 : 1;
  if (!(std::fabs(direction[1 - p]) < kSameDirection * std::fabs(direction[p]))) return std::nullopt;
  return p;
}

/// A point of both, and the parameter of x that changes with the first one of y, the other one of which
/// changes with the other one.
struct CommonPlace {
  Place on_x;
  Place on_y;
  std::size_t with_first;
};
template <class K>
std::optional<CommonPlace> common_place_near(const PairOf<K>& pair, const Start& start) {
  Place at = start.on_x;
  if (!improve_place(pair.x, at, start.of_y.point)) return std::nullopt;
  const SecondOrder x = second_order(pair.x, at[0], at[1]);
  const SecondOrder y = second_order(pair.y, start.of_y.at[0], start.of_y.at[1]);
  const auto with_first = changing(x, y.u), with_second = changing(x, y.v);
  if (!with_first || !with_second || *with_first == *with_second) return std::nullopt;
  return CommonPlace{at, start.of_y.at, *with_first};
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
std::optional<std::array<Rational, 2>> parameter_ratios(const PairOf<K>& pair, const ExactPatch<K>& x,
                                                        const ExactPatch<K>& y) requires K::weighted {
  const auto place = common_place(pair);
  if (!place) return std::nullopt;
  const auto ratios = moebius_ratios<K>(x, y, place->on_x, place->on_y, place->with_first);
  return ratios && ((*ratios)[0] != 1 || (*ratios)[1] != 1) ? ratios : std::nullopt;
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

#define EXSECT_INSTANTIATE(K)                                          \
  template std::optional<std::array<Rational, 2>> parameter_ratios<K>( \
      const PairOf<K>&, const ExactPatch<K>&, const ExactPatch<K>&);   \
  template ElevatedPatch<K> in_other_parameters<K>(const ElevatedPatch<K>&, const std::array<Rational, 2>&);
EXSECT_INSTANTIATE(WeightedBiquadratic)
EXSECT_INSTANTIATE(WeightedBicubic)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
