#include "eliminant/eliminant_proof.h"

#include <algorithm>
#include <string>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"

namespace exsect {

namespace {

bool meet(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

class EliminantProof {
 public:
  EliminantProof(const std::vector<EliminantRoot>& roots, const std::vector<Stations>& curves,
                 const FibreCount& fibre, Parameter sweep)
      : roots_(roots), curves_(curves), fibre_(fibre), sweep_(sweep), known_(roots.size(), 0) {}

  bool run(const std::vector<RationalInterval>& singular) {
    return match_turning_points() && match_singular_points(singular) && are_explained() && count_fibres();
  }

 private:
  bool match_turning_points() {
    for (const Stations& curve : curves_) {
      const std::size_t ends = curve.closed ? 0 : 1;
      for (std::size_t i = ends; i + ends < curve.at.size(); ++i)
        if (!add(curve.at[i], 1)) return false;
    }
    return true;
  }

  bool match_singular_points(const std::vector<RationalInterval>& singular) {
    return std::ranges::all_of(singular, [&](const RationalInterval& place) { return add(place, 2); });
  }

  /// A multiple point lies over a root, of the order at least to which all over it count (Theorem 4.4). False
  /// if it is not known over which one.
  bool add(const RationalInterval& place, int count) {
    const auto root = root_at(place);
    if (!root) return false;
    known_[*root] += count;
    if (known_[*root] > roots_[*root].order) {
      contradiction(place, "more multiple points lie over a root of the eliminant than its order is");
    }
    return true;
  }

  /// No singular point and no curve of a fibre is left, each of which counts two at least: (14.15a). Or the
  /// fibre has simple points alone: what else lies over the root is outside of the squares.
  bool are_explained() {
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      if (known_[i] + 2 > roots_[i].order) continue;
      if (known_[i] > 0 || !fibre_(roots_[i].at)) return false;
      known_[i] = roots_[i].order;
    }
    return true;
  }

  /// Nothing else turns over it.
  bool is_taken(std::size_t root) const { return known_[root] == roots_[root].order; }

  /// The only root in this place; empty if it is not known which one.
  std::optional<std::size_t> root_at(const RationalInterval& place) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      if (!meet(roots_[i].at, place)) continue;
      if (found) return std::nullopt;
      found = i;
    }
    if (!found) contradiction(place, "no root of the eliminant lies under a turning point");
    return found;
  }

  /// A further closed curve has its extremes over two roots that are not taken: it meets the fibre over any
  /// sample between them.
  bool count_fibres() {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      if (is_taken(i)) continue;
      if (last && !count_between(*last, i)) return false;
      last = i;
    }
    return true;
  }

  bool count_between(std::size_t left, std::size_t right) const {
    const auto sample = sample_between(left, right);
    const auto count = sample ? fibre_({*sample, *sample}) : std::nullopt;
    if (count && *count != crossings(*sample)) {
      contradiction({*sample, *sample}, "the known curves and a fibre are not in bijection");
    }
    return count.has_value();
  }

  /// In the widest gap between all enclosures, strictly between the two roots: an end shared by neighbouring
  /// intervals is no root.
  std::optional<Rational> sample_between(std::size_t left, std::size_t right) const {
    const Rational end = roots_[right].at.lower;
    Rational lower = roots_[left].at.upper;
    std::vector<RationalInterval> events = {{end, end}};
    const auto add = [&](const RationalInterval& interval) {
      if (interval.upper > lower && interval.lower < end) events.push_back(interval);
    };
    for (const EliminantRoot& root : roots_) add(root.at);
    for (const Stations& curve : curves_) std::for_each(curve.at.begin(), curve.at.end(), add);
    std::sort(events.begin(), events.end(),
              [](const RationalInterval& a, const RationalInterval& b) { return a.lower < b.lower; });
    std::optional<RationalInterval> widest;
    for (const RationalInterval& event : events) {
      const RationalInterval gap{lower, std::max(lower, event.lower)};
      if (event.lower >= lower && (!widest || gap.width() > widest->width()) && is_free(gap.midpoint())) {
        widest = gap;
      }
      lower = std::max(lower, event.upper);
    }
    if (!widest) return std::nullopt;
    const Rational width = widest->width();
    return width == 0 ? widest->lower
                      : simplest_between(widest->lower + width / 4, widest->upper - width / 4);
  }

  /// In no enclosure of an end or turning point, and no rational root.
  bool is_free(const Rational& sample) const {
    const auto holds = [&](const RationalInterval& interval) {
      return interval.lower <= sample && sample <= interval.upper;
    };
    return std::none_of(roots_.begin(), roots_.end(),
                        [&](const EliminantRoot& root) { return root.at.width() == 0 && holds(root.at); }) &&
           std::none_of(curves_.begin(), curves_.end(), [&](const Stations& curve) {
             return std::any_of(curve.at.begin(), curve.at.end(), holds);
           });
  }

  /// Points of the known curves over a sample outside of all enclosures.
  std::size_t crossings(const Rational& sample) const {
    std::size_t count = 0;
    for (const Stations& curve : curves_) {
      const std::size_t n = curve.at.size();
      for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
        count += (curve.at[i].lower < sample) != (curve.at[(i + 1) % n].lower < sample) ? 1 : 0;
      }
    }
    return count;
  }

  [[noreturn]] void contradiction(const RationalInterval& at, const std::string& why) const {
    ParameterBox where = whole_domain();
    where[index(sweep_)] = at;
    throw ProofFailure(where, why);
  }

  const std::vector<EliminantRoot>& roots_;
  const std::vector<Stations>& curves_;
  const FibreCount& fibre_;
  Parameter sweep_;
  std::vector<int> known_;  // how much the known multiple points over the root, and points outside, count
};

}  // namespace

bool no_curve_is_missing(const std::vector<EliminantRoot>& roots, const std::vector<Stations>& curves,
                         const FibreCount& fibre, Parameter sweep,
                         const std::vector<RationalInterval>& singular) {
  return EliminantProof(roots, curves, fibre, sweep).run(singular);
}

std::vector<EliminantRoot> simple_roots(const std::vector<RationalInterval>& roots) {
  std::vector<EliminantRoot> result;
  for (const RationalInterval& root : roots) result.push_back({root});
  return result;
}

}  // namespace exsect
