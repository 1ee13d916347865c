#include "self/turning_pairs.h"

#include <algorithm>

#include "answer/exact_source.h"
#include "answer/parameter_box.h"
#include "line/known_tangent.h"

namespace exsect {
namespace {

/// Of the polynomial of a value.
constexpr int kLargestValueDegree = 16;

Rational fine_width() { return power_of_two(-200); }

template <class T>
void exchange_parameters(std::array<T, 4>& a) {
  std::swap(a[0], a[1]);
  std::swap(a[2], a[3]);
}

TurningPair with_parameters_exchanged(TurningPair turning) {
  exchange_parameters(turning.pair.numerator);
  exchange_parameters(turning.pair.denominator);
  exchange_parameters(turning.zero);
  return turning;
}

TurningPair with_points_exchanged(TurningPair turning) {
  const auto exchange = [](auto& a) { std::rotate(a.begin(), a.begin() + 2, a.end()); };
  exchange(turning.pair.numerator);
  exchange(turning.pair.denominator);
  exchange(turning.zero);
  return turning;
}

ParameterBox box_of_turning(const ExactParameters& pair) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) box[j] = enclosure(pair, j, fine_width());
  return box;
}

bool lies_between(const RationalInterval& inner, const RationalInterval& outer) {
  return outer.lower <= inner.lower && inner.upper <= outer.upper;
}

/// The pair is this boundary point.
bool is_at(const ExactParameters& pair, const CertifiedPoint& point) {
  const ParameterBox& box = point.box();
  for (std::size_t j = 0; j < 4; ++j) {
    const bool known = box[j].width() == 0 ? has_value(pair, j, box[j].lower)
                                           : lies_between(enclosure(pair, j, fine_width()), box[j]);
    if (!known) return false;
  }
  return true;
}

}  // namespace

TurningPairs::TurningPairs(const BezierPatch& x) : x_(x), exchanged_(x.exchanged()) {}

const SelfValues& TurningPairs::values() {
  if (!values_) values_ = self_values(x_);
  return *values_;
}

std::array<bool, 4> TurningPairs::zero_at(const CertifiedPoint& point) {
  std::array<bool, 4> zero = known_zero_tangent(x_, x_, point);
  if (std::ranges::count(zero, true) > 0) return zero;
  for (const TurningPair& turning : near(point.box()))
    if (is_at(turning.pair, point)) return turning.zero;
  return zero;
}

std::optional<ParameterBox> TurningPairs::common_zero(const ParameterBox& where, std::size_t i,
                                                      std::size_t j) {
  for (const TurningPair& turning : near(where)) {
    const ParameterBox box = box_of_turning(turning.pair);
    if (turning.zero[i] && turning.zero[j] && lies_in(box, where)) return box;
  }
  return std::nullopt;
}

const std::vector<TurningPair>& TurningPairs::over(std::size_t sweep, std::size_t k) {
  const auto known = over_.find({sweep, k});
  if (known != over_.end()) return known->second;
  const BezierPatch& owner = sweep == 1 ? x_ : exchanged_;
  if (!projections_[sweep]) projections_[sweep] = self_projection(owner);
  std::vector<TurningPair> pairs =
      turning_pairs_over(owner, *projections_[sweep], (*values().turning[sweep])[k]);
  if (sweep == 0) std::ranges::transform(pairs, pairs.begin(), with_parameters_exchanged);
  return over_[{sweep, k}] = std::move(pairs);
}

std::vector<TurningPair> TurningPairs::near(const ParameterBox& box) {
  std::vector<TurningPair> result;
  for (const std::size_t sweep : {0, 1}) {
    const auto& turning = values().turning[sweep];
    for (std::size_t k = 0; turning && k < turning->size(); ++k)
      for (const bool exchanged : {false, true}) {
        const RealAlgebraic& value = (*turning)[k];
        const RationalInterval& range = box[exchanged ? sweep + 2 : sweep];
        if (value.polynomial().degree() > kLargestValueDegree || value.compare(range.lower) < 0 ||
            value.compare(range.upper) > 0)
          continue;
        for (const TurningPair& pair : over(sweep, k))
          result.push_back(exchanged ? with_points_exchanged(pair) : pair);
      }
  }
  return result;
}

}  // namespace exsect
