#include "output/drawing/svg_picture.h"

#include <fmt/format.h>

#include <array>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

std::string escaped(const std::string& text) {
  std::string xml;
  for (char c : printable(text)) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

}  // namespace

std::string palette(std::size_t i) {
  static const std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#e69f00", "#56b4e9", "#000000"};
  return colours[i % colours.size()];
}

double text_width(const std::string& text, double size) {
  double characters = 0;
  for (char byte : text) characters += starts_character(byte) ? 1 : 0;
  return 0.54 * size * characters;
}

std::string fitted(const std::string& text, double size, double width) {
  if (text_width(text, size) <= width) return text;
  std::string shorter = text;
  while (!shorter.empty() && text_width(shorter + ".", size) > width) {
    while (!shorter.empty() && !starts_character(shorter.back())) shorter.pop_back();
    if (!shorter.empty()) shorter.pop_back();
  }
  return shorter + "\u2026";
}

void SvgPicture::text(double x, double y, const std::string& content, double size, TextAnchor anchor,
                      bool italic) {
  const char* place = anchor == TextAnchor::start ? "start" : anchor == TextAnchor::middle ? "middle" : "end";
  element(fmt::format(R"(<text x="{:.2f}" y="{:.2f}" font-size="{}" text-anchor="{}"{}>{}</text>)", x, y,
                      size, place, italic ? R"( font-style="italic")" : "", escaped(content)));
}

std::string attributes(const Stroke& stroke) {
  return fmt::format(R"(stroke="{}" stroke-width="{}"{}{})", stroke.colour, stroke.width,
                     stroke.dashes.empty() ? "" : fmt::format(R"( stroke-dasharray="{}")", stroke.dashes),
                     stroke.width > 4 ? R"( stroke-linecap="butt")" : "");
}

void SvgPicture::line(double x1, double y1, double x2, double y2, const Stroke& stroke) {
  element(fmt::format(R"(<path d="M{:.2f},{:.2f}L{:.2f},{:.2f}" {}/>)", x1, y1, x2, y2, attributes(stroke)));
}

void SvgPicture::mark(Mark mark, double x, double y, const std::string& colour) {
  const auto filled = [&](const std::string& path) {
    element(
        fmt::format(R"svg(<path transform="translate({:.2f},{:.2f})" d="{}" fill="{}" stroke="#ffffff"/>)svg",
                    x, y, path, colour));
  };
  const auto stroked = [&](const std::string& path) {
    element(fmt::format(
        R"svg(<path transform="translate({:.2f},{:.2f})" d="{}" stroke="{}" stroke-width="2.2"/>)svg", x, y,
        path, colour));
  };
  switch (mark) {
    case Mark::square:
      return filled("M-4.5,-4.5H4.5V4.5H-4.5Z");
    case Mark::diamond:
      return filled("M0,-6.5L6.5,0L0,6.5L-6.5,0Z");
    case Mark::triangle:
      return filled("M0,-6.5L6,4.5H-6Z");
    case Mark::plus:
      return stroked("M-6,0H6M0,-6V6");
    case Mark::cross:
      return stroked("M-5,-5L5,5M-5,5L5,-5");
    case Mark::ring:
      return element(fmt::format(
          R"(<circle cx="{:.2f}" cy="{:.2f}" r="4.2" fill="#ffffff" stroke="{}" stroke-width="1.8"/>)", x, y,
          colour));
    case Mark::point:
      return element(fmt::format(R"(<circle cx="{:.2f}" cy="{:.2f}" r="2.8" fill="{}"/>)", x, y, colour));
    case Mark::dot:
      return element(
          fmt::format(R"(<circle cx="{:.2f}" cy="{:.2f}" r="4" fill="{}" stroke="#ffffff"/>)", x, y, colour));
  }
}

std::string SvgPicture::document() const {
  // 882 units, two parameter squares, become 174 mm, the width of a page of print: text is 6.7 points or
  // more.
  constexpr double millimetres = 174.0 / 882;
  return fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{3:.2f}mm" height="{4:.2f}mm" viewBox="0 0 {0} {1}">
<rect width="{0}" height="{1}" fill="#ffffff"/>
<g fill="none" stroke-linecap="round" stroke-linejoin="round" font-family="Helvetica, Arial, 'Liberation Sans', sans-serif">
{2}</g>
</svg>
)",
      width_, height_, body_, millimetres * width_, millimetres * height_);
}

}  // namespace exsect::cli
