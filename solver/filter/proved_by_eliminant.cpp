#include "filter/proved_by_eliminant.h"

#include <optional>

#include "answer/proof_failure.h"
#include "eliminant/weighted_eliminant.h"

namespace exsect::filter {

namespace {

/// Beyond the first two the time is better spent on the patches exchanged.
constexpr std::size_t kMostSweeps = 2;

}  // namespace

bool has_eliminant(const RationalPatch& x, const RationalPatch& y) {
  return !(x.biquadratic() && y.biquadratic()) && !eliminant_sweeps(x, y).empty();
}

template <class K>
bool proved_by_eliminant(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                         const ContactsOf<K>& contacts, const KnownStations& known, TreesOf<K>& trees,
                         long& boxes) {
  const RationalPatch first = rational_patch(x), second = rational_patch(y);
  std::vector<Parameter> sweeps = eliminant_sweeps(first, second);
  if (sweeps.size() > kMostSweeps) sweeps.resize(kMostSweeps);
  for (const Parameter p : sweeps) {
    PatchTreeOf<K>& other = index(p) < 2 ? trees.y : trees.x;
    const auto count = [&](const Rational& sample) -> std::optional<std::size_t> {
      const auto points = points_on_line<K>(pair, centred_line(p, sample), contacts, other, boxes);
      return points ? std::optional(points->size()) : std::nullopt;
    };
    const auto roots = weighted_turning_roots(first, second, p);
    try {
      if (roots && no_curve_is_missing(*roots, known.curves[index(p)], count, p, known.singular[index(p)]))
        return true;
    } catch (const ProofFailure&) {  // a curve is missing
      return false;
    }
  }
  return false;
}

#define EXSECT_INSTANTIATE(K)                                                                        \
  template bool proved_by_eliminant<K>(const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, \
                                       const ContactsOf<K>&, const KnownStations&, TreesOf<K>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
