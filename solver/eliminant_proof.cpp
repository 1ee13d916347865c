#include "eliminant_proof.h"

#include <algorithm>
#include <stdexcept>

namespace exsect {

namespace {

constexpr long kWidths[] = {16, 32, 64};  // roots are refined to 2^-width where they are not told apart

bool meet(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

class EliminantProof {
 public:
  EliminantProof(const TurningValues& turning, const std::vector<Stations>& curves, const FibreCount& fibre)
      : curves_(curves), fibre_(fibre) {
    for (const TurningValue& turn : turning.values) roots_.push_back({turn.value, false});
  }

  bool run() { return match_turning_points() && count_fibres(); }

 private:
  struct Root {
    RealAlgebraic value;
    bool taken;  // under a turning point of a known curve
  };

  /// Every known turning point lies over a root, a simple one lies under no other.
  bool match_turning_points() {
    for (const Stations& curve : curves_) {
      const std::size_t ends = curve.closed ? 0 : 1;
      for (std::size_t i = ends; i + ends < curve.at.size(); ++i) {
        const auto root = root_at(curve.at[i]);
        if (!root) return false;
        if (roots_[*root].taken) {
          throw std::logic_error("two turning points lie over a simple root of the eliminant");
        }
        roots_[*root].taken = true;
      }
    }
    return true;
  }

  std::optional<std::size_t> root_at(const RationalInterval& place) {
    std::vector<std::size_t> candidates;
    const auto collect = [&] {
      candidates.clear();
      for (std::size_t i = 0; i < roots_.size(); ++i) {
        if (meet(roots_[i].value.interval(), place)) candidates.push_back(i);
      }
    };
    collect();
    for (const long width : kWidths) {
      if (candidates.size() < 2) break;
      for (const std::size_t i : candidates) {
        roots_[i].value = roots_[i].value.refined_to(power_of_two(-width));
      }
      collect();
    }
    if (candidates.empty()) {
      throw std::logic_error("no root of the eliminant lies under a turning point");
    }
    return candidates.size() == 1 ? std::optional(candidates.front()) : std::nullopt;
  }

  /// A further closed curve has its extremes over two roots that are not taken: it meets the fibre over any
  /// sample between them.
  bool count_fibres() {
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      if (roots_[i].taken) continue;
      if (last && !count_between(*last, i)) return false;
      last = i;
    }
    return true;
  }

  bool count_between(std::size_t left, std::size_t right) {
    std::optional<Rational> sample = sample_between(left, right);
    for (const long width : kWidths) {
      if (sample) break;
      for (std::size_t i = left; i <= right; ++i) {
        roots_[i].value = roots_[i].value.refined_to(power_of_two(-width));
      }
      sample = sample_between(left, right);
    }
    const auto count = sample ? fibre_(*sample) : std::nullopt;
    if (count && *count != crossings(*sample)) {
      throw std::logic_error("the known curves and a fibre are not in bijection");
    }
    return count.has_value();
  }

  /// In the widest gap between all enclosures, strictly between the two roots.
  std::optional<Rational> sample_between(std::size_t left, std::size_t right) const {
    const Rational end = roots_[right].value.interval().lower;
    Rational lower = roots_[left].value.interval().upper;
    std::vector<RationalInterval> events = {{end, end}};
    const auto add = [&](const RationalInterval& interval) {
      if (interval.upper > lower && interval.lower < end) events.push_back(interval);
    };
    for (const Root& root : roots_) add(root.value.interval());
    for (const Stations& curve : curves_) std::for_each(curve.at.begin(), curve.at.end(), add);
    std::sort(events.begin(), events.end(),
              [](const RationalInterval& a, const RationalInterval& b) { return a.lower < b.lower; });
    RationalInterval widest{lower, lower};
    for (const RationalInterval& event : events) {
      if (event.lower - lower > widest.width()) widest = {lower, event.lower};
      lower = std::max(lower, event.upper);
    }
    const Rational width = widest.width();
    if (width <= 0) return std::nullopt;
    return simplest_between(widest.lower + width / 4, widest.upper - width / 4);
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

  const std::vector<Stations>& curves_;
  const FibreCount& fibre_;
  std::vector<Root> roots_;  // ascending
};

}  // namespace

bool no_curve_is_missing(const TurningValues& turning, const std::vector<Stations>& curves,
                         const FibreCount& fibre) {
  const bool simple = std::all_of(turning.values.begin(), turning.values.end(),
                                  [](const TurningValue& turn) { return turn.multiplicity == 1; });
  return simple && !turning.touching && EliminantProof(turning, curves, fibre).run();
}

}  // namespace exsect
