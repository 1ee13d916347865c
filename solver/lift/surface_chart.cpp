#include "lift/surface_chart.h"

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "curve/curve_values.h"
#include "curve/plane_curve.h"
#include "curve/short_rational.h"
#include "curve/turning_resultant.h"
#include "lift/root_interval.h"

namespace exsect {
namespace {

/// What is left of a vector orthogonally to another one, up to a positive factor.
Point orthogonal_part(const Point& of, const Point& to) { return dot(to, to) * of - dot(of, to) * to; }

/// The first of the vectors that has a part orthogonal to the axis.
Point orthogonal_direction(const Point& axis, const std::vector<Point>& vectors) {
  for (const Point& vector : vectors)
    if (const Point part = orthogonal_part(vector, axis); !is_zero(part)) return shortened(part);
  return shortened(cross(axis, least_parallel_axis(axis)));
}

bool is_bounded(SurfaceKind kind) { return kind == SurfaceKind::sphere || kind == SurfaceKind::torus; }

/// Above the greatest distance of a point of a bounded surface from its centre, over a length of this square.
Rational reach_of(const SurfaceData& data, const Rational& squared_unit) {
  return Rational(9, 8) *
         (root_above(data.squared / squared_unit) + root_above(data.minor_squared / squared_unit));
}

/// Coordinates h, x, y along three orthogonal vectors about the surface's point.
class Frame {
 public:
  Frame(const ImplicitSurface& surface, const ImplicitSurface& other) : kind_(surface.kind()) {
    const SurfaceData& data = *surface.data();
    const std::optional<SurfaceData>& beside = other.data();
    origin_ = data.point;
    squared_ = data.squared;
    const Point offset = beside ? beside->point - data.point : Point{0, 0, 0};
    const Point direction = beside ? beside->axis : Point{0, 0, 0};
    axis_ = data.axis;
    if (kind_ == SurfaceKind::plane) axis_ = orthogonal_direction(data.axis, {cross(data.axis, direction)});
    if (kind_ == SurfaceKind::sphere)
      axis_ = !is_zero(direction) ? direction : !is_zero(offset) ? offset : Point{0, 0, 1};
    axis_ = shortened(axis_);
    const bool is_plane = kind_ == SurfaceKind::plane;
    e1_ = is_plane ? shortened(cross(data.axis, axis_))
                   : orthogonal_direction(axis_, beside && other.kind() == SurfaceKind::plane
                                                     ? std::vector<Point>{direction}
                                                     : std::vector<Point>{direction, offset});
    e2_ = shortened(cross(axis_, e1_));
  }

  /// Of a plane: another frame in it, k times e1 added to the axis.
  Frame turned(int k) const {
    Frame result = *this;
    result.axis_ = shortened(axis_ + Rational(k) * e1_);
    result.e1_ = shortened(cross(e2_, result.axis_));
    return result;
  }

  /// For h and x in these intervals.
  SurfaceChart chart(const RationalInterval& h, const RationalInterval& x) const {
    const BivariatePolynomial at_h = along(BivariatePolynomial::r(), h);
    const BivariatePolynomial at_x = along(BivariatePolynomial::s(), x);
    const Rational hh = dot(axis_, axis_), xx = dot(e1_, e1_), yy = dot(e2_, e2_);
    BivariatePolynomial radicand;
    if (kind_ != SurfaceKind::plane) {
      radicand = BivariatePolynomial::constant(-xx / yy) * at_x * at_x;
      const Rational& rate = kind_ == SurfaceKind::sphere ? Rational(-1) : squared_;
      if (kind_ != SurfaceKind::cylinder)
        radicand += BivariatePolynomial::constant(rate * hh / yy) * at_h * at_h;
      if (kind_ != SurfaceKind::cone) radicand += BivariatePolynomial::constant(squared_ / yy);
    }
    return {origin_ + h.lower * axis_ + x.lower * e1_, h.width() * axis_, x.width() * e1_, e2_,
            std::move(radicand)};
  }

  /// Where x is, for h in the interval; wider than that.
  RationalInterval width(const RationalInterval& h) const {
    Rational most = squared_ / dot(e1_, e1_);
    if (kind_ == SurfaceKind::cone) {
      const Rational highest = std::max<Rational>(abs(h.lower), abs(h.upper));
      most *= highest * highest * dot(axis_, axis_);
    }
    const Rational reach = Rational(9, 8) * root_above(most);
    return {-reach, reach};
  }

  /// Where another bounded surface has its h, or its coordinate along e1.
  RationalInterval range_of(const SurfaceData& other, const Point& along) const {
    const Rational squared = dot(along, along);
    const Rational at = dot(other.point - origin_, along) / squared, reach = reach_of(other, squared);
    return {at - reach, at + reach};
  }

  Rational height(const Point& p) const { return dot(p - origin_, axis_) / dot(axis_, axis_); }
  /// A length by which the surface may be measured, as a difference of heights.
  Rational unit() const {
    return kind_ == SurfaceKind::cone ? Rational(1) : root_above(squared_ / dot(axis_, axis_));
  }
  const Point& axis() const { return axis_; }
  const Point& e1() const { return e1_; }

 private:
  static BivariatePolynomial along(const BivariatePolynomial& t, const RationalInterval& range) {
    return BivariatePolynomial::constant(range.lower) + BivariatePolynomial::constant(range.width()) * t;
  }

  SurfaceKind kind_;
  Point origin_;
  Rational squared_;
  Point axis_;
  Point e1_;
  Point e2_;
};

/// The heights h of everything that ends, turns or meets one of the curves `cuts` on the curve of the shadow,
/// as roots of these polynomials.
std::vector<Polynomial> critical_heights(const BivariatePolynomial& all,
                                         const std::vector<BivariatePolynomial>& cuts) {
  if (all.degree_r() < 1 && all.degree_s() < 1) return {};
  const ContentAndPart parts = split_content(squarefree(all).exchanged());
  const BivariatePolynomial& in_x = parts.primitive;
  std::vector<Polynomial> result = {parts.content};
  if (in_x.degree_r() < 1) return result;
  const BivariatePolynomial curve = in_x.exchanged();
  result.push_back(turning_resultant(curve));
  result.push_back(in_x.coefficient(in_x.degree_r()));
  for (const BivariatePolynomial& each : cuts) {
    if (each.is_zero()) continue;
    const BivariatePolynomial cut = without_factors_of(curve, each);
    result.push_back(cut.degree_s() > 0 ? resultant_s(curve, cut) : cut.at_s(0));
  }
  return result;
}

/// All heights at which an unbounded surface and another one have more than arcs that go on.
RationalInterval heights(const Frame& frame, const ImplicitSurface& surface, const ImplicitSurface& other,
                         const SurfaceRegion& region) {
  if (other.data() && is_bounded(other.kind())) return frame.range_of(*other.data(), frame.axis());
  const SurfaceChart whole = frame.chart({0, 1}, {0, 1});
  const SheetFunction f = on_chart(other.equation(), whole);
  std::vector<Rational> marked;
  for (const ImplicitSurface* cone : {&surface, &other})
    if (cone->kind() == SurfaceKind::cone) marked.push_back(frame.height(cone->data()->point));
  if (f.is_zero()) return interval_around({}, marked, frame.unit());
  return interval_around(critical_heights(whole_shadow(f, whole), cuts_of(region, whole)), marked,
                         frame.unit());
}

/// A plane, turned until x is bounded on the other surface over every bounded interval of h: the equation has
/// the term of x alone of greatest degree, as it has in all but finitely many directions.
SurfaceChart plane_chart(const ImplicitSurface& plane, const ImplicitSurface& other,
                         const SurfaceRegion& region) {
  const Frame first(plane, other);
  for (int k = 0;; ++k) {
    const Frame frame = first.turned(k);
    const SurfaceChart whole = frame.chart({0, 1}, {0, 1});
    const BivariatePolynomial f = on_chart(other.equation(), whole).a;
    if (f.is_zero()) return whole;
    if (f.coefficient(0, f.total_degree()) == 0) continue;
    const RationalInterval h = fitted_interval(critical_heights(f, cuts_of(region, whole)));
    // x is extreme there, or over the ends of h.
    std::vector<Polynomial> extrema = critical_heights(f.exchanged(), {});
    for (const Rational& end : {h.lower, h.upper}) extrema.push_back(f.at_r(end));
    return frame.chart(h, fitted_interval(extrema));
  }
}

}  // namespace

Point shortened(const Point& direction) {
  const Polynomial multiple = Polynomial({direction[0], direction[1], direction[2]}).primitive();
  return {multiple.coefficient(0), multiple.coefficient(1), multiple.coefficient(2)};
}

SheetFunction on_chart(const SpacePolynomial& f, const SurfaceChart& chart) {
  const auto product = [&](const SheetFunction& p, const SheetFunction& q) {
    SheetFunction result{p.a * q.a, p.a * q.b + p.b * q.a};
    if (!p.b.is_zero() && !q.b.is_zero()) result.a += p.b * q.b * chart.radicand;
    return result;
  };
  const auto number = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  const auto in_u = [](const Polynomial& g) {
    return BivariatePolynomial(std::vector<Polynomial>(1, g)).exchanged();
  };
  const BivariatePolynomial height = in_u(chart.height), width = in_u(chart.width),
                            below = in_u(chart.denominator);
  const SheetFunction one{number(1), {}};
  std::array<std::vector<SheetFunction>, 3> powers;
  for (std::size_t k = 0; k < 3; ++k) {
    const SheetFunction coordinate{
        number(chart.origin[k]) * below + number(chart.along_u[k]) * height +
            number(chart.along_v[k]) * width * (BivariatePolynomial::s() - number(chart.middle)),
        chart.is_flat() ? BivariatePolynomial() : number(chart.along_y[k]) * width};
    powers[k] = {one};
    for (int i = 0; i < f.degree_in(k); ++i) powers[k].push_back(product(powers[k].back(), coordinate));
  }
  SheetFunction sum;
  for (const auto& [exponents, coefficient] : f.terms()) {
    SheetFunction term = one;
    for (std::size_t k = 0; k < 3; ++k)
      term = product(term, powers[k][static_cast<std::size_t>(exponents[k])]);
    BivariatePolynomial factor = number(coefficient);
    for (int i = exponents[0] + exponents[1] + exponents[2]; i < f.degree(); ++i) factor = factor * below;
    sum.a += factor * term.a;
    sum.b += factor * term.b;
  }
  return sum;
}

Shadow shadow(const SheetFunction& f, const SurfaceChart& chart) {
  if (chart.is_flat()) return {f, BivariatePolynomial::constant(1), f.a};
  const BivariatePolynomial common = gcd(f.a, f.b);
  SheetFunction rest{exact_quotient(f.a, common), exact_quotient(f.b, common)};
  BivariatePolynomial norm = rest.a * rest.a - chart.radicand * rest.b * rest.b;
  return {std::move(rest), common, std::move(norm)};
}

BivariatePolynomial whole_shadow(const SheetFunction& f, const SurfaceChart& chart) {
  if (f.is_zero()) return {};
  const Shadow of = shadow(f, chart);
  return of.common * of.norm;
}

std::vector<BivariatePolynomial> cuts_of(const SurfaceRegion& region, const SurfaceChart& chart) {
  std::vector<BivariatePolynomial> cuts = {chart.radicand};
  for (const SurfaceBound& bound : region.bounds)
    if (!bound.name.empty()) cuts.push_back(whole_shadow(on_chart(bound.form, chart), chart));
  return cuts;
}

std::optional<SurfaceChart> chart_of(const ImplicitSurface& surface, const ImplicitSurface& other,
                                     const SurfaceRegion& region) {
  switch (surface.kind()) {
    case SurfaceKind::plane: {
      if (other.kind() == SurfaceKind::polynomial) return plane_chart(surface, other, region);
      if (other.kind() != SurfaceKind::torus) return std::nullopt;
      const Frame frame(surface, other);
      return frame.chart(frame.range_of(*other.data(), frame.axis()),
                         frame.range_of(*other.data(), frame.e1()));
    }
    case SurfaceKind::sphere: {
      const Frame frame(surface, other);
      const RationalInterval h = {-reach_of(*surface.data(), dot(frame.axis(), frame.axis())),
                                  reach_of(*surface.data(), dot(frame.axis(), frame.axis()))};
      return frame.chart(h, frame.width(h));
    }
    case SurfaceKind::cylinder:
    case SurfaceKind::cone: {
      const Frame frame(surface, other);
      const RationalInterval h = heights(frame, surface, other, region);
      return frame.chart(h, frame.width(h));
    }
    default:
      return std::nullopt;
  }
}

}  // namespace exsect
