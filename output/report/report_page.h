// One self-contained HTML page around a JSON object.
#pragma once

#include <string>

#include "output/text/json_forms.h"

namespace exsect::cli {

/// The page of output/report/ with the given data, which its script shows: one file without any reference to
/// another, and a Content-Security-Policy that allows no request and no script or style but its own, by their
/// hashes. The title and every string of the data may hold any characters; bytes that are not UTF-8 become
/// U+FFFD.
///
/// What report_words.h says of the data stands in the HTML, and so does the picture, an SVG document, if it
/// is not empty: both are read without a script.
std::string report_page(const std::string& title, const Json& data, const std::string& picture = "");

}  // namespace exsect::cli
