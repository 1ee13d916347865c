#include "filter/newton_polygon.h"

#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::newton_polygon_test {
namespace {

using filter::newton_polygon;
using filter::PlaneSeries;
using filter::PolygonEdge;

struct Term {
  int i, j, c;
};
PlaneSeries series_of(const std::vector<Term>& terms, int order = 8) {
  PlaneSeries f(order, 1);
  for (const Term& t : terms) f.add(PlaneSeries::power(order, 1, t.i, t.j), t.c);
  return f;
}

}  // namespace

TEST_CASE("newton polygon: a cusp, two edges, points on an edge", "[filter]") {
  const auto cusp = newton_polygon(series_of({{0, 2, 1}, {3, 0, -1}, {2, 2, 5}}));
  REQUIRE(cusp.size() == 1);
  CHECK(cusp[0].p_weight == 2);
  CHECK(cusp[0].q_weight == 3);
  CHECK(cusp[0].degree == 6);
  CHECK(cusp[0].in_c == Polynomial{-1, 0, 1});
  // A loop of the folium p^3 + q^3 = 3 p q at its double point.
  const auto folium = newton_polygon(series_of({{0, 3, 1}, {1, 1, -3}, {3, 0, 1}}));
  REQUIRE(folium.size() == 2);
  CHECK(folium[0].p_weight == 2);
  CHECK(folium[0].q_weight == 1);
  CHECK(folium[0].in_c == Polynomial{0, -3, 0, 1});
  CHECK(folium[1].p_weight == 1);
  CHECK(folium[1].q_weight == 2);
  CHECK(folium[1].in_c == Polynomial{1, -3});
  CHECK(folium[0].lowest == folium[1].highest);
  const auto lines = newton_polygon(series_of({{0, 2, 1}, {1, 1, -3}, {2, 0, 2}}));
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].in_c == Polynomial{2, -3, 1});
}

TEST_CASE("newton polygon: none with an axis in the zeros, without zeros, and of zero", "[filter]") {
  CHECK(newton_polygon(series_of({{1, 0, 1}, {1, 2, -1}})).empty());
  CHECK(newton_polygon(series_of({{0, 1, 1}, {2, 1, -1}})).empty());
  CHECK(newton_polygon(series_of({{0, 0, 1}, {2, 0, -1}})).empty());
  CHECK(newton_polygon(series_of({})).empty());
}

TEST_CASE("newton polygon: every edge has the terms of least weight", "[filter]") {
  int edges = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    PlaneSeries f(7, 1);
    for (int k = 0; k < 8; ++k) {
      const int i = static_cast<int>(random_pairs::integer(generator, 0, 5));
      const int j = static_cast<int>(random_pairs::integer(generator, 0, 7 - i));
      f.add(PlaneSeries::power(7, 1, i, j), Rational(random_pairs::integer(generator, -2, 2)));
    }
    for (const PolygonEdge& edge : newton_polygon(f)) {
      ++edges;
      std::vector<Rational> least(8);
      for (int i = 0; i <= 7; ++i)
        for (int j = 0; i + j <= 7; ++j) {
          const int weight = edge.p_weight * i + edge.q_weight * j;
          if (f.coefficient(i, j) == 0) continue;
          CHECK(weight >= edge.degree);
          if (weight == edge.degree) least[static_cast<std::size_t>(j)] = f.coefficient(i, j);
        }
      CHECK(edge.in_c == Polynomial(least));
      CHECK(edge.highest[1] == edge.in_c.degree());
      CHECK(f.coefficient(edge.lowest[0], edge.lowest[1]) != 0);
    }
  }
  CHECK(edges >= 60);
}

}  // namespace exsect::newton_polygon_test
