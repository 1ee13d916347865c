#include "answer/exact_source.h"

#include <exsect/algebra/algebraic_value.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace exsect {
namespace {

/// The quotient of two functions at the point, enclosed; nothing if the denominator is not told from zero.
std::optional<RationalInterval> quotient_at(const BivariatePolynomial& numerator,
                                            const BivariatePolynomial& denominator, const TriangularPoint& at,
                                            const Rational& width) {
  const RationalInterval n = enclosure_at(numerator, at, width);
  const RationalInterval d = enclosure_at(denominator, at, width);
  if (d.lower <= 0 && d.upper >= 0) return std::nullopt;
  const std::array<Rational, 4> corners = {n.lower / d.lower, n.lower / d.upper, n.upper / d.lower,
                                           n.upper / d.upper};
  const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
  return RationalInterval{*least, *greatest};
}

class ExactSource : public CertifiedPoint::Source {
 public:
  ExactSource(ExactParameters exact, std::vector<Side> sides)
      : exact_(std::move(exact)), sides_(std::move(sides)) {}

  ParameterBox box(const Rational& width) const override {
    ParameterBox result;
    for (std::size_t j = 0; j < 4; ++j) result[j] = enclosure(exact_, j, width);
    for (const Side& side : sides_) result[index(side.parameter)] = {side.value, side.value};
    return result;
  }
  std::optional<ExactParameters> exact_parameters() const override { return exact_; }

 private:
  ExactParameters exact_;
  std::vector<Side> sides_;
};

}  // namespace

RationalInterval enclosure(const ExactParameters& exact, std::size_t j, const Rational& width) {
  for (Rational fine = width / 4;; fine /= 65536) {
    const auto value = quotient_at(exact.numerator[j], exact.denominator[j], exact.at, fine);
    if (value && value->width() <= width) return *value;
  }
}

CertifiedPoint certified(ExactParameters exact, const std::vector<Side>& sides) {
  return {std::make_shared<ExactSource>(std::move(exact), sides), power_of_two(-100), sides, 0, 0};
}

bool takes_value(const ExactParameters& exact, std::size_t j, const RealAlgebraic& value) {
  const RationalInterval isolating = value.interval();
  if (isolating.width() > 0) {
    const RationalInterval at = enclosure(exact, j, isolating.width() / 16);
    if (!(isolating.lower <= at.lower && at.upper <= isolating.upper)) return false;
  }
  const Polynomial& f = value.polynomial();  // f(n/d) d^k
  BivariatePolynomial sum;
  BivariatePolynomial power = BivariatePolynomial::constant(1);
  for (int i = f.degree(); i >= 0; --i) {
    sum = sum * exact.numerator[j] + BivariatePolynomial::constant(f.coefficient(i)) * power;
    power = power * exact.denominator[j];
  }
  return sign_at(sum, exact.at) == 0;
}

bool agree(const ExactParameters& exact, std::size_t j) {
  return sign_at(
             exact.numerator[j] * exact.denominator[j + 2] - exact.numerator[j + 2] * exact.denominator[j],
             exact.at) == 0;
}

}  // namespace exsect
