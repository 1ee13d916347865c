// The files of output/report/ that make up a page; embed.cmake writes their content into the program.
#pragma once

#include <string_view>

namespace exsect::cli {

/// Text without carriage returns, and its SHA-256 in hexadecimal.
struct ReportAsset {
  std::string_view text;
  std::string_view sha256;
};

extern const ReportAsset report_template;  // page.html
extern const ReportAsset report_style;     // page.css
extern const ReportAsset report_three;     // three.js, bundled
extern const ReportAsset report_script;    // the scripts, one after the other

}  // namespace exsect::cli
