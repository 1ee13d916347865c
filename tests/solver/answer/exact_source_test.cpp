#include "answer/exact_source.h"

#include "support/catch.h"

namespace exsect::exact_source_test {

TEST_CASE("fractions at a triangular set are enclosed") {
  using Form = BivariatePolynomial;
  const RealAlgebraic half_root = real_roots(Polynomial{-1, 0, 2}, 0, 1).front();  // s = 1/sqrt 2
  const TriangularPoint at(half_root, Form::r() - Form::constant(3), {3, 3});
  const Form one = Form::constant(1);
  for (const int n : {-1, 1})
    for (const int d : {-1, 1}) {
      // n d s/(1 + s) = n d (sqrt 2 - 1), in another form for each parameter.
      const Form numerator = Form::constant(n) * Form::s();
      const Form denominator = Form::constant(d) * (one + Form::s());
      const Form three = Form::r();
      const ExactParameters point{at,
                                  {numerator, three * numerator, numerator * Form::s(), numerator},
                                  {denominator, three * denominator, denominator * Form::s(), denominator}};
      for (const Rational& width : {Rational(1, 10), power_of_two(-60), power_of_two(-300)})
        for (std::size_t j = 0; j < 4; ++j) {
          const RationalInterval value = enclosure(point, j, width);
          CHECK(value.width() <= width);
          CHECK(value.lower < value.upper);
          const auto side = [&](const Rational& x) {  // (x + 1)^2 - 2 for x > 0
            const Rational y = n * d * x;
            return sign(Rational((y + 1) * (y + 1) - 2));
          };
          CHECK(side(value.lower) * side(value.upper) < 0);
        }
    }
}

}  // namespace exsect::exact_source_test
