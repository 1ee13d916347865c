#include "filter/corner_branches.h"

#include <exsect/algebra/descartes.h>

#include <algorithm>
#include <stdexcept>

namespace exsect::filter {

namespace {

constexpr std::array<int, 3> kOrders = {4, 7, 10};
constexpr std::array<int, 5> kReaches = {3, 5, 7, 9, 12};  // powers of 1/2
/// Relative half widths of charts, powers of 1/2.
constexpr std::array<int, 4> kWidths = {3, 5, 7, 10};
constexpr int kMostExponent = 60;

/// 2^exponent p^(numerator/denominator).
struct Curve {
  long exponent;
  long numerator;
  long denominator;
};

/// The p, q in (0, 2^-k]^2 with q below one curve and above another one, if these are there.
struct Sector {
  long k;
  std::optional<Curve> above;
  std::optional<Curve> below;

  /// >= p^(n/d), n >= 0.
  Rational power_of_p(long n, long d) const {
    long exponent = floor_of(k * n, d);
    if (below && k + below->exponent > 0)
      exponent =
          std::max(exponent, floor_of((k + below->exponent) * n * below->denominator, d * below->numerator));
    return power_of_two(-exponent);
  }
  /// >= p^x q^y; empty if there is no bound.
  std::optional<Rational> bound(long x, long y) const {
    std::optional<Rational> best;
    const auto along = [&](const Curve& curve) {
      const long n = x * curve.denominator + curve.numerator * y;
      if (n < 0) return;
      const Rational found = power_of_two(curve.exponent * y) * power_of_p(n, curve.denominator);
      if (!best || found < *best) best = found;
    };
    if (y >= 0 && x >= 0) best = power_of_two(-k * y) * power_of_p(x, 1);
    if (y >= 0 && above) along(*above);
    if (y < 0 && below) along(*below);
    return best;
  }
};

/// Calls use(i, j, |c_ij|) for all terms but one, and for those of which the rest is a sum.
template <class Use>
bool for_all_terms(const PlaneSeries& g, const Use& use) {
  for (int i = 0; i <= g.order(); ++i)
    for (int j = 0; i + j <= g.order(); ++j)
      if (const Rational& c = g.coefficient(i, j); c != 0 && !use(i, j, abs(c))) return false;
  return g.rest() == 0 || (use(g.order() + 1, 0, g.rest()) && use(0, g.order() + 1, g.rest()));
}

/// (14.123): the term of the vertex is greater than all others.
bool vertex_dominates(const PlaneSeries& g, const std::array<int, 2>& vertex, const Sector& sector) {
  Rational others = 0;
  const bool is_bounded = for_all_terms(g, [&](int i, int j, const Rational& size) {
    if (i == vertex[0] && j == vertex[1]) return true;
    const auto bound = sector.bound(i - vertex[0], j - vertex[1]);
    if (bound) others += size * *bound;
    return bound.has_value();
  });
  return is_bounded && abs(g.coefficient(vertex[0], vertex[1])) > others;
}

/// Powers of two between which all positive zeros are, and beyond which a term at the end of the edge is four
/// times as large as all others.
std::optional<std::array<long, 2>> outer_exponents(const Polynomial& in_c, int lowest, int highest) {
  const auto dominates = [&](int end, long exponent) {
    Rational others = 0;
    for (int j = lowest; j <= highest; ++j)
      if (j != end) others += abs(in_c.coefficient(j)) * power_of_two(exponent * (j - end));
    return abs(in_c.coefficient(end)) > 4 * others;
  };
  long lower = 0, upper = 0;
  while (lower > -kMostExponent && !dominates(lowest, lower)) --lower;
  while (upper < kMostExponent && !dominates(highest, upper)) ++upper;
  if (lower == -kMostExponent || upper == kMostExponent) return std::nullopt;
  return std::array{lower, upper};
}

/// Positive zeros, far narrower than their distances; empty if some are double.
std::optional<std::vector<RationalInterval>> zeros(const PolygonEdge& edge,
                                                   const std::array<long, 2>& exponents) {
  const std::vector<Rational> all = edge.in_c.coefficients();
  const Polynomial f(std::vector<Rational>(all.begin() + edge.lowest[1], all.end()));
  try {
    auto found = isolate_roots(f, power_of_two(exponents[0]), power_of_two(exponents[1]));
    for (RationalInterval& root : found)
      while (root.width() * 4096 > root.lower) {
        const Rational middle = root.midpoint();
        const int at = f.sign_at(middle);
        if (at == 0)
          root = {middle, middle};
        else
          (at == f.sign_at(root.lower) ? root.lower : root.upper) = middle;
      }
    return found;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// There is no polygon.
bool is_left_open(const PlaneSeries& g) { return g.coefficient(0, 0) == 0 && newton_polygon(g).empty(); }

/// All about one equation and the box [0, 2^-k]^4.
class Search {
 public:
  Search(const CornerEquation& equation, long k) : equation_(equation), g_(equation.normal), k_(k) {}

  std::optional<std::vector<CornerBranch>> run() {
    if (is_left_open(g_)) return std::nullopt;
    if (g_.coefficient(0, 0) != 0) return alone();
    const std::vector<PolygonEdge> edges = newton_polygon(g_);
    std::optional<Curve> above;
    for (const PolygonEdge& edge : edges) {
      const auto ends = outer_exponents(edge.in_c, edge.lowest[1], edge.highest[1]);
      if (!ends) return std::nullopt;
      const Curve upper{(*ends)[1], edge.q_weight, edge.p_weight};
      if (!vertex_dominates(g_, edge.highest, {k_, above, upper}) || !add_edge(edge, *ends))
        return std::nullopt;
      above = Curve{(*ends)[0], edge.q_weight, edge.p_weight};
    }
    if (!vertex_dominates(g_, edges.back().lowest, {k_, above, std::nullopt})) return std::nullopt;
    return std::move(branches_);
  }

 private:
  /// Nothing but the sides by which the equation is divided.
  std::optional<std::vector<CornerBranch>> alone() const {
    return vertex_dominates(g_, {0, 0}, {k_, {}, {}}) ? std::optional(branches_) : std::nullopt;
  }

  bool add_edge(const PolygonEdge& edge, const std::array<long, 2>& ends) {
    const auto roots = zeros(edge, ends);
    if (!roots) return false;
    Rational from = power_of_two(ends[0]);
    for (const RationalInterval& root : *roots) {
      const auto chart = chart_around(edge, root);
      if (!chart || !(chart->lower > from) || !is_empty(g_, {edge, {from, chart->lower}, k_})) return false;
      from = chart->upper;
    }
    const Rational to = power_of_two(ends[1]);
    return to > from && is_empty(g_, {edge, {from, to}, k_});
  }

  /// The interval of a branch, which is added if it is in the domain.
  std::optional<RationalInterval> chart_around(const PolygonEdge& edge, const RationalInterval& root) {
    for (const int width : kWidths) {
      const Rational half = root.upper * power_of_two(-width);
      const CornerChart chart{edge, {root.lower - half, root.upper + half}, k_};
      if (!is_one_branch(g_, chart)) continue;
      const int first = sign_in(equation_.bound[0], chart), second = sign_in(equation_.bound[1], chart);
      if (first > 0 && second > 0) branches_.push_back({edge, chart.c});
      if ((first > 0 && second > 0) || first < 0 || second < 0) return chart.c;
    }
    return std::nullopt;
  }

  const CornerEquation& equation_;
  const PlaneSeries& g_;
  const long k_;
  std::vector<CornerBranch> branches_;
};

}  // namespace

std::optional<CornerBranches> corner_branches(const CornerNet& x, const CornerNet& y,
                                              const std::vector<SideAtCorner>& sides) {
  const CornerSystem system(x, y);
  for (const CornerSplit& split : system.splits()) {
    std::vector<std::array<PlaneSeries, 2>> series;
    for (const int k : kReaches)
      for (std::size_t i = 0; i < kOrders.size(); ++i) {
        if (series.size() == i) series.push_back(system.series(split, kOrders[i]));
        // Twice as far for complex numbers.
        const auto whole = system.equation(split, series[i], power_of_two(1 - k));
        if (!whole) break;
        auto equation = divided_at_sides(*whole, sides);
        if (!equation || is_left_open(equation->normal)) continue;
        auto branches = Search(*equation, k).run();
        if (branches) return CornerBranches{*std::move(equation), power_of_two(-k), k, *std::move(branches)};
      }
  }
  return std::nullopt;
}

}  // namespace exsect::filter
