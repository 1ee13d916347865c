// Where two patches have one normal, approximately. Internal to solver/; docs/method-doubles.md,
// section 14.9.
#pragma once

#include <optional>

#include "filter/patch.h"

namespace exsect::filter {

/// Taylor coefficients of a patch in space.
struct SecondOrder {
  Vec3 value, u, v, uu, uv, vv;
};
/// At (h,k), centred.
template <class K>
SecondOrder second_order(const PatchOf<K>& patch, double h, double k);

/// Newton's method for (x - y).y_r = (x - y).y_s = x_u.(y_r x y_s) = x_v.(y_r x y_s) = 0 from w (centred):
/// where it ends, if it settles; |x - y| is that of `distance` then.
struct CommonNormal {
  Vec4 at;
  double distance;
};
template <class K>
std::optional<CommonNormal> common_normal(const PairOf<K>& pair, Vec4 w);

/// The tangent planes being the same at w: the difference of the heights of x and y over the plane takes both
/// signs, to second order, (14.17).
template <class K>
bool looks_like_crossing(const PairOf<K>& pair, const Vec4& w);

}  // namespace exsect::filter
