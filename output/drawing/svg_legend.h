// The legend of a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/drawing/svg_picture.h"

namespace exsect::cli {

/// Entries in columns of equal width: a short stroke or a mark, and what it means.
class SvgLegend {
 public:
  void add(const Stroke& stroke, const std::string& text) {
    entries_.push_back({stroke, std::nullopt, text});
  }
  void add(Mark mark, const std::string& colour, const std::string& text) {
    entries_.push_back({Stroke{colour}, mark, text});
  }
  /// Height it takes within the given width.
  double height(double width) const;
  void draw(SvgPicture& picture, double left, double top, double width) const;

 private:
  struct Entry {
    Stroke stroke;
    std::optional<Mark> mark;
    std::string text;
  };
  std::size_t columns(double width) const;

  std::vector<Entry> entries_;
};

}  // namespace exsect::cli
