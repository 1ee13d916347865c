#include "eliminant/critical_values.h"

#include <exsect/solver/turning_eliminant.h>

#include <algorithm>

#include "shape/planar_patch.h"

namespace exsect {

namespace {

/// (4.22) where y is plane, else (4.7) to (4.21), along u.
TurningEliminant eliminant_along_u(const BezierPatch& x, const BezierPatch& y) {
  if (auto planar = planar_turning_eliminant(x, y)) {
    return {std::move(planar), {}, false};
  }
  return turning_eliminant(x, y);
}

TurningEliminant eliminant_along(const BezierPatch& x, const BezierPatch& y, Parameter sweep) {
  switch (sweep) {
    case Parameter::u:
      return eliminant_along_u(x, y);
    case Parameter::v:
      return eliminant_along_u(x.exchanged(), y);
    case Parameter::r:
      return eliminant_along_u(y, x);
    case Parameter::s:
      break;
  }
  return eliminant_along_u(y.exchanged(), x);
}

/// The factors of the polynomial with their multiplicities, or 0 where these mean nothing.
std::vector<PolynomialPower> weighted_factors(const TurningEliminant& eliminant) {
  const Polynomial& e = *eliminant.polynomial;
  if (eliminant.unweighted.degree() == 0) {
    return is_squarefree(e) ? std::vector<PolynomialPower>{{e, 1}} : squarefree_factors(e);
  }
  const Polynomial unweighted = squarefree_part(eliminant.unweighted);
  std::vector<PolynomialPower> result = {{unweighted, 0}};
  for (PolynomialPower& power : squarefree_factors(exact_quotient(e, eliminant.unweighted))) {
    power.factor = exact_quotient(power.factor, gcd(power.factor, unweighted));
    if (power.factor.degree() > 0) {
      result.push_back(std::move(power));
    }
  }
  return result;
}

TurningValues turning_values_of(const TurningEliminant& eliminant, Parameter sweep) {
  std::vector<TurningValue> result;
  const auto append_roots = [&](const Polynomial& f, int multiplicity) {
    for (RealAlgebraic& root : real_roots(f, 0, 1)) {
      result.push_back({std::move(root), multiplicity});
    }
  };
  for (const auto& [factor, multiplicity] : weighted_factors(eliminant)) {
    if (multiplicity == 1) {
      append_roots(factor, 1);
      continue;
    }
    // Events over multiple roots are studied in exact arithmetic: their numbers must be as simple as can be.
    for (const PolynomialPower& irreducible : irreducible_factors(factor)) {
      append_roots(irreducible.factor, multiplicity);
    }
  }
  std::sort(result.begin(), result.end(),
            [](const TurningValue& a, const TurningValue& b) { return a.value < b.value; });
  return {sweep, std::move(result), eliminant.touching};
}

/// A closed interval that holds critical values; `turning` is the index of the one turning value in it, or
/// -1.
struct Event {
  RationalInterval interval;
  int turning;
};

/// Sorts and merges overlapping events; false if two turning values would be merged.
bool merge_events(std::vector<Event>& events) {
  std::vector<Event> merged;
  for (const Event& event : events) {
    if (merged.empty() || merged.back().interval.upper < event.interval.lower) {
      merged.push_back(event);
      continue;
    }
    Event& last = merged.back();
    if (last.turning >= 0 && event.turning >= 0) {
      return false;
    }
    last.interval.upper = std::max(last.interval.upper, event.interval.upper);
    last.turning = std::max(last.turning, event.turning);
  }
  events = std::move(merged);
  return true;
}

std::vector<Event> events_within(TurningValues& turning, const std::vector<CertifiedPoint>& boundary,
                                 const Rational& width) {
  std::vector<Event> events;
  for (std::size_t i = 0; i < turning.values.size(); ++i) {
    turning.values[i].value = turning.values[i].value.refined_to(width);
    events.push_back({turning.values[i].value.interval(), static_cast<int>(i)});
  }
  for (const CertifiedPoint& point : boundary) {
    events.push_back({point.refined_to(width).box()[index(turning.sweep)], -1});
  }
  std::sort(events.begin(), events.end(),
            [](const Event& a, const Event& b) { return a.interval.lower < b.interval.lower; });
  return events;
}

/// Away from both ends: beside one of them what is over the sample is close to what is over a critical value.
Rational sample_between(const Rational& left, const Rational& right) {
  const Rational quarter = (right - left) / 4;
  return simplest_between(left + quarter, right - quarter);
}

/// A curve of contact is found by a fibre between its ends: two boundary points that cannot be told apart may
/// be these.
bool may_hide_contact(const std::vector<Event>& events) {
  return std::adjacent_find(events.begin(), events.end(), [](const Event& a, const Event& b) {
           return b.interval.lower <= a.interval.upper && a.turning < 0 && b.turning < 0 &&
                  a.interval.width() + b.interval.width() > 0;
         }) != events.end();
}

}  // namespace

std::optional<TurningValues> turning_values(const BezierPatch& x, const BezierPatch& y, Parameter sweep) {
  const TurningEliminant eliminant = eliminant_along(x, y, sweep);
  if (!eliminant.polynomial) return std::nullopt;
  return turning_values_of(eliminant, sweep);
}

namespace {

/// How hard a sweep will be: the least comes first.
struct Difficulty {
  bool touching;
  int unweighted;  // roots without a multiplicity, complex ones too
  /// Values inside of [0,1] of a high multiplicity, which come of lines that lie on the other patch, or
  /// nearly, and double ones that are rational, which may.
  std::ptrdiff_t lines;
  std::ptrdiff_t multiple;  // all values without a multiplicity of one
  auto operator<=>(const Difficulty&) const = default;
};

Difficulty difficulty(const TurningEliminant& eliminant, const TurningValues& turning) {
  const auto may_be_line = [](const TurningValue& value) {
    return value.multiplicity != 1 && (value.multiplicity != 2 || value.value.is_rational()) &&
           value.value.compare(0) > 0 && value.value.compare(1) < 0;
  };
  const auto is_multiple = [](const TurningValue& value) { return value.multiplicity != 1; };
  return {eliminant.touching, eliminant.unweighted.degree(),
          std::count_if(turning.values.begin(), turning.values.end(), may_be_line),
          std::count_if(turning.values.begin(), turning.values.end(), is_multiple)};
}

}  // namespace

SweepChoice choose_sweep(const BezierPatch& x, const BezierPatch& y, const StopRequest& stop) {
  SweepChoice choice;
  std::optional<Difficulty> least;
  for (const Parameter sweep : all_parameters) {
    if (is_stopped(stop)) {
      break;
    }
    const TurningEliminant eliminant = eliminant_along(x, y, sweep);
    auto& tried = choice.tried[index(sweep)].emplace();
    if (!eliminant.polynomial) {
      choice.why += (choice.why.empty() ? "" : "; ") + std::string("sweep along ") + name(sweep) + ": " +
                    eliminant.degenerate;
      continue;
    }
    tried = turning_values_of(eliminant, sweep);
    const Difficulty here = difficulty(eliminant, *tried);
    const bool first = !least;
    if (first || here < *least) {
      choice.turning = tried;
      least = here;
    }
    if (!here.touching && here.lines == 0 && (first || here.multiple == 0)) {
      break;
    }
  }
  return choice;
}

std::vector<Rational> sweep_samples(TurningValues& turning, const std::vector<CertifiedPoint>& boundary) {
  Rational width = power_of_two(-50);
  std::vector<Event> events = events_within(turning, boundary, width);
  while ((turning.touching && width > power_of_two(-800) && may_hide_contact(events)) ||
         !merge_events(events)) {
    width *= width;
    events = events_within(turning, boundary, width);
  }
  std::vector<Rational> samples;
  Rational left = 0;
  for (const Event& event : events) {
    const Rational right = std::min<Rational>(event.interval.lower, 1);
    if (left < right) {
      samples.push_back(sample_between(left, right));
    }
    left = std::max<Rational>(event.interval.upper, left);
  }
  if (left < 1) {
    samples.push_back(sample_between(left, 1));
  }
  return samples;
}

}  // namespace exsect
