#include "certificate/near_pair.h"

#include <algorithm>
#include <cmath>

namespace exsect::cli {
namespace {

template <std::size_t dimension, std::size_t most>
checker::Grid<double, dimension, most> near_grid(const checker::Grid<Rational, dimension, most>& grid,
                                                 const Rational& factor) {
  checker::Grid<double, dimension, most> result(grid.degree(0), grid.degree(1));
  grid.each([&](std::size_t i, std::size_t j) {
    for (std::size_t d = 0; d < dimension; ++d) result[i][j][d] = to_double(factor * grid[i][j][d]);
  });
  return result;
}

template <std::size_t dimension, std::size_t most>
Rational greatest(const checker::Grid<Rational, dimension, most>& grid) {
  Rational result = 0;
  grid.each([&](std::size_t i, std::size_t j) {
    for (const Rational& q : grid[i][j]) result = std::max<Rational>(result, abs(q));
  });
  return result;
}
/// The least power of two that is at least the number. Throws NoCertificate beyond doubles.
double power_above(const Rational& q) {
  const double result = std::exp2(std::ceil(std::log2(to_double(q))));
  if (!(result > 0) || !std::isfinite(result)) throw NoCertificate("control points beyond doubles");
  return result;
}

}  // namespace

NearPair near_pair(const Patches& patches, bool self) {
  NearPair result;
  std::array<checker::WeightedNet<Rational>, 2> nets = {control_net(patches[0]), control_net(patches[1])};
  const checker::Net<Rational>& first = nets[0].points;
  const Point origin = first[first.degree(0) / 2][first.degree(1) / 2];
  std::array<Rational, 2> weight;
  Rational most = 0;
  for (std::size_t n = 0; n < 2; ++n) {
    weight[n] = from_double(power_above(greatest(nets[n].weights)));
    nets[n].move_by_minus(origin);
    most = std::max<Rational>(most, greatest(nets[n].points) / weight[n]);
  }
  const double scale = power_above(most);
  const Rational factor = 1 / from_double(scale);
  const auto near = [&](std::size_t n) {
    checker::WeightedNet<double> net;
    net.points = near_grid(nets[n].points, factor / weight[n]);
    net.weights = near_grid(nets[n].weights, 1 / weight[n]);
    return net;
  };
  std::array<checker::WeightedNet<double>, 2> power;
  for (std::size_t n = 0; n < 2; ++n) {
    result.control[n] = near(n);
    nets[n].to_powers();
    power[n] = near(n);
  }
  result.power = checker::pair_map(power[0], power[1]);
  result.scale.fill(to_double(from_double(scale) * weight[0] * weight[1]));
  if (self) result.charts = {checker::pair_chart(power[0]), checker::pair_chart(power[0].exchanged())};
  return result;
}

NearPair near_section(const SpacePolynomial& f, const RationalPatch& x) {
  const ExactMap exact = equation_of(f, x);
  const auto degree = [&](int d) { return static_cast<std::size_t>(f.degree() * d); };
  const auto net =
      checker::section_net(checker::component(exact, 0), degree(x.degree_u()), degree(x.degree_v()));
  const double scale = power_above(greatest(net));
  const Rational factor = 1 / from_double(scale);
  NearPair result;
  for (const auto& term : exact.terms())
    result.power.coefficient(term.power) = {to_double(factor * term.c[0]), to_double(term.c[1]),
                                            to_double(term.c[2])};
  result.section = near_grid(net, factor);
  result.scale = {scale, 1, 1};
  const auto occurs = [&](std::size_t i) {
    return std::any_of(exact.terms().begin(), exact.terms().end(),
                       [&](const auto& term) { return term.c[0] != 0 && term.power[i] > 0; });
  };
  result.constant = {!occurs(1), !occurs(0), true, true};
  return result;
}

}  // namespace exsect::cli
