#include "bounding_box.h"

#include <algorithm>

namespace exsect {

bool BoundingBox::contains(const Point& p) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < lower[k] || p[k] > upper[k]) return false;
  return true;
}

BoundingBox bounding_box(const BezierPatch& x) {
  BoundingBox box = {x.net()[0][0], x.net()[0][0]};
  for (const auto& row : x.net()) {
    for (const Point& p : row) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (p[k] < box.lower[k]) box.lower[k] = p[k];
        if (p[k] > box.upper[k]) box.upper[k] = p[k];
      }
    }
  }
  return box;
}

BoundingBox united(const BoundingBox& a, const BoundingBox& b) {
  BoundingBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lower[k] = std::min(a.lower[k], b.lower[k]);
    box.upper[k] = std::max(a.upper[k], b.upper[k]);
  }
  return box;
}

bool intersects(const BoundingBox& a, const BoundingBox& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.upper[k] < b.lower[k] || b.upper[k] < a.lower[k]) return false;
  return true;
}

Rational largest_extent(const BoundingBox& box) {
  const Point edges = box.upper - box.lower;
  return *std::max_element(edges.begin(), edges.end());
}

}  // namespace exsect
