#include "support/random_nets.h"

#include <functional>

namespace exsect::random_nets {
namespace {

using random_pairs::integer;

template <class Make>
Net net_of(int m, int n, const Make& make) {
  Net net(static_cast<std::size_t>(m) + 1);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      net[static_cast<std::size_t>(i)].push_back(make(Rational(i, m), Rational(j, n)));
  return net;
}

Rational sixteenths(Generator& generator, long largest) {
  return Rational(integer(generator, -largest, largest), 16);
}

/// In [0,1).
double random_bits(Generator& generator) { return static_cast<double>(generator() >> 11U) * 0x1p-53; }

Net anywhere(int m, int n, const std::function<Rational()>& coordinate) {
  return net_of(m, n, [&](const Rational&, const Rational&) {
    const Rational a = coordinate(), b = coordinate();
    return Point{a, b, coordinate()};
  });
}

RationalPatch weighted_by(const Net& net, const std::function<Rational()>& weight) {
  Weights weights;
  for (const auto& row : net) {
    weights.emplace_back();
    for (std::size_t j = 0; j < row.size(); ++j) weights.back().push_back(weight());
  }
  return RationalPatch(net, weights);
}

}  // namespace

Nets crossing(Generator& generator, std::array<int, 4> degrees, bool doubles) {
  const Rational half(1, 2);
  const long placement = integer(generator, 0, 2);
  const auto move = [&](long largest) {
    const double unit = static_cast<double>(generator() >> 11U) * 0x1p-52 - 1;  // in [-1,1)
    return doubles ? from_double(unit * static_cast<double>(largest) / 16) : sixteenths(generator, largest);
  };
  const auto moved = [&](const Point& p, long bend) { return p + Point{move(2), move(2), move(bend)}; };
  const auto x = [&](const Rational& a, const Rational& b) { return moved({a, b, Rational(0)}, 5); };
  const auto y = [&](const Rational& a, const Rational& b) {
    if (placement == 0) return moved({a, half, b - half}, 4);
    if (placement == 1) return moved({a, (a + b) * half, b - half}, 4);
    return moved({b, a, (a - half) * Rational(1, 4)}, 9);
  };
  return {net_of(degrees[0], degrees[1], x), net_of(degrees[2], degrees[3], y)};
}

Nets scattered(Generator& generator, std::array<int, 4> degrees) {
  const auto coordinate = [&] { return Rational(integer(generator, 0, 16), 16); };
  Nets nets;
  nets.x = anywhere(degrees[0], degrees[1], coordinate);
  nets.y = anywhere(degrees[2], degrees[3], coordinate);
  return nets;
}

Nets loop(Generator& generator, std::array<int, 4> degrees) {
  const Rational height = Rational(integer(generator, 4, 40), 100);
  const auto cap = [&](const Rational& a, const Rational& b) {
    const bool inner = a != 0 && a != 1 && b != 0 && b != 1;
    return Point{a, b, inner ? Rational(1) : Rational(0)} +
           Point{sixteenths(generator, 1), sixteenths(generator, 1), sixteenths(generator, 1) / 8};
  };
  const auto flat = [&](const Rational& a, const Rational& b) {
    return Point{a * 2 - Rational(1, 2), b * 2 - Rational(1, 2), height + sixteenths(generator, 1) / 4};
  };
  return {net_of(degrees[0], degrees[1], cap), net_of(degrees[2], degrees[3], flat)};
}

Net small(Generator& generator, int m, int n) {
  return anywhere(m, n, [&] { return Rational(integer(generator, -2, 2)); });
}

Net tiny(Generator& generator, int m, int n) {
  return anywhere(m, n, [&] { return Rational(integer(generator, -1, 1)); });
}

Net chosen(Generator& generator, const Net& other, int m, int n) {
  const auto any = [&](std::size_t size) {
    return static_cast<std::size_t>(integer(generator, 0, static_cast<long>(size) - 1));
  };
  return net_of(m, n, [&](const Rational&, const Rational&) {
    const auto& row = other[any(other.size())];
    return row[any(row.size())];
  });
}

Net doubles(Generator& generator, int m, int n) {
  return anywhere(m, n, [&] { return from_double(random_bits(generator)); });
}

RationalPatch weighted(Generator& generator, const Net& net) {
  return weighted_by(net, [&] { return Rational(integer(generator, 5, 16), 8); });
}

RationalPatch weighted_by_one_or_two(Generator& generator, const Net& net) {
  return weighted_by(net, [&] { return Rational(integer(generator, 1, 2)); });
}

RationalPatch weighted_by_doubles(Generator& generator, const Net& net) {
  return weighted_by(net, [&] { return from_double(0.5 + 1.5 * random_bits(generator)); });
}

ProjectiveMap projective_map(Generator& generator) {
  ProjectiveMap rows;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = 0; l < 4; ++l)
      rows[k][l] = Rational(integer(generator, -3, 3), k == 3 ? 32 : 16) + (k == l ? 1 : 0);
  return rows;
}

RationalPatch image(const RationalPatch& patch, const ProjectiveMap& rows) {
  std::vector<std::vector<HomogeneousPoint>> net;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    net.emplace_back();
    for (int j = 0; j <= patch.degree_v(); ++j) {
      HomogeneousPoint p;
      for (std::size_t k = 0; k < 4; ++k) {
        p[k] = 0;
        for (std::size_t l = 0; l < 4; ++l) p[k] += rows[k][l] * patch.homogeneous(i, j)[l];
      }
      net.back().push_back(p);
    }
  }
  return RationalPatch::from_homogeneous(net);
}

RationalPatch reparametrised(const RationalPatch& patch, const Rational& k) {
  std::vector<std::vector<HomogeneousPoint>> net;
  Rational factor = 1;
  for (int i = patch.degree_u(); i >= 0; --i) {
    std::vector<HomogeneousPoint> row;
    for (int j = 0; j <= patch.degree_v(); ++j) {
      HomogeneousPoint p = patch.homogeneous(i, j);
      for (Rational& c : p) c *= factor;
      row.push_back(p);
    }
    net.insert(net.begin(), row);
    factor *= k;
  }
  return RationalPatch::from_homogeneous(net);
}

}  // namespace exsect::random_nets
