#include "filter/contact_finder.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "filter/homogeneous.h"

namespace exsect::filter {

namespace {

/// Points further apart than this in doubles are different.
constexpr double kNearlySame = 0x1p-24;

template <class K>
constexpr std::array<std::size_t, 4> kCorners = {0, K::degree, K::degree* K::side, K::count - 1};
constexpr std::array<SquareSide, 4> kSides = {{{0, false}, {0, true}, {1, false}, {1, true}}};

template <class K>
bool same_point(const ExactPatch<K>& a, std::size_t i, const ExactPatch<K>& b, std::size_t j) {
  if constexpr (K::weighted) {
    return is_same_point(homogeneous<K>(a, i), homogeneous<K>(b, j));
  } else {
    return control_point(a, i) == control_point(b, j);
  }
}

/// Above the error of a minor of rounded homogeneous control points: 8 u for coordinates of at most 1.
constexpr double kLeastMinor = 0x1p-49;

/// False only if control points of one patch are certainly different ones: quicker than the exact comparison.
template <class K>
bool may_be_one(const Row<K>& a, const Row<K>& b) {
  if constexpr (K::weighted) {  // a weight may be zero
    for (std::size_t c = 0; c < 3; ++c)
      if (std::fabs(a[c] * b[3] - b[c] * a[3]) > kLeastMinor) return false;
    return true;
  } else {
    return a == b;
  }
}

template <class K>
Repeated repeated_at(const ExactPatch<K>& patch, const CoefficientsOf<K>& net, std::size_t corner) {
  const std::array<bool, 2> upper = corner_ends<K>(corner);
  Repeated repeated{};
  for (std::size_t p = 0; p < 2; ++p) {
    const SideView row = {{1 - p, upper[1 - p]}, upper[p], K::degree};
    const auto is_corner = [&](std::size_t k) {
      const std::size_t i = row.index(0, k);
      return may_be_one<K>(net[i], net[corner]) && same_point<K>(patch, i, patch, corner);
    };
    while (repeated[p] + 1 < K::degree && is_corner(repeated[p] + 1)) ++repeated[p];
  }
  return repeated;
}

/// (14.37): the field less the multiple of the own side that makes it zero at one end of it. Returns by how
/// much sizes and errors grow at most: with a factor f and a weight w, f errs by 22 u (1 + |f|) / w, as the
/// field by 20 u, and the difference by less than 30 u (1 + |f|) (1 + 1/w).
template <class K>
double subtract_own(AcrossFieldOf<K>& field, const std::array<Row<K>, K::side>& own, bool upper) {
  const std::size_t end = upper ? K::degree : 0;
  double most = 0;
  for (std::size_t i = 0; i < K::degree; ++i) {
    const double factor = field[K::side * i + end][3] / own[end][3];
    most = larger_bound(most, std::fabs(factor));
    for (std::size_t j = 0; j < K::side; ++j) {
      field[K::side * i + j] = field[K::side * i + j] - factor * own[j];
    }
  }
  return 2 * (1 + most) * (1 + 1 / std::fabs(own[end][3]));
}

/// (14.32): the field divided by t if it is zero at the lower end of the side, by 1 - t if at the upper one,
/// of degree n in t again. Coefficient j of degree n-1 is n/j times that of degree n.
template <class K>
void divide_at(AcrossFieldOf<K>& field, bool upper) {
  constexpr std::size_t n = K::degree;
  for (std::size_t i = 0; i < n; ++i) {
    std::array<Row<K>, K::side> row;
    for (std::size_t j = 0; j <= n; ++j) row[j] = field[K::side * i + (upper ? n - j : j)];
    for (std::size_t j = 0; j < n; ++j) {
      row[j] = (static_cast<double>(n) / static_cast<double>(j + 1)) * row[j + 1];
    }
    row[n] = row[n - 1];
    for (std::size_t j = n - 1; j > 0; --j) {
      row[j] = between(row[j], row[j - 1], static_cast<double>(j) / static_cast<double>(n));
    }
    for (std::size_t j = 0; j <= n; ++j) field[K::side * i + (upper ? n - j : j)] = row[j];
  }
}

/// The corners of a patch: those at the ends of a side that is one point are one.
template <class K>
class Corners {
 public:
  Corners(const ExactPatch<K>& patch, const CoefficientsOf<K>& net) {
    for (std::size_t i = 0; i < 4; ++i) first_[i] = kCorners<K>[i];
    if constexpr (std::is_same_v<K, Biquadratic>) return;  // exact arithmetic is behind these
    for (const SquareSide& side : kSides) {
      const SideView view = {side, false, K::degree};
      const auto is_first = [&](std::size_t k) {
        const std::size_t i = view.index(0, k), first = view.index(0, 0);
        return may_be_one<K>(net[i], net[first]) && same_point<K>(patch, i, patch, first);
      };
      bool is_pole = true;
      for (std::size_t k = 1; is_pole && k <= K::degree; ++k) is_pole = is_first(k);
      if (!is_pole) continue;
      poles_.push_back(side);
      for (std::size_t i = 0; i < 4; ++i) {
        if (kCorners<K>[i] == view.index(0, K::degree)) first_[i] = view.index(0, 0);
      }
    }
  }

  /// Sides that are one point each have no corner in common.
  bool are_sound() const {
    return poles_.size() < 2 || (poles_.size() == 2 && poles_[0].parameter == poles_[1].parameter);
  }
  bool is_pole(const SquareSide& side) const {
    return std::find(poles_.begin(), poles_.end(), side) != poles_.end();
  }
  /// That stands for this one.
  std::size_t operator()(std::size_t corner) const {
    const auto& all = kCorners<K>;
    return first_[static_cast<std::size_t>(std::find(all.begin(), all.end(), corner) - all.begin())];
  }
  std::optional<SquareSide> pole_at(std::size_t corner) const {
    const std::array<bool, 2> upper = corner_ends<K>(corner);
    for (const SquareSide& side : poles_) {
      if (upper[side.parameter] == side.upper) return side;
    }
    return std::nullopt;
  }

 private:
  std::array<std::size_t, 4> first_;
  std::vector<SquareSide> poles_;
};

template <class K>
class ContactFinder {
 public:
  ContactFinder(const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair)
      : x_(x), y_(y), pair_(pair), corners_of_x_(x, pair.x.net), corners_of_y_(y, pair.y.net) {}

  std::optional<ContactsOf<K>> run() {
    if (!corners_of_x_.are_sound() || !corners_of_y_.are_sound() || !find_corners()) {
      return std::nullopt;
    }
    ContactsOf<K> contacts;
    std::vector<bool> on_side(corners_.size(), false);
    for (const SquareSide& a : kSides) {
      for (const SquareSide& b : kSides) {
        for (const bool reversed : {false, true}) {
          const SideView x = {a, false, K::degree};
          const SideView y = {b, reversed, K::degree};
          if (const auto ratio = same_side(x, y)) {
            SideContactOf<K>& contact = contacts.sides.emplace_back(contact_of(x, y, *ratio));
            for (const std::size_t end : {std::size_t{0}, K::degree}) {
              for (std::size_t k = 0; k < corners_.size(); ++k) {
                if (!is_end(corners_[k], x, y, end)) continue;
                on_side[k] = true;
                add_end(contact, corners_[k], end != 0);
              }
            }
            if (K::weighted && has_two_poles(contact)) return std::nullopt;
          }
        }
      }
    }
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      if (!on_side[k]) {
        contacts.corners.push_back(corners_[k]);
      }
    }
    return contacts;
  }

 private:
  /// False if a corner is perhaps one of the other patch but for rounding; or, of biquadratic pairs, behind
  /// which there is exact arithmetic, if it is two of them: a pole's, perhaps.
  bool find_corners() {
    for (const std::size_t i : kCorners<K>) {
      for (const std::size_t j : kCorners<K>) {
        if (corners_of_x_(i) != i || corners_of_y_(j) != j || !may_be_same(i, j)) {
          continue;
        }
        const bool again = std::is_same_v<K, Biquadratic> &&
                           std::any_of(corners_.begin(), corners_.end(),
                                       [&](const CornerContact& c) { return c.x == i || c.y == j; });
        if (again || !same_point<K>(x_, i, y_, j)) {
          return false;
        }
        corners_.push_back({i, j, corners_of_x_.pole_at(i), corners_of_y_.pole_at(j),
                            repeated_at<K>(x_, pair_.x.net, i), repeated_at<K>(y_, pair_.y.net, j)});
      }
    }
    return true;
  }

  bool may_be_same(std::size_t i, std::size_t j) const {
    if constexpr (K::weighted) {
      return largest(affine(pair_.x.net[i]) - affine(pair_.y.net[j])) < kNearlySame;
    } else {
      return pair_.x.net[i] == pair_.y.net[j];
    }
  }

  SideContactOf<K> contact_of(const SideView& x, const SideView& y,
                              [[maybe_unused]] const Rational& ratio) const {
    if constexpr (K::weighted) {
      return weighted_side_contact<K>(pair_, x, y, {{0, ratio}, {1, ratio}});
    } else {
      return side_contact<K>(pair_, x, y);
    }
  }

  /// Of one patch: its field cannot be made zero at both.
  static bool has_two_poles(const SideContactOf<K>& contact) {
    const auto both = [&](auto pole) {
      return contact.ends.size() == 2 && contact.ends[0].*pole && contact.ends[1].*pole;
    };
    return both(&CornerContact::pole_of_x) || both(&CornerContact::pole_of_y);
  }

  /// A patch with a pole there has a field that is zero there.
  static void add_end(SideContactOf<K>& contact, const CornerContact& corner, bool upper) {
    contact.ends.push_back(corner);
    if constexpr (K::weighted) {
      double growth = 1;
      if (corner.pole_of_x) growth = subtract_own<K>(contact.x_across, contact.own, upper);
      if (corner.pole_of_y) {
        growth = larger_bound(growth, subtract_own<K>(contact.y_across, contact.own_of_y, upper));
      }
      contact.growth *= growth;
    }
    if (corner.pole_of_x) divide_at<K>(contact.x_across, upper);
    if (corner.pole_of_y) divide_at<K>(contact.y_across, upper);
    if (corner.is_pole()) contact.growth *= static_cast<double>(K::degree);
  }

  /// The ratio of the parameters, 1 of polynomial sides; empty if they are different curves.
  std::optional<Rational> same_side(const SideView& x, const SideView& y) const {
    if (corners_of_x_.is_pole(x.side) || corners_of_y_.is_pole(y.side)) return std::nullopt;
    for (const std::size_t end : {std::size_t{0}, K::degree}) {
      if (!may_be_same(x.index(0, end), y.index(0, end))) return std::nullopt;
    }
    if constexpr (K::weighted) {
      return ratio_of_sides(x, y);
    } else {
      for (std::size_t k = 0; k < K::side; ++k) {
        const std::size_t i = x.index(0, k);
        const std::size_t j = y.index(0, k);
        if (pair_.x.net[i] != pair_.y.net[j] || control_point(x_, i) != control_point(y_, j)) {
          return std::nullopt;
        }
      }
      return 1;
    }
  }

  /// k > 0 with y's vectors in proportion to k^i times those of x, exactly.
  std::optional<Rational> ratio_of_sides(const SideView& x, const SideView& y) const requires K::weighted {
    std::array<Rational, K::side> factor;
    for (std::size_t k = 0; k < K::side; ++k) {
      const HomogeneousPoint a = homogeneous<K>(x_, x.index(0, k));
      const HomogeneousPoint b = homogeneous<K>(y_, y.index(0, k));
      const auto largest = std::max_element(
          a.begin(), a.end(), [](const Rational& p, const Rational& q) { return abs(p) < abs(q); });
      if (*largest == 0) return std::nullopt;
      factor[k] = b[static_cast<std::size_t>(largest - a.begin())] / *largest;
      for (std::size_t c = 0; c < 4; ++c) {
        if (b[c] != factor[k] * a[c]) return std::nullopt;
      }
      if (!(factor[k] > 0)) return std::nullopt;
    }
    const Rational ratio = factor[1] / factor[0];
    for (std::size_t k = 1; k < K::side; ++k) {
      if (factor[k] != ratio * factor[k - 1]) return std::nullopt;
    }
    return ratio;
  }

  bool is_end(const CornerContact& corner, const SideView& x, const SideView& y, std::size_t along) const {
    return corner.x == corners_of_x_(x.index(0, along)) && corner.y == corners_of_y_(y.index(0, along));
  }

  const ExactPatch<K>& x_;
  const ExactPatch<K>& y_;
  const PairOf<K>& pair_;
  Corners<K> corners_of_x_;
  Corners<K> corners_of_y_;
  std::vector<CornerContact> corners_;
};

}  // namespace

template <class K>
SideContactOf<K> side_contact(const PairOf<K>& pair, const SideView& x, const SideView& y) {
  SideContactOf<K> contact{x, y, {}, across_field<K>(pair.x.net, x), across_field<K>(pair.y.net, y)};
  for (std::size_t j = 0; j < K::degree; ++j) {
    contact.direction[j] = pair.x.net[x.index(0, j + 1)] - pair.x.net[x.index(0, j)];
  }
  return contact;
}

template <class K>
requires K::weighted SideContactOf<K> weighted_side_contact(const PairOf<K>& pair, const SideView& x,
                                                            const SideView& y,
                                                            const MoebiusMap<Rational>& to_x) {
  constexpr std::size_t n = K::degree;
  const auto rounded = [](const std::array<Rational, 2>& ends) {
    return std::array{to_double(ends[0]), to_double(ends[1])};
  };
  SideContactOf<K> contact{x,
                           y,
                           to_x,
                           {rounded(to_x.value), rounded(to_x.weight)},
                           {},
                           {},
                           {},
                           {},
                           across_field<K>(pair.x.net, x),
                           across_field<K>(pair.y.net, y)};
  for (std::size_t k = 0; k <= n; ++k) {
    contact.own[k] = pair.x.net[x.index(0, k)];
    contact.own_of_y[k] = pair.y.net[y.index(0, k)];
  }
  const auto binomial = [](std::size_t of, std::size_t k) {
    double result = 1;
    for (std::size_t i = 1; i <= k; ++i) {
      result = result * static_cast<double>(of + 1 - i) / static_cast<double>(i);
    }
    return result;
  };
  // (14.35).
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = i + 1; j <= n; ++j) {
      const Row<K>& a = contact.own[i];
      const Row<K>& b = contact.own[j];
      const Vec3 p = {a[0], a[1], a[2]};
      const Vec3 q = {b[0], b[1], b[2]};
      const Vec3 line = b[3] * p - a[3] * q;
      const Vec3 moment = cross(p, q);
      for (std::size_t m = 0; m < j - i; ++m) {
        const std::size_t row = i + m;
        const std::size_t column = j - 1 - m;
        const double weight =
            binomial(n, i) * binomial(n, j) / (binomial(n - 1, row) * binomial(n - 1, column));
        Vec3& direction = contact.line[n * row + column];
        Vec3& around = contact.line_moment[n * row + column];
        direction = direction + weight * line;
        around = around + weight * moment;
      }
    }
  }
  return contact;
}

template <class K>
std::optional<ContactsOf<K>> find_contacts(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                           const PairOf<K>& pair) {
  return ContactFinder<K>(x, y, pair).run();
}

template SideContactOf<Biquadratic> side_contact<Biquadratic>(const PairOf<Biquadratic>&, const SideView&,
                                                              const SideView&);
#define EXSECT_INSTANTIATE(K)                                                                        \
  template std::optional<ContactsOf<K>> find_contacts<K>(const ExactPatch<K>&, const ExactPatch<K>&, \
                                                         const PairOf<K>&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
