// The JSON forms of implicit equations, form "implicit/1" (docs/formats.md).
#pragma once

#include <exsect/geometry/polynomial_terms.h>
#include <exsect/implicit/implicitize_curve.h>

#include <string>
#include <vector>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// A proved statement about an equation. The value, if there is one, is a number that the statement speaks
/// of.
struct Proved {
  std::string name;  // "one-sided", ...
  std::string statement;
  std::optional<Rational> value;
};

/// A statement that could not be proved, where (an object of intervals), and why.
struct NotProved {
  std::string name;
  Json where;
  std::string why;
};

/// What can be said of the distance between a planar curve and its implicit function.
struct PlanarStatements {
  std::vector<Proved> proved;
  std::vector<NotProved> not_proved;

  /// The distance of the curve from the zero set is bounded.
  bool is_complete() const;
};
PlanarStatements statements(const PlanarImplicit& implicit,
                            const std::vector<std::string>& variables = {"x", "y"});

/// {"name": .., "degree": .., "degrees": [..], "text": "..", "terms": [["p/q", [i, j]], ...]}.
Json equation_json(const std::string& name, const PolynomialTerms& polynomial);
/// [{"name": .., "statement": .., "value": "p/q", "approx": ..}, ...]; approx is not below value.
Json proved_json(const std::vector<Proved>& proved);
/// [{"name": .., "where": {..}, "why": ".."}, ...].
Json not_proved_json(const std::vector<NotProved>& not_proved);
/// {"x": ["lower", "upper"], "y": [..]} with the names of the variables.
Json planar_box_json(const PlanarBox& box, const std::vector<std::string>& variables);

/// The whole result for a planar curve, in two variables.
Json planar_implicit_json(const PlanarImplicit& implicit, const PlanarOptions& options,
                          const std::vector<std::string>& variables);

/// The double nearest to q >= 0 that is not below it; infinite beyond the range of doubles.
double double_not_below(const Rational& q);

}  // namespace exsect::cli
