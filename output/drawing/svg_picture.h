// A picture as SVG.
#pragma once

#include <string>

namespace exsect::cli {

/// Colours that colour-blind readers can tell apart (Okabe and Ito); they repeat from the eighth on.
std::string palette(std::size_t i);

struct Stroke {
  std::string colour;
  double width = 2;
  std::string dashes = "";  // lengths of strokes and gaps; empty for a solid line
};

/// The SVG attributes of the stroke; a thick one ends flat, others round.
std::string attributes(const Stroke& stroke);

enum class Mark { square, ring, dot, point, diamond, plus, cross, triangle };
enum class TextAnchor { start, middle, end };

/// Width of a text set at the given size, estimated for a common sans-serif face.
double text_width(const std::string& text, double size);
/// The text, or its beginning and an ellipsis, at most `width` wide.
std::string fitted(const std::string& text, double size, double width);

/// Units of 174/882 mm, so that pictures print in a page's width; origin at the top left, white background.
class SvgPicture {
 public:
  SvgPicture(double width, double height) : width_(width), height_(height) {}

  double width() const { return width_; }
  /// Text in UTF-8; characters that XML does not allow become blanks.
  void text(double x, double y, const std::string& content, double size, TextAnchor anchor,
            bool italic = false);
  void line(double x1, double y1, double x2, double y2, const Stroke& stroke);
  void mark(Mark mark, double x, double y, const std::string& colour);
  /// An SVG element, verbatim.
  void element(const std::string& svg) { body_ += svg + "\n"; }
  /// The whole document.
  std::string document() const;

 private:
  double width_;
  double height_;
  std::string body_;
};

}  // namespace exsect::cli
