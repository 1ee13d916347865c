#include "filter/lone_corner.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace exsect::filter {

namespace {

constexpr int kMostHalvings = 6;

/// On which places the Bernstein polynomial of index i of n, j of m, is positive.
SquarePlaces where_positive(std::size_t i, std::size_t n, std::size_t j, std::size_t m) {
  const auto along = [](std::size_t k, std::size_t degree) { return std::array{k == 0, true, k == degree}; };
  const auto first = along(i, n), second = along(j, m);
  SquarePlaces result = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      if (first[a] && second[b]) result |= 1U << (3 * a + b);
  return result;
}

/// The control points of one patch that count on the places where solutions may be.
struct Remaining {
  struct Entry {
    Point vector;
    SquarePlaces positive;
  };
  std::vector<Entry> entries;
  SquarePlaces places = kAllPlaces;

  /// The points times `sign`.
  Remaining(const ControlVectors& net, int sign) {
    using exsect::operator*;
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j) {
        const HomogeneousPoint& h = net[i][j];
        const Point vector = Rational(sign) * Point{h[0], h[1], h[2]};
        if (!exsect::is_zero(vector))
          entries.push_back({vector, where_positive(i, net.size() - 1, j, net[i].size() - 1)});
      }
  }

  /// Leaves the places where n.X = 0. Requires n.X_k >= 0 for all entries.
  void restrict_to_plane(const Point& n) {
    for (const Entry& entry : entries)
      if (exsect::dot(n, entry.vector) > 0) places &= ~entry.positive;
    std::erase_if(entries, [&](const Entry& entry) { return (entry.positive & places) == 0; });
  }
};

/// The vector times a positive number: primitive integers.
Point primitive(const Point& v) {
  using exsect::operator*;
  Integer divisor = 0, common = 1;
  for (const Rational& c : v) common = lcm(common, denominator(c));
  for (const Rational& c : v) divisor = gcd(divisor, numerator(Rational(common * c)));
  return divisor == 0 ? v : Rational(common) / Rational(divisor) * v;
}

/// Candidates for normals of planes that support the cone of the vectors: those of two of its rays, both
/// ways, and, where all are in a plane or on a line, directions in it.
std::set<Point> candidates(const std::set<Point>& vectors) {
  using exsect::operator*;
  std::set<Point> result;
  for (auto a = vectors.begin(); a != vectors.end(); ++a) {
    result.insert(*a);
    for (auto b = std::next(a); b != vectors.end(); ++b) {
      const Point normal = primitive(exsect::cross(*a, *b));
      if (exsect::is_zero(normal)) continue;
      std::vector<Point> normals = {normal};
      if (std::ranges::all_of(vectors, [&](const Point& v) { return exsect::dot(normal, v) == 0; }))
        normals = {primitive(exsect::cross(normal, *a)), primitive(exsect::cross(normal, *b))};
      for (const Point& n : normals) result.insert({n, Rational(-1) * n});
    }
  }
  return result;
}

/// n with n.v >= 0 for all vectors, > 0 wherever that is so for any of the candidates; 0 if there is none.
Point supporting_normal(const Remaining& x, const Remaining& y) {
  using exsect::operator+;
  std::set<Point> vectors;
  for (const Remaining* patch : {&x, &y})
    for (const Remaining::Entry& entry : patch->entries) vectors.insert(primitive(entry.vector));
  Point sum = {0, 0, 0};
  for (const Point& n : candidates(vectors))
    if (std::ranges::all_of(vectors, [&](const Point& v) { return exsect::dot(n, v) >= 0; })) sum = sum + n;
  return sum;
}

/// The control points on [0,1/2].
void halve_row(std::vector<HomogeneousPoint>& row) {
  for (std::size_t step = 1; step < row.size(); ++step)
    for (std::size_t k = row.size() - 1; k >= step; --k)
      for (std::size_t c = 0; c < 4; ++c) row[k][c] = (row[k - 1][c] + row[k][c]) / 2;
}

void halve_net(ControlVectors& net, std::size_t parameter) {
  if (parameter == 1) {
    for (auto& row : net) halve_row(row);
    return;
  }
  for (std::size_t j = 0; j < net.front().size(); ++j) {
    std::vector<HomogeneousPoint> column;
    for (const auto& row : net) column.push_back(row[j]);
    halve_row(column);
    for (std::size_t i = 0; i < net.size(); ++i) net[i][j] = column[i];
  }
}

}  // namespace

template <class K>
CornerNet corner_net(const ExactPatch<K>& patch, std::size_t corner, const std::optional<SquareSide>& pole) {
  const std::array<bool, 2> upper = corner_ends<K>(corner);
  CornerNet net = {control_vectors(patch), pole ? side_places(pole->parameter) : kCornerPlace};
  if (upper[0]) std::ranges::reverse(net.points);
  for (auto& row : net.points)
    if (upper[1]) std::ranges::reverse(row);
  const HomogeneousPoint at = net.points.front().front();
  for (auto& row : net.points)
    for (HomogeneousPoint& h : row)
      for (std::size_t c = 0; c < 3; ++c) h[c] -= at[c] / at[3] * h[3];
  return net;
}

// (14.14a)
bool meet_in_own_places(const CornerNet& x, const CornerNet& y) {
  Remaining of_x(x.points, 1), of_y(y.points, -1);
  const auto is_left = [](const Remaining& patch, SquarePlaces own) { return (patch.places & ~own) != 0; };
  while (is_left(of_x, x.own) || is_left(of_y, y.own)) {
    // Where one patch is the origin, the other one is as well.
    if (!is_left(of_x, x.own)) of_x.entries.clear();
    if (!is_left(of_y, y.own)) of_y.entries.clear();
    const Point normal = supporting_normal(of_x, of_y);
    const auto before = std::array{of_x.places, of_y.places};
    of_x.restrict_to_plane(normal);
    of_y.restrict_to_plane(normal);
    if (std::array{of_x.places, of_y.places} == before) return false;
  }
  return true;
}

template <class K>
double lone_reach(const ExactPatch<K>& x, const ExactPatch<K>& y, const CornerContact& corner) {
  CornerNet of_x = corner_net<K>(x, corner.x, corner.pole_of_x);
  CornerNet of_y = corner_net<K>(y, corner.y, corner.pole_of_y);
  const auto shrink = [](CornerNet& net, const std::optional<SquareSide>& pole) {
    for (std::size_t p = 0; p < 2; ++p)
      if (!pole || pole->parameter == p) halve_net(net.points, p);
  };
  for (int k = 0; k <= kMostHalvings; ++k) {
    if (meet_in_own_places(of_x, of_y)) return std::ldexp(1.0, -k);
    shrink(of_x, corner.pole_of_x);
    shrink(of_y, corner.pole_of_y);
  }
  return 0;
}

#define EXSECT_INSTANTIATE(K)                                                                            \
  template CornerNet corner_net<K>(const ExactPatch<K>&, std::size_t, const std::optional<SquareSide>&); \
  template double lone_reach<K>(const ExactPatch<K>&, const ExactPatch<K>&, const CornerContact&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
