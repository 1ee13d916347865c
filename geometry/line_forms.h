// The forms of a parameter line over any ring, the formulas of method, section 1. Internal to geometry/.
#pragma once

#include <exsect/geometry/pull_back.h>

#include "vector_algebra.h"

namespace exsect {

/// a[0] + a[1] t + a[2] t^2.
template <class Ring>
using LineOver = std::array<VectorOver<Ring>, 3>;

template <class Ring>
AffineFormOver<Ring> form_through_over(const VectorOver<Ring>& a0, const VectorOver<Ring>& normal) {
  return {normal, -dot_over(normal, a0)};
}

template <class Ring>
AffineFormOver<Ring> constant_form_over(const Ring& c) {
  return {{Ring(0), Ring(0), Ring(0)}, c};
}

/// Orthogonal cylinder; n = a1 x a2.
template <class Ring>
LineFormsOver<Ring> orthogonal_forms_over(const LineOver<Ring>& a, const VectorOver<Ring>& n) {
  return {form_through_over(a[0], n), constant_form_over(dot_over(n, n)),
          form_through_over(a[0], cross_over(a[2], n)), form_through_over(a[0], cross_over(n, a[1]))};
}

/// Cylinder along the coordinate axis k; n = a1 x a2.
template <class Ring>
LineFormsOver<Ring> axis_forms_over(const LineOver<Ring>& a, const VectorOver<Ring>& n, std::size_t k) {
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  // (w x a2)_k = w_i a2_j - w_j a2_i and (a1 x w)_k = a1_i w_j - a1_j w_i with w = P - a0
  VectorOver<Ring> e1 = {Ring(0), Ring(0), Ring(0)};
  VectorOver<Ring> e2 = e1;
  e1[i] = a[2][j];
  e1[j] = -a[2][i];
  e2[i] = -a[1][j];
  e2[j] = a[1][i];
  return {form_through_over(a[0], n), constant_form_over(n[k]), form_through_over(a[0], e1),
          form_through_over(a[0], e2)};
}

/// The index of the coordinate that is largest in magnitude, the first of them.
template <class Ring>
std::size_t largest_coordinate(const VectorOver<Ring>& n) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(n[i]) > abs(n[k])) k = i;
  return k;
}

}  // namespace exsect
