#include "filter/proved_by_eliminant.h"

#include <type_traits>

#include "answer/proof_failure.h"
#include "eliminant/weighted_eliminant.h"

namespace exsect::filter {

namespace {

/// Sweeps along r and s are those of the patches exchanged.
constexpr std::array kSweeps = {Parameter::u, Parameter::v};

}  // namespace

template <class K>
bool proved_by_eliminant(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                         TreesOf<K>& trees, const std::array<std::vector<Stations>, 4>& stations,
                         long& boxes) {
  if constexpr (!std::is_same_v<K, WeightedBiquadratic>) {
    return false;
  } else {
    const RationalPatch first = rational_patch(x), second = rational_patch(y);
    for (const Parameter p : kSweeps) {
      const auto count = [&](const Rational& sample) -> std::optional<std::size_t> {
        const auto points = points_on_line<K>(pair, centred_line(p, sample), {}, trees.y, boxes);
        return points ? std::optional(points->size()) : std::nullopt;
      };
      const auto roots = weighted_turning_roots(p == Parameter::u ? first : first.transposed(), second);
      try {
        if (roots && no_curve_is_missing(*roots, stations[index(p)], count, p)) return true;
      } catch (const ProofFailure&) {  // a curve is missing
        return false;
      }
    }
    return false;
  }
}

#define EXSECT_INSTANTIATE(K)                                                                        \
  template bool proved_by_eliminant<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, \
                                       TreesOf<K>&, const std::array<std::vector<Stations>, 4>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
