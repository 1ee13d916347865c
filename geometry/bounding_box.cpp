#include "bounding_box.h"

#include <algorithm>

#include "rational_patch.h"

namespace exsect {
namespace {

void extend(BoundingBox& box, const Point& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < box.lower[k]) box.lower[k] = p[k];
    if (p[k] > box.upper[k]) box.upper[k] = p[k];
  }
}

bool has_positive_weights(const RationalPatch& x) {
  for (int i = 0; i <= x.degree_u(); ++i)
    for (int j = 0; j <= x.degree_v(); ++j)
      if (x.weight(i, j) <= 0) return false;
  return true;
}

}  // namespace

bool BoundingBox::contains(const Point& p) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < lower[k] || p[k] > upper[k]) return false;
  return true;
}

BoundingBox bounding_box(const BezierPatch& x) {
  BoundingBox box = {x.net()[0][0], x.net()[0][0]};
  for (const auto& row : x.net())
    for (const Point& p : row) extend(box, p);
  return box;
}

BoundingBox bounding_box(const RationalPatch& x) {
  if (!has_positive_weights(x)) {
    // Method, section 16: the weights of small parts are near to the values of the denominator, which is
    // positive.
    const Rational half(1, 2);
    const auto part = [&](int i, int j) {
      return bounding_box(x.restricted_to(i * half, (i + 1) * half, j * half, (j + 1) * half));
    };
    return united(united(part(0, 0), part(0, 1)), united(part(1, 0), part(1, 1)));
  }
  BoundingBox box = {x.point(0, 0), x.point(0, 0)};
  for (int i = 0; i <= x.degree_u(); ++i)
    for (int j = 0; j <= x.degree_v(); ++j) extend(box, x.point(i, j));
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
