// Polynomials in doubles against the same ones over Q.
#include "filter/square_form.h"

#include <exsect/algebra/bivariate_polynomial.h>

#include <cmath>
#include <random>

#include "support/catch.h"

namespace exsect::square_form_test {
namespace {

using Engine = std::mt19937_64;

double random_between(Engine& engine, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(engine);
}

FormTable random_table(Engine& engine, std::size_t m, std::size_t n) {
  FormTable table(m, n);
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) table(i, j) = random_between(engine, -1, 1);
  return table;
}

/// What is meant: every coefficient is off by `off`, in turn up and down.
BivariatePolynomial exact_of(const FormTable& table, double off) {
  std::vector<Polynomial> rows;
  for (std::size_t i = 0; i <= table.m(); ++i) {
    std::vector<Rational> row;
    for (std::size_t j = 0; j <= table.n(); ++j)
      row.push_back(from_double(table(i, j)) + from_double((i + j) % 2 == 0 ? off : -off));
    rows.emplace_back(row);
  }
  return BivariatePolynomial(rows);
}

BivariatePolynomial derived(BivariatePolynomial f, std::size_t k, std::size_t l) {
  for (; k > 0; --k) f = f.derivative_r();
  for (; l > 0; --l) f = f.derivative_s();
  return f;
}

/// Whether a number is in the ball, exactly.
bool holds(const DoubleBall& ball, const Rational& x) {
  const RationalInterval interval = ball.interval();
  return interval.lower <= x && x <= interval.upper;
}

bool is_about(double a, double b) { return std::fabs(a - b) < 1e-10; }

}  // namespace

TEST_CASE("square form: values and expansions hold what is meant, on the sides and beyond") {
  Engine engine(2201);
  for (const auto& [m, n] : {std::pair<std::size_t, std::size_t>{0, 0}, {1, 3}, {6, 6}, {12, 12}}) {
    const FormTable table = random_table(engine, m, n);
    const double off = 0x1p-40, all = off * static_cast<double>((m + 1) * (n + 1));
    const SquareForm form(table, all);
    const BivariatePolynomial exact = exact_of(table, off);
    for (const auto& [p, q] : {std::pair{0.0, 0.0},
                               {1.0, -1.0},
                               {-1.0, 0.3},
                               {SquareForm::reach, -SquareForm::reach},
                               {random_between(engine, -1, 1), random_between(engine, -1, 1)}}) {
      const Rational x = from_double(p), y = from_double(q);
      CHECK(abs(exact(x, y) - from_double(form(p, q))) <= from_double(form.error()));
      const LocalForm local = form.about(p, q);
      for (std::size_t k = 0; k <= 2; ++k)
        for (std::size_t l = 0; l + k <= 2; ++l)
          CHECK(holds(local.derivative(k, l), derived(exact, k, l)(x, y)));
    }
  }
}

TEST_CASE("square form: changes and higher terms are bounded, and nearly reached") {
  Engine engine(2202);
  for (int round = 0; round < 20; ++round) {
    const FormTable table = random_table(engine, 5, 4);
    const SquareForm form(table, 0);
    const BivariatePolynomial exact = exact_of(table, 0);
    const double p = random_between(engine, -1, 1), q = random_between(engine, -1, 1);
    const double a = random_between(engine, 0, 0.3), b = round % 5 == 0 ? 0 : random_between(engine, 0, 0.3);
    const LocalForm local = form.about(p, q);
    for (std::size_t k = 0; k <= 2; ++k)
      for (std::size_t l = 0; l + k <= 2; ++l) {
        const BivariatePolynomial f = derived(exact, k, l);
        const DoubleBall over = local.derivative_over(k, l, a, b);
        for (int sample = 0; sample < 8; ++sample) {
          const double x = sample < 4 ? (sample % 2 == 0 ? a : -a) : random_between(engine, -a, a);
          const double y = sample < 4 ? (sample / 2 == 0 ? b : -b) : random_between(engine, -b, b);
          CHECK(holds(over, f(from_double(p) + from_double(x), from_double(q) + from_double(y))));
        }
      }
    // The terms of at least the order 3 are those of f without its value and derivatives up to the second.
    const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();
    Rational left = exact(from_double(p) + from_double(a), from_double(q) + from_double(b));
    for (std::size_t k = 0; k <= 2; ++k)
      for (std::size_t l = 0; l + k <= 2; ++l) {
        Rational term = derived(exact, k, l)(from_double(p), from_double(q));
        for (std::size_t i = 0; i < k; ++i) term *= from_double(a) / static_cast<int>(i + 1);
        for (std::size_t j = 0; j < l; ++j) term *= from_double(b) / static_cast<int>(j + 1);
        left -= term;
      }
    CHECK(abs(left) <= from_double(local.terms(0, 0, a, b, 3)));
  }
  FormTable square(2, 1);  // 3 p^2 + p q
  square(2, 0) = 3;
  square(1, 1) = 1;
  const SquareForm form(square, 0);
  CHECK(is_about(form.about(0.5, 0).change(0, 0, 0.1, 0), 0.33));
  CHECK(is_about(form.about(0.5, 0).change(1, 0, 0.1, 0), 0.6));
  CHECK(is_about(form.about(0.5, 0).terms(0, 0, 0.1, 0.2, 2), 0.05));
  CHECK(form.about(0.5, 0).terms(0, 0, 0.1, 0.2, 3) < 1e-12);
}

TEST_CASE("square form: numbers that are none prove nothing") {
  FormTable table(1, 1);
  table(0, 0) = std::nan("");
  const SquareForm form(table, 0);
  CHECK(form.about(0, 0).derivative_over(0, 0, 0.1, 0.1).certain_sign() == 0);
  table(0, 0) = 1;
  CHECK(SquareForm(table, std::nan("")).about(0, 0).derivative(0, 0).certain_sign() == 0);
  CHECK(SquareForm(table, 0).about(0, 0).derivative(0, 0).certain_sign() == 1);
}

}  // namespace exsect::square_form_test
