// The polynomials of the fibres over successive u by tables of differences: docs/method.md, section 4.5.
#pragma once

#include "eliminant/fibre_resultants.h"

namespace exsect {

/// The fibres over first, first + 1, first + 2, ...: R, S1 and the leading coefficients are polynomials in u
/// of the degrees of FibreKind, so that additions in their tables of differences are enough. Field as
/// for FibreResultants, and add_unreduced(a, b) for sums of at most 16 residues, which reduced(a) makes
/// residues again; multiply, Sum are not needed.
template <class Field, class Kind>
class FibreTable {
 public:
  using Residue = typename Field::Residue;
  using Fibre = EliminantFibre<Field, Kind>;

  /// What it is made from.
  static constexpr std::size_t size =
      (Kind::fibre_degree > Kind::lead_degree ? Kind::fibre_degree : Kind::lead_degree) + 1;

  /// fibres[i] is the one over first + i.
  FibreTable(const Field& field, const Fibre (&fibres)[size]) : field_(field) {
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t i = 0; i <= Kind::points && k <= Kind::fibre_degree; ++i) r_[i][k] = fibres[k].r[i];
      for (std::size_t i = 0; i <= Kind::s1_points && k <= Kind::s1_degree; ++i) s1_[i][k] = fibres[k].s1[i];
      if (k <= Kind::lead_degree) {
        lead_r_[k] = fibres[k].lead_r;
        lead_s_[k] = fibres[k].lead_s;
      }
    }
    for (auto& row : r_) set_differences(row);
    for (auto& row : s1_) set_differences(row);
    set_differences(lead_r_);
    set_differences(lead_s_);
  }

  /// The next four.
  void next(Fibre (&fibres)[4]) {
    Residue values[4];
    for (std::size_t i = 0; i <= Kind::points; ++i) {
      advance(r_[i], values);
      for (std::size_t k = 0; k < 4; ++k) fibres[k].r[i] = values[k];
    }
    for (std::size_t i = 0; i <= Kind::s1_points; ++i) {
      advance(s1_[i], values);
      for (std::size_t k = 0; k < 4; ++k) fibres[k].s1[i] = values[k];
    }
    advance(lead_r_, values);
    for (std::size_t k = 0; k < 4; ++k) fibres[k].lead_r = values[k];
    advance(lead_s_, values);
    for (std::size_t k = 0; k < 4; ++k) fibres[k].lead_s = values[k];
  }

 private:
  /// From values to differences of order 0, 1, ... at the first one.
  template <std::size_t n>
  void set_differences(Residue (&row)[n]) const {
    for (std::size_t k = 1; k < n; ++k)
      for (std::size_t i = n - 1; i >= k; --i) row[i] = field_.add(row[i], field_.negate(row[i - 1]));
  }
  /// By four values; `values` are the current one and the three after it. A step adds to each difference the
  /// next one: moduli at most double.
  template <std::size_t n>
  void advance(Residue (&row)[n], Residue (&values)[4]) const {
    Residue after[4];  // the next difference before each of the four steps
    for (Residue& difference : after) difference = row[n - 1];
    Residue now[4] = {row[0], row[0], row[0], row[0]};
    for (std::size_t i = n - 1; i-- > 0;) {
      Residue sum = row[i];
      for (std::size_t k = 0; k < 4; ++k) {
        now[k] = sum;
        sum = field_.add_unreduced(sum, after[k]);
        after[k] = now[k];
      }
      row[i] = field_.reduced(sum);
    }
    for (std::size_t k = 0; k < 4; ++k) values[k] = field_.reduced(now[k]);
  }

  Field field_;
  Residue r_[Kind::points + 1][Kind::fibre_degree + 1];
  Residue s1_[Kind::s1_points + 1][Kind::s1_degree + 1];
  Residue lead_r_[Kind::lead_degree + 1];
  Residue lead_s_[Kind::lead_degree + 1];
};

}  // namespace exsect
