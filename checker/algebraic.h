// Numbers of a field Q(a) as polynomials in a, where a is a real root of a polynomial.
#pragma once

#include <memory>
#include <vector>

#include "map.h"
#include "require.h"

namespace exsect::checker {

/// A real number a: any root of m between two numbers where m has opposite signs. What vanishes modulo m
/// vanishes at each root, and a ball over the interval holds the values at all of them; so m may be reducible
/// and have several roots there.
struct Root {
  std::vector<Rational> modulus;  // m, the constant coefficient first, the leading one 1
  std::array<Rational, 2> between;

  int degree() const { return static_cast<int>(modulus.size()) - 1; }
  void check() const {
    require(degree() >= 1 && modulus.back() == 1, "its modulus has no leading coefficient 1");
    require(between[0] < between[1] && value(between[0]) * value(between[1]) < 0,
            "its modulus changes no sign between the two numbers");
  }

 private:
  Rational value(const Rational& t) const {
    Rational sum = 0;
    for (std::size_t i = modulus.size(); i-- > 0;) sum = sum * t + modulus[i];
    return sum;
  }
};

/// c_0 + c_1 a + ..., of lower degree than m; a rational number needs no a.
class Algebraic {
 public:
  Algebraic(int n = 0) : Algebraic(Rational(n)) {}
  Algebraic(const Rational& q) : Algebraic(std::vector<Rational>{q}, nullptr) {}
  Algebraic(std::vector<Rational> c, std::shared_ptr<const Root> root)
      : c_(std::move(c)), root_(std::move(root)) {
    reduce();
  }

  /// Empty for 0.
  const std::vector<Rational>& coefficients() const { return c_; }
  const std::shared_ptr<const Root>& root() const { return root_; }
  bool is_rational() const { return c_.size() <= 1; }
  Rational rational() const {
    require(is_rational(), "an irrational number where only rational ones are allowed");
    return c_.empty() ? Rational(0) : c_[0];
  }
  /// A ball that holds the number, by Horner's rule.
  Ball<Rational> ball() const {
    if (is_rational()) return rational();
    const auto& [lower, upper] = root_->between;
    const Ball<Rational> a = {(lower + upper) / 2, (upper - lower) / 2};
    Ball<Rational> sum;
    for (std::size_t i = c_.size(); i-- > 0;) sum = sum * a + Ball<Rational>(c_[i]);
    return sum;
  }

  friend Algebraic operator+(const Algebraic& a, const Algebraic& b) {
    std::vector<Rational> c(std::max(a.c_.size(), b.c_.size()));
    for (std::size_t i = 0; i < a.c_.size(); ++i) c[i] = a.c_[i];
    for (std::size_t i = 0; i < b.c_.size(); ++i) c[i] += b.c_[i];
    return {std::move(c), a.root_ ? a.root_ : b.root_};
  }
  friend Algebraic operator*(const Algebraic& a, const Algebraic& b) {
    std::vector<Rational> c(a.c_.size() + b.c_.size());
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      for (std::size_t j = 0; j < b.c_.size(); ++j) c[i + j] += a.c_[i] * b.c_[j];
    return {std::move(c), a.root_ ? a.root_ : b.root_};
  }
  friend Algebraic operator-(const Algebraic& a, const Algebraic& b) { return a + Algebraic(-1) * b; }
  Algebraic& operator+=(const Algebraic& a) { return *this = *this + a; }
  /// Of numbers that are equal only if they are modulo m.
  friend bool operator==(const Algebraic& a, const Algebraic& b) { return (a - b).c_.empty(); }
  /// Of numbers that are certainly different, or equal modulo m; otherwise 0.
  friend int sign_of(const Algebraic& a) { return a.ball().sign(); }

 private:
  void reduce() {
    const auto strip = [&] {
      while (!c_.empty() && c_.back() == 0) c_.pop_back();
    };
    for (strip(); root_ && c_.size() >= root_->modulus.size(); strip()) {
      const Rational top = c_.back();
      const std::size_t shift = c_.size() - root_->modulus.size();
      for (std::size_t i = 0; i < root_->modulus.size(); ++i) c_[shift + i] -= top * root_->modulus[i];
    }
  }

  std::vector<Rational> c_;
  std::shared_ptr<const Root> root_;
};

/// In the numbers of the check, or near it.
template <class N>
N number(const Algebraic& a) {
  if constexpr (std::is_same_v<N, Rational>) {
    return a.rational();
  } else {
    const Ball<Rational> ball = a.ball();
    if constexpr (std::is_same_v<N, double>)
      return approximate(ball.middle);
    else
      return N(ball.middle, ball.radius);
  }
}

}  // namespace exsect::checker
