#include "sweep/search_window.h"

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"

namespace exsect {

ParameterBox SearchWindow::box(const SearchRegion& seen) const {
  const auto at = [this](double t) { return range.lower + range.width() * from_double(t); };
  ParameterBox result;
  for (std::size_t j = 0; j < 4; ++j) {
    result[j] = {from_double(seen.lower[j]), from_double(seen.upper[j])};
  }
  result[index(across)] = {at(seen.lower[index(across)]), at(seen.upper[index(across)])};
  return result;
}

std::array<double, 2> SearchWindow::direction(std::array<double, 2> c) const {
  if (index(across) < 2) {
    c[index(across)] *= to_double(range.width());
  }
  return c;
}

SearchWindow window_around(const SweepData& sweep, const RealAlgebraic& value) {
  Rational half = power_of_two(-24);
  const auto keep_away = [&](const auto& interval_at) {
    for (const Rational& width : {power_of_two(-60), power_of_two(-400)}) {
      const Rational d = gap(interval_at(width), value.refined_to(width).interval());
      if (d > 0) {
        half = std::min<Rational>(half, d / 64);
        return;
      }
    }
  };
  for (const TurningValue& other : sweep.turning->values) {
    if (&other.value != &value) {
      keep_away([&](const Rational& width) { return other.value.refined_to(width).interval(); });
    }
  }
  const std::size_t across = index(sweep.turning->sweep);
  for (const LandmarkPoint& landmark : sweep.landmarks) {
    keep_away([&](const Rational& width) { return landmark.point.refined_to(width).box()[across]; });
  }
  const RationalInterval at = value.refined_to(half * power_of_two(-20)).interval();
  const Rational middle = simplest_between(at.lower - half / 64, at.upper + half / 64);
  return {sweep.turning->sweep, {std::max<Rational>(0, middle - half), std::min<Rational>(1, middle + half)}};
}

SearchRegion rounded_outwards(const ParameterBox& box) {
  SearchRegion region{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double lower = to_double(box[j].lower);
    const double upper = to_double(box[j].upper);
    region.lower[j] = from_double(lower) <= box[j].lower ? lower : std::nextafter(lower, -1.0);
    region.upper[j] = from_double(upper) >= box[j].upper ? upper : std::nextafter(upper, 2.0);
  }
  return region;
}

}  // namespace exsect
