#include "common_field.h"

#include <algorithm>
#include <array>

#include "integer_relation.h"

namespace exsect {

namespace {

/// Powers of numbers of size 25 at most, and products with derivatives, are known to fewer bits than these.
constexpr int kLostBits = 64;
/// Multiples of the numbers that are added for a generator of their field: those of which that has a smaller
/// degree are finitely many lines.
constexpr std::array<std::array<int, 4>, 3> kMultiples = {{{1, 2, 3, 5}, {1, -1, 2, -3}, {3, 1, -2, 7}}};

class Recognition {
 public:
  Recognition(const std::vector<Rational>& values, int bits, int most_degree)
      : values_(values), bits_(bits), most_degree_(most_degree) {}

  std::optional<std::vector<FieldNumber>> run() const {
    std::vector<FieldNumber> numbers(values_.size());
    std::vector<std::size_t> irrational;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (const auto q = rational_near(values_[i]))
        numbers[i] = *q;
      else
        irrational.push_back(i);
    }
    if (irrational.empty()) return numbers;
    // The field of one of the numbers may have them all.
    std::optional<RealAlgebraic> largest;
    for (const std::size_t i : irrational) {
      auto a = algebraic_near(values_[i]);
      if (!a) return std::nullopt;
      if (!largest || a->polynomial().degree() > largest->polynomial().degree()) largest = std::move(a);
    }
    if (fill(*largest, irrational, numbers)) return numbers;
    for (const auto& multiples : kMultiples) {
      Rational sum = 0;
      for (std::size_t k = 0; k < irrational.size(); ++k)
        sum += multiples[k % multiples.size()] * values_[irrational[k]];
      const auto a = algebraic_near(sum);
      if (a && fill(*a, irrational, numbers)) return numbers;
    }
    return std::nullopt;
  }

 private:
  int known_bits() const { return bits_ - kLostBits; }

  std::optional<Rational> rational_near(const Rational& value) const {
    const auto c = integer_relation({value, 1}, known_bits());
    if (!c || (*c)[0] == 0) return std::nullopt;
    return Rational(-(*c)[1], (*c)[0]);
  }

  /// The root near a value of an irreducible polynomial of degree most_degree at most.
  std::optional<RealAlgebraic> algebraic_near(const Rational& value) const {
    const Rational room = power_of_two(-bits_ / 3);
    std::vector<Rational> powers = {1};
    for (int degree = 1; degree <= most_degree_; ++degree) {
      powers.push_back(powers.back() * value);
      // A relation of one of these lengths is a multiple of that of every smaller degree.
      if (degree != most_degree_ && degree != 2 && degree != 4) continue;
      const auto c = integer_relation(powers, known_bits());
      if (!c) continue;
      for (const PolynomialPower& power :
           irreducible_factors(Polynomial(std::vector<Rational>(c->begin(), c->end())))) {
        const auto roots = real_roots(power.factor, value - room, value + room);
        if (roots.size() == 1) return roots.front();
      }
    }
    return std::nullopt;
  }

  /// Sets the numbers with these indices; false if one of them is not found in the field.
  bool fill(const RealAlgebraic& generator, const std::vector<std::size_t>& indices,
            std::vector<FieldNumber>& numbers) const {
    const RealField field(generator);
    const Rational a = generator.refined_to(power_of_two(-bits_)).interval().midpoint();
    // (14.71). With the derivative of the polynomial as denominator numerators have about as many digits as
    // that has.
    const Polynomial slope = field.modulus().derivative().primitive();
    std::vector<Rational> relation = {0};
    for (int i = 0; i < field.degree(); ++i) relation.push_back(i == 0 ? Rational(1) : relation.back() * a);
    for (const std::size_t i : indices) {
      relation[0] = slope(a) * values_[i];
      const auto c = integer_relation(relation, known_bits());
      if (!c || (*c)[0] == 0) return false;
      const Polynomial numerator(std::vector<Rational>(c->begin() + 1, c->end()));
      numbers[i] = -FieldNumber(field, numerator) / FieldNumber(field, Polynomial(Rational((*c)[0])) * slope);
      const RationalInterval found = enclosure(numbers[i], bits_ / 2 + 2);
      if (abs(found.midpoint() - values_[i]) > power_of_two(-bits_ / 2 - 1)) return false;
    }
    return true;
  }

  const std::vector<Rational>& values_;
  int bits_;
  int most_degree_;
};

}  // namespace

std::optional<std::vector<FieldNumber>> recognised_in_field(const std::vector<Rational>& values, int bits,
                                                            int most_degree) {
  return Recognition(values, bits, most_degree).run();
}

}  // namespace exsect
