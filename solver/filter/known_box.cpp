#include "filter/known_box.h"

#include <algorithm>

#include "filter/error_bounds.h"

namespace exsect::filter {

KnownBox known_box(const ParameterBox& box) {
  KnownBox known;
  for (std::size_t j = 0; j < 4; ++j) known.range[j] = {to_double(box[j].lower), to_double(box[j].upper)};
  return known;
}

bool lie_in(const KnownBox& box, const Part& x, const Part& y) {
  const std::array<Part::Interval, 4> ranges = {x.range[0], x.range[1], y.range[0], y.range[1]};
  return std::equal(ranges.begin(), ranges.end(), box.range.begin(),
                    [](const Part::Interval& part, const Part::Interval& all) {
                      return part.lower >= all.lower && part.upper <= all.upper;
                    });
}

std::optional<bool> is_in(const KnownBox& box, std::span<const double, 4> middle, double radius) {
  const double error = kSlack * radius + kSumRounding;
  bool inside = true;
  for (std::size_t j = 0; j < 4; ++j) {
    const double t = middle[j] + 0.5;
    if (t + error < box.range[j].lower || t - error > box.range[j].upper) return false;
    inside = inside && t - error > box.range[j].lower && t + error < box.range[j].upper;
  }
  return inside ? std::optional(true) : std::nullopt;
}

}  // namespace exsect::filter
