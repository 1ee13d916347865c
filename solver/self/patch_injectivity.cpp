#include "self/patch_injectivity.h"

#include <algorithm>

#include "filter/injectivity.h"

namespace exsect {
namespace {

template <class K>
InjectiveRectangle injectivity_as(const RationalPatch& patch) {
  const filter::ExactPatch<K> elevated = filter::elevated<K>(patch);
  const auto pair = filter::make_pair_of<K>(elevated, elevated);
  if (!pair) return {};
  return [pair = *pair](const filter::Rectangle& where) {
    return filter::is_injective<K>(pair.x, 2 * pair.total_error, where);
  };
}

}  // namespace

InjectiveRectangle patch_injectivity(const RationalPatch& patch) {
  const RationalPatch& reduced = patch.reduced();
  if (reduced.is_polynomial()) return injectivity_as<filter::Bicubic>(reduced);
  return std::max(reduced.degree_u(), reduced.degree_v()) <= 2
             ? injectivity_as<filter::WeightedBiquadratic>(reduced)
             : injectivity_as<filter::WeightedBicubic>(reduced);
}

}  // namespace exsect
