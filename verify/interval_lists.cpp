#include "interval_lists.h"

#include <algorithm>
#include <cmath>

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
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (std::max(i->first, j->first) <= std::min(i->second, j->second))
      result.push_back({std::max(i->first, j->first), std::min(i->second, j->second)});
    i->second < j->second ? ++i : ++j;
  }
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

std::map<double, double>::const_iterator IntervalSet::before(double at) const {
  const auto after = ends_.upper_bound(at);
  return after == ends_.begin() ? after : std::prev(after);
}

void IntervalSet::add(const Interval& interval) {
  auto [from, to] = interval;
  for (auto i = before(from); i != ends_.end() && i->first <= to;) {
    if (i->second < from) {
      ++i;
      continue;
    }
    from = std::min(from, i->first);
    to = std::max(to, i->second);
    i = ends_.erase(i);
  }
  ends_.emplace(from, to);
}

bool IntervalSet::contains(double at) const {
  const auto i = before(at);
  return i != ends_.end() && i->first <= at && at <= i->second;
}

double IntervalSet::length(double from, double to) const {
  double result = 0;
  for (auto i = before(from); i != ends_.end() && i->first <= to; ++i)
    result += std::max(0.0, std::min(i->second, to) - std::max(i->first, from));
  return result;
}

void IntervalIndex::add(const Interval& interval) {
  by_begin_.insert({interval.first, {interval.second, by_begin_.size()}});
  longest_ = std::max(longest_, interval.second - interval.first);
}

std::vector<std::size_t> IntervalIndex::crossing(const Interval& interval) const {
  std::vector<std::size_t> result;
  const double first = interval.first - longest_;
  // The difference may be rounded up: one more than its rounding is looked at.
  for (auto i = by_begin_.lower_bound(first - std::abs(first) * 0x1p-50);
       i != by_begin_.end() && i->first < interval.second; ++i)
    if (i->second.first > interval.first) result.push_back(i->second.second);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace exsect
