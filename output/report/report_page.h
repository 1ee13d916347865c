// One self-contained HTML page around a JSON object.
#pragma once

#include <string>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// The page of cli/report/ with the given data, which its script shows: one file without any reference to
/// another, and a Content-Security-Policy that allows no request and no script or style but its own, by their
/// hashes. The title and every string of the data may hold any characters; bytes that are not UTF-8 become
/// U+FFFD.
std::string report_page(const std::string& title, const Json& data);

}  // namespace exsect::cli
