#include "bezier_curve.h"

#include <exsect/algebra/bernstein.h>

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw std::invalid_argument("Bezier curve: " + reason);
}

template <class Value>
bool all_equal(const std::vector<Value>& values) {
  return std::all_of(values.begin(), values.end(), [&](const Value& v) { return v == values.front(); });
}

}  // namespace

BezierCurve::BezierCurve(std::vector<std::vector<Rational>> points, std::vector<Rational> weights)
    : points_(std::move(points)), weights_(std::move(weights)) {
  if (points_.size() < 2) refuse("the degree must be at least 1");
  const std::size_t dimension = points_.front().size();
  if (dimension != 2 && dimension != 3) refuse("points must have 2 or 3 coordinates");
  for (const std::vector<Rational>& point : points_)
    if (point.size() != dimension) refuse("all points must have the same number of coordinates");
  if (weights_.empty()) weights_.assign(points_.size(), 1);
  if (weights_.size() != points_.size()) refuse("there must be as many weights as points");
  for (const Rational& weight : weights_)
    if (weight <= 0) refuse("every weight must be > 0");
}

bool BezierCurve::is_polynomial() const { return all_equal(weights_); }

bool BezierCurve::is_point() const { return all_equal(points_); }

std::vector<Rational> BezierCurve::operator()(const Rational& t) const {
  const HomogeneousCurve curve = homogeneous(*this);
  const Rational denominator = curve.denominator(t);
  if (denominator == 0) throw std::domain_error("Bezier curve: the point is at infinity");
  std::vector<Rational> value;
  for (const Polynomial& numerator : curve.numerators) value.push_back(numerator(t) / denominator);
  return value;
}

BezierCurve BezierCurve::projected(int i, int j) const {
  if (i < 0 || j < 0 || i >= dimension() || j >= dimension())
    throw std::invalid_argument("Bezier curve: no such coordinate");
  std::vector<std::vector<Rational>> planar;
  for (const std::vector<Rational>& point : points_)
    planar.push_back({point[static_cast<std::size_t>(i)], point[static_cast<std::size_t>(j)]});
  return BezierCurve(std::move(planar), weights_);
}

BezierCurve BezierCurve::reversed() const {
  return BezierCurve({points_.rbegin(), points_.rend()}, {weights_.rbegin(), weights_.rend()});
}

int HomogeneousCurve::degree() const {
  int degree = denominator.degree();
  for (const Polynomial& numerator : numerators) degree = std::max(degree, numerator.degree());
  return degree;
}

HomogeneousCurve homogeneous(const BezierCurve& curve) {
  HomogeneousCurve result;
  result.denominator = from_bernstein(curve.weights());
  Polynomial common = result.denominator;
  for (std::size_t k = 0; k < static_cast<std::size_t>(curve.dimension()); ++k) {
    std::vector<Rational> coefficients;
    for (std::size_t i = 0; i < curve.points().size(); ++i)
      coefficients.push_back(curve.weights()[i] * curve.points()[i][k]);
    result.numerators.push_back(from_bernstein(coefficients));
    if (common.degree() > 0) common = gcd(common, result.numerators.back());
  }
  // The weights are positive, so the denominator is too; a factor of it keeps one sign on [0,1].
  if (common.degree() <= 0) common = Polynomial(result.denominator.degree() == 0 ? result.denominator(0) : 1);
  if (common(0) < 0) common = -common;
  for (Polynomial& numerator : result.numerators) numerator = exact_quotient(numerator, common);
  result.denominator = exact_quotient(result.denominator, common);
  if (result.denominator.degree() == 0) {
    const Polynomial scale(1 / result.denominator(0));
    for (Polynomial& numerator : result.numerators) numerator *= scale;
    result.denominator = 1;
  }
  return result;
}

}  // namespace exsect
