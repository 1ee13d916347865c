// How far the local equations at a singular solution are from their leading terms. Internal to solver/;
// docs/method-doubles.md, sections 14.9 and 14.16.
#pragma once

#include "filter/local_forms.h"

namespace exsect::filter {

/// For |t| <= reach, |t| = max(|alpha|,|beta|): exactly one c with |c_i| <= k[i] reach satisfies the first
/// two equations, and |c_i| <= k[i] |t|. Of weighted patches e0 X and e0 Y are positive there.
struct LocalBounds {
  std::array<double, 2> k;
  std::array<double, 2> turn;  // |c_t - B S| <= turn[i] |t|, entry by entry
  double value;                // |g - q| <= value |t|³
  double slope;                // |g_t - q_t| <= slope |t|², for both components
};
/// Empty if `reach` is too large for that.
template <class K>
std::optional<LocalBounds> local_bounds(const LocalFormsOf<K>& forms, double reach);

}  // namespace exsect::filter
