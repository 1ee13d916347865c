#include "line/line_system.h"

#include <exsect/geometry/straight_line.h>

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

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
