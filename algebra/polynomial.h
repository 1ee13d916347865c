// Polynomials in one variable over Q.
#pragma once

#include <exsect/algebra/rational.h>

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace exsect {

/// An element of Q[t]. Always in lowest terms; arithmetic never rescales, so signs survive.
/// The zero polynomial has degree -1.
class Polynomial {
 public:
  Polynomial();
  Polynomial(const Rational& constant);  // NOLINT: Q embeds in Q[t]
  Polynomial(int constant);              // NOLINT
  /// Coefficients, constant term first; trailing zeros allowed.
  explicit Polynomial(const std::vector<Rational>& coefficients);
  /// Polynomial{1, 0, 3} is 1 + 3 t^2.
  Polynomial(std::initializer_list<Rational> coefficients)
      : Polynomial(std::vector<Rational>(coefficients)) {}
  Polynomial(const Polynomial&);
  Polynomial(Polynomial&&) noexcept;
  Polynomial& operator=(const Polynomial&);
  Polynomial& operator=(Polynomial&&) noexcept;
  ~Polynomial();

  /// The polynomial t.
  static Polynomial variable();

  int degree() const;
  bool is_zero() const { return degree() < 0; }
  /// The coefficient of t^i, zero for i beyond the degree.
  Rational coefficient(int i) const;
  /// Zero for the zero polynomial.
  Rational leading_coefficient() const;
  /// All coefficients, constant term first; empty for zero.
  std::vector<Rational> coefficients() const;

  Rational operator()(const Rational& t) const;
  /// Sign of the value at t: -1, 0, +1. Faster than evaluating.
  int sign_at(const Rational& t) const;
  /// this(inner(t)).
  Polynomial compose(const Polynomial& inner) const;
  Polynomial derivative() const;
  /// t^n this(1/t); requires n >= degree(), else std::invalid_argument.
  Polynomial reversed(int n) const;
  /// The positive rational multiple with coprime integer coefficients; zero for zero.
  Polynomial primitive() const;

  Polynomial& operator+=(const Polynomial& other);
  Polynomial& operator-=(const Polynomial& other);
  Polynomial& operator*=(const Polynomial& other);
  Polynomial operator-() const;
  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial& a, const Polynomial& b);

  struct Rep;  // holds the fmpq_poly; defined in algebra/flint_polynomial.h
  const Rep& rep() const { return *rep_; }
  Rep& rep() { return *rep_; }

 private:
  std::unique_ptr<Rep> rep_;
};

struct Division {
  Polynomial quotient;
  Polynomial remainder;
};

/// a = quotient b + remainder, deg remainder < deg b. Throws std::domain_error for b = 0.
Division divide(const Polynomial& a, const Polynomial& b);
/// a / b where b divides a; throws std::domain_error otherwise.
Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);
/// Monic greatest common divisor; gcd(0,0) = 0.
Polynomial gcd(const Polynomial& a, const Polynomial& b);
/// No complex root of f is multiple (true for nonzero constants). Throws std::domain_error for f = 0.
bool is_squarefree(const Polynomial& f);
/// f divided by gcd(f, f'), primitive with the sign of f; every complex root of f exactly once.
/// Throws std::domain_error for f = 0.
Polynomial squarefree_part(const Polynomial& f);

struct PolynomialPower {
  Polynomial factor;
  int multiplicity;
};

/// Squarefree factorisation (Yun): pairwise coprime squarefree primitive non-constant factors of
/// multiplicities 1, 2, ..., whose product of powers is f up to a rational constant. Throws std::domain_error
/// for f = 0.
std::vector<PolynomialPower> squarefree_factors(const Polynomial& f);
/// Irreducible factors over Q with multiplicities; primitive, up to a rational constant. Throws for f = 0.
std::vector<PolynomialPower> irreducible_factors(const Polynomial& f);

}  // namespace exsect
