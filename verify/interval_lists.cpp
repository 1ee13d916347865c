#include "interval_lists.h"

#include <algorithm>

namespace exsect {

std::vector<Interval> united(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::vector<Interval> result;
  for (const Interval& next : intervals) {
    if (!result.empty() && next.first <= result.back().second)
      result.back().second = std::max(result.back().second, next.second);
    else
      result.push_back(next);
  }
  return result;
}

std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> result;
  for (const Interval& i : a)
    for (const Interval& j : b)
      if (std::max(i.first, j.first) <= std::min(i.second, j.second))
        result.push_back({std::max(i.first, j.first), std::min(i.second, j.second)});
  return result;
}

std::vector<Interval> remaining(const std::vector<Interval>& covered, double length) {
  std::vector<Interval> result;
  double at = 0;
  for (const Interval& i : covered) {
    if (i.first > at) result.push_back({at, i.first});
    at = std::max(at, i.second);
  }
  if (at < length) result.push_back({at, length});
  return result;
}

bool contains(const std::vector<Interval>& covered, double at) {
  return std::any_of(covered.begin(), covered.end(),
                     [&](const Interval& i) { return i.first <= at && at <= i.second; });
}

double covered_length(const std::vector<Interval>& covered, double from, double to) {
  double result = 0;
  for (const Interval& i : united(covered))
    result += std::max(0.0, std::min(i.second, to) - std::max(i.first, from));
  return result;
}

}  // namespace exsect
