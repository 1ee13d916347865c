#include "eliminant/weighted_pair.h"

namespace exsect {

namespace {

using RationalNet = std::vector<std::vector<HomogeneousPoint>>;

/// The power basis, moved by -origin and divided by the weight there.
RationalNet moved(const RationalPatch& patch, const Point& origin) {
  const auto rows = static_cast<std::size_t>(patch.degree_u() + 1);
  const auto columns = static_cast<std::size_t>(patch.degree_v() + 1);
  RationalNet net(rows, std::vector<HomogeneousPoint>(columns));
  const Rational& weight = patch.weight(0, 0);
  for (int k = 3; k >= 0; --k) {
    const auto c = static_cast<std::size_t>(k);
    const BivariatePolynomial component = patch.component(k);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        net[i][j][c] = component.coefficient(static_cast<int>(i), static_cast<int>(j)) / weight;
        if (k < 3) net[i][j][c] -= origin[c] * net[i][j][3];
      }
  }
  return net;
}

template <class Net, class Function>
void for_each_vector(Net& net, const Function& function) {
  for (auto& row : net)
    for (auto& vector : row) function(vector);
}

Integer common_multiple(const Integer& a, const Integer& b) { return a / gcd(a, b) * b; }

/// Coordinate k of both, by a common factor.
void set_coordinate(WeightedPair& pair, const RationalNet& x, const RationalNet& y, std::size_t k) {
  Integer denominators = 1;
  for (const RationalNet* net : {&x, &y})
    for_each_vector(*net, [&](const HomogeneousPoint& c) {
      denominators = common_multiple(denominators, denominator(c[k]));
    });
  const auto set = [&](WeightedPair::Net& integers, const RationalNet& net) {
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j)
        integers[i][j][k] = numerator(net[i][j][k] * denominators);
  };
  set(pair.x, x);
  set(pair.y, y);
  Integer content = 0;
  for (WeightedPair::Net* net : {&pair.x, &pair.y})
    for_each_vector(*net, [&](const WeightedPair::Vector& c) { content = gcd(content, c[k]); });
  if (content <= 1) return;
  for (WeightedPair::Net* net : {&pair.x, &pair.y})
    for_each_vector(*net, [&](WeightedPair::Vector& c) { c[k] /= content; });
}

WeightedPair::Net zeros(const RationalNet& net) {
  return WeightedPair::Net(net.size(), std::vector<WeightedPair::Vector>(net.front().size()));
}

void divide_by_content(WeightedPair::Net& net) {
  Integer content = 0;
  for_each_vector(net, [&](const WeightedPair::Vector& c) {
    for (const Integer& coordinate : c) content = gcd(content, coordinate);
  });
  if (content <= 1) return;
  for_each_vector(net, [&](WeightedPair::Vector& c) {
    for (Integer& coordinate : c) coordinate /= content;
  });
}

}  // namespace

WeightedPair weighted_pair(const RationalPatch& x, const RationalPatch& y) {
  const Point origin = x(0, 0);
  const RationalNet first = moved(x, origin);
  const RationalNet second = moved(y, origin);
  WeightedPair pair = {zeros(first), zeros(second)};
  for (std::size_t k = 0; k < 4; ++k) set_coordinate(pair, first, second, k);
  divide_by_content(pair.x);
  divide_by_content(pair.y);
  return pair;
}

}  // namespace exsect
