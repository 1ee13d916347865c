#include "output/options/revolve_options.h"

#include <array>
#include <optional>

#include "output/options/implicitize_options.h"
#include "output/options/option_values.h"

namespace exsect::cli {

namespace {

RevolutionMethod method(const std::string& text) {
  if (text.empty()) throw UsageError("--method: one of elimination, product, substitution is needed");
  constexpr std::array<RevolutionMethod, 3> methods = {
      RevolutionMethod::elimination, RevolutionMethod::product, RevolutionMethod::substitution};
  return methods[choice("--method", text, {"elimination", "product", "substitution"})];
}

/// "m" or "mxn".
std::array<std::optional<int>, 2> pair_of_integers(const std::string& option, const std::string& text,
                                                   int least, int most) {
  if (text.empty()) return {};
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return {integer_value(option, text, least, most), std::nullopt};
  return {integer_value(option, text.substr(0, cross), least, most),
          integer_value(option, text.substr(cross + 1), least, most)};
}

}  // namespace

RevolveOptions revolve_options(const RevolveCommand& command) {
  RevolveOptions result;
  result.method = method(command.method);
  const auto degree = pair_of_integers("--degree", command.degree, 1, 10);
  result.degree = degree[0];
  result.degree_z = degree[1];
  const auto cells = pair_of_integers("--cells", command.cells, 1, 64);
  if (cells[0]) result.cells = std::array<int, 2>{*cells[0], cells[1].value_or(*cells[0])};
  result.samples = integer_value("--samples", command.samples, 2, 10000);
  result.weights = {number_value("--w1", command.w1), number_value("--w2", command.w2)};
  if (!command.region.empty()) {
    const std::vector<Rational> region = number_list("--region", command.region, 3);
    result.region = Rectangle{{0, region[0]}, {region[1], region[2]}};
  }
  return result;
}

ShownRevolutionPatch shown_on_patch(const std::vector<std::string>& lines, const Revolution& revolution,
                                    const NamedPatch& patch) {
  if (!revolution.profile.is_polynomial()) throw UsageError("--patch-file: not for splines");
  const BivariatePolynomial& f = revolution.profile.polynomial();
  ShownRevolutionPatch shown{patch.name, patch.patch, intersect_revolution(f, patch.patch), {}};
  for (const std::string& text : lines) {
    const Rational u = parameter_value("--u", text);
    shown.lines.push_back({u, points_on_line(f, patch.patch, u)});
  }
  return shown;
}

}  // namespace exsect::cli
