// The bidegrees of pairs of patches for which the eliminant of a sweep along u has closed formulas. Internal
// to solver/.
#pragma once

#include <cstddef>

namespace exsect {

// Of each kind: the coordinates of a vector; the degrees of x in u, at most, and in v, and of y in r and s;
// the degrees in s of R, with the points of a fibre as roots, and of its first subresultant S1; and the
// greatest degrees in u of R, S1, of the leading coefficients, and of E for the degree of x in u. No inline
// function of the standard library is used here: see turning_eliminant_lanes.cpp.

/// Polynomial patches of bidegree (2,2), by vectors in space: (4.8).
struct PolynomialKind {
  static constexpr std::size_t coordinates = 3;
  static constexpr std::size_t u_degree = 2, v_degree = 2, r_degree = 2, s_degree = 2;
  static constexpr std::size_t points = 16, s1_points = 10;
  static constexpr std::size_t fibre_degree = 16, s1_degree = 10, lead_degree = 4;  // of g_r and g_s
  static constexpr std::size_t degree(std::size_t /*u_degree*/) { return 128; }
};

/// Patches of bidegree (2,2) with weights, by vectors in homogeneous coordinates: (16.9).
struct WeightedKind {
  static constexpr std::size_t coordinates = 4;
  static constexpr std::size_t u_degree = 2, v_degree = 2, r_degree = 2, s_degree = 2;
  static constexpr std::size_t points = 16, s1_points = 10;
  static constexpr std::size_t fibre_degree = 16, s1_degree = 14, lead_degree = 16;  // of l_r and l_s
  static constexpr std::size_t lead_power = 4;                                       // of l_r
  static constexpr std::size_t coordinate_degree = 48;  // of E in each coordinate
  static constexpr std::size_t degree(std::size_t /*u_degree*/) { return 160; }
};

/// x of bidegree (a,1), a <= 3, and y of bidegree (m,n), with weights or without: (16.16).
template <std::size_t m, std::size_t n>
struct RuledKind {
  static constexpr std::size_t coordinates = 4;
  static constexpr std::size_t u_degree = 3, v_degree = 1, r_degree = m, s_degree = n;
  static constexpr std::size_t points = 2 * m * n, s1_points = 2 * n * (m - 1);
  static constexpr std::size_t fibre_degree = 6 * m, s1_degree = 6 * (m - 1);
  static constexpr std::size_t lead_degree = 6 * (m < n ? n : m);
  static constexpr std::size_t lead_power = 2 * m - 2;
  static constexpr std::size_t coordinate_degree = 2 * (3 * m * n - m - n);
  static constexpr std::size_t degree(std::size_t a) { return 2 * a * coordinate_degree; }
};

using Ruled11 = RuledKind<1, 1>;
using Ruled12 = RuledKind<1, 2>;
using Ruled13 = RuledKind<1, 3>;
using Ruled22 = RuledKind<2, 2>;
using Ruled23 = RuledKind<2, 3>;
using Ruled33 = RuledKind<3, 3>;

/// A kind with weights without the fixed factors of its pair, powers of a polynomial D of this degree:
/// (16.20).
template <class WholeKind, std::size_t degree_of_factor>
struct StrippedKind : WholeKind {
  using Whole = WholeKind;
  static constexpr bool has_conics = Whole::v_degree == 2;
  static constexpr std::size_t r_power = has_conics ? 4 : Whole::r_degree;  // of D in R
  static constexpr std::size_t s1_power = has_conics ? 2 : Whole::r_degree - 1;
  static constexpr std::size_t factor_degree = degree_of_factor;
  static constexpr std::size_t points = Whole::points - r_power * factor_degree;
  static constexpr std::size_t s1_points = Whole::s1_points - s1_power * factor_degree;
};

/// Explicit instantiations, at the end of a source.
#define EXSECT_WEIGHTED_KINDS(INSTANTIATE) \
  INSTANTIATE(WeightedKind)                \
  INSTANTIATE(Ruled11)                     \
  INSTANTIATE(Ruled12) INSTANTIATE(Ruled13) INSTANTIATE(Ruled22) INSTANTIATE(Ruled23) INSTANTIATE(Ruled33)
// n >= 2: orders of two at fibres that are not finite need it.
#define EXSECT_STRIPPED_KINDS_OF_DEGREE(INSTANTIATE, degree) \
  INSTANTIATE(StrippedKind<WeightedKind, degree>)            \
  INSTANTIATE(StrippedKind<Ruled12, degree>)                 \
  INSTANTIATE(StrippedKind<Ruled13, degree>)                 \
  INSTANTIATE(StrippedKind<Ruled22, degree>)                 \
  INSTANTIATE(StrippedKind<Ruled23, degree>) INSTANTIATE(StrippedKind<Ruled33, degree>)
#define EXSECT_STRIPPED_KINDS(INSTANTIATE)        \
  EXSECT_STRIPPED_KINDS_OF_DEGREE(INSTANTIATE, 1) \
  EXSECT_STRIPPED_KINDS_OF_DEGREE(INSTANTIATE, 2)

}  // namespace exsect
