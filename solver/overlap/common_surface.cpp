#include "overlap/common_surface.h"

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/trivariate_gcd.h>
#include <exsect/geometry/straight_line.h>
#include <exsect/solver/line_query.h>

#include <algorithm>

#include "eliminant/fibre_forms.h"
#include "line/line_forms.h"
#include "line/line_system.h"

namespace exsect {

namespace {

using Vector = SpaceVector<Polynomial>;
using Form = TrivariatePolynomial;

TrivariateCoefficients table_of(const Form& f) {
  TrivariateCoefficients table(static_cast<std::size_t>(f.degree_r() + 1));
  for (int i = 0; i <= f.degree_r(); ++i)
    for (int j = 0; j <= f.degree_s(); ++j) table[static_cast<std::size_t>(i)].push_back(f.coefficient(i, j));
  return table;
}

bool vanishes(const Vector& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

bool has_curve(const TrivariatePolynomial& f) { return f.degree_r() > 0 || f.degree_s() > 0; }

Form constant_in_rs(const Polynomial& c) { return Form({{c}}); }

/// The coordinates of y(r,s) - a0(u).
std::array<Form, 3> difference(const BezierPatch& y, const Vector& a0) {
  const ControlNet c = y.power_basis();
  std::array<Form, 3> w;
  for (std::size_t k = 0; k < 3; ++k) {
    TrivariateCoefficients table(3, std::vector<Polynomial>(3));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) table[i][j] = Polynomial(c[i][j][k]);
    table[0][0] -= a0[k];
    w[k] = Form(table);
  }
  return w;
}

/// (a x w)_k
Form cross_coordinate(const Vector& a, const std::array<Form, 3>& w, std::size_t k) {
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  return constant_in_rs(a[i]) * w[j] - constant_in_rs(a[j]) * w[i];
}

/// The equations of the line x(u,.) on y (method, section 1) with u as a variable.
std::vector<Form> line_equations(const SymbolicLine& line, const BezierPatch& y) {
  const std::array<Form, 3> w = difference(y, line.a[0]);
  const Vector n = cross_product(line.a[1], line.a[2]);
  if (vanishes(n)) {
    const Vector& direction = vanishes(line.a[2]) ? line.a[1] : line.a[2];
    return {cross_coordinate(direction, w, 0), cross_coordinate(direction, w, 1),
            cross_coordinate(direction, w, 2)};
  }
  std::size_t k = 0;
  while (n[k].is_zero()) ++k;
  const Form zero;
  const Form plane = constant_in_rs(n[0]) * w[0] - (zero - constant_in_rs(n[1]) * w[1]) -
                     (zero - constant_in_rs(n[2]) * w[2]);
  const Form lambda = cross_coordinate(line.a[2], w, k);  // the sign drops out
  const Form mu = cross_coordinate(line.a[1], w, k);
  return {plane, constant_in_rs(n[k]) * mu - lambda * lambda};  // (1.3)
}

/// f without its factors that do not depend on u: they stand for parameters of y that are mapped to a point
/// on all lines of x.
TrivariatePolynomial without_points(const TrivariatePolynomial& f) {
  const auto in_rs = [&](int k) {
    std::vector<Polynomial> rows;
    for (int i = 0; i <= f.degree_r(); ++i) {
      std::vector<Rational> in_s;
      for (int j = 0; j <= f.degree_s(); ++j) in_s.push_back(f.coefficient(i, j).coefficient(k));
      rows.emplace_back(in_s);
    }
    return BivariatePolynomial(std::move(rows));
  };
  BivariatePolynomial content;
  for (int k = 0; k <= f.degree_u(); ++k) content = gcd(content, in_rs(k));
  TrivariateCoefficients table(static_cast<std::size_t>(f.degree_r() + 1));
  for (auto& row : table) row.resize(static_cast<std::size_t>(f.degree_s() + 1));
  for (int k = 0; k <= f.degree_u(); ++k) {
    const BivariatePolynomial quotient = exact_quotient(in_rs(k), content);
    std::vector<Rational> power(static_cast<std::size_t>(k + 1));
    for (int i = 0; i <= quotient.degree_r(); ++i)
      for (int j = 0; j <= quotient.coefficient(i).degree(); ++j) {
        power.back() = quotient.coefficient(i, j);
        table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += Polynomial(power);
      }
  }
  return TrivariatePolynomial(std::move(table));
}

/// False only if the line at one u has no curve in common with y: then W is empty.
bool may_have_curve(const BezierPatch& x, const BezierPatch& y) {
  const LineQuery query = {Parameter::u, Rational(2, 7)};
  const IntegerLineAndPatch problem = integer_line_and_patch(x, y, query);
  if (is_conic(problem.line)) {
    const auto separated = [](const IntegerLineAndPatch& p) { return !conic_forms(p).eliminant.is_zero(); };
    // Infinitely many points would have infinitely many values of s, or of r.
    if (separated(problem) && separated({problem.line, exchanged(problem.patch)})) return false;
  }
  const LineAndPatch general = line_and_patch(x, y, query);
  if (shape(general.line) == LineShape::point) return true;
  const LineSystem system = line_system(general);
  const BivariatePolynomial shared = gcd(system.first, system.second);
  return shared.is_zero() || shared.degree_r() > 0 || shared.degree_s() > 0;
}

bool lie_in_one_plane(const BezierPatch& x, const BezierPatch& y) {
  const Point& origin = x.net()[0][0];
  std::vector<Point> differences;
  for (const BezierPatch* patch : {&x, &y})
    for (const auto& row : patch->net())
      for (const Point& p : row) differences.push_back(p - origin);
  Point first = {0, 0, 0};
  Point normal = {0, 0, 0};
  for (const Point& d : differences) {
    if (is_zero(first)) first = d;
    if (is_zero(normal)) normal = cross(first, d);
  }
  return std::all_of(differences.begin(), differences.end(),
                     [&](const Point& d) { return dot(normal, d) == 0; });
}

/// Values of c[0] + c[1] t + c[2] t^2 over the interval.
RationalInterval range_of(const std::array<Rational, 3>& c, const RationalInterval& t) {
  const Rational m = t.midpoint();
  const Rational value = c[0] + m * (c[1] + m * c[2]);
  const Rational largest = std::max(abs(t.lower), abs(t.upper));
  const Rational spread = t.width() / 2 * (abs(c[1]) + 2 * abs(c[2]) * largest);
  return {value - spread, value + spread};
}

}  // namespace

CommonSurface::CommonSurface(const BezierPatch& x, const BezierPatch& y, TrivariatePolynomial f)
    : x_(x), y_(y), f_(std::move(f)), planar_(lie_in_one_plane(x, y)) {
  const SymbolicLine line = symbolic_line(x);
  all_straight_ = vanishes(cross_product(line.a[1], line.a[2]));
}

std::optional<CommonSurface> CommonSurface::of(const BezierPatch& x, const BezierPatch& y) {
  if (!may_have_curve(x, y)) return std::nullopt;
  TrivariateCoefficients common;
  for (const Form& equation : line_equations(symbolic_line(x), y)) common = gcd(common, table_of(equation));
  const TrivariatePolynomial f = without_points(TrivariatePolynomial(std::move(common)));
  if (!has_curve(f)) return std::nullopt;
  return CommonSurface(x, y, f);
}

bool CommonSurface::has_point(const Rational& u, const Rational& s, const RationalInterval& r,
                              const RationalInterval& v) const {
  return has_point(f_.at_u(u), line_at_first(x_, u), y_, s, r, v);
}

bool CommonSurface::has_point_at_r(const Rational& u, const Rational& r, const RationalInterval& s,
                                   const RationalInterval& v) const {
  return has_point(f_.at_u(u).exchanged(), line_at_first(x_, u), y_.exchanged(), r, s, v);
}

bool CommonSurface::has_point(const BivariatePolynomial& f, const ParameterLine& line, const BezierPatch& y,
                              const Rational& s, const RationalInterval& r, const RationalInterval& v) const {
  const LineShape kind = exsect::shape(line);
  const Polynomial in_r = f.at_s(s);
  if (kind == LineShape::point || in_r.degree() <= 0) return false;
  // The line's coordinate: lambda(P) = phi(v), phi = v on a conic.
  AffineForm lambda;
  Polynomial phi = Polynomial::variable();
  if (kind == LineShape::conic) {
    const LineForms forms = axis_forms(line);
    const Rational scale = 1 / forms.e0.constant;
    lambda = {scale * forms.e1.normal, scale * forms.e1.constant};
  } else {
    const StraightForms forms = straight_forms(line);
    lambda = forms.lambda;
    phi = forms.phi;
    if (phi.degree() > 1 && !all_straight_) return false;  // the point of W may be at the other v
  }
  const BivariatePolynomial on_patch = pull_back(lambda, y);
  const Polynomial on_line = on_patch.at_s(s);
  const std::array<Rational, 3> c = {on_line.coefficient(0), on_line.coefficient(1), on_line.coefficient(2)};
  const Rational from = std::min(phi(v.lower), phi(v.upper));
  const Rational to = std::max(phi(v.lower), phi(v.upper));
  for (const RealAlgebraic& root : real_roots(in_r, r.lower, r.upper)) {
    const RationalInterval value = range_of(c, root.refined_to(r.width() * power_of_two(-30)).interval());
    if (from <= value.lower && value.upper <= to) return true;  // phi takes the value between the ends
  }
  return false;
}

}  // namespace exsect
