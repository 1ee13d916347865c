// Every number that bounds an error of the solution in doubles: value, what it covers, and where that is
// proved. The table of docs/method-doubles.md, section 14.1, is this one. Internal to solver/.
//
// Arithmetic, u = 2^-53, to nearest (algebra/nearest_rounding.h), no contraction: a computed sum or
// difference is the exact one times 1 + d, |d| <= u, also where it is subnormal, because there it is exact. A
// computed product or quotient is the exact one times 1 + d, or differs from it by at most 2^-1075, if it is
// subnormal or zero.
//
// Sizes: `make_pair` takes models whose coordinates are below 2^300 and at most 2^40 times the half of the
// extent, which is above 2^-300, and scales them by a power of two to at most 1; `invert` refuses inverses
// above 2^200. So the coordinates of control points are at most 1, parameters at most 3/4 in absolute value,
// Taylor coefficients below 2^10 (2^7 for degree 2), the entries of C below 2^221, those of C x_ij and slopes
// below 2^233. Products of these may overflow, and then a bound is infinite or NaN: all comparisons are such
// that they fail. Where (14.5) holds, slopes are at most one over the length of the tube, 2^32 for those
// along a curve, and nothing overflows.
//
// Constants that depend on the bidegree (n,n) of the patches, n in {2,3}, are templates.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <cstddef>

namespace exsect::filter {

// One operation, and sums.

/// u: of a sum, and of a product that is not subnormal, relative to it.
inline constexpr double kUnit = kUnitRoundoff;
/// At least what a product or quotient loses by underflow, 2^-1075, which is no double.
inline constexpr double kUnderflow = 0x1p-1074;
/// Makes a computed sum of nonnegative terms, with at most 1000 roundings on the way to each, an upper bound.
using exsect::kSlack;
static_assert((1 - 1024 * kUnit) * kSlack > 1 + 512 * 1024 * kUnit * kUnit);
/// Added where all terms of a bound may underflow: 1000 underflows, also if each is multiplied by 2^128
/// afterwards. A bound with a term of at least that size needs no other one: kSlack times this term covers
/// them, multiplied by 2^100.
inline constexpr double kTiny = 0x1p-900;
static_assert(kTiny > 1000 * 0x1p128 * kUnderflow && kTiny * (kSlack - 1) / 2 > 1000 * 0x1p100 * kUnderflow);

// Parameters, numbers of size 1: 14.2 to 14.5.

/// A sum or difference of two numbers below 2 and a product below 1.
inline constexpr double kSumRounding = 0x1p-51;
static_assert(kSumRounding >= 3 * kUnit);
/// Two of these, and the change from centred parameters to those in [0,1].
inline constexpr double kPlaceRounding = 0x1p-50;
static_assert(kPlaceRounding >= 2 * kSumRounding);
/// middle - centre - tau slope and its comparison: at most 5 operations on numbers below 4.
inline constexpr double kPlacing = 0x1p-48;
static_assert(kPlacing >= 5 * 4 * kUnit);

// Nets: 14.1, 14.4.

/// Scaled coordinates err by kSlack (u |coordinate| + u) at most: their rounding to doubles, that of the
/// difference from the origin, of size 1. Coordinates that are rounded to subnormal numbers err by 2^-1075
/// times the scale, which is at most 2^300, those scaled to such numbers by 2^-1075 more, which kSlack
/// covers.
inline constexpr double kInputError = kSlack * kUnit;
static_assert(kInputError - kUnit > 4 * 0x1p300 * kUnderflow);

inline constexpr int kDeepestLevel = 40;
/// (14.1): a level halves both parameters by n means (a + b)/2 of numbers of size 1 on each path, u each;
/// what the products by 1/2 lose in subnormal numbers is 2^-1075, which the factor kSlack covers.
template <std::size_t Degree>
inline constexpr double kDegreeNetError = 2 * Degree* kDeepestLevel* kUnit;
/// The least net_error: lemmas below that use e >= 160 u.
inline constexpr double kNetError = kDegreeNetError<2>;
static_assert(kNetError >= 160 * kUnit && kDegreeNetError<3> >= kNetError);
/// (14.2): the exact difference of a coordinate of two points is at most 2 e from that of the nets, whose
/// rounded value is off by 2 u; a product n.P, |P| <= 1, is off by 3.01 u |n|_1, a difference of two of them
/// by 2 u |n|_1: 9 u |n|_1 in all, and the comparison itself.
inline constexpr double kSeparation = 2.5;
static_assert((kSeparation - 2.25) * kNetError > 16 * kUnit);
/// In (14.2) the six products of n.P and n.Q lose 2^-1075 each. |n|_1 is replaced by |n|_1 + kTiny, of which
/// 1/4 e is left for them.
static_assert(0.25 * kNetError * kTiny > 16 * kUnderflow);
/// c_u x_v - c_v x_u, |c| <= 1, times e: differences of neighbouring points, of size s <= 2, err by 2 e + u
/// s, their means (1-t) a + t b, t = k/n rounded, by as much and another 4 u s; in all 4 e + 16 u s.
inline constexpr double kDirectionError = 5;
static_assert((kDirectionError - 4) * kNetError >= 16 * kUnit * 2);
/// y_r x y_s: control vectors are means, with weights from products of binomials, of cross products a x b of
/// differences. With |a| <= A, |b| <= B and errors t = 2 e + 2 u < 2.02 e of a and b, a coordinate of a x b
/// errs by 2 (A + B) t + 2 t² < kNormalError e (A + B + 3 e), and by its own rounding and that of the means,
/// 5 + n² roundings of numbers below 2 A B (a weight, the product with it, a sum of n² at most), by less than
/// kNormalRounding u A B. The last term of the bound is kTiny.
inline constexpr double kNormalError = 5;
inline constexpr double kDifferenceError = 2.02;
static_assert(kNormalError > 2 * kDifferenceError &&
              3 * kNormalError > 2 * kDifferenceError * kDifferenceError &&
              kDifferenceError * kNetError > 2 * kNetError + 2 * kUnit);
template <std::size_t Degree>
inline constexpr double kNormalRounding = 20 * Degree;
static_assert(kNormalRounding<2> > 3 * 2 + (5 + 4) * 2 && kNormalRounding<3> > 3 * 2 + (5 + 9) * 2);
/// d.n, k products: k (size_d error_n + size_n error_d), sizes with their errors, and k u times k size_d
/// size_n for its rounding, and kTiny.
template <std::size_t Rows>
inline constexpr double kProductRounding = Rows* Rows + 1;
/// (14.31a) in R^4: a coordinate of a bivector is the same of a = Y, A = 1, and b = Y_r, with at most 2 n²
/// products in a mean. Of size 2 B, with error_b, it is multiplied by Y_s, of size S, with error t: a
/// coordinate of the covector is a mean of sums of three products, 3 (S error_b + t (2 B + error_b)), and 8 +
/// n (n+1) roundings of numbers below 3 S times 2 B.
inline constexpr double kCovectorRounding = 80;
static_assert(kCovectorRounding > 3 * (8 + 12) && kNormalRounding<2> > 3 * 2 + (5 + 8) * 2 &&
              kNormalRounding<3> > 3 * 2 + (5 + 18) * 2);

// Taylor coefficients: 14.1.

/// |h|, |k| of `expand`.
inline constexpr double kReach = 0.75;
/// At most so many roundings of a value contain a coefficient as a factor. In (14.4) these are 3 of the
/// product with C, 2 n - 1 of the product with slopes, n + 1 of a sum over one order and both patches, and 4
/// n of the sum over orders; elsewhere fewer. With four rows, 4 of the product with C, one of that with the
/// scale, 2 for the terms of its change, and one order more.
template <std::size_t Degree, std::size_t Rows>
inline constexpr double kValueRoundings = 8 * Degree + 4 + 4 * (Rows - 3);
static_assert(kValueRoundings<2, 3> >= 3 + 3 + 3 + 8 && kValueRoundings<3, 3> >= 3 + 5 + 4 + 12);
static_assert(kValueRoundings<2, 4> >= 5 + 3 + 3 + 2 + 10 && kValueRoundings<3, 4> >= 5 + 5 + 4 + 2 + 14);
/// That times u times their sizes; the rest for terms of second order.
template <std::size_t Degree, std::size_t Rows>
inline constexpr double kValueRounding = kValueRoundings<Degree, Rows> + 4;

// Tubes: 14.2.

/// Of 1 / det: the largest for which nothing overflows later.
inline constexpr double kGreatestInverse = 0x1p200;
/// The sum of the weights of any coefficient of order 2 to 2 n in the second derivative along a direction
/// with components at most 1, offsets at most 1: i (i-1) + 2 i j + j (j-1) = (i + j) (i + j - 1) for a^i b^j.
template <std::size_t Degree>
inline constexpr double kSecondWeight = 2 * Degree*(2 * Degree - 1);
/// (14.9): the rounding of the sum, relative to |C F_j| |d_j|.
inline constexpr double kDirectionRounding = 0x1p-46;
static_assert(kDirectionRounding > 2 * kValueRoundings<3, 4> * kUnit);
/// Vectors: |v| <= kDiagonal max |v_i|.
inline constexpr double kDiagonal = 1.75;
static_assert(kDiagonal * kDiagonal > 3);

// Sizes of what is kept around points of curves: larger where errors of values and derivatives are larger, by
// Width, which is 0 for biquadratic pairs, 1 for bicubic and 2 for weighted ones.

/// Balls of points where pieces of a curve end are smaller than a quarter of this.
template <int Width>
inline constexpr double kEndMargin = Width == 0   ? 0x1p-28
                                     : Width == 1 ? 0x1p-25
                                                  : 0x1p-23;
/// Of balls around turning points.
template <int Width>
inline constexpr double kLargestBox = Width == 0   ? 0x1p-31
                                      : Width == 1 ? 0x1p-27
                                                   : 0x1p-25;
static_assert(kLargestBox<0> <= kEndMargin<0> / 4 && kLargestBox<1> <= kEndMargin<1> / 4 &&
              kLargestBox<2> <= kEndMargin<2> / 4);
/// Of tubes along the curve: below this nothing is gained, and boxes of nodes would not fit in.
template <int Width>
inline constexpr double kLeastHalfwidth = Width == 0   ? 0x1p-26
                                          : Width == 1 ? 0x1p-23
                                                       : 0x1p-21;
static_assert(kLeastHalfwidth<0> > 2 * kEndMargin<0> && kLeastHalfwidth<1> > 2 * kEndMargin<1> &&
              kLeastHalfwidth<2> > 2 * kEndMargin<2>);
/// |x_u| + |x_v| changes by that much at most within a node's box: |x_uu| + 2 |x_uv| + |x_vv| < 2^8 near the
/// square, as second differences are at most 4 in each coordinate: 1.74 (24 + 2 * 36 + 24) for n = 3.
template <int Width>
inline constexpr double kSpeedChange = Width == 0   ? 0x1p-22
                                       : Width == 1 ? 0x1p-19
                                                    : 0x1p-17;
static_assert(kSpeedChange<0> >= 0x1p8 * kEndMargin<0> / 4 && kSpeedChange<1> >= 0x1p8 * kEndMargin<1> / 4 &&
              kSpeedChange<2> >= 0x1p8 * kEndMargin<2> / 4);

// Lines: 14.3.

/// Control points of an inner line are means (1-t) a + t b of points of size 1, n times, computed as a + t (b
/// - a): 5 u each time by their roundings, and 2 |dt|, where |dt| <= error + u with the rounding of value +
/// 1/2.
template <std::size_t Degree>
inline constexpr double kLineRounding = 8 * Degree* kUnit;
static_assert(kLineRounding<1> >= 5 * kUnit + 2 * kUnit);
template <std::size_t Degree>
inline constexpr double kLineError = 2 * Degree;
/// A number in [-1/2,1/2] rounded to a double.
inline constexpr double kValueError = 0x1p-54;

// Weighted patches: 14.11.

/// The fifth unknown is the scale divided by this: numbers of size 1, as the parameters are. Pairs whose
/// scale may be greater have their first patch divided by 2^kMostReduction at most.
inline constexpr double kScaleUnit = 4;
inline constexpr int kMostReduction = 6;
inline constexpr double kLeastScale = 0x1p-12;
/// The least weight for which affine points are computed.
inline constexpr double kLeastWeight = 0x1p-12;

// Contacts: 14.7.

/// (14.13): computed control vectors of X are differences of control points, which err by 2 e0 + 2 u and are
/// of size 2, twice that, and after three means by 9 u times the size 4 more: by 4 net_error in all, as
/// net_error >= e0 + 160 u; those of C by 2 net_error. A coordinate of w = C x n errs by 4 net_error |n| and
/// 8 u |n| of its own, |n| the largest coordinate, so w.X by 4 net_error |w|_1 + 12 (4 net_error + 8 u) |n| +
/// 5 u 4 |w|_1 < kSideError net_error
/// (|w|_1 + kSideNormal |n|), and kTiny.
template <std::size_t Degree>
inline constexpr double kSideError = 5;
template <std::size_t Degree>
inline constexpr double kSideNormal = 10;
static_assert((kSideError<2> - 4) * kNetError > 20 * kUnit);
static_assert(kSideError<2> * kSideNormal<2> * kNetError > 12 * (4 * kNetError + 8 * kUnit));
/// For n = 3, (14.27): control vectors of X are of size 6, err by 3 (2 e0 + 2 u) and after five means by 15 u
/// times the size more, by 7 net_error in all, as net_error >= e0 + 240 u; those of D / 3, of size 2, by 2 e0
/// + 2 u, and after two means, sums and products by 16 u times the size more, by 2 net_error. A coordinate of
/// w errs by 4 net_error |n| and 12 u |n|, and w.X by 7 net_error |w|_1 + 18 (4 net_error + 12 u) |n| + 5 u 6
/// |w|_1.
template <>
inline constexpr double kSideError<3> = 8;
static_assert((kSideError<3> - 7) * kDegreeNetError<3> > 30 * kUnit &&
              7 * kDegreeNetError<3> > 6 * kUnit + 6 * 15 * kUnit && 2 * kDegreeNetError<3> > 34 * kUnit);
static_assert(kSideError<3> * kSideNormal<3> * kDegreeNetError<3> >
              18 * (4 * kDegreeNetError<3> + 12 * kUnit));
/// Differences of control points are of size 2 and err by less than 2.1 net_error, (14.2): a product of
/// three, of which a determinant has 6, by 3 * 4 * 2.1 net_error. Its value, of size 48, and a mean of at
/// most ten values of that size err by 17 roundings more.
inline constexpr double kDeterminantError = 160;
static_assert((kDeterminantError - 6 * 3 * 4 * 2.1) * kNetError > 17 * 48 * kUnit);
/// The same of points that are restricted to a part of a side, by two means with a rounded parameter: they
/// err by 2.3 net_error.
inline constexpr double kPartDeterminantError = 170;
static_assert((kPartDeterminantError - 6 * 3 * 4 * 2.3) * kNetError > 13 * 48 * kUnit);

/// (14.36): C(t) ^ C(t') / (t' - t) has control vectors of size 6, sums of products of numbers of size 1 that
/// err by u each, with weights of 6 in all: 6 (4 u + 3 u) + 20 u, and after four means 72 u more. A
/// coordinate of the plane errs by 3 |q| times that and 9 roundings of size 18 |q|. Control vectors of X, of
/// size 6, err by 12 u + 8 u, and after five means by 90 u more, less than net_error; so the product of four
/// of them by net_error |plane|_1 and 4 * 6 times the plane's error, |q| the sum of the coordinates of q.
inline constexpr double kPlaneError = 90;
static_assert(kPlaneError * kNetError > 4 * 6 * (3 * (6 * 7 + 20 + 72) + 9 * 18) * kUnit &&
              kNetError > (12 + 8 + 90 + 30) * kUnit);

// Double points: 14.9.

/// The entries of B S, sums of two products with |S| <= 1, relative to the row sum of B.
inline constexpr double kLocalError = 0x1p-50;
static_assert(kLocalError > 4 * kUnit);
/// The form in t has coefficients below 2 |f|, |S| <= 1, each computed with some ten roundings.
inline constexpr double kFormError = 0x1p-46;
static_assert(kFormError > 3 * 2 * 12 * kUnit);
inline constexpr double kLeastDeterminant = 0x1p-10;  // of S
/// Of the inverse of S: entries and determinant err by 4 u, which the determinant above 2^-10 magnifies.
inline constexpr double kInverseError = 0x1p-36;
static_assert(kInverseError > 16 * kUnit / kLeastDeterminant);
/// Of sums with entries of that inverse.
inline constexpr double kInverseSlack = 1 + 0x1p-30;
static_assert(kInverseSlack - 1 > 2 * kInverseError);
/// Larger coefficients are refused: then the row sums of B S are below 2^42 and all bounds are products of
/// two sums of terms below 2^40 (2^43)^6 with powers of k and z, so that nothing overflows, and comparisons
/// fail where it does.
inline constexpr double kGreatestCoefficient = 0x1p40;
/// Added to the size of each coefficient, whose rounding may underflow. Products with up to three powers of
/// two sizes above 2^-11 and five of a reach above 2^-20 are no subnormal numbers; what products of two such
/// sums lose is covered by kSlack times the first term of the sum they stand in, which is one.
inline constexpr double kTinyCoefficient = 0x1p-800;
static_assert(kTinyCoefficient * 0x1p-66 * 0x1p-100 * (kSlack - 1) > 1000 * kUnderflow);

}  // namespace exsect::filter
