#include "line/line_point.h"

#include <exsect/algebra/fixed_point_interval.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "answer/parameter_box.h"
#include "line/line_point_source.h"

namespace exsect {
namespace {

/// r = -s0/s1, t = -t_numerator/s1 (F3) at a root s.
class ConicPointSource : public LinePointSource {
 public:
  ConicPointSource(LinePlace place, LocalSides sides, RealAlgebraic s,
                   std::shared_ptr<const ConicForms> forms)
      : LinePointSource(std::move(place), sides), s_(std::move(s)), forms_(std::move(forms)) {}

 protected:
  LocalBox local_box(const Rational& width) const override {
    const IntegerPolynomial s1(forms_->s1);
    const IntegerPolynomial s0(forms_->s0);
    const IntegerPolynomial tn(forms_->t_numerator);
    for (long bits = bits_below(width) + 24;; bits += bits / 2) {
      const RationalInterval s = s_.refined_to(power_of_two(-bits)).interval();
      const FixedPointInterval at(s, bits);
      const FixedPointInterval denominator = enclose_numerator(s1, at);
      if (denominator.contains_zero()) continue;
      const RationalInterval r = (-enclose_numerator(s0, at) / denominator).interval();
      const RationalInterval t = (-enclose_numerator(tn, at) / denominator).interval();
      if (r.width() <= width && t.width() <= width) return {t, r, s};
    }
  }

 public:
  std::optional<ExactParameters> exact_parameters() const override {
    const auto in_s = [](const Polynomial& f) { return BivariatePolynomial({f}); };
    const BivariatePolynomial denominator = in_s(-forms_->s1);
    return in_place(TriangularPoint(s_, BivariatePolynomial::r(), {0, 0}),
                    {in_s(forms_->t_numerator), denominator}, {in_s(forms_->s0), denominator},
                    {BivariatePolynomial::s(), BivariatePolynomial::constant(1)});
  }

 private:
  RealAlgebraic s_;
  std::shared_ptr<const ConicForms> forms_;
};

enum class UnitPlace { outside, at_zero, inside, at_one };

/// Where -n/d lies with respect to [0,1]; sign_d is the sign of d, not zero.
UnitPlace place_of_ratio(const Polynomial& n, const Polynomial& d, int sign_d, const RealAlgebraic& s) {
  const int at_zero = sign_at(n, s) * sign_d;
  if (at_zero > 0) return UnitPlace::outside;
  if (at_zero == 0) return UnitPlace::at_zero;
  const int at_one = sign_at(n + d, s) * sign_d;
  if (at_one < 0) return UnitPlace::outside;
  return at_one == 0 ? UnitPlace::at_one : UnitPlace::inside;
}

std::optional<int> side_at(UnitPlace place) {
  if (place == UnitPlace::at_zero) return 0;
  if (place == UnitPlace::at_one) return 1;
  return std::nullopt;
}

}  // namespace

Rational initial_width() { return power_of_two(-50); }

std::vector<CertifiedPoint> conic_point(const LinePlace& place,
                                        const std::shared_ptr<const ConicForms>& forms,
                                        const RealAlgebraic& s) {
  const int sign_d = sign_at(forms->s1, s);
  const UnitPlace r = place_of_ratio(forms->s0, forms->s1, sign_d, s);
  if (r == UnitPlace::outside) return {};
  const UnitPlace t = place_of_ratio(forms->t_numerator, forms->s1, sign_d, s);
  if (t == UnitPlace::outside) return {};
  const LocalSides sides = {side_at(t), side_at(r), side_of(s)};
  const int multiplicity = root_multiplicity(forms->eliminant, s);
  const Polynomial derivative = forms->b * forms->s1 - Polynomial(2) * forms->a * forms->s0;
  const int branch = branch_from(sign_at(derivative, s) * sign_d, forms->a.is_zero());
  auto source = std::make_shared<ConicPointSource>(place, sides, s, forms);
  return {CertifiedPoint(source, initial_width(), global_sides(place, sides), multiplicity, branch)};
}

void separate(std::vector<CertifiedPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (Rational width = initial_width() / 1024; meet(points[i].box(), points[j].box()); width *= width) {
        points[i] = points[i].refined_to(width);
        points[j] = points[j].refined_to(width);
      }
}

}  // namespace exsect
