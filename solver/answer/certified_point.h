// Certified intersection points of a parameter line with a patch.
#pragma once

#include <exsect/algebra/triangular_point.h>
#include <exsect/solver/parameter.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace exsect {

/// A point exactly: its parameter j is numerator[j] / denominator[j], where the denominator is not zero.
struct ExactParameters {
  TriangularPoint at;
  std::array<BivariatePolynomial, 4> numerator;
  std::array<BivariatePolynomial, 4> denominator;
};

/// One exact solution (u,v,r,s) of x(u,v) = y(r,s) in [0,1]^4 on a parameter line. Its closed box holds the
/// point; `refined_to` gives any width. Which of the eight sides of the two parameter squares it lies on is
/// exact.
class CertifiedPoint {
 public:
  /// How the point is represented: refines boxes to any width.
  class Source {
   public:
    virtual ~Source() = default;
    /// A closed box of width at most `width` in every parameter that contains the point.
    virtual ParameterBox box(const Rational& width) const = 0;
    /// The point's branch, where it was not known from the start.
    virtual int branch() const;
    /// Empty if the point is not known in this form.
    virtual std::optional<ExactParameters> exact_parameters() const { return std::nullopt; }
  };

  CertifiedPoint(std::shared_ptr<const Source> source, const Rational& width, std::vector<Side> sides,
                 int multiplicity, int branch);
  /// With a box that is known already, and a branch that is found when it is asked for.
  CertifiedPoint(std::shared_ptr<const Source> source, ParameterBox box, std::vector<Side> sides,
                 int multiplicity);

  const ParameterBox& box() const { return box_; }
  std::optional<ExactParameters> exact() const { return source_->exact_parameters(); }
  CertifiedPoint refined_to(const Rational& width) const;
  /// The sides this point lies on, exactly; in the order u=0, u=1, v=0, ..., s=1.
  const std::vector<Side>& sides() const { return sides_; }
  bool on(Side side) const;
  /// 1: line and patch cross transversally here. Otherwise the multiplicity (at least 2) of the point's root
  /// in the eliminant, or 0 where the eliminant vanishes identically.
  int multiplicity() const { return multiplicity_; }
  /// 1 or 2, the branch r_1, r_2 of (9.16) it lies on (the sign of 2 A r + B; always 1 if A vanishes
  /// identically); 0 where both branches meet or none is defined.
  int branch() const { return branch_ ? *branch_ : source_->branch(); }

 private:
  std::shared_ptr<const Source> source_;
  ParameterBox box_;
  std::vector<Side> sides_;
  int multiplicity_;
  std::optional<int> branch_;
};

}  // namespace exsect
