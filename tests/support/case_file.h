// Exact cases as data: <name>.json, a patch file, and <name>.expected.json beside it, the exact answer.
#pragma once

#include <string>

#include "support/exact_case.h"

namespace exsect {

/// The name in small letters with hyphens.
std::string case_stem(const ExactCase& c);

/// The patch file x, y.
std::string patches_text(const ExactCase& c);
/// {"case", "turning", "nodes": [{"at": [NUMBER, ...], "kind", "wrt", "free"}], "arcs": [{"from", "to", "on",
/// "contact", "samples"}], "overlaps": [[[arc, ...], ...], ...]} with NUMBER a rational "p/q" or {"root_of":
/// [coefficients, constant term first], "between": ["lower", "upper"]}, the one root there.
std::string expected_text(const ExactCase& c);

/// From the two texts.
ExactCase parse_case(const std::string& patches, const std::string& expected);
/// From the file <stem>.json and <stem>.expected.json in the same directory.
ExactCase read_case(const std::string& path);

}  // namespace exsect
