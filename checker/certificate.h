// A certificate as it is written (docs/certificate.md): what is claimed, nothing of it checked but its form.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "algebraic.h"
#include "curve_bounds.h"
#include "require.h"

namespace exsect::checker {

/// Not a certificate at all: no JSON, or another form.
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A claim that does not hold, or is not written as it has to be.
class Rejected : public std::runtime_error {
 public:
  using Kind = Violation;

  Rejected(std::string place, const std::string& reason, Kind kind, std::optional<double> needed = {})
      : std::runtime_error(reason), place_(std::move(place)), kind_(kind), needed_(needed) {}
  /// JSON path such as $.tubes[3].
  const std::string& place() const { return place_; }
  Kind kind() const { return kind_; }
  /// Of Kind::error_bound: at least the distance that is proved; nothing if none is.
  const std::optional<double>& needed() const { return needed_; }

 private:
  std::string place_;
  Kind kind_;
  std::optional<double> needed_;
};

struct Side {
  Parameter parameter;
  int value;  // 0 or 1
};

/// Of a line: only solutions with this value of this parameter are meant.
struct Fixed {
  Parameter parameter;
  Rational value;
};

/// A polynomial in x, y and z: the coefficients of its monomials.
using SurfaceEquation = std::map<std::array<int, 3>, Rational>;

/// F = sum_j columns_j g_j^powers_j for the components g_j of the map: where the columns are independent, F
/// vanishes with the map alone. With an empty third column, where the first two are independent, with g_1 and
/// g_2.
struct Factor {
  Map<Rational> map;
  std::array<std::size_t, 3> powers;
  std::array<Map<Rational>, 3> columns;

  bool is_surface() const { return columns[2].terms().empty(); }
};

using Matrix4 = std::array<Vector4<Algebraic>, 4>;

/// An inner node of the subdivision of a box or a leaf of it.
struct Cell {
  enum class Kind { split, excluded, tube, star, sheet, mirrored, lower, injective };
  Kind kind;
  std::size_t index;             // the parameter that is halved; the tube; the star; the overlap
  std::array<int, 3> direction;  // excluded, injective
  std::size_t row;               // of the list in which it stands
};

/// The solution `at` and all solutions near it, w = at + sum_j axes_ij e_j, |e_j| <= 1: they are on half
/// branches e_j = d_j t^weights_j, each the curve of a tube in one of the eight charts d_k = 1 and d_k = -1,
/// where `rows` F is divisible by t^orders.
struct Star {
  std::shared_ptr<const Root> root;  // of its numbers
  Vector4<Algebraic> at;
  Matrix4 axes;
  Matrix4 coordinates;  // their inverse
  std::array<std::size_t, 4> weights;
  Matrix3<Algebraic> rows;
  std::array<int, 3> orders;
  std::array<std::vector<Cell>, 8> charts;  // u+, u-, v+, ...: subdivisions

  bool is_rational() const { return root->degree() == 1; }
};

/// A point on the curve of a tube, within `radius` of `at` in each parameter; neither on sides nor turning: a
/// cuspidal point of a patch.
template <class N>
struct Node {
  std::size_t tube;
  Vector4<N> at;
  N radius;
  std::vector<Side> on;
  std::vector<Parameter> wrt;
  Vector4<Rational> place;  // `at`, exactly; not of a star
  int star = -1;            // the point of this star, in no tube of its own
};

/// A place on the curve, with the polyline's vertex in space if it has one here.
template <class N>
struct ArcPoint {
  Vector4<N> at;
  std::optional<Vector3<N>> vertex;
};

/// The part of an arc in a tube, up to the point `last`.
struct Piece {
  std::size_t tube;
  std::size_t last;
};

template <class N>
struct Arc {
  std::size_t component;
  std::size_t from;
  std::size_t to;
  std::vector<ArcPoint<N>> points;
  std::vector<Piece> pieces;
  N error_bound;
  std::array<Vector4<Rational>, 2> ends;  // the first and the last place, exactly
};

/// All points of a plane of solutions in [0,1]^4: a convex polygon. Its edges are straight in the parameters;
/// of them as arcs only the points and the error bound are meant.
template <class N>
struct Overlap {
  std::size_t factor;         // of which g_1 and g_2 vanish on the plane
  std::vector<Arc<N>> edges;  // from each corner to the next one
};

struct Component {
  std::string shape;  // open, closed or branched
  std::vector<std::size_t> arcs;
};

struct Summary {
  // Factors, stars, tubes, nodes, arcs, entries of the cover, overlaps.
  std::array<std::size_t, 7> claims;
  std::size_t components = 0;
  std::size_t closed = 0;
  std::size_t open = 0;
  std::size_t branched = 0;
  std::size_t isolated = 0;
  std::size_t boundary = 0;
  std::size_t tangential = 0;
  std::array<std::size_t, 4> turning = {};

  bool operator==(const Summary&) const = default;
};

/// N: Rational, or Enclosure, to check in doubles.
template <class N>
struct Certificate {
  std::array<WeightedNet<Rational>, 2> nets;  // of control points; twice the same if `self`
  std::optional<SurfaceEquation> equation;    // of a surface in the place of the second patch
  bool self;
  std::optional<Fixed> fixed;  // of a line: then the points are the nodes, and there are no arcs
  std::vector<Factor> factors;
  std::vector<Star> stars;
  std::vector<Tube<N>> tubes;
  std::vector<Node<N>> nodes;  // those of the stars last
  std::vector<Arc<N>> arcs;
  std::vector<Component> components;
  std::vector<Overlap<N>> overlaps;
  std::vector<Cell> cover;
  Summary summary;
};

/// An error bound that is too small for an arc, or an edge of an overlap.
struct Shortfall {
  std::optional<std::size_t> overlap;
  std::size_t arc;  // its number; of an overlap that of the edge
  double needed;    // at least the distance that is proved
};

/// The seal of a claim: FNV-1a, 64 bits, 16 hexadecimal digits.
std::string seal(std::string_view text);

/// Sizes beyond which a certificate is rejected: characters of a number, the degree of a star's number,
/// the sum of a monomial's exponents in a factor and in an equation, entries of all subdivisions together.
inline constexpr std::size_t max_number_characters = 6100;
inline constexpr std::size_t max_modulus_degree = 64;
inline constexpr int max_factor_degree = 12;
inline constexpr std::size_t max_factor_power = 6;
inline constexpr int max_equation_degree = 4;
inline constexpr std::size_t max_entries = std::size_t{1} << 20;

/// The number p/q in lowest terms, p/2^n with p odd and 1 <= n <= 2000, or p, that the text of at most
/// max_number_characters is; throws std::invalid_argument for any other text, and for p/3/2^n.
Rational number_of(std::string_view text);

/// Throws Unreadable, or Rejected with the place where the form is violated or a seal is broken.
template <class N>
Certificate<N> read_certificate(const std::string& text);

}  // namespace exsect::checker
