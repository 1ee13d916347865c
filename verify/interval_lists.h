// Lists of closed intervals of doubles, for what a candidate covers. Internal to solver/; docs/method.md,
// section 15.
#pragma once

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
/// Whether a number is in some interval of any list.
bool contains(const std::vector<Interval>& covered, double at);
/// The length of the part of [from, to] that is in some interval, of any list.
double covered_length(const std::vector<Interval>& covered, double from, double to);

}  // namespace exsect
