#include "shape/injective_rectangle.h"

#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <optional>

#include "answer/parameter_box.h"
#include "curve/half_space.h"

namespace exsect {
namespace {

using Vector = std::array<double, 3>;

constexpr int kMostTests = 120;

Vector approximate(const Point& p) { return {to_double(p[0]), to_double(p[1]), to_double(p[2])}; }

/// Bernstein coefficients of x_u (of x_v: rows and columns exchanged) up to a positive factor: i = 0, 1 and j
/// = 0, 1, 2.
using Derivative = std::array<std::array<Point, 3>, 2>;
Derivative derivative(const ControlNet& net) {
  Derivative d;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 3; ++j) d[i][j] = net[i + 1][j] - net[i][j];
  return d;
}

bool is_collapsed(const std::array<Point, 3>& side) { return side[0] == side[1] && side[1] == side[2]; }

/// Rectangles are in the plane of the exact parameters; `patch` is x over the rectangle.
struct Part {
  ParameterRectangle where;
  BezierPatch patch;
  std::array<Vector, 9> guess;

  Part(const BezierPatch& x, const ParameterRectangle& rectangle)
      : where(rectangle),
        patch(x.restricted_to(rectangle.u.lower, rectangle.u.upper, rectangle.v.lower, rectangle.v.upper)) {
    for (std::size_t i = 0; i < 9; ++i) guess[i] = approximate(patch.net()[i / 3][i % 3]);
  }
};

std::array<Point, 3> side_points(const ControlNet& net, std::size_t fixed, std::size_t value) {
  const std::size_t k = 2 * value;
  return fixed == 0 ? net[k] : std::array<Point, 3>{net[0][k], net[1][k], net[2][k]};
}

const RationalInterval& range(const ParameterRectangle& where, std::size_t j) {
  return j == 0 ? where.u : where.v;
}

/// The differences x_2 - x_1 along the straight segment between two points of the rectangle are du a + dv b,
/// a and b means of x_u and x_v. If n.(a_i x b_j) > 0 for all coefficients but those with a_i x b_j = 0, then
/// a and b are independent unless the segment lies on a side, which is asked separately.
class Certificate {
 public:
  explicit Certificate(const Part& part)
      : part_(part), a_(derivative(part.patch.net())), b_(derivative(part.patch.exchanged().net())) {}

  bool holds() const {
    std::vector<Vector> guesses;
    for (const Point& a : all(a_))
      for (const Point& b : all(b_)) guesses.push_back(cross_over(approximate(a), approximate(b)));
    const std::optional<Point> n = positive_direction(std::move(guesses));
    if (!n) return false;
    std::vector<Point> products;
    for (const Point& a : all(a_))
      for (const Point& b : all(b_)) products.push_back(cross(a, b));
    if (!all_positive(*n, products)) return false;
    for (const std::size_t fixed : {0, 1})
      for (const std::size_t value : {0, 1})
        if (!side_is_simple(*n, fixed, value)) return false;
    return true;
  }

 private:
  static std::vector<Point> all(const Derivative& d) {
    std::vector<Point> result(d[0].begin(), d[0].end());
    result.insert(result.end(), d[1].begin(), d[1].end());
    return result;
  }

  /// Along the side the difference is a mean of the tangents t_k times the length. It is not zero if for one
  /// coefficient c of the other derivative all n.(t_k x c) have one sign, apart from t_k = 0.
  bool side_is_simple(const Point& n, std::size_t fixed, std::size_t value) const {
    const std::array<Point, 3> side = side_points(part_.patch.net(), fixed, value);
    if (is_collapsed(side)) {
      const RationalInterval& ends = range(part_.where, fixed);
      return (value == 0 ? ends.lower : ends.upper) == static_cast<int>(value);
    }
    const std::array<Point, 2> tangent = {side[1] - side[0], side[2] - side[1]};
    return std::ranges::any_of(all(fixed == 0 ? a_ : b_), [&](const Point& c) {
      std::array<int, 2> signs{};
      for (std::size_t k = 0; k < 2; ++k) {
        signs[k] = sign(dot(n, cross(tangent[k], c)));
        if (signs[k] == 0 && !is_zero(tangent[k])) return false;
      }
      return signs[0] * signs[1] >= 0;
    });
  }

  const Part& part_;
  Derivative a_;
  Derivative b_;
};

bool meet(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

class InjectivityProof {
 public:
  explicit InjectivityProof(const BezierPatch& x) : x_(x) {}

  bool of(const ParameterRectangle& where) { return of(Part(x_, where)); }

 private:
  bool exhausted() { return ++tests_ > kMostTests; }

  bool of(const Part& part) {
    if (exhausted()) return false;
    if (Certificate(part).holds()) return true;
    const std::array<Part, 2> half = halves(part);
    return of_pair(half[0], half[1]) && of(half[0]) && of(half[1]);
  }

  /// No common point, apart from the collapsed sides.
  bool of_pair(const Part& a, const Part& b) {
    if (exhausted()) return false;
    const bool touching = meet(a.where.u, b.where.u) && meet(a.where.v, b.where.v);
    if (!touching && (are_separated(a, b) || are_separated_at_a_collapsed_side(a, b))) return true;
    if (touching && Certificate(Part(x_, {hull(a.where.u, b.where.u), hull(a.where.v, b.where.v)})).holds())
      return true;
    const std::array<Part, 2> first = halves(a);
    const std::array<Part, 2> second = halves(b);
    for (const Part& p : first)
      for (const Part& q : second)
        if (!of_pair(p, q)) return false;
    return true;
  }

  /// Across the direction in which the side of the square is longest; the parameters that vary most on the
  /// part.
  std::array<Part, 2> halves(const Part& part) const {
    ParameterRectangle lower = part.where;
    ParameterRectangle upper = part.where;
    if (part.where.u.width() >= part.where.v.width())
      lower.u.upper = upper.u.lower = part.where.u.midpoint();
    else
      lower.v.upper = upper.v.lower = part.where.v.midpoint();
    return {Part(x_, lower), Part(x_, upper)};
  }

  static bool are_separated(const Part& a, const Part& b) {
    std::vector<Vector> guesses;
    for (const Vector& p : a.guess)
      for (const Vector& q : b.guess) guesses.push_back({p[0] - q[0], p[1] - q[1], p[2] - q[2]});
    const std::optional<Point> n = positive_direction(std::move(guesses));
    if (!n) return false;
    const auto along = [&](const Part& part) {
      std::vector<Rational> values;
      for (const auto& row : part.patch.net())
        for (const Point& p : row) values.push_back(dot(*n, p));
      return values;
    };
    return std::ranges::min(along(a)) > std::ranges::max(along(b));
  }

  /// n.(x - Q) >= 0 on one part and <= 0 on the other one, 0 only on the side that is the point Q.
  static bool are_separated_at_a_collapsed_side(const Part& a, const Part& b) {
    for (const std::size_t fixed : {0, 1})
      for (const std::size_t value : {0, 1}) {
        const RationalInterval& ends = range(a.where, fixed);
        const Rational at = value == 0 ? ends.lower : ends.upper;
        if (at != static_cast<int>(value) ||
            at != (value == 0 ? range(b.where, fixed).lower : range(b.where, fixed).upper))
          continue;
        const std::array<Point, 3> side = side_points(a.patch.net(), fixed, value);
        if (!is_collapsed(side)) continue;
        std::vector<Point> vectors = off_side(a.patch.net(), fixed, value, side[0], 1);
        const std::vector<Point> other = off_side(b.patch.net(), fixed, value, side[0], -1);
        vectors.insert(vectors.end(), other.begin(), other.end());
        if (lie_in_half_space(vectors)) return true;
      }
    return false;
  }

  static std::vector<Point> off_side(const ControlNet& net, std::size_t fixed, std::size_t value,
                                     const Point& q, int factor) {
    std::vector<Point> result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if ((fixed == 0 ? i : j) != 2 * value) result.push_back(Rational(factor) * (net[i][j] - q));
    return result;
  }

  const BezierPatch& x_;
  int tests_ = 0;
};

RationalInterval from_end(int value, const Rational& width) {
  return value == 0 ? RationalInterval{0, width} : RationalInterval{1 - width, 1};
}

constexpr std::array<long, 6> kWidths = {0, -1, -3, -6, -10, -16};  // exponents of 2

}  // namespace

bool is_injective(const BezierPatch& x, const ParameterRectangle& where) {
  // The proof divides the longer range first: u of two that are equal.
  return InjectivityProof(x).of(where) || InjectivityProof(x.exchanged()).of({where.v, where.u});
}

bool is_collapsed_side(const BezierPatch& x, std::size_t fixed, int value) {
  return is_collapsed(side_points(x.net(), fixed, static_cast<std::size_t>(value)));
}

bool is_cuspidal_side(const BezierPatch& x, std::size_t fixed, int value) {
  // x_u x x_v has degree 3 along the side.
  for (int k = 0; k <= 3; ++k) {
    const Rational t(k, 3);
    const Rational u = fixed == 0 ? Rational(value) : t;
    const Rational v = fixed == 0 ? t : Rational(value);
    if (!is_zero(cross(x.derivative_first(u, v), x.derivative_second(u, v)))) return false;
  }
  return true;
}

bool InjectiveRectangles::along(std::size_t fixed, int value) const {
  return std::ranges::count(along_sides, std::array<int, 2>{static_cast<int>(fixed), value}) > 0;
}

InjectiveRectangles injective_rectangles(const BezierPatch& x) {
  InjectiveRectangles result;
  const auto add = [&](const auto& rectangle) {
    if (!is_injective(x, rectangle(power_of_two(kWidths.back())))) return false;  // nor on a larger one
    for (const long exponent : kWidths) {
      const ParameterRectangle where = rectangle(power_of_two(exponent));
      if (!is_injective(x, where)) continue;
      result.rectangles.push_back(where);
      return true;
    }
    return false;
  };
  for (const int fixed : {0, 1})
    for (const int value : {0, 1}) {
      const auto strip = [&](const Rational& width) {
        const RationalInterval across = from_end(value, width);
        return fixed == 0 ? ParameterRectangle{across, {0, 1}} : ParameterRectangle{{0, 1}, across};
      };
      if (is_cuspidal_side(x, static_cast<std::size_t>(fixed), value) && add(strip))
        result.along_sides.push_back({fixed, value});
    }
  for (const int u : {0, 1})
    for (const int v : {0, 1}) {
      if (result.along(0, u) || result.along(1, v) ||
          !is_zero(cross(x.derivative_first(u, v), x.derivative_second(u, v))))
        continue;
      add([&](const Rational& width) { return ParameterRectangle{from_end(u, width), from_end(v, width)}; });
    }
  return result;
}

}  // namespace exsect
