#include "output/report/report_page.h"

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string_view>

#include "output/report/report_assets.h"
#include "output/report/report_words.h"

namespace exsect::cli {
namespace {

unsigned digit_value(char digit) {
  return static_cast<unsigned>(digit >= 'a' ? digit - 'a' + 10 : digit - '0');
}

/// The Base64 form of bytes in lower-case hexadecimal.
std::string base64_of_hexadecimal(std::string_view hexadecimal) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char digit : hexadecimal) {
    bits = (bits << 4) | digit_value(digit);
    count += 4;
    if (count < 6) continue;
    count -= 6;
    result += digits[(bits >> count) & 63];
  }
  if (count > 0) result += digits[(bits << (6 - count)) & 63];
  while (result.size() % 4 != 0) result += '=';
  return result;
}

std::string source(const ReportAsset& asset) {
  return "'sha256-" + base64_of_hexadecimal(asset.sha256) + "'";
}

std::string policy() {
  return "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; style-src " +
         source(report_style) + "; script-src " + source(report_three) + " " + source(report_script);
}

/// Text in UTF-8 as it stands between the tags of an element.
std::string html_escaped(const std::string& text) {
  const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string html;
  for (const char c : Json::parse(quoted).get<std::string>()) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

/// JSON in a script element: no "<" of a string can end the element or open a comment.
std::string script_data(const Json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::string counts_html(const ReportWords& words) {
  std::string html;
  for (const auto& [name, value] : words.counts)
    html += "<div><dt>" + html_escaped(name) + "</dt><dd>" + html_escaped(value) + "</dd></div>";
  return html;
}

/// An SVG document as an element of the page, without the XML declaration; its text is escaped already.
std::string picture_html(const std::string& svg) {
  const std::size_t begin = svg.find("<svg");
  if (begin == std::string::npos) return "";
  return "<figure id=\"still\"><div class=\"picture\">" + svg.substr(begin) + "</div></figure>";
}

/// The template with every {{name}} replaced; what is put in is not looked at again.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& values) {
  std::string result;
  for (;;) {
    const std::size_t open = page.find("{{");
    if (open == std::string_view::npos) return result += page;
    const std::size_t close = page.find("}}", open);
    if (close == std::string_view::npos) throw std::invalid_argument("page.html: \"{{\" is not closed");
    result += page.substr(0, open);
    result += values.at(page.substr(open + 2, close - open - 2));
    page.remove_prefix(close + 2);
  }
}

}  // namespace

std::string report_page(const std::string& title, const Json& data, const std::string& picture) {
  const ReportWords words = report_words(data);
  return filled(report_template.text, {{"policy", policy()},
                                       {"title", html_escaped(title)},
                                       {"origin", html_escaped(words.origin)},
                                       {"grade", words.good ? "complete" : "incomplete"},
                                       {"verdict", html_escaped(words.verdict)},
                                       {"answer", html_escaped(words.answer)},
                                       {"counts", counts_html(words)},
                                       {"picture", picture_html(picture)},
                                       {"style", std::string(report_style.text)},
                                       {"data", script_data(data)},
                                       {"three", std::string(report_three.text)},
                                       {"script", std::string(report_script.text)}});
}

}  // namespace exsect::cli
