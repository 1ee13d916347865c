#include "rational_patch.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/positive_on_square.h>
#include <exsect/algebra/tensor_bernstein.h>

#include <algorithm>
#include <utility>

#include "net_piece.h"
#include "number.h"
#include "reduced_net.h"

namespace exsect {
namespace {

/// The vectors of a Bézier curve in homogeneous coordinates.
using Row = std::vector<HomogeneousPoint>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

HomogeneousPoint homogeneous_between(const HomogeneousPoint& a, const HomogeneousPoint& b,
                                     const Rational& t) {
  HomogeneousPoint p;
  for (std::size_t k = 0; k < 4; ++k) p[k] = a[k] + t * (b[k] - a[k]);
  return p;
}

bool has_no_coordinate(const HomogeneousPoint& p) {
  return std::all_of(p.begin(), p.end(), [](const Rational& c) { return c == 0; });
}

HomogeneousPoint value(Row row, const Rational& t) {
  for (; row.size() > 1; row.pop_back())
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = homogeneous_between(row[i], row[i + 1], t);
  return row.front();
}

Row elevated_once(const Row& row) {
  const int n = static_cast<int>(row.size());
  Row result = {row.front()};
  for (int i = 1; i < n; ++i)
    result.push_back(homogeneous_between(row[at(i)], row[at(i - 1)], Rational(i, n)));
  result.push_back(row.back());
  return result;
}

/// "1/2", or six digits and more of what is long or only enclosed.
std::string shown(const RationalInterval& t) {
  const std::string exact = to_string(t.lower);
  if (t.lower == t.upper && exact.size() <= 20) return exact;
  std::string text = std::to_string(to_double(t.midpoint()));
  return text;
}

void require_positive(const BivariatePolynomial& denominator, const std::string& where) {
  const std::optional<NotPositive> place = not_positive_on_square(denominator);
  if (!place) return;
  throw PatchError(where, std::string("the denominator ") + (place->sign < 0 ? "is negative" : "vanishes") +
                              " at (u,v) = (" + shown(place->r) + ", " + shown(place->s) +
                              "); it must be positive on the closed unit square");
}

std::string in_brackets(std::size_t i) { return "[" + std::to_string(i) + "]"; }

/// The degree of a list of `size` rows or points.
int degree_of(std::size_t size, const std::string& where, const char* what) {
  if (size < 2)
    throw PatchError(where, "degree 0 is not supported: 2 to 4 " + std::string(what) + " are needed");
  if (size > at(max_patch_degree) + 1)
    throw PatchError(
        where, "degree " + std::to_string(size - 1) + " is not supported: 2 to 4 " + what + " are needed");
  return static_cast<int>(size) - 1;
}

/// The bidegree of a net; every row must have as many elements as the first.
template <class Element>
std::array<int, 2> bidegree_of(const std::vector<std::vector<Element>>& net, const std::string& name) {
  const int m = degree_of(net.size(), name, "rows");
  const int n = degree_of(net.front().size(), name + "[0]", "points in a row");
  for (std::size_t i = 1; i < net.size(); ++i)
    if (net[i].size() != net.front().size())
      throw PatchError(name + in_brackets(i), "must be " + std::to_string(n + 1) +
                                                  " elements as in the first row, has " +
                                                  std::to_string(net[i].size()));
  return {m, n};
}

void require_weights(const std::vector<std::vector<Rational>>& weights, int m, int n) {
  if (weights.size() != at(m) + 1)
    throw PatchError("weights", "must be " + std::to_string(m + 1) + " rows as the points, has " +
                                    std::to_string(weights.size()));
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i].size() != at(n) + 1)
      throw PatchError("weights" + in_brackets(i), "must be " + std::to_string(n + 1) +
                                                       " weights as the points in a row, has " +
                                                       std::to_string(weights[i].size()));
}

}  // namespace

RationalPatch::RationalPatch(int m, int n, Net net)
    : state_(std::make_shared<const State>(m, n, std::move(net))) {}

RationalPatch::RationalPatch(const std::vector<std::vector<Point>>& points,
                             const std::vector<std::vector<Rational>>& weights) {
  const auto [m, n] = bidegree_of(points, "points");
  if (!weights.empty()) require_weights(weights, m, n);
  Net net;
  const Point* first = nullptr;
  bool distinct = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points[i].size(); ++j) {
      const Rational w = weights.empty() ? Rational(1) : weights[i][j];
      const Point& p = points[i][j];
      net.push_back({w * p[0], w * p[1], w * p[2], w});
      if (w == 0) continue;
      if (first == nullptr) first = &p;
      distinct = distinct || p != *first;
    }
  }
  state_ = std::make_shared<const State>(m, n, std::move(net));
  if (!weights.empty()) require_positive(component(3), "weights");
  if (!distinct && (!weights.empty() || std::max(m, n) > 2))
    throw PatchError("points", "all control points coincide: the patch is a point");
}

RationalPatch::RationalPatch(const BezierPatch& patch) {
  Net net;
  for (const auto& row : patch.net())
    for (const Point& p : row) net.push_back({p[0], p[1], p[2], 1});
  state_ = std::make_shared<const State>(2, 2, std::move(net));
}

RationalPatch RationalPatch::from_homogeneous(const std::vector<std::vector<HomogeneousPoint>>& net) {
  const auto [m, n] = bidegree_of(net, "net");
  Net flat;
  for (const auto& row : net) flat.insert(flat.end(), row.begin(), row.end());
  RationalPatch patch(m, n, std::move(flat));
  require_positive(patch.component(3), "net");
  return patch;
}

const HomogeneousPoint& RationalPatch::homogeneous(int i, int j) const {
  return state_->net[at(i * (degree_v() + 1) + j)];
}

Point RationalPatch::point(int i, int j) const {
  const HomogeneousPoint& p = homogeneous(i, j);
  if (p[3] != 0) return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
  if (!has_no_coordinate(p)) throw std::domain_error("rational patch: the control point is at infinity");
  return {0, 0, 0};
}

BivariatePolynomial RationalPatch::component(int k) const {
  std::vector<Polynomial> in_u;  // for the power v^j
  std::vector<std::vector<Rational>> rows;
  for (int i = 0; i <= degree_u(); ++i) {
    std::vector<Rational> row;
    for (int j = 0; j <= degree_v(); ++j) row.push_back(homogeneous(i, j)[at(k)]);
    const Polynomial powers = from_bernstein(row);
    rows.emplace_back();
    for (int j = 0; j <= degree_v(); ++j) rows.back().push_back(powers.coefficient(j));
  }
  for (int j = 0; j <= degree_v(); ++j) {
    std::vector<Rational> column;
    for (const std::vector<Rational>& row : rows) column.push_back(row[at(j)]);
    in_u.push_back(from_bernstein(column));
  }
  return BivariatePolynomial(std::move(in_u)).exchanged();
}

HomogeneousPoint RationalPatch::homogeneous_at(const Rational& u, const Rational& v) const {
  Row column;
  for (int i = 0; i <= degree_u(); ++i) {
    const auto row = state_->net.begin() + i * (degree_v() + 1);
    column.push_back(value(Row(row, row + degree_v() + 1), v));
  }
  return value(column, u);
}

Point RationalPatch::operator()(const Rational& u, const Rational& v) const {
  const HomogeneousPoint p = homogeneous_at(u, v);
  if (p[3] == 0) throw std::domain_error("rational patch: the denominator vanishes");
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

bool RationalPatch::has_equal_weights() const {
  return std::all_of(state_->net.begin(), state_->net.end(),
                     [this](const HomogeneousPoint& p) { return p[3] == state_->net.front()[3]; });
}

bool RationalPatch::is_polynomial() const { return has_equal_weights() || reduced().has_equal_weights(); }

const RationalPatch& RationalPatch::reduced() const {
  std::call_once(state_->has_reduced, [this] {
    if (is_surely_reduced(state_->net, state_->m, state_->n)) return;
    std::array<BivariatePolynomial, 4> x;
    for (int k = 0; k < 4; ++k) x[at(k)] = component(k);
    BivariatePolynomial common = x[3];
    for (std::size_t k = 0; k < 3 && common.total_degree() > 0; ++k) common = gcd(common, x[k]);
    if (common.total_degree() == 0) common = BivariatePolynomial::constant(1);
    for (BivariatePolynomial& f : x) f = exact_quotient(f, common);
    // The denominator has one sign, so the common factor has; 1 is the weight of polynomial patches.
    const Rational scale = x[3].total_degree() == 0 ? 1 / x[3].coefficient(0, 0) : Rational(sign(x[3](0, 0)));
    int m = 1, n = 1;
    for (BivariatePolynomial& f : x) {
      f *= Polynomial(scale);
      m = std::max(m, f.degree_r());
      n = std::max(n, f.degree_s());
    }
    Net net(at((m + 1) * (n + 1)));
    for (std::size_t k = 0; k < 4; ++k) {
      const std::vector<std::vector<Rational>> b = tensor_bernstein(x[k], m, n);
      for (std::size_t i = 0; i < net.size(); ++i) net[i][k] = b[i / at(n + 1)][i % at(n + 1)];
    }
    if (m != state_->m || n != state_->n || net != state_->net)
      state_->reduced = std::shared_ptr<const RationalPatch>(new RationalPatch(m, n, std::move(net)));
  });
  return state_->reduced ? *state_->reduced : *this;
}

std::optional<BezierPatch> RationalPatch::biquadratic() const {
  const bool as_it_stands = std::max(degree_u(), degree_v()) <= 2 && has_equal_weights();
  const RationalPatch& patch = as_it_stands ? *this : reduced();
  if (std::max(patch.degree_u(), patch.degree_v()) > 2 || !patch.has_equal_weights()) return std::nullopt;
  std::vector<std::vector<Point>> points;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    points.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) points.back().push_back(patch.point(i, j));
  }
  return BezierPatch::elevated(points);
}

RationalPatch RationalPatch::transposed() const {
  Net net;
  for (int j = 0; j <= degree_v(); ++j)
    for (int i = 0; i <= degree_u(); ++i) net.push_back(homogeneous(i, j));
  return {degree_v(), degree_u(), std::move(net)};
}

RationalPatch RationalPatch::elevated(int m, int n) const {
  if (m < degree_u() || n < degree_v() || m > max_patch_degree || n > max_patch_degree)
    throw std::invalid_argument("rational patch: elevated to less than its degree, or to more than 3");
  if (m == degree_u() && n == degree_v()) return *this;
  if (m > degree_u()) return transposed().elevated(degree_v(), m).transposed().elevated(m, n);
  Net net;
  for (int i = 0; i <= m; ++i) {
    const auto begin = state_->net.begin() + i * (degree_v() + 1);
    Row row(begin, begin + degree_v() + 1);
    while (row.size() < at(n) + 1) row = elevated_once(row);
    net.insert(net.end(), row.begin(), row.end());
  }
  return {m, n, std::move(net)};
}

RationalPatch RationalPatch::restricted_to(const Rational& u0, const Rational& u1, const Rational& v0,
                                           const Rational& v1) const {
  for (const Rational* t : {&u0, &u1, &v0, &v1})
    if (*t < 0 || *t > 1) throw std::invalid_argument("rational patch: a piece outside of the unit square");
  return {degree_u(), degree_v(), net_of_piece(state_->net, degree_u(), degree_v(), {u0, u1}, {v0, v1})};
}

bool operator==(const RationalPatch& a, const RationalPatch& b) {
  return a.state_ == b.state_ ||
         (a.degree_u() == b.degree_u() && a.degree_v() == b.degree_v() && a.state_->net == b.state_->net);
}

std::string kind_of(const RationalPatch& patch) {
  const RationalPatch& reduced = patch.reduced();
  return "bidegree (" + std::to_string(reduced.degree_u()) + "," + std::to_string(reduced.degree_v()) + ")" +
         (reduced.is_polynomial() ? "" : " with weights");
}

}  // namespace exsect
