// Arcs of a circle with ends in sixteen directions, against sets of directions and gaps between them.
#include "lift/shared_arcs.h"

#include <algorithm>
#include <set>

#include "support/catch.h"

namespace exsect::shared_arcs_test {
namespace {

constexpr int many = 16;

/// Counter-clockwise, of several lengths.
PlaneDirection direction(int k) {
  const std::array<std::array<int, 2>, 4> quarter = {{{3, 0}, {5, 2}, {1, 1}, {1, 4}}};
  std::array<int, 2> d = quarter[static_cast<std::size_t>(k % 4)];
  for (int turn = 0; turn < k % many / 4; ++turn) d = {-d[1], d[0]};
  return {Rational(d[0], 7), Rational(d[1], 7)};
}

/// Directions are even numbers, the gaps between them odd ones.
std::set<int> cells(int from, int to) {
  std::set<int> result;
  for (int k = 2 * from;; ++k) {
    result.insert(k % (2 * many));
    if (k % (2 * many) == 2 * (to % many) && k > 2 * from) return result;
  }
}

}  // namespace

TEST_CASE("shared arcs: every pair of arcs between sixteen directions") {
  const auto number_of = [](const PlaneDirection& d) {
    for (int k = 0; k < many; ++k)
      if (CircleArc{direction(k), d}.is_point()) return k;
    return -1;
  };
  for (int a = 0; a < many; ++a)
    for (int b = a + 1; b < a + many; ++b)
      for (int c = 0; c < many; ++c)
        for (int d = c + 1; d < c + many; ++d) {
          std::set<int> expected, found;
          std::ranges::set_intersection(cells(a, b), cells(c, d), std::inserter(expected, expected.end()));
          std::size_t size = 0;
          for (const CircleArc& arc :
               shared_arcs({direction(a), direction(b)}, {direction(c), direction(d)})) {
            const int from = number_of(arc.from), to = number_of(arc.to);
            const std::set<int> part =
                from == to ? std::set<int>{2 * from} : cells(from, to < from ? to + many : to);
            size += part.size();
            found.insert(part.begin(), part.end());
          }
          if (found == expected && size == found.size()) continue;
          FAIL(a << " to " << b << " and " << c << " to " << d);
        }
}

TEST_CASE("shared arcs: points, and parts of many") {
  const CircleArc arc = {direction(3), direction(9)}, point = {direction(9), direction(9)};
  CHECK(shared_arcs(arc, point).size() == 1);
  CHECK(shared_arcs(point, arc).at(0).is_point());
  CHECK(shared_arcs(point, point).size() == 1);
  CHECK(shared_arcs(point, {direction(10), direction(8)}).empty());
  CHECK(shared_arcs(point, {direction(4), direction(4)}).empty());
  CHECK(parts_of_all({}).empty());
  CHECK(parts_of_all({arc}).size() == 1);
  // 9 alone, then 9 and 3 to 4.
  CHECK(parts_of_all({arc, {direction(9), direction(1)}, {direction(8), direction(10)}}).at(0).is_point());
  CHECK(parts_of_all({arc, {direction(9), direction(4)}, {direction(14), direction(11)}}).size() == 2);
}

TEST_CASE("shared arcs: the order of directions beyond one of them") {
  for (int a = 0; a < many; ++a)
    for (int b = 0; b < many; ++b)
      for (int c = 0; c < many; ++c)
        if (comes_before(direction(a), direction(a + b), direction(a + c)) != (b < c))
          FAIL(a << " " << b << " " << c);
}

}  // namespace exsect::shared_arcs_test
