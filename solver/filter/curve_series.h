// Power series of the intersection about an exact point of it. Internal to solver/; docs/method-doubles.md,
// section 14.12.
#pragma once

#include <exsect/algebra/real_field.h>

#include <optional>
#include <vector>

#include "filter/exact_patch.h"

namespace exsect::filter {

/// Higher terms are not looked for.
inline constexpr std::size_t kMostSeriesOrder = 12;

/// The parameters w_j of the curve x = y through an exact solution p as power series in tau = w_axis -
/// p_axis.
class CurveSeries {
 public:
  /// Coefficients of powers of tau.
  template <class Number>
  using Terms = std::vector<Number>;
  /// Taylor coefficients of homogeneous coordinates, that of h^i k^j at index side i + j.
  template <class Number>
  using Taylor = std::vector<std::array<Number, 4>>;

  /// Empty if the derivatives of x - y by the parameters other than `axis` are dependent at p. Requires x = y
  /// there, numbers of one field.
  template <class K>
  static std::optional<CurveSeries> about(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                          const std::array<FieldNumber, 4>& p, std::size_t axis);

  /// The least m > 0 with a term tau^m in w_j; 0 if there is none up to kMostSeriesOrder.
  std::size_t order(std::size_t j) const;
  /// The sign of dw_j/dtau for 0 < tau <= reach on an arc of the curve through p with |w_i - p_i| <= room[i]
  /// for all |tau| <= reach, if it has also this sign, but for the factor (-1)^(order - 1), for -reach <= tau
  /// < 0; 0 if that is not proved. (14.120).
  int sign_beside(const std::array<double, 4>& room, double reach, std::size_t j) const;

 private:
  CurveSeries() = default;
  bool is_complete() const;
  void bound_rest();
  double size_of_change(std::size_t j, double reach, std::size_t from) const;

  std::size_t axis_ = 0;
  std::size_t side_ = 0;
  Taylor<FieldNumber> x_, y_;  // the point of space at p as origin
  std::array<std::array<FieldNumber, 3>, 3> inverse_;
  std::array<Terms<FieldNumber>, 4> terms_;  // up to one power
  std::vector<double> rest_;                 // of C G along these terms, from the next power
};

}  // namespace exsect::filter
