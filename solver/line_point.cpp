#include "line_point.h"

#include <exsect/algebra/fixed_point_interval.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "parameter_box.h"
#include "plane_curve.h"

namespace exsect {
namespace {

/// Which ends of [0,1] t, r and s are at, exactly: 0, 1 or neither.
struct LocalSides {
  std::optional<int> t;
  std::optional<int> r;
  std::optional<int> s;
};

struct LocalBox {
  RationalInterval t;
  RationalInterval r;
  RationalInterval s;
};

std::optional<int> side_of(const RealAlgebraic& s) {
  if (s.compare(0) == 0) return 0;
  if (s.compare(1) == 0) return 1;
  return std::nullopt;
}

std::vector<Side> global_sides(const LinePlace& place, const LocalSides& local) {
  std::vector<Side> sides;
  const auto add = [&](Parameter p, const std::optional<int>& value) {
    if (value) sides.push_back({p, *value});
  };
  add(place.roles.fixed, side_of(RealAlgebraic(place.value)));
  add(place.roles.line, local.t);
  add(place.roles.first, local.r);
  add(place.roles.second, local.s);
  std::ranges::sort(sides, {}, [](const Side& side) {
    return 2 * index(side.parameter) + static_cast<std::size_t>(side.value);
  });
  return sides;
}

/// Local boxes of width at most half the width asked for, put in place: rounded outward to short dyadics, cut
/// to [0,1], exact on sides.
class LinePointSource : public CertifiedPoint::Source {
 public:
  LinePointSource(LinePlace place, LocalSides sides) : place_(std::move(place)), sides_(sides) {}

  ParameterBox box(const Rational& width) const final {
    const LocalBox local = local_box(width / 2);
    ParameterBox result;
    result[index(place_.roles.fixed)] = {place_.value, place_.value};
    result[index(place_.roles.line)] = placed(local.t, sides_.t, width);
    result[index(place_.roles.first)] = placed(local.r, sides_.r, width);
    result[index(place_.roles.second)] = placed(local.s, sides_.s, width);
    return result;
  }

 protected:
  virtual LocalBox local_box(const Rational& width) const = 0;

  /// A parameter as a fraction.
  struct Fraction {
    BivariatePolynomial numerator;
    BivariatePolynomial denominator;
  };
  ExactParameters in_place(TriangularPoint at, const Fraction& t, const Fraction& r,
                           const Fraction& s) const {
    ExactParameters result{std::move(at), {}, {}};
    const auto put = [&](Parameter p, const Fraction& f) {
      result.numerator[index(p)] = f.numerator;
      result.denominator[index(p)] = f.denominator;
    };
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    put(place_.roles.fixed, {BivariatePolynomial::constant(place_.value), one});
    put(place_.roles.line, t);
    put(place_.roles.first, r);
    put(place_.roles.second, s);
    return result;
  }

 private:
  static RationalInterval placed(const RationalInterval& x, const std::optional<int>& side,
                                 const Rational& width) {
    if (side) return {*side, *side};
    const RationalInterval rounded = rounded_outward(x, width);
    return {std::max(rounded.lower, Rational(0)), std::min(rounded.upper, Rational(1))};
  }

  LinePlace place_;
  LocalSides sides_;
};

/// r = -s0/s1, t = -t_numerator/s1 at a root s.
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
    if (system_->phi.degree() != 1) return std::nullopt;
    const BivariatePolynomial one = BivariatePolynomial::constant(1);
    return in_place(at_, {system_->lambda, one}, {BivariatePolynomial::r(), one},
                    {BivariatePolynomial::s(), one});
  }

 private:
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

/// Multiplicity of the root s of f.
int root_multiplicity(const Polynomial& f, const RealAlgebraic& s) {
  if (sign_at(f.derivative(), s) != 0) return 1;
  for (const PolynomialPower& power : squarefree_factors(f))
    if (sign_at(power.factor, s) == 0) return power.multiplicity;
  return 0;
}

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

std::optional<int> side_of(UnitPlace place) {
  if (place == UnitPlace::at_zero) return 0;
  if (place == UnitPlace::at_one) return 1;
  return std::nullopt;
}

/// Branch of (9.16) from the sign of P_r = 2 A r + B. Where P is linear in r throughout there is one
/// branch, 1.
int branch_from(int sign_of_derivative, bool linear) {
  if (sign_of_derivative == 0) return 0;
  return linear || sign_of_derivative < 0 ? 1 : 2;
}

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

Rational initial_width() { return power_of_two(-50); }

std::vector<CertifiedPoint> conic_point(const LinePlace& place,
                                        const std::shared_ptr<const ConicForms>& forms,
                                        const RealAlgebraic& s) {
  const int sign_d = sign_at(forms->s1, s);
  const UnitPlace r = place_of_ratio(forms->s0, forms->s1, sign_d, s);
  if (r == UnitPlace::outside) return {};
  const UnitPlace t = place_of_ratio(forms->t_numerator, forms->s1, sign_d, s);
  if (t == UnitPlace::outside) return {};
  const LocalSides sides = {side_of(t), side_of(r), side_of(s)};
  const int multiplicity = root_multiplicity(forms->eliminant, s);
  const Polynomial derivative = forms->b * forms->s1 - Polynomial(2) * forms->a * forms->s0;
  const int branch = branch_from(sign_at(derivative, s) * sign_d, forms->a.is_zero());
  auto source = std::make_shared<ConicPointSource>(place, sides, s, forms);
  return {CertifiedPoint(source, initial_width(), global_sides(place, sides), multiplicity, branch)};
}

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

void separate(std::vector<CertifiedPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (Rational width = initial_width() / 1024; meet(points[i].box(), points[j].box()); width *= width) {
        points[i] = points[i].refined_to(width);
        points[j] = points[j].refined_to(width);
      }
}

}  // namespace exsect
