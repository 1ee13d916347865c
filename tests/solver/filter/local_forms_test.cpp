#include "filter/local_forms.h"

#include "known_curve.h"

namespace exsect::local_forms_test {
namespace {

using filter::Biquadratic;
using testing::q;
using testing::Terms;

const Rational half(1, 2);
const Terms a = {{{1, 0}, 1}, {{0, 0}, -half}}, b = {{{0, 1}, 1}, {{0, 0}, -half}};

std::optional<filter::LocalForms> forms_in_the_middle(const Terms& h) {
  return filter::local_forms<Biquadratic>(
      testing::graph(h), testing::larger_plane(),
      {FieldNumber(half), FieldNumber(half), FieldNumber(half), FieldNumber(half)});
}

/// A form in the directions of S, which are those of (u,v) but for a factor: {alpha^2, alpha beta, beta^2}.
std::array<double, 3> in_directions(const filter::LocalForms& forms, double aa, double ab, double bb) {
  const auto value = [&](double alpha, double beta) {
    const double x = forms.s[0][0] * alpha + forms.s[0][1] * beta,
                 y = forms.s[1][0] * alpha + forms.s[1][1] * beta;
    return aa * x * x + ab * x * y + bb * y * y;
  };
  const double first = value(1, 0), second = value(0, 1);
  return {first, value(1, 1) - first - second, second};
}

}  // namespace

TEST_CASE("local forms: a touch point's form is a multiple of alpha^2 + beta^2", "[filter]") {
  const auto forms = forms_in_the_middle(a * a + Terms{{{0, 0}, 3}} * a * b + Terms{{{0, 0}, 5}} * b * b);
  REQUIRE(forms);
  CHECK_FALSE(forms->crossing);
  const auto form = in_directions(*forms, 1, 3, 5);
  CHECK(form[0] == Approx(form[2]));
  CHECK(form[1] == Approx(0).margin(1e-12));
}

TEST_CASE("local forms: a crossing's form is a multiple of alpha beta", "[filter]") {
  const auto forms = forms_in_the_middle(a * a + Terms{{{0, 0}, 3}} * a * b + Terms{{{0, 0}, -5}} * b * b);
  REQUIRE(forms);
  CHECK(forms->crossing);
  const auto form = in_directions(*forms, 1, 3, -5);
  CHECK(form[0] == Approx(0).margin(1e-12));
  CHECK(form[2] == Approx(0).margin(1e-12));
  CHECK(std::fabs(form[1]) > 0.1);
}

TEST_CASE("local forms: none of degenerate forms, of regular points and beside the surface", "[filter]") {
  CHECK_FALSE(forms_in_the_middle(a * a));
  CHECK_FALSE(forms_in_the_middle(a * a + Terms{{{0, 0}, -2}} * a * b + b * b));
  CHECK_FALSE(forms_in_the_middle(a + b * b));
  CHECK_FALSE(forms_in_the_middle(a * a + b * b + Terms{{{0, 0}, power_of_two(-200)}}));
}

}  // namespace exsect::local_forms_test
