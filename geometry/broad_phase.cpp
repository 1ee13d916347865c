#include "broad_phase.h"

// Boost.Geometry 1.74 includes a header that announces its own age in every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace exsect {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Corner>;
using Entry = std::pair<Box, std::uint32_t>;
using Tree = bgi::rtree<Entry, bgi::linear<16>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The greatest double <= q, or -infinity.
double rounded_down(const Rational& q, bool& exact) {
  const double nearest = to_double(q);
  if (std::isinf(nearest)) {
    exact = false;
    return nearest < 0 ? nearest : std::numeric_limits<double>::max();
  }
  const Rational value = from_double(nearest);
  if (value == q) return nearest;
  exact = false;
  return value < q ? nearest : std::nextafter(nearest, -infinity);
}

Box tree_box(const RoundedBox& box) {
  return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

}  // namespace

RoundedBox rounded_outwards(const BoundingBox& box) {
  return in_nearest_rounding([&] {
    RoundedBox rounded = {{}, {}, true};
    for (std::size_t k = 0; k < 3; ++k) {
      rounded.lower[k] = rounded_down(box.lower[k], rounded.exact);
      rounded.upper[k] = -rounded_down(-box.upper[k], rounded.exact);
    }
    return rounded;
  });
}

bool certainly_meet(const RoundedBox& a, const RoundedBox& b) {
  return in_nearest_rounding([&]() -> bool {
    // The true end lies within the double next to the rounded one, so the boxes shrunk by one double are
    // inside.
    const auto inner_lower = [](const RoundedBox& box, std::size_t k) {
      return box.exact ? box.lower[k] : std::nextafter(box.lower[k], infinity);
    };
    const auto inner_upper = [](const RoundedBox& box, std::size_t k) {
      return box.exact ? box.upper[k] : std::nextafter(box.upper[k], -infinity);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(inner_lower(a, k) <= inner_upper(b, k) && inner_lower(b, k) <= inner_upper(a, k))) return false;
    }
    return true;
  });
}

void visit_meeting_boxes(const std::vector<RoundedBox>& boxes,
                         const std::function<void(std::uint32_t, const std::vector<std::uint32_t>&)>& visit) {
  return in_nearest_rounding([&] {
    if (boxes.size() >= std::numeric_limits<std::uint32_t>::max())
      throw std::invalid_argument("broad phase: 2^32 boxes or more");
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (const RoundedBox& box : boxes)
      entries.emplace_back(tree_box(box), static_cast<std::uint32_t>(entries.size()));
    const Tree tree(entries);  // bulk loaded
    std::vector<Entry>().swap(entries);
    std::vector<std::uint32_t> later;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      later.clear();
      const auto keep = [&](const Entry& entry) {
        if (entry.second > i) later.push_back(entry.second);
      };
      tree.query(bgi::intersects(tree_box(boxes[i])), boost::make_function_output_iterator(keep));
      if (later.empty()) continue;
      std::sort(later.begin(), later.end());
      visit(i, later);
    }
  });
}

}  // namespace exsect
