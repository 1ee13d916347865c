#include "line/line_parameter.h"

#include <exsect/algebra/algebraic_value.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace exsect {

LineParameter::LineParameter(BivariatePolynomial numerator, BivariatePolynomial denominator,
                             TriangularPoint at) {
  const int sign = sign_at(denominator, at);
  if (sign == 0) throw std::invalid_argument("line parameter: the denominator is zero at the point");
  quotient_ = Quotient{std::move(numerator), std::move(denominator), std::move(at), sign};
  const Rational width = power_of_two(-30);
  const RationalInterval near = enclosure(width);
  const Rational simplest = simplest_between(near.lower - width, near.upper + width);
  if (compare(simplest) == 0) number_ = RealAlgebraic(simplest);
}

RationalInterval LineParameter::enclosure(const Rational& width) const {
  if (number_) return number_->refined_to(width).interval();
  for (Rational each = std::min<Rational>(width, 1) / 4;; each *= each) {
    const RationalInterval n = enclosure_at(quotient_->numerator, quotient_->at, each);
    const RationalInterval d = enclosure_at(quotient_->denominator, quotient_->at, each);
    if (d.lower <= 0 && d.upper >= 0) continue;
    const auto [least, greatest] = std::minmax({Rational(n.lower / d.lower), Rational(n.lower / d.upper),
                                                Rational(n.upper / d.lower), Rational(n.upper / d.upper)});
    if (greatest - least <= width) return {least, greatest};
  }
}

int LineParameter::compare(const Rational& value) const {
  if (number_) return number_->compare(value);
  const BivariatePolynomial difference = quotient_->numerator - quotient_->denominator * Polynomial(value);
  return sign_at(difference, quotient_->at) * quotient_->sign;
}

std::optional<RealAlgebraic> LineParameter::number() const {
  return number_ ? number_ : quotient_at(quotient_->numerator, quotient_->denominator, quotient_->at);
}

}  // namespace exsect
