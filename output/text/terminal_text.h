// Text forms of the summaries on the terminal.
#pragma once

#include <exsect/solver/parameter.h>

#include <string>
#include <vector>

#include "output/text/parameter_names.h"

namespace exsect::cli {

/// The text with everything that can steer a terminal or reorder its text replaced by a blank: control
/// characters, the marks, embeddings, overrides and isolates of bidirectional text, line and paragraph
/// separators, and bytes that are no UTF-8.
std::string printable(const std::string& text);

/// Three significant digits, never below x: the decimal is at least x. Requires x >= 0.
std::string rounded_up(double x);
/// The numbers with `separator` between them; "-" for none.
std::string joined(const std::vector<std::string>& texts, const std::string& separator);
/// "[0.25, 0.5]": the ends rounded outwards to six digits.
std::string interval_text(const RationalInterval& interval);
/// "u in [0.25, 0.5], ...".
std::string box_text(const ParameterBox& box, const ParameterNames& names = pair_names);
/// "1 point", "2 points".
std::string counted(std::size_t number, const std::string& noun);

/// "file: title", or "file" without a title, on a line of its own.
std::string heading(const std::string& file, const std::string& title);

/// Rows of equally many cells under a row of heads, columns aligned left and separated by two blanks, each
/// line indented by two; empty without rows.
std::string table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows);

}  // namespace exsect::cli
