#include "lift/shared_arcs.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace exsect {
namespace {

Rational turn_to(const PlaneDirection& a, const PlaneDirection& b) { return a[0] * b[1] - a[1] * b[0]; }
Rational along(const PlaneDirection& a, const PlaneDirection& b) { return a[0] * b[0] + a[1] * b[1]; }

bool is_same_direction(const PlaneDirection& a, const PlaneDirection& b) {
  return turn_to(a, b) == 0 && along(a, b) > 0;
}

/// Half a turn or more beyond a.
bool is_beyond_half(const PlaneDirection& a, const PlaneDirection& b) {
  const int s = sign(turn_to(a, b));
  return s < 0 || (s == 0 && along(a, b) < 0);
}

bool contains(const CircleArc& arc, const PlaneDirection& a) { return !comes_before(arc.from, arc.to, a); }

}  // namespace

bool CircleArc::is_point() const { return is_same_direction(from, to); }

bool comes_before(const PlaneDirection& a, const PlaneDirection& b, const PlaneDirection& c) {
  if (is_same_direction(b, c) || is_same_direction(a, c)) return false;
  if (is_same_direction(a, b)) return true;
  const bool b_beyond = is_beyond_half(a, b), c_beyond = is_beyond_half(a, c);
  return b_beyond != c_beyond ? c_beyond : turn_to(b, c) > 0;
}

/// (17.17)
std::vector<CircleArc> shared_arcs(const CircleArc& one, const CircleArc& other) {
  if (one.is_point()) return contains(other, one.from) ? std::vector{one} : std::vector<CircleArc>{};
  if (other.is_point()) return shared_arcs(other, one);
  const auto before = [&](const PlaneDirection& b, const PlaneDirection& c) {
    return comes_before(one.from, b, c);
  };
  const auto first_of = [&](const PlaneDirection& b, const PlaneDirection& c) {
    return before(b, c) ? b : c;
  };
  const bool holds_start = !before(other.from, other.to);  // it runs through the start, or ends there
  const bool begins_within = !before(one.to, other.from);
  std::vector<CircleArc> parts;
  if (holds_start) parts.push_back({one.from, first_of(other.to, one.to)});
  if (!begins_within) return parts;
  parts.push_back({other.from, holds_start ? one.to : first_of(other.to, one.to)});
  return parts;
}

std::vector<CircleArc> parts_of_all(const std::vector<CircleArc>& arcs) {
  std::vector<CircleArc> parts(arcs.begin(), arcs.begin() + (arcs.empty() ? 0 : 1));
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    std::vector<CircleArc> fewer;
    for (const CircleArc& part : parts)
      std::ranges::copy(shared_arcs(part, arcs[i]), std::back_inserter(fewer));
    parts = std::move(fewer);
  }
  return parts;
}

}  // namespace exsect
