#include "output/drawing/svg_legend.h"

#include <algorithm>

namespace exsect::cli {
namespace {

constexpr double text_size = 13;
constexpr double entry_height = 20;
constexpr double key_width = 34;
constexpr double entry_gap = 16;

}  // namespace

std::size_t SvgLegend::columns(double width) const {
  double widest = 1;
  for (const Entry& entry : entries_)
    widest = std::max(widest, key_width + text_width(entry.text, text_size) + entry_gap);
  return std::max<std::size_t>(1, static_cast<std::size_t>(width / widest));
}

double SvgLegend::height(double width) const {
  const std::size_t rows = (entries_.size() + columns(width) - 1) / columns(width);
  return entry_height * static_cast<double>(rows);
}

void SvgLegend::draw(SvgPicture& picture, double left, double top, double width) const {
  const std::size_t count = columns(width);
  const std::size_t rows = (entries_.size() + count - 1) / count;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    const double x = left + width / static_cast<double>(count) * static_cast<double>(i / rows);
    const double y = top + entry_height * (static_cast<double>(i % rows) + 0.5);
    if (entry.mark) {
      picture.mark(*entry.mark, x + 13, y, entry.stroke.colour);
    } else {
      picture.line(x, y, x + 26, y, entry.stroke);
    }
    picture.element("<g fill=\"#202020\">");
    picture.text(x + key_width, y + 4.5, entry.text, text_size, TextAnchor::start);
    picture.element("</g>");
  }
}

}  // namespace exsect::cli
