// The Newton polygon of a power series in two numbers. Internal to solver/; docs/method-doubles.md,
// section 14.26.
#pragma once

#include <exsect/algebra/polynomial.h>

#include <vector>

#include "filter/plane_series.h"

namespace exsect::filter {

/// An edge: p = t^p_weight, q = c t^q_weight make p^i q^j = c^j t^degree for its terms, and of a higher power
/// of t for all others; the weights are positive and coprime. Its lowest and highest powers of q, with those
/// of p beside them, are vertices.
struct PolygonEdge {
  int p_weight;
  int q_weight;
  int degree;
  std::array<int, 2> lowest;   // i, j
  std::array<int, 2> highest;  // i, j
  Polynomial in_c;             // sum of c_ij c^j
};

/// From the terms q^j to the terms p^i, steep edges first: highest of each is lowest of the one before. Empty
/// if there are no terms p^i, or q^j, of the polynomial, or a constant one.
std::vector<PolygonEdge> newton_polygon(const PlaneSeries& series);

}  // namespace exsect::filter
