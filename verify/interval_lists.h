// Lists of closed intervals of doubles, for what a candidate covers. Internal to solver/;
// docs/method-verify.md, section 15.
#pragma once

#include <map>
#include <utility>
#include <vector>

namespace exsect {

using Interval = std::pair<double, double>;

/// Sorted, overlapping and adjacent ones united.
std::vector<Interval> united(std::vector<Interval> intervals);
/// What two united lists have in common.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b);
/// What of [0, length] is left by a united list.
std::vector<Interval> remaining(const std::vector<Interval>& covered, double length);

/// A union of closed intervals that grows.
class IntervalSet {
 public:
  void add(const Interval& interval);
  bool contains(double at) const;
  /// The length of its part in [from, to].
  double length(double from, double to) const;
  std::vector<Interval> intervals() const { return {ends_.begin(), ends_.end()}; }

 private:
  /// The last interval that begins at or before the number, or the first one.
  std::map<double, double>::const_iterator before(double at) const;

  std::map<double, double> ends_;  // by the beginning; apart from each other
};

/// Numbered intervals, to find those that have more than a point in common with another one: in a time that
/// grows with their number alone where all have a similar length.
class IntervalIndex {
 public:
  /// The next number, from 0.
  void add(const Interval& interval);
  /// In ascending order.
  std::vector<std::size_t> crossing(const Interval& interval) const;

 private:
  std::multimap<double, std::pair<double, std::size_t>> by_begin_;  // to the end and the number
  double longest_ = 0;
};

}  // namespace exsect
