// What is found about implicit equations, as text for a terminal.
#pragma once

#include <string>
#include <vector>

#include "output/text/implicit_json.h"

namespace exsect::cli {

/// "proved" and "not proved", one statement a line.
std::string statements_text(const std::vector<Proved>& proved, const std::vector<NotProved>& not_proved);

/// "f = ...", broken into lines between terms.
std::string equation_text(const std::string& name, const PolynomialTerms& polynomial);

/// "least-squares of degree 3: within 0.00665 of the curve": the line under a picture's title.
std::string planar_subtitle(const PlanarImplicit& implicit, const PlanarOptions& options);

std::string planar_implicit_summary(const PlanarImplicit& implicit, const PlanarOptions& options,
                                    const std::vector<std::string>& variables);

}  // namespace exsect::cli
