#include "output/text/implicit_summary.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr std::size_t line_width = 110;

std::string value_text(const Rational& value) {
  const std::string exact = to_string(value);
  return exact.size() <= 12 ? exact : rounded_up(double_not_below(value));
}

/// "t in [0.25, 0.5]" and so on for every key.
std::string where_text(const Json& where) {
  std::vector<std::string> parts;
  for (const auto& [key, interval] : where.items())
    parts.push_back(fmt::format("{} in [{:.6g}, {:.6g}]", key,
                                to_double(parse_number(interval[0].get<std::string>())),
                                to_double(parse_number(interval[1].get<std::string>()))));
  return joined(parts, ", ");
}

std::string times(int power) {
  return power == 1 ? "once" : power == 2 ? "twice" : std::to_string(power) + " times";
}

std::string equation_headline(const PlanarImplicit& implicit, const PlanarOptions& options) {
  std::string text;
  if (options.method == PlanarMethod::exact)
    return fmt::format("exact equation of degree {}; the parametrisation runs through the curve {}\n",
                       implicit.exact_degree, times(implicit.power));
  if (implicit.is_exact)
    return fmt::format("{}: the rank shows that the space holds the exact equation, of degree {}\n",
                       name(options.method), implicit.exact_degree);
  text = fmt::format("{}, {} functions ({}, degree {}), an equation is exact from degree {} on\n",
                     name(options.method), implicit.dimension, name(options.space), options.degree,
                     implicit.exact_degree);
  if (options.degree >= implicit.exact_degree)
    text +=
        fmt::format("  this is a fit; the curve has an exact equation of degree {}, found without --degree\n",
                    implicit.exact_degree);
  if (implicit.singular_value)
    text += fmt::format("  least singular value {:.3g}\n", *implicit.singular_value);
  if (!implicit.is_unique) text += "  the samples leave some coefficients open: other fits are as good\n";
  if (implicit.digits) text += fmt::format("  coefficients rounded to {} decimals\n", *implicit.digits);
  return text;
}

}  // namespace

std::string statements_text(const std::vector<Proved>& proved, const std::vector<NotProved>& not_proved) {
  std::string text;
  for (const Proved& statement : proved)
    text +=
        fmt::format("  proved      {}: {}\n",
                    statement.value ? statement.name + " " + value_text(*statement.value) : statement.name,
                    statement.statement);
  for (const NotProved& statement : not_proved)
    text += fmt::format("  not proved  {}: {} ({})\n", statement.name, statement.why,
                        where_text(statement.where));
  return text;
}

std::string equation_text(const std::string& name, const PolynomialTerms& polynomial) {
  std::string text = "  " + name + " = ";
  std::size_t used = text.size();
  std::string term;
  const auto flush = [&] {
    if (used + term.size() > line_width && used > name.size() + 5) {
      text += "\n" + std::string(name.size() + 5, ' ');
      used = name.size() + 5;
    }
    text += term;
    used += term.size();
    term.clear();
  };
  for (const char c : to_text(polynomial)) {
    if ((c == '+' || c == '-') && !term.empty()) flush();
    term += c;
  }
  flush();
  return text + "\n";
}

std::string planar_subtitle(const PlanarImplicit& implicit, const PlanarOptions& options) {
  if (implicit.is_exact) return fmt::format("exact equation of degree {}", implicit.exact_degree);
  const auto& distance = implicit.bounds.one_sided.distance;
  return fmt::format("{} of degree {}: {}", name(options.method), options.degree,
                     distance ? "one-sided distance at most " + value_text(*distance) : "no distance proved");
}

std::string planar_implicit_summary(const PlanarImplicit& implicit, const PlanarOptions& options,
                                    const std::vector<std::string>& variables) {
  const PlanarStatements known = statements(implicit, variables);
  std::string text = equation_headline(implicit, options);
  if (implicit.function.is_polynomial())
    text += equation_text("f", terms_of(implicit.function.polynomial(), variables[0], variables[1]));
  else
    text += fmt::format("  f is a spline; --json writes its polynomials\n");
  return text + statements_text(known.proved, known.not_proved);
}

}  // namespace exsect::cli
