#include "output/text/patch_implicit_output.h"

#include <exsect/geometry/implicit_patch.h>
#include <fmt/format.h>

#include "output/text/implicit_summary.h"

namespace exsect::cli {
namespace {

std::string method_name(const PatchOptions& options) { return options.fit ? name(*options.fit) : "exact"; }

}  // namespace

PatchImplicit implicitize_patch(const BezierPatch& patch, const PatchOptions& options) {
  const Proved exact = {"exact", "the equation vanishes on the patch", std::nullopt};
  if (!options.fit) return {implicit_equation(patch), {exact}, {}, {}, {}};
  ApproximateEquation found = approximate_equation(patch, options.degree, *options.fit);
  std::vector<Proved> proved;
  if (found.bound == 0) proved.push_back(exact);
  proved.push_back({"residual", "|f| is at most this on the patch", found.bound});
  return {std::move(found.equation), std::move(proved), found.singular_value, found.centre, found.unit};
}

std::string patch_implicit_summary(const PatchImplicit& implicit, const PatchOptions& options) {
  std::string text = options.fit ? fmt::format("{}, total degree {}\n", method_name(options), options.degree)
                                 : fmt::format("exact equation of degree {}\n", implicit.equation.degree());
  if (implicit.singular_value)
    text += fmt::format("  least singular value {:.3g}\n", *implicit.singular_value);
  const PolynomialTerms terms = terms_of(implicit.equation);
  constexpr std::size_t most_terms = 60;
  text += terms.terms.size() <= most_terms
              ? equation_text("f", terms)
              : fmt::format("  f has {} terms; --json writes them\n", terms.terms.size());
  return text + statements_text(implicit.proved, {});
}

Json patch_implicit_json(const PatchImplicit& implicit, const PatchOptions& options) {
  const PolynomialTerms terms = terms_of(implicit.equation);
  Json json = {{"exsect", "implicit/1"},
               {"status", "complete"},
               {"kind", "patch"},
               {"method", method_name(options)},
               {"exact", implicit.is_exact()},
               {"variables", terms.variables},
               {"equations", Json::array({equation_json("f", terms)})}};
  if (implicit.singular_value) json["singular_value"] = *implicit.singular_value;
  if (implicit.centre) {
    Json centre = Json::array();
    for (const Rational& coordinate : *implicit.centre) centre.push_back(json_number(coordinate));
    json["coordinates"] = {{"centre", std::move(centre)}, {"unit", json_number(*implicit.unit)}};
  }
  json["proved"] = proved_json(implicit.proved);
  json["not_proved"] = Json::array();
  return json;
}

}  // namespace exsect::cli
