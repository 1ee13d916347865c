// Which of many boxes meet.
#pragma once

#include <exsect/geometry/bounding_box.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace exsect {

/// A box with ends in doubles, rounded outwards: it contains the box that it stands for, and no double lies
/// between an end and the true end. `exact`: nothing was rounded.
struct RoundedBox {
  std::array<double, 3> lower;
  std::array<double, 3> upper;
  bool exact;

  friend bool operator==(const RoundedBox&, const RoundedBox&) = default;
};

/// Ends beyond the range of doubles become infinite.
RoundedBox rounded_outwards(const BoundingBox& box);

/// True if the true boxes certainly have a point in common, false if that is not known. For rounded boxes
/// that meet (the only ones that it makes sense for), the exact boxes decide where it is false.
bool certainly_meet(const RoundedBox& a, const RoundedBox& b);

/// Calls `visit` with every i in ascending order and all j > i, ascending, whose closed rounded boxes have a
/// point in common with that of i; not for i without any. By an R-tree: the time grows as n log n and the
/// number of pairs. Requires less than 2^32 boxes.
void visit_meeting_boxes(const std::vector<RoundedBox>& boxes,
                         const std::function<void(std::uint32_t, const std::vector<std::uint32_t>&)>& visit);

}  // namespace exsect
