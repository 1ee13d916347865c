#include "line/half_rational_point.h"

#include <algorithm>

#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"

namespace exsect {

namespace {

using Equations = PolynomialVector;

BivariatePolynomial scalar_product(const Point& a, const Equations& b) {
  BivariatePolynomial sum;
  for (std::size_t k = 0; k < 3; ++k) sum = sum + BivariatePolynomial::constant(a[k]) * b[k];
  return sum;
}

/// The components of the tangent field (5.1) that vanish, exactly; own: the patch with rational parameters,
/// of_x: it is x.
std::array<bool, 4> zero_components(const Point& own_first, const Point& own_second, const Equations& other,
                                    const TriangularPoint& at, bool of_x) {
  Equations first;
  Equations second;
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = other[k].derivative_r();
    second[k] = other[k].derivative_s();
  }
  const Equations normal = cross(first, second);
  const Point own_normal = cross(own_first, own_second);
  const std::array<BivariatePolynomial, 4> components = {
      scalar_product(own_second, normal), scalar_product(own_first, normal),
      scalar_product(own_normal, second), scalar_product(own_normal, first)};
  std::array<bool, 4> result{};
  for (std::size_t j = 0; j < 4; ++j) result[of_x ? j : (j + 2) % 4] = sign_at(components[j], at) == 0;
  return result;
}

class HalfRationalSource : public CertifiedPoint::Source {
 public:
  HalfRationalSource(bool of_x, std::array<Rational, 2> own, TriangularPoint other,
                     std::array<std::optional<int>, 2> side)
      : of_x_(of_x), own_(std::move(own)), other_(std::move(other)), side_(side) {}

  ParameterBox box(const Rational& width) const override {
    const TriangularPoint fine = other_.refined_to(width);
    const std::array<RationalInterval, 2> intervals = {fine.r_interval(), fine.s().interval()};
    ParameterBox result;
    for (std::size_t k = 0; k < 2; ++k) {
      result[of_x_ ? k : 2 + k] = {own_[k], own_[k]};
      const RationalInterval inside = {std::max<Rational>(intervals[k].lower, 0),
                                       std::min<Rational>(intervals[k].upper, 1)};
      result[of_x_ ? 2 + k : k] = side_[k] ? RationalInterval{*side_[k], *side_[k]} : inside;
    }
    return result;
  }

  std::optional<ExactParameters> exact_parameters() const override {
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    ExactParameters result{other_, {}, {one, one, one, one}};
    for (std::size_t k = 0; k < 2; ++k) {
      result.numerator[of_x_ ? k : 2 + k] = BivariatePolynomial::constant(own_[k]);
      result.numerator[of_x_ ? 2 + k : k] = k == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s();
    }
    return result;
  }

 private:
  bool of_x_;
  std::array<Rational, 2> own_;
  TriangularPoint other_;
  std::array<std::optional<int>, 2> side_;
};

std::optional<int> side_of(const BivariatePolynomial& variable, const TriangularPoint& at) {
  for (const int side : {0, 1})
    if (sign_at(variable - BivariatePolynomial::constant(side), at) == 0) return side;
  return std::nullopt;
}

}  // namespace

std::vector<HalfRationalPoint> half_rational_points(const BezierPatch& x, const BezierPatch& y, bool of_x,
                                                    const std::array<Rational, 2>& at) {
  const BezierPatch& own = of_x ? x : y;
  const Equations other = coordinates_from(of_x ? y : x, own(at[0], at[1]));
  const Point first = own.derivative_first(at[0], at[1]);
  const Point second = own.derivative_second(at[0], at[1]);
  std::vector<HalfRationalPoint> result;
  for (const TriangularPoint& p : common_zeros({other.begin(), other.end()}).points) {
    const std::array<std::optional<int>, 2> side = {side_of(BivariatePolynomial::r(), p),
                                                    side_of(BivariatePolynomial::s(), p)};
    std::vector<Side> sides;
    for (const Parameter parameter : all_parameters) {
      const std::size_t k = index(parameter) % 2;
      const bool is_own = (index(parameter) < 2) == of_x;
      for (const int value : {0, 1})
        if (is_own ? at[k] == value : side[k] == value) sides.push_back({parameter, value});
    }
    const auto source = std::make_shared<HalfRationalSource>(of_x, at, p, side);
    result.push_back({CertifiedPoint(source, power_of_two(-50), sides, 0, 0),
                      zero_components(first, second, other, p, of_x)});
  }
  return result;
}

}  // namespace exsect
