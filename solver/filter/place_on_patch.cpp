#include "filter/place_on_patch.h"

#include <cmath>

#include "filter/common_normal.h"

namespace exsect::filter {

namespace {

constexpr int kGuessSteps = 6;
/// How near to each other points are in doubles that would be the same in exact arithmetic.
constexpr double kClose = 0x1p-30;
/// The square may be a small part of what is asked for.
constexpr double kFarthest = 1e4;

}  // namespace

Place coordinates(const Vec3& p, const Vec3& q, const Vec3& v) {
  const double pp = dot(p, p);
  const double pq = dot(p, q);
  const double qq = dot(q, q);
  const double inverse = 1 / (pp * qq - pq * pq);
  return {inverse * (qq * dot(p, v) - pq * dot(q, v)), inverse * (pp * dot(q, v) - pq * dot(p, v))};
}

template <class K>
bool improve_place(const PatchOf<K>& patch, Place& at, const Vec3& point) {
  for (int step = 0; step < kGuessSteps; ++step) {
    if (!(std::fabs(at[0]) < kFarthest && std::fabs(at[1]) < kFarthest)) {
      return false;
    }
    const SecondOrder c = second_order(patch, at[0], at[1]);
    const Vec3 miss = point - c.value;
    const Place by = coordinates(c.u, c.v, miss);
    at = {at[0] + by[0], at[1] + by[1]};
    if (std::fabs(by[0]) + std::fabs(by[1]) < 0x1p-40 * (1 + std::fabs(at[0]) + std::fabs(at[1]))) {
      return largest(miss) < kClose;
    }
  }
  return false;
}

#define EXSECT_INSTANTIATE(K) template bool improve_place<K>(const PatchOf<K>&, Place&, const Vec3&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
