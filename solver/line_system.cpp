#include "line_system.h"

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

/// The axis least parallel to e.
Point least_parallel_axis(const Point& e) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(e[i]) < abs(e[k])) k = i;
  Point axis = {0, 0, 0};
  axis[k] = 1;
  return axis;
}

AffineForm form_through(const Point& a0, const Point& normal) { return {normal, -dot(normal, a0)}; }

MonotonePiece piece(const Polynomial& phi, const Rational& from, const Rational& to) {
  const Rational a = phi(from);
  const Rational b = phi(to);
  return {{from, to}, {std::min(a, b), std::max(a, b)}};
}

std::vector<MonotonePiece> monotone_pieces(const Polynomial& phi) {
  if (phi.degree() == 2) {
    const Rational turn = -phi.coefficient(1) / (2 * phi.coefficient(2));
    if (turn > 0 && turn < 1) return {piece(phi, 0, turn), piece(phi, turn, 1)};
  }
  return {piece(phi, 0, 1)};
}

LineSystem conic_system(const LineAndPatch& problem) {
  const LineForms forms = axis_forms(problem.line);
  PullBack p = pull_back(forms, problem.patch);
  const Polynomial scale(Rational(1 / forms.e0.constant));
  return {p.plane, p.cylinder(), p.l * scale, Polynomial::variable(),
          monotone_pieces(Polynomial::variable())};
}

}  // namespace

StraightForms straight_forms(const ParameterLine& line) {
  const LineShape s = shape(line);
  if (s != LineShape::straight && s != LineShape::folded)
    throw std::domain_error("parameter line: not straight, it spans no pencil of planes");
  const auto& [a0, a1, a2] = line.a;
  const bool uniform = is_zero(a2);
  const Point e = uniform ? a1 : a2;
  const Rational ee = dot(e, e);
  const Point n1 = cross(e, least_parallel_axis(e));
  const Point n2 = cross(e, n1);
  const Polynomial t = Polynomial::variable();
  const Polynomial phi = uniform ? t : t * t + Polynomial(Rational(dot(a1, e) / ee)) * t;
  return {form_through(a0, n1), form_through(a0, n2), form_through(a0, Rational(1 / ee) * e), phi};
}

LineSystem line_system(const LineAndPatch& problem) {
  const LineShape s = shape(problem.line);
  if (s == LineShape::conic) return conic_system(problem);
  if (s == LineShape::point)
    throw std::domain_error("parameter line: collapsed to a point, it has no carrier");
  const StraightForms forms = straight_forms(problem.line);
  return {pull_back(forms.first, problem.patch), pull_back(forms.second, problem.patch),
          pull_back(forms.lambda, problem.patch), forms.phi, monotone_pieces(forms.phi)};
}

RationalInterval lambda_range(const LineSystem& system) {
  RationalInterval range = system.pieces.front().lambda;
  for (const MonotonePiece& p : system.pieces) {
    range.lower = std::min(range.lower, p.lambda.lower);
    range.upper = std::max(range.upper, p.lambda.upper);
  }
  return range;
}

RealAlgebraic preimage(const Polynomial& phi, const MonotonePiece& piece, const RealAlgebraic& lambda) {
  for (const Rational& end : {piece.t.lower, piece.t.upper})
    if (lambda.compare(phi(end)) == 0) return end;
  const RationalInterval near = lambda.interval();
  const Polynomial equation =
      lambda.is_rational() ? phi - Polynomial(lambda.rational()) : lambda.polynomial().compose(phi);
  for (const RealAlgebraic& t : real_roots(equation, piece.t.lower, piece.t.upper)) {
    if (lambda.is_rational()) return t;
    if (sign_at(phi - Polynomial(near.lower), t) > 0 && sign_at(phi - Polynomial(near.upper), t) < 0)
      return t;
  }
  throw std::domain_error("preimage: the value is not taken on the piece");
}

}  // namespace exsect
