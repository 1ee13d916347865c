#include "eliminant/algebraic_fibre.h"

#include <exsect/algebra/number_field.h>
#include <exsect/geometry/integer_pair.h>

#include <algorithm>
#include <optional>

#include "answer/exact_source.h"
#include "eliminant/fibre_projection.h"
#include "line/exact_tangent.h"

namespace exsect {

namespace {

BivariatePolynomial in_s(const Polynomial& f) { return BivariatePolynomial({f}); }

/// The four parameters by their parts in the fibre.
struct Roles {
  Parameter sweep;
  Parameter line;  // the other one of the same patch
  Parameter eliminated;
  Parameter kept;
};

class FibreOverAlgebraic {
 public:
  FibreOverAlgebraic(const BezierPatch& x, const BezierPatch& y, FibreCoefficients<Polynomial> f, Roles roles,
                     const RealAlgebraic& value)
      : x_(x), y_(y), f_(std::move(f)), roles_(roles), value_(value) {}

  /// Projects the fibre. True if no singular point is inside: each is a multiple root of the projection, and
  /// there are none, but for 0 and 1.
  bool is_excluded() {
    const FibreProjection points = project_fibre(f_);
    if (is_zero(points.r) || sign_at(points.content, value_) == 0) return false;
    projection_ = reduced(BivariatePolynomial((points.complete ? points.finite : points.r).coefficients));
    if (projection_.degree_r() < 1) return false;
    const auto bound = gcd_degree_bound(projection_, projection_.derivative_r(), value_.polynomial());
    return bound && *bound <= std::max(0, order_of_root(0) - 1) + std::max(0, order_of_root(1) - 1);
  }

  /// The points inside the squares; requires is_excluded() to be called before.
  std::vector<SingularFibrePoint> run() {
    if (projection_.degree_r() < 1) return {};
    const auto repeated = gcd_modulo(projection_, projection_.derivative_r(), value_.polynomial());
    const int k = repeated ? repeated->degree_r() : 0;
    // If all roots of the repeated part are equal, this is the one: their mean.
    if (k < 1 || !set_equations(Polynomial(Rational(-1, k)) * repeated->coefficient(k - 1), 1)) return {};
    return points_of_equation();
  }

 private:
  /// Of the projection over the value.
  int order_of_root(const Rational& at) const {
    int order = 0;
    for (BivariatePolynomial f = projection_; order < projection_.degree_r(); f = f.derivative_r(), ++order)
      if (sign_at(f.at_r(at), value_) != 0) break;
    return order;
  }

  Polynomial reduced(const Polynomial& f) const { return divide(f, value_.polynomial()).remainder; }
  BivariatePolynomial reduced(const BivariatePolynomial& f) const {
    std::vector<Polynomial> coefficients;
    for (int i = 0; i <= f.degree_r(); ++i) coefficients.push_back(reduced(f.coefficient(i)));
    return BivariatePolynomial(std::move(coefficients));
  }

  using FormVector = std::array<BivariatePolynomial, 3>;

  /// den² (y - a0) at kept = num / den, by powers of the parameter that is eliminated.
  FormVector difference() const {
    FormVector result;
    const Polynomial square = reduced(den_ * den_);
    const std::array<Polynomial, 3> powers = {square, reduced(num_ * den_), reduced(num_ * num_)};
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<Polynomial> coefficients(3);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) coefficients[i] = coefficients[i] + f_.y[i][j][c] * powers[j];
      coefficients[0] = reduced(coefficients[0] - f_.a[0][c] * square);
      result[c] = BivariatePolynomial(std::move(coefficients));
    }
    return result;
  }

  /// x(sweep, line) = y with the kept parameter num / den: the line's parameter as a fraction, and the
  /// equation that is left for the eliminated one. False if there is none.
  bool set_equations(Polynomial num, Polynomial den) {
    num_ = std::move(num);
    den_ = std::move(den);
    const FormVector w = difference();
    const auto is_nonzero = [&](const Polynomial& p) { return sign_at(p, value_) != 0; };
    const SpaceVector<Polynomial> n = cross_product(f_.a[1], f_.a[2]);
    const Polynomial square = reduced(den_ * den_);
    FormVector left;
    if (const auto k = std::find_if(n.begin(), n.end(), is_nonzero); k != n.end()) {
      const auto axis = static_cast<std::size_t>(k - n.begin());
      const std::size_t a = (axis + 1) % 3;
      const std::size_t b = (axis + 2) % 3;
      line_numerator_ = reduced(w[a] * in_s(f_.a[2][b]) - w[b] * in_s(f_.a[2][a]));
      const Polynomial nk = reduced(*k);
      line_denominator_ = reduced(nk * square);
      for (std::size_t c = 0; c < 3; ++c)
        left[c] = reduced(line_numerator_ * in_s(f_.a[1][c] * line_denominator_) +
                          line_numerator_ * line_numerator_ * in_s(f_.a[2][c]) -
                          w[c] * in_s(nk * line_denominator_));
    } else if (std::none_of(f_.a[2].begin(), f_.a[2].end(), is_nonzero)) {
      const auto first = std::find_if(f_.a[1].begin(), f_.a[1].end(), is_nonzero);
      if (first == f_.a[1].end()) return false;
      const auto axis = static_cast<std::size_t>(first - f_.a[1].begin());
      line_numerator_ = w[axis];
      line_denominator_ = reduced(*first * square);
      for (std::size_t c = 0; c < 3; ++c)
        left[c] = reduced(w[axis] * in_s(f_.a[1][c]) - w[c] * in_s(f_.a[1][axis]));
    } else {
      return false;
    }
    const auto two = gcd_modulo(left[0], left[1], value_.polynomial());
    const auto three = two ? gcd_modulo(*two, left[2], value_.polynomial()) : std::nullopt;
    if (!three) return false;
    equation_ = *three;
    return equation_.degree_r() > 0;
  }

  std::vector<SingularFibrePoint> points_of_equation() const {
    std::vector<SingularFibrePoint> result;
    for (const TriangularPoint& p : roots_at(equation_, value_, 0, 1)) {
      const ExactParameters exact = parameters(p);
      if (!is_inside(exact)) continue;
      const std::array<bool, 4> zero = zero_tangent_components(x_, y_, exact);
      if (std::count(zero.begin(), zero.end(), true) != 4) continue;
      result.push_back(
          {certified(exact, {}), value_, roles_.kept, roles_.eliminated, projection_, equation_});
    }
    return result;
  }

  ExactParameters parameters(const TriangularPoint& p) const {
    ExactParameters exact{p, {}, {}};
    exact.denominator.fill(BivariatePolynomial::constant(1));
    exact.numerator[index(roles_.sweep)] = BivariatePolynomial::s();
    exact.numerator[index(roles_.eliminated)] = BivariatePolynomial::r();
    exact.numerator[index(roles_.kept)] = in_s(num_);
    exact.denominator[index(roles_.kept)] = in_s(den_);
    exact.numerator[index(roles_.line)] = line_numerator_;
    exact.denominator[index(roles_.line)] = in_s(line_denominator_);
    return exact;
  }

  static bool is_inside(const ExactParameters& exact) {
    for (std::size_t j = 0; j < 4; ++j) {
      const BivariatePolynomial& n = exact.numerator[j];
      const BivariatePolynomial& d = exact.denominator[j];
      const int sign = sign_at(d, exact.at);
      if (sign * sign_at(n, exact.at) <= 0 || sign * sign_at(n - d, exact.at) >= 0) return false;
    }
    return true;
  }

  const BezierPatch& x_;
  const BezierPatch& y_;
  FibreCoefficients<Polynomial> f_;
  Roles roles_;
  RealAlgebraic value_;
  BivariatePolynomial projection_;
  Polynomial num_;
  Polynomial den_;
  BivariatePolynomial line_numerator_;
  Polynomial line_denominator_;
  BivariatePolynomial equation_;
};

FibreCoefficients<Polynomial> fibre_over(const BezierPatch& x, const BezierPatch& y, Parameter sweep) {
  const bool of_x = index(sweep) < 2;
  const BezierPatch& owner = of_x ? x : y;
  return symbolic_fibre(integer_pair(index(sweep) % 2 == 0 ? owner : owner.exchanged(), of_x ? y : x));
}

bool is_new(const std::vector<SingularFibrePoint>& known, const CertifiedPoint& point) {
  return std::none_of(known.begin(), known.end(), [&](const SingularFibrePoint& other) {
    const ParameterBox a = other.at.box();
    const ParameterBox b = point.box();
    for (std::size_t j = 0; j < 4; ++j)
      if (a[j].upper < b[j].lower || b[j].upper < a[j].lower) return false;
    return true;
  });
}

}  // namespace

bool SingularFibrePoint::is_alone_in(const ParameterBox& box) const {
  const auto has_one_root = [&](const BivariatePolynomial& f, Parameter p) {
    const RationalInterval& range = box[index(p)];
    return roots_at(f, value, range.lower, range.upper).size() == 1;
  };
  return has_one_root(projection, kept) && has_one_root(equation, eliminated);
}

std::vector<SingularFibrePoint> singular_points_over(const BezierPatch& x, const BezierPatch& y,
                                                     Parameter sweep, const RealAlgebraic& value) {
  const bool of_x = index(sweep) < 2;
  const auto line = static_cast<Parameter>(index(sweep) ^ 1U);
  const FibreCoefficients<Polynomial> f = fibre_over(x, y, sweep);
  const Parameter first = all_parameters[of_x ? 2 : 0];
  const Parameter second = all_parameters[of_x ? 3 : 1];
  FibreOverAlgebraic by_first(x, y, f, {sweep, line, first, second}, value);
  FibreOverAlgebraic by_second(x, y, f.exchanged(), {sweep, line, second, first}, value);
  if (by_first.is_excluded() || by_second.is_excluded()) return {};
  std::vector<SingularFibrePoint> result = by_first.run();
  for (SingularFibrePoint& point : by_second.run())
    if (is_new(result, point.at)) result.push_back(std::move(point));
  return result;
}

// If the fibre contains a curve, R vanishes identically over the value, or does with r and s exchanged
// (method, Theorem 4.4).
bool may_have_infinite_fibre(const BezierPatch& x, const BezierPatch& y, Parameter sweep,
                             const RealAlgebraic& value) {
  const FibreCoefficients<Polynomial> f = fibre_over(x, y, sweep);
  const auto vanishes = [&](const FibreCoefficients<Polynomial>& g) {
    return sign_at(project_fibre(g).content, value) == 0;
  };
  return vanishes(f) || vanishes(f.exchanged());
}

}  // namespace exsect
