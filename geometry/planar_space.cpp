#include "planar_space.h"

#include <exsect/algebra/bernstein.h>

#include <algorithm>
#include <stdexcept>

namespace exsect {
namespace {

using Piecewise = std::vector<std::vector<Polynomial>>;

void require(bool statement, const char* message) {
  if (!statement) throw std::invalid_argument(message);
}

void require_box(const PlanarBox& box) {
  require(box.x.lower < box.x.upper && box.y.lower < box.y.upper,
          "planar space: the box must have positive sides");
}

/// 1, t, ..., t^degree on one interval.
Piecewise piecewise_powers(int degree, const Polynomial& t) {
  Piecewise functions;
  Polynomial power = 1;
  for (int i = 0; i <= degree; ++i) {
    functions.push_back({power});
    power *= t;
  }
  return functions;
}

/// The greatest power of two that is at most q > 0.
Rational power_below(const Rational& q) {
  Rational power = 1;
  while (power > q) power /= 2;
  while (2 * power <= q) power *= 2;
  return power;
}

/// The multiple of the step nearest to q.
Rational nearest_multiple(const Rational& q, const Rational& step) {
  const Rational shifted = q / step + Rational(1, 2);
  Integer whole = numerator(shifted) / denominator(shifted);
  if (Rational(whole) > shifted) --whole;
  return whole * step;
}

/// (t - from) / length.
Polynomial local_coordinate(const Rational& from, const Rational& length) {
  return Polynomial{-from / length, 1 / length};
}

Piecewise bernstein_functions(int degree, const RationalInterval& on) {
  const Polynomial t = local_coordinate(on.lower, on.width());
  Piecewise functions;
  for (int i = 0; i <= degree; ++i) {
    std::vector<Rational> unit(static_cast<std::size_t>(degree) + 1, 0);
    unit[static_cast<std::size_t>(i)] = 1;
    functions.push_back({from_bernstein(unit).compose(t)});
  }
  return functions;
}

/// Pieces of the uniform B-spline of the degree on [0,1], [1,2], ..., [degree, degree+1], each in its local
/// coordinate: N_m(k + t) = ((k + t) N_(m-1)(k + t) + (m + 1 - k - t) N_(m-1)(k - 1 + t)) / m.
std::vector<Polynomial> cardinal_b_spline(int degree) {
  std::vector<Polynomial> pieces = {Polynomial(1)};
  for (int m = 1; m <= degree; ++m) {
    std::vector<Polynomial> next;
    for (int k = 0; k <= m; ++k) {
      Polynomial sum;
      if (k < m) sum += Polynomial{Rational(k), 1} * pieces[static_cast<std::size_t>(k)];
      if (k > 0) sum += Polynomial{Rational(m + 1 - k), -1} * pieces[static_cast<std::size_t>(k - 1)];
      next.push_back(sum * Polynomial(Rational(1, m)));
    }
    pieces = std::move(next);
  }
  return pieces;
}

std::vector<Rational> equal_breaks(const RationalInterval& on, int cells) {
  std::vector<Rational> breaks;
  for (int k = 0; k <= cells; ++k) breaks.push_back(on.lower + on.width() * k / cells);
  return breaks;
}

/// The cells + degree uniform B-splines whose support meets the breaks' interval.
Piecewise b_spline_functions(int degree, const std::vector<Rational>& breaks) {
  const std::vector<Polynomial> pieces = cardinal_b_spline(degree);
  const std::size_t cells = breaks.size() - 1;
  const auto m = static_cast<std::size_t>(degree);
  Piecewise functions(cells + m, std::vector<Polynomial>(cells));
  for (std::size_t k = 0; k < cells; ++k) {
    const Polynomial t = local_coordinate(breaks[k], breaks[k + 1] - breaks[k]);
    // Function i begins at the break i - m, so the interval k is its piece k + m - i.
    for (std::size_t i = k; i <= k + m; ++i) functions[i][k] = pieces[k + m - i].compose(t);
  }
  return functions;
}

std::size_t interval_of(const std::vector<Rational>& breaks, const Rational& t) {
  std::size_t k = 0;
  while (k + 2 < breaks.size() && breaks[k + 1] <= t) ++k;
  return k;
}

/// Intervals of the breaks that meet [range].
std::pair<std::size_t, std::size_t> intervals_meeting(const std::vector<Rational>& breaks,
                                                      const RationalInterval& range) {
  std::size_t first = 0;
  while (first + 2 < breaks.size() && breaks[first + 1] < range.lower) ++first;
  std::size_t last = first;
  while (last + 2 < breaks.size() && breaks[last + 1] <= range.upper) ++last;
  return {first, last};
}

std::vector<std::vector<bool>> cells_near(const BezierCurve& curve, const std::vector<Rational>& breaks_x,
                                          const std::vector<Rational>& breaks_y) {
  const std::size_t nx = breaks_x.size() - 1, ny = breaks_y.size() - 1;
  std::vector<std::vector<bool>> near(nx, std::vector<bool>(ny, false));
  const HomogeneousCurve reduced = homogeneous(curve);
  const int parts = static_cast<int>(8 * std::max(nx, ny));
  for (int part = 0; part < parts; ++part) {
    const PlanarBox box = control_box(reduced, Rational(part, parts), Rational(part + 1, parts));
    const auto [i0, i1] = intervals_meeting(breaks_x, box.x);
    const auto [j0, j1] = intervals_meeting(breaks_y, box.y);
    // The cells met and their neighbours.
    for (std::size_t i = i0 > 0 ? i0 - 1 : 0; i <= std::min(i1 + 1, nx - 1); ++i)
      for (std::size_t j = j0 > 0 ? j0 - 1 : 0; j <= std::min(j1 + 1, ny - 1); ++j) near[i][j] = true;
  }
  return near;
}

/// The integral of f g over [a,b].
Rational integral(const Polynomial& f, const Polynomial& g, const RationalInterval& on) {
  const Polynomial product = f * g;
  std::vector<Rational> primitive = {0};
  for (int i = 0; i <= product.degree(); ++i) primitive.push_back(product.coefficient(i) / (i + 1));
  const Polynomial antiderivative(primitive);
  return antiderivative(on.upper) - antiderivative(on.lower);
}

/// gram[d][i][j]: the integral of the d-th derivatives of functions i and j over the k-th interval.
using Gram = std::vector<std::vector<std::vector<Rational>>>;

Gram gram(const Piecewise& functions, std::size_t k, const RationalInterval& on) {
  const std::size_t n = functions.size();
  Gram result(3, std::vector<std::vector<Rational>>(n, std::vector<Rational>(n, 0)));
  std::vector<Polynomial> derivative;
  for (const std::vector<Polynomial>& f : functions) derivative.push_back(f[k]);
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        if (!derivative[i].is_zero() && !derivative[j].is_zero())
          result[d][i][j] = result[d][j][i] = integral(derivative[i], derivative[j], on);
    for (Polynomial& f : derivative) f = f.derivative();
  }
  return result;
}

/// a(x) b(y), or a(x^2) b(y).
BivariatePolynomial product_of(const Polynomial& a, const Polynomial& b, bool squared) {
  std::vector<Polynomial> rows;
  for (int i = 0; i <= a.degree(); ++i) {
    if (squared && i > 0) rows.emplace_back();
    rows.push_back(b * Polynomial(a.coefficient(i)));
  }
  return BivariatePolynomial(std::move(rows));
}

}  // namespace

PlanarBox control_box(const HomogeneousCurve& curve, const Rational& from, const Rational& to) {
  const int n = curve.degree();
  const std::vector<Rational> w = bernstein_coefficients(curve.denominator, n, from, to);
  // Where a weight of the part is not positive the part must be divided for a hull.
  if (*std::min_element(w.begin(), w.end()) <= 0) {
    const Rational middle = (from + to) / 2;
    const PlanarBox a = control_box(curve, from, middle), b = control_box(curve, middle, to);
    return {{std::min(a.x.lower, b.x.lower), std::max(a.x.upper, b.x.upper)},
            {std::min(a.y.lower, b.y.lower), std::max(a.y.upper, b.y.upper)}};
  }
  const auto range = [&](const Polynomial& numerator) {
    std::vector<Rational> c = bernstein_coefficients(numerator, n, from, to);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] /= w[i];
    const auto [least, greatest] = std::minmax_element(c.begin(), c.end());
    return RationalInterval{*least, *greatest};
  };
  return {range(curve.numerators[0]), range(curve.numerators[1])};
}

PlanarSpace PlanarSpace::monomials(int degree, const PlanarBox& box) {
  return powers_of(degree, box, Polynomial::variable(), Polynomial::variable());
}

PlanarSpace PlanarSpace::local_monomials(int degree, const PlanarBox& box) {
  require_box(box);
  const Rational unit = power_below(std::max(box.x.width(), box.y.width()));
  const auto local = [&](const RationalInterval& side) {
    return local_coordinate(nearest_multiple(side.midpoint(), unit / 4), unit);
  };
  return powers_of(degree, box, local(box.x), local(box.y));
}

PlanarSpace PlanarSpace::powers_of(int degree, const PlanarBox& box, const Polynomial& x,
                                   const Polynomial& y) {
  require(degree >= 0, "planar space: the degree must not be negative");
  require_box(box);
  PlanarSpace space;
  space.breaks_x_ = {box.x.lower, box.x.upper};
  space.breaks_y_ = {box.y.lower, box.y.upper};
  space.in_x_ = piecewise_powers(degree, x);
  space.in_y_ = piecewise_powers(degree, y);
  space.active_ = {{true}};
  for (int total = 0; total <= degree; ++total)
    for (int j = 0; j <= total; ++j)
      space.products_.push_back({static_cast<std::size_t>(total - j), static_cast<std::size_t>(j)});
  return space;
}

PlanarSpace PlanarSpace::bernstein(int m, int n, const PlanarBox& box) {
  require(m >= 0 && n >= 0, "planar space: the degree must not be negative");
  require_box(box);
  PlanarSpace space;
  space.breaks_x_ = {box.x.lower, box.x.upper};
  space.breaks_y_ = {box.y.lower, box.y.upper};
  space.in_x_ = bernstein_functions(m, box.x);
  space.in_y_ = bernstein_functions(n, box.y);
  space.active_ = {{true}};
  for (std::size_t i = 0; i < space.in_x_.size(); ++i)
    for (std::size_t j = 0; j < space.in_y_.size(); ++j) space.products_.push_back({i, j});
  return space;
}

PlanarSpace PlanarSpace::b_splines(int m, int n, const PlanarBox& box, int cells_x, int cells_y,
                                   const BezierCurve& curve) {
  require(m >= 2 && n >= 2, "planar space: B-splines need degree 2 or more");
  require(cells_x >= 1 && cells_y >= 1, "planar space: at least one cell is needed");
  require_box(box);
  PlanarSpace space;
  space.breaks_x_ = equal_breaks(box.x, cells_x);
  space.breaks_y_ = equal_breaks(box.y, cells_y);
  space.in_x_ = b_spline_functions(m, space.breaks_x_);
  space.in_y_ = b_spline_functions(n, space.breaks_y_);
  space.active_ = cells_near(curve, space.breaks_x_, space.breaks_y_);
  const auto meets_cells = [&](std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < space.active_.size(); ++k)
      for (std::size_t l = 0; l < space.active_[k].size(); ++l)
        if (space.active_[k][l] && !space.in_x_[i][k].is_zero() && !space.in_y_[j][l].is_zero()) return true;
    return false;
  };
  for (std::size_t i = 0; i < space.in_x_.size(); ++i)
    for (std::size_t j = 0; j < space.in_y_.size(); ++j)
      if (meets_cells(i, j)) space.products_.push_back({i, j});
  return space;
}

PlanarSpace PlanarSpace::in_squares() const {
  PlanarSpace space = *this;
  space.squared_ = true;
  return space;
}

int PlanarSpace::total_degree() const {
  const auto degree = [](const std::vector<Polynomial>& f) {
    int largest = -1;
    for (const Polynomial& piece : f) largest = std::max(largest, piece.degree());
    return largest;
  };
  int largest = -1;
  for (const Product& p : products_)
    largest = std::max(largest, (squared_ ? 2 : 1) * degree(in_x_[p.i]) + degree(in_y_[p.j]));
  return largest;
}

PlanarSpace::Values PlanarSpace::at(const Rational& x, const Rational& y) const {
  const Rational first = squared_ ? Rational(x * x) : x;
  const Rational chain = squared_ ? Rational(2 * x) : Rational(1);
  const std::size_t k = interval_of(breaks_x_, first);
  const std::size_t l = interval_of(breaks_y_, y);
  const bool inside = first >= breaks_x_.front() && first <= breaks_x_.back() && y >= breaks_y_.front() &&
                      y <= breaks_y_.back() && active(k, l);
  if (!is_polynomial() && !inside) throw std::domain_error("planar space: no function is defined there");
  const auto values = [](const Piecewise& functions, std::size_t interval, const Rational& t) {
    std::vector<std::pair<Rational, Rational>> result;
    for (const std::vector<Polynomial>& f : functions)
      result.emplace_back(f[interval](t), f[interval].derivative()(t));
    return result;
  };
  const auto a = values(in_x_, k, first);
  const auto b = values(in_y_, l, y);
  Values result;
  for (const Product& p : products_) {
    result.value.push_back(a[p.i].first * b[p.j].first);
    result.dx.push_back(chain * a[p.i].second * b[p.j].first);
    result.dy.push_back(a[p.i].first * b[p.j].second);
  }
  return result;
}

RationalMatrix PlanarSpace::tension() const {
  RationalMatrix h(dimension(), dimension());
  std::vector<Gram> of_x, of_y;
  for (std::size_t k = 0; k + 1 < breaks_x_.size(); ++k)
    of_x.push_back(gram(in_x_, k, {breaks_x_[k], breaks_x_[k + 1]}));
  for (std::size_t l = 0; l + 1 < breaks_y_.size(); ++l)
    of_y.push_back(gram(in_y_, l, {breaks_y_[l], breaks_y_[l + 1]}));
  for (std::size_t k = 0; k < of_x.size(); ++k) {
    for (std::size_t l = 0; l < of_y.size(); ++l) {
      if (!active(k, l)) continue;
      for (std::size_t p = 0; p < dimension(); ++p) {
        const auto [i, j] = products_[p];
        if (in_x_[i][k].is_zero() || in_y_[j][l].is_zero()) continue;
        for (std::size_t q = 0; q < dimension(); ++q) {
          const auto [m, n] = products_[q];
          if (of_x[k][0][i][m] == 0 && of_y[l][0][j][n] == 0) continue;
          h(p, q) += of_x[k][2][i][m] * of_y[l][0][j][n] + 2 * of_x[k][1][i][m] * of_y[l][1][j][n] +
                     of_x[k][0][i][m] * of_y[l][2][j][n];
        }
      }
    }
  }
  return h;
}

PlanarFunction PlanarSpace::combination(const std::vector<Rational>& c) const {
  require(c.size() == dimension(), "planar space: one coefficient for each function is required");
  const auto on_cell = [&](std::size_t k, std::size_t l) {
    BivariatePolynomial sum;
    for (std::size_t p = 0; p < dimension(); ++p) {
      const Polynomial& a = in_x_[products_[p].i][k];
      const Polynomial& b = in_y_[products_[p].j][l];
      if (c[p] != 0 && !a.is_zero() && !b.is_zero()) sum += product_of(a * Polynomial(c[p]), b, squared_);
    }
    return sum;
  };
  if (is_polynomial()) return on_cell(0, 0);
  std::vector<std::vector<std::optional<BivariatePolynomial>>> cells(active_.size());
  for (std::size_t k = 0; k < active_.size(); ++k)
    for (std::size_t l = 0; l < active_[k].size(); ++l)
      cells[k].push_back(active(k, l) ? std::optional(on_cell(k, l)) : std::nullopt);
  return PlanarFunction({breaks_x_, breaks_y_, squared_}, std::move(cells));
}

}  // namespace exsect
