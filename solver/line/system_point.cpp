#include "line/system_point.h"

// Points of a parameter line given by its system: straight and folded lines, and where the formula fails.
#include <exsect/algebra/fixed_point_interval.h>

#include <memory>
#include <optional>
#include <utility>

#include "curve/plane_curve.h"
#include "line/line_point_source.h"

namespace exsect {
namespace {

/// (r,s) from a triangular set, t on one monotone piece of phi.
class SystemPointSource : public LinePointSource {
 public:
  SystemPointSource(LinePlace place, LocalSides sides, TriangularPoint at,
                    std::shared_ptr<const LineSystem> system, std::size_t piece)
      : LinePointSource(std::move(place), sides),
        at_(std::move(at)),
        system_(std::move(system)),
        piece_(piece) {}

 protected:
  LocalBox local_box(const Rational& width) const override {
    for (long bits = bits_below(width) + 24;; bits += bits / 2) {
      const TriangularPoint point = at_.refined_to(power_of_two(-bits));
      const RationalInterval r = point.r_interval();
      const RationalInterval s = point.s().interval();
      const FixedPointInterval lambda =
          enclose(system_->lambda, FixedPointInterval(r, bits), FixedPointInterval(s, bits));
      const RationalInterval t = line_parameter(lambda).interval();
      if (t.width() <= width) return {t, r, s};
    }
  }

 public:
  std::optional<ExactParameters> exact_parameters() const override {
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    if (system_->phi.degree() != 1) return on_folded_line();
    return in_place(at_, {system_->lambda, one}, {BivariatePolynomial::r(), one},
                    {BivariatePolynomial::s(), one});
  }

 private:
  /// Where r is a fraction of s, (t,s) is a triangular set: phi(t) = lambda.
  std::optional<ExactParameters> on_folded_line() const {
    const BivariatePolynomial linear = reduced_at(at_.g(), at_.s());
    if (linear.degree_r() != 1) return std::nullopt;
    const Polynomial numerator = -linear.coefficient(0);
    const Polynomial denominator = linear.coefficient(1);
    Polynomial lambda;
    Polynomial power{1};  // of the denominator
    for (int i = system_->lambda.degree_r(); i >= 0; --i) {
      lambda = lambda * numerator + power * system_->lambda.coefficient(i);
      if (i > 0) power = power * denominator;
    }
    std::vector<Polynomial> of_t = {-lambda};
    for (int i = 1; i <= system_->phi.degree(); ++i)
      of_t.push_back(power * Polynomial(system_->phi.coefficient(i)));
    const MonotonePiece& piece = system_->pieces[piece_];
    const auto roots = roots_at(BivariatePolynomial(of_t), at_.s(), piece.t.lower, piece.t.upper);
    if (roots.size() != 1) return std::nullopt;
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    return in_place(roots.front(), {BivariatePolynomial::r(), one},
                    {BivariatePolynomial({numerator}), BivariatePolynomial({denominator})},
                    {BivariatePolynomial::s(), one});
  }

  /// phi(t) = t, or t^2 + k t: t = -k/2 +- sqrt(k^2/4 + lambda), + to the right of the turn -k/2.
  FixedPointInterval line_parameter(const FixedPointInterval& lambda) const {
    if (system_->phi.degree() == 1) return lambda;
    const Rational turn = -system_->phi.coefficient(1) / 2;
    const Rational square = turn * turn;
    const FixedPointInterval centre({turn, turn}, lambda.bits());
    const FixedPointInterval root = sqrt(FixedPointInterval({square, square}, lambda.bits()) + lambda);
    return system_->pieces[piece_].t.lower >= turn ? centre + root : centre - root;
  }

  TriangularPoint at_;
  std::shared_ptr<const LineSystem> system_;
  std::size_t piece_;
};

int multiplicity_at(const LineSystem& system, const TriangularPoint& at, const Polynomial& eliminant) {
  if (eliminant.is_zero()) return 0;
  const int multiplicity = root_multiplicity(eliminant, at.s());
  if (multiplicity == 1 || sign_at(jacobian(system.first, system.second), at) != 0) return 1;
  return multiplicity;
}

std::optional<int> end_of(const BivariatePolynomial& f, const TriangularPoint& at) {
  if (sign_at(f, at) == 0) return 0;
  if (sign_at(f - BivariatePolynomial::constant(1), at) == 0) return 1;
  return std::nullopt;
}

}  // namespace

std::vector<std::size_t> pieces_at(const LineSystem& system, const TriangularPoint& at) {
  const auto compared = [&](const Rational& value) {
    return sign_at(system.lambda - BivariatePolynomial::constant(value), at);
  };
  std::vector<std::size_t> pieces;
  for (std::size_t i = 0; i < system.pieces.size(); ++i) {
    const MonotonePiece& piece = system.pieces[i];
    if (compared(piece.lambda.lower) < 0 || compared(piece.lambda.upper) > 0) continue;
    if (i > 0 && compared(system.phi(piece.t.lower)) == 0) continue;  // the turn belongs to the piece before
    pieces.push_back(i);
  }
  return pieces;
}

std::vector<CertifiedPoint> system_points(const LinePlace& place,
                                          const std::shared_ptr<const LineSystem>& system,
                                          const TriangularPoint& at, const Polynomial& eliminant,
                                          const Rational& width) {
  const auto compared = [&](const Rational& value) {
    return sign_at(system->lambda - BivariatePolynomial::constant(value), at);
  };
  const int multiplicity = multiplicity_at(*system, at, eliminant);
  const BivariatePolynomial derivative = system->first.derivative_r();
  const int branch =
      derivative.is_zero() ? 0 : branch_from(sign_at(derivative, at), system->first.degree_r() == 1);
  std::vector<CertifiedPoint> points;
  for (const std::size_t i : pieces_at(*system, at)) {
    const MonotonePiece& piece = system->pieces[i];
    LocalSides sides = {std::nullopt, end_of(BivariatePolynomial::r(), at), side_of(at.s())};
    if (piece.t.lower == 0 && compared(system->phi(0)) == 0) sides.t = 0;
    if (piece.t.upper == 1 && compared(system->phi(1)) == 0) sides.t = 1;
    auto source = std::make_shared<SystemPointSource>(place, sides, at, system, i);
    points.emplace_back(source, width, global_sides(place, sides), multiplicity, branch);
  }
  return points;
}

}  // namespace exsect
