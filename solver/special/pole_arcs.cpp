#include "special/pole_arcs.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/polynomial_vector.h"
#include "special/pole_directions.h"
#include "special/remaining_squares.h"

namespace exsect {
namespace {

constexpr int kFirstCells = 16;   // of the pole's side, and one of them beyond each end
constexpr int kFinestCells = 10;  // halvings of these
constexpr std::size_t kMostCells = 512;
const Rational kRoom(1, 8);  // of an arc's rectangle, by the width of its wider direction

RationalInterval cell(int i) { return {Rational(i, kFirstCells), Rational(i + 1, kFirstCells)}; }

bool has_root(const Polynomial& f, const RationalInterval& in) {
  return f.is_zero() || (f.degree() > 0 && !real_roots(f, in.lower, in.upper).empty());
}

/// The greatest one of f(a,t) that does not depend on a.
Polynomial factor_in_t(const BivariatePolynomial& f) {
  Polynomial common;
  for (int i = 0; i <= f.degree_r(); ++i) common = gcd(common, f.coefficient(i));
  return common;
}

/// A polynomial with its derivatives of order one and two.
struct Jet {
  explicit Jet(const BivariatePolynomial& f)
      : value(f),
        first{f.derivative_r(), f.derivative_s()},
        second{first[0].derivative_r(), first[0].derivative_s(), first[1].derivative_s()} {}
  BivariatePolynomial value;
  std::array<BivariatePolynomial, 2> first;   // by r, by s
  std::array<BivariatePolynomial, 3> second;  // by rr, rs, ss
};

/// The equations (14.101), f_i omega = w g_i / a: a row along the normal of y, and two rows that are dual to
/// its derivatives in the pole.
struct PoleEquations {
  PoleEquations(const RationalPatch& x, const RationalPatch& y, const PoleOnPatch& pole)
      : weight(x.component(3)), weight_of_y(y.component(3)) {
    direction = pole_directions(x, pole.point);
    const PolynomialVector z = coordinates_from(y, pole.point);
    z_r = derivative_r(z);
    z_s = derivative_s(z);
    at = {pole.at[0].midpoint(), pole.at[1].midpoint()};
    const Point e_r = value(z_r, at[0], at[1]), e_s = value(z_s, at[0], at[1]);
    const Point normal = cross(e_r, e_s);
    const Rational scale = 1 / dot(normal, normal);
    rows = {normal, scale * cross(e_s, normal), scale * cross(normal, e_r)};
    for (const Point& row : rows) {
      f.push_back(dot(row, direction));
      g.emplace_back(dot(row, z));
    }
    lies_in_plane = pole.is_rational() && g[0].value.is_zero();
    while (lies_in_plane && !f[0].is_zero() && f[0].coefficient(0).is_zero()) f[0] = divided_by_first(f[0]);
    is_flat = pole.is_rational() && f[0].coefficient(0).is_zero();
    if (!lies_in_plane || f[0].is_zero()) return;
    line = factor_in_t(f[0]);
    beside_line = exact_quotient(f[0], BivariatePolynomial({line}));
  }

  BivariatePolynomial weight, weight_of_y;
  std::array<Rational, 2> at;  // the place on y, but for its box's width
  PolynomialVector direction;  // D
  PolynomialVector z_r, z_s;
  std::array<Point, 3> rows;
  std::vector<BivariatePolynomial> f;
  std::vector<Jet> g;
  bool is_flat;  // f_0(0,t) = 0: the tangent plane of y holds all directions of x in the pole
  bool lies_in_plane;
  Polynomial line;  // in a plane, f_0 = line(t) beside_line(a,t)
  BivariatePolynomial beside_line;
};

/// Proof of (14.102) to (14.106) near the pole.
class PoleProof {
 public:
  PoleProof(const RationalPatch& x, const RationalPatch& y, const PoleOnPatch& pole, const Rational& reach,
            const std::vector<Parameter>& turning)
      : e_(x, y, pole),
        pole_(pole),
        reach_(reach),
        a_(DoubleBall::enclosing(RationalInterval{0, reach})),
        turning_(turning) {}

  std::optional<std::vector<PoleArc>> arcs() {
    if (!find_region() || !is_alone()) return std::nullopt;
    std::vector<PoleArc> result;
    const auto clusters = find_clusters();
    if (!clusters || (e_.is_flat && !clusters->empty())) return std::nullopt;
    for (const Cluster& cluster : *clusters) {
      if (cluster.before == 0 || cluster.behind == 0) return std::nullopt;
      const Ranges ranges = ranges_on(cluster.along);
      const int order = order_of_line(cluster, ranges);
      const Columns columns = columns_of(ranges, order > 0);
      if (determinant_over(columns.t, columns.k[0], columns.k[1]).certain_sign() == 0)  // (14.104)
        return std::nullopt;
      if (order == 0 && cluster.before == cluster.behind) continue;
      std::vector<Side> on;
      const int place = std::min(place_at_ends(cluster, columns, order > 0, on),
                                 place_at_sides(cluster, ranges, columns, on));
      if (place < 0) continue;
      if (place == 0 || !all_monotone(cluster, ranges, columns)) return std::nullopt;
      result.push_back(arc_over(cluster, ranges, on, order > 1 ? Contact::tangential : Contact::transversal));
    }
    return result;
  }

 private:
  /// Over 0 <= a <= reach and an interval of t.
  struct Ranges {
    EnclosedVector f;
    DoubleBall weight;
    DoubleBall inverse_weight;
    std::array<DoubleBall, 2> k;  // of all solutions
    Rectangle on;
  };
  /// A maximal interval of t, which may reach beyond [0,1], outside of which there are no solutions near; the
  /// signs of the first of (14.101) beside it, 0 where it is not known.
  struct Cluster {
    RationalInterval along;
    int before;
    int behind;
  };
  /// Derivatives of (14.101) by t, k and a.
  struct Columns {
    EnclosedVector t;
    std::array<EnclosedVector, 2> k;
    EnclosedVector a;
  };

  Rectangle near(const RationalInterval& along) const { return {{0, reach_}, along}; }

  /// (14.103): sets the rectangle of y, what is known of y over it, and bounds of |k|.
  bool find_region() {
    std::array<double, 2> most = {0, 0};
    for (int i = -1; i <= kFirstCells; ++i) {
      const Rectangle on = near(cell(i));
      const DoubleBall inverse = inverse_range(e_.weight, on);
      if (!std::isfinite(inverse.radius())) {
        if (i == -1) begin_ = 0;
        if (i == kFirstCells) end_ = kFirstCells;
        if (i == -1 || i == kFirstCells) continue;
      }
      for (std::size_t j = 0; j < 3; ++j) {
        const double size = (range_on(e_.f[j], on) * inverse).upper_magnitude();
        if (j > 0) most[j - 1] = larger_bound(most[j - 1], size);
        box_[j] = larger_bound(box_[j], size);
      }
    }
    const double scale = to_double(e_.weight_of_y(e_.at[0], e_.at[1]));
    std::array<Rational, 2> room;
    for (std::size_t j = 0; j < 2; ++j) {
      const double rate = 2 * scale * (most[j] + 0.25 * (most[0] + most[1]));
      if (!std::isfinite(rate) || rate == 0) return false;
      room[j] = reach_ * from_double(rate);
      if (!(e_.at[j] - room[j] > 0 || e_.at[j] == 0) || !(e_.at[j] + room[j] < 1 || e_.at[j] == 1))
        return false;
    }
    region_ = {{e_.at[0] - room[0], e_.at[0] + room[0]}, {e_.at[1] - room[1], e_.at[1] + room[1]}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 2; ++j) first_[i][j] = range_on(e_.g[i].first[j], region_);
      for (std::size_t j = 0; j < 3; ++j) second_[i][j] = range_on(e_.g[i].second[j], region_);
    }
    const Jet omega(e_.weight_of_y);
    omega_ = range_on(omega.value, region_);
    if (omega_.certain_sign() <= 0) return false;
    omega_first_ = {range_on(omega.first[0], region_), range_on(omega.first[1], region_)};
    double off = 0;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        off = larger_bound(off, (first_[i + 1][j] - DoubleBall(i == j ? 1 : 0)).upper_magnitude());
    if (!(off < 0.125)) return false;
    const double all = (most[0] + most[1]) * omega_.upper_magnitude();
    off_ = kSlack * off * all / (1 - 2 * off);
    for (std::size_t j = 0; j < 2; ++j) {
      const double k = kSlack * (most[j] * omega_.upper_magnitude() + off_);
      if (!(reach_ * from_double(k) + pole_.at[j].width() < room[j])) return false;
    }
    return true;
  }

  /// (14.102): no point of y outside of the rectangle is near enough to the pole.
  bool is_alone() const {
    std::vector<BivariatePolynomial> tests;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational most = reach_ * from_double(kSlack * box_[i]);
      for (const int sign : {1, -1})
        tests.push_back(e_.g[i].value * Polynomial(sign) + e_.weight_of_y * Polynomial(-most));
    }
    return remaining_squares(tests,
                             [&](const Rectangle& square) {
                               return region_.r.lower <= square.r.lower &&
                                      square.r.upper <= region_.r.upper &&
                                      region_.s.lower <= square.s.lower && square.s.upper <= region_.s.upper;
                             })
        .has_value();
  }

  Ranges ranges_on(const RationalInterval& along) const {
    Ranges result;
    result.on = near(along);
    result.weight = range_on(e_.weight, result.on);
    result.inverse_weight = inverse_range(e_.weight, result.on);
    for (std::size_t i = 0; i < 3; ++i) result.f[i] = range_on(e_.f[i], result.on);
    for (std::size_t j = 0; j < 2; ++j)
      result.k[j] = (result.f[j + 1] * result.inverse_weight * omega_).widened(off_);
    return result;
  }

  /// What the second derivatives of g_i make of k: k' g'' k / 2.
  DoubleBall quadratic(std::size_t i, const std::array<DoubleBall, 2>& k) const {
    return DoubleBall(0.5) * (second_[i][0] * k[0] * k[0] + second_[i][2] * k[1] * k[1]) +
           second_[i][1] * k[0] * k[1];
  }
  DoubleBall linear(std::size_t i, const std::array<DoubleBall, 2>& k) const {
    return first_[i][0] * k[0] + first_[i][1] * k[1];
  }

  /// Of the first of (14.101), or (14.105) where that is flat.
  int sign_on(const Ranges& ranges) const {
    const DoubleBall along_normal = e_.is_flat ? range_on(divided_by_first(e_.f[0]), ranges.on) * omega_ -
                                                     ranges.weight * quadratic(0, ranges.k)
                                               : ranges.f[0] * omega_ - ranges.weight * linear(0, ranges.k);
    return along_normal.certain_sign();
  }

  /// Those that hold a t of [0,1]; empty if there are too many cells.
  std::optional<std::vector<Cluster>> find_clusters() const {
    std::vector<std::pair<RationalInterval, int>> cells;  // with signs
    for (int i = begin_; i < end_; ++i)
      if (!divide(cell(i), 0, cells)) return std::nullopt;
    std::vector<Cluster> result;
    int last = 0;
    bool is_open = false;
    for (const auto& [along, sign] : cells) {
      if (sign != 0 && is_open)
        result.back().behind = sign;
      else if (sign != 0 && last * sign < 0)
        return std::nullopt;
      else if (sign == 0 && !is_open)
        result.push_back({along, last, 0});
      else if (sign == 0)
        result.back().along.upper = along.upper;
      is_open = sign == 0;
      last = sign;
    }
    std::erase_if(result, [](const Cluster& c) { return c.along.upper <= 0 || c.along.lower >= 1; });
    return result;
  }

  /// False if there are too many cells.
  bool divide(const RationalInterval& along, int level,
              std::vector<std::pair<RationalInterval, int>>& cells) const {
    const int sign = sign_on(ranges_on(along));
    if (sign != 0 || level == kFinestCells) {
      cells.emplace_back(along, sign);
      return cells.size() < kMostCells;
    }
    return divide({along.lower, along.midpoint()}, level + 1, cells) &&
           divide({along.midpoint(), along.upper}, level + 1, cells);
  }

  /// How often f_0 vanishes on a line of t in the plane of y, if nothing else of its zeros is over the
  /// cluster (14.113); 0 if that is not known.
  int order_of_line(const Cluster& cluster, const Ranges& ranges) const {
    if (!e_.lies_in_plane || e_.line.degree() <= 0) return 0;
    if (range_on(e_.beside_line, ranges.on).certain_sign() == 0) return 0;
    if (real_roots(e_.line, cluster.along.lower, cluster.along.upper).size() != 1) return 0;
    int order = 1;
    for (Polynomial next = e_.line.derivative();
         has_root(gcd(e_.line, next), cluster.along) && !next.is_zero(); next = next.derivative())
      ++order;
    return order;
  }

  /// With the equation of a line of t for the first one if `on_line` (14.113).
  Columns columns_of(const Ranges& ranges, bool on_line) const {
    const DoubleBall weight_t = range_on(e_.weight.derivative_s(), ranges.on);
    const DoubleBall weight_a = range_on(e_.weight.derivative_r(), ranges.on);
    Columns result;
    for (std::size_t i = 0; i < 3; ++i) {
      const DoubleBall g = linear(i, ranges.k);
      result.t[i] = range_on(e_.f[i].derivative_s(), ranges.on) * omega_ - weight_t * g;
      for (std::size_t j = 0; j < 2; ++j)
        result.k[j][i] = ranges.f[i] * a_ * omega_first_[j] - ranges.weight * first_[i][j];
      result.a[i] = range_on(e_.f[i].derivative_r(), ranges.on) * omega_ +
                    ranges.f[i] * (omega_first_[0] * ranges.k[0] + omega_first_[1] * ranges.k[1]) -
                    weight_a * g - ranges.weight * quadratic(i, ranges.k);
    }
    if (!on_line) return result;
    result.t[0] = 1;
    result.k[0][0] = result.k[1][0] = result.a[0] = 0;
    return result;
  }

  bool is_asked_for(std::size_t j) const { return std::ranges::count(turning_, all_parameters[j]) > 0; }

  /// The derivative of t along the arc times the determinant (14.104).
  DoubleBall rate_of_t(const Columns& columns) const {
    return -determinant_over(columns.a, columns.k[0], columns.k[1]);
  }
  /// The derivative of k_j along the arc times the determinant (14.104).
  DoubleBall rate(std::size_t j, const Columns& columns) const {
    return j == 0 ? -determinant_over(columns.t, columns.a, columns.k[1])
                  : -determinant_over(columns.t, columns.k[0], columns.a);
  }

  /// (14.106).
  bool all_monotone(const Cluster& cluster, const Ranges& ranges, const Columns& columns) const {
    const DoubleBall whole = determinant_over(columns.t, columns.k[0], columns.k[1]);
    if (is_asked_for(1) && rate_of_t(columns).certain_sign() == 0 && !is_straight(cluster)) return false;
    for (std::size_t j = 0; j < 2; ++j) {
      if (!is_asked_for(2 + j)) continue;
      const DoubleBall k = rate(j, columns);
      const bool moves = (ranges.k[j] * whole + a_ * k).certain_sign() != 0;
      if (!moves && !(k.certain_sign() != 0 && begins_still(cluster, j)) && !stays(cluster, j)) return false;
    }
    return true;
  }

  /// 1: all of the arc has t in (0,1) but for the pole, or is on an end of the side, which is added; -1: t is
  /// outside of [0,1]; 0: not known (14.114).
  int place_at_ends(const Cluster& cluster, const Columns& columns, bool on_line,
                    std::vector<Side>& on) const {
    const bool at_zero = cluster.along.lower<0, at_one = cluster.along.upper> 1;
    if (!at_zero && !at_one) return 1;
    const int end = at_one ? 1 : 0;
    if ((at_zero && at_one) || !begins_at(end)) return 0;
    if (on_line) {
      if (e_.line.sign_at(end) != 0) return 0;
      on.push_back({Parameter::v, end});
      return 1;
    }
    const DoubleBall whole = determinant_over(columns.t, columns.k[0], columns.k[1]);
    const int sign = rate_of_t(columns).certain_sign() * whole.certain_sign();
    return at_zero ? sign : -sign;
  }

  /// The zero of the first of (14.101) for a = 0 near this t is t itself (14.114).
  bool begins_at(int t) const {
    if (pole_.is_rational()) return e_.f[0].coefficient(0).sign_at(t) == 0;
    Point direction;
    for (std::size_t c = 0; c < 3; ++c) direction[c] = e_.direction[c].coefficient(0)(t);
    const BivariatePolynomial normal = dot(direction, cross(e_.z_r, e_.z_s));
    return sign_at(normal, *pole_.exact) == 0;
  }

  /// 1: all of the arc is inside of the square of y but for the pole, which may be on sides of it, or is on
  /// such a side, which is added; -1: it is outside of the square; 0: not known (14.107).
  int place_at_sides(const Cluster& cluster, const Ranges& ranges, const Columns& columns,
                     std::vector<Side>& on) const {
    int result = 1;
    for (std::size_t j = 0; j < 2; ++j) {
      if (e_.at[j] != 0 && e_.at[j] != 1) continue;
      int sign = ranges.k[j].certain_sign();
      if (sign == 0 && begins_still(cluster, j)) {
        const DoubleBall whole = determinant_over(columns.t, columns.k[0], columns.k[1]);
        sign = rate(j, columns).certain_sign() * whole.certain_sign();
      }
      if (sign == 0 && stays(cluster, j)) {
        on.push_back({all_parameters[2 + j], e_.at[j] == 0 ? 0 : 1});
        continue;
      }
      const int inwards = e_.at[j] == 0 ? sign : -sign;
      if (inwards < 0) return -1;
      result = std::min(result, inwards);
    }
    return result;
  }

  /// t is constant: y lies in a plane, which x meets in a line t = constant.
  bool is_straight(const Cluster& cluster) const {
    return e_.lies_in_plane && has_root(e_.line, cluster.along);
  }

  /// k_j = 0 for all a: that line is one of y on which r, or s, is constant.
  bool stays(const Cluster& cluster, std::size_t j) const {
    const Polynomial common = gcd(e_.line, factor_in_t(e_.f[j + 1]));
    return e_.lies_in_plane && has_root(common, cluster.along) && is_zero_on_line(e_.g[j + 1].value, j);
  }

  /// g vanishes for r, or s, as in the pole.
  bool is_zero_on_line(const BivariatePolynomial& g, std::size_t j) const {
    Polynomial on_line;
    for (int i = g.degree_r(); i >= 0; --i) {
      if (j == 1 && g.coefficient(i)(e_.at[1]) != 0) return false;
      on_line = on_line * Polynomial(e_.at[0]) + g.coefficient(i);
    }
    return j == 1 || on_line.is_zero();
  }

  /// k_j = 0 for a = 0, exactly (14.106).
  bool begins_still(const Cluster& cluster, std::size_t j) const {
    if (pole_.is_rational())
      return has_root(gcd(e_.f[0].coefficient(0), e_.f[j + 1].coefficient(0)), cluster.along);
    const Point normal = common_normal(directions_in_pole(e_.direction));
    if (is_zero(normal)) return false;
    const PolynomialVector& along = j == 0 ? e_.z_s : e_.z_r;
    return sign_at(dot(normal, along), *pole_.exact) == 0;
  }

  PoleArc arc_over(const Cluster& cluster, const Ranges& ranges, std::vector<Side> on,
                   Contact contact) const {
    PoleArc result{cluster.along, {}, std::move(on), contact, {}, 0};
    for (std::size_t j = 0; j < 2; ++j) {
      const RationalInterval k = (a_ * ranges.k[j]).interval();
      result.on_other[j] = {pole_.at[j].lower + k.lower, pole_.at[j].upper + k.upper};
    }
    add_room(result, {region_.r, region_.s});
    set_chord(result, e_.direction, e_.weight, ranges.on);
    return result;
  }

  const PoleEquations e_;
  const PoleOnPatch& pole_;
  const Rational reach_;
  const DoubleBall a_;
  const std::vector<Parameter>& turning_;
  std::array<double, 3> box_ = {0, 0, 0};  // bounds of |f_i|/w
  Rectangle region_;
  std::array<std::array<DoubleBall, 2>, 3> first_;  // derivatives of g over the rectangle
  std::array<std::array<DoubleBall, 3>, 3> second_;
  DoubleBall omega_;
  std::array<DoubleBall, 2> omega_first_;
  int begin_ = -1, end_ = kFirstCells + 1;  // of the cells in which the weight is positive
  double off_ = 0;                          // |k_j - f_j omega / w| is not above it
};

}  // namespace

void add_room(PoleArc& arc, const std::array<RationalInterval, 2>& within) {
  const Rational room = kRoom * std::max(arc.on_other[0].width(), arc.on_other[1].width());
  for (std::size_t j = 0; j < 2; ++j) {
    RationalInterval& at = arc.on_other[j];
    at = {std::max<Rational>(within[j].lower, at.lower - room),
          std::min<Rational>(within[j].upper, at.upper + room)};
  }
}

void set_chord(PoleArc& arc, const PolynomialVector& direction, const BivariatePolynomial& weight,
               const Rectangle& on) {
  const DoubleBall inverse = inverse_range(weight, on);
  const double reach = to_double(on.r.upper);
  double squares = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const DoubleBall d = range_on(direction[c], on) * inverse;
    arc.step[c] = reach * d.approximation();
    squares += d.radius() * d.radius();
  }
  arc.bend = kSlack * reach * std::sqrt(squares);
}

std::optional<std::vector<PoleArc>> arcs_at_pole(const RationalPatch& x, const RationalPatch& y,
                                                 const PoleOnPatch& pole, const Rational& reach,
                                                 const std::vector<Parameter>& turning) {
  return PoleProof(x, y, pole, reach, turning).arcs();
}

}  // namespace exsect
