#include "candidate_file.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

#include "candidate_json.h"
#include "json_tree.h"
#include "number.h"

namespace exsect {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t at = line.find(separator);
    cells.push_back(trimmed(line.substr(0, at)));
    if (at == std::string_view::npos) return cells;
    line.remove_prefix(at + 1);
  }
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (;;) {
    line = trimmed(line);
    if (line.empty()) return result;
    std::size_t length = 0;
    while (length < line.size() && !is_blank(line[length])) ++length;
    result.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

/// The lines of a text file, and messages that name one.
class Lines {
 public:
  Lines(const std::string& text, const std::string& file) : file_(file) {
    std::string_view rest = text;
    while (!rest.empty()) {
      const std::size_t end = rest.find('\n');
      lines_.push_back(rest.substr(0, end));
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
  }

  std::size_t size() const { return lines_.size(); }
  std::string_view operator[](std::size_t i) const { return lines_[i]; }

  [[noreturn]] void fail(std::size_t line, const std::string& reason) const {
    throw InputError(file_, "line " + std::to_string(line + 1), reason);
  }
  [[noreturn]] void fail_at_end(const std::string& reason) const { throw InputError(file_, "", reason); }

  double number(std::size_t line, std::string_view text) const {
    try {
      const double value = to_double(parse_binary64(text));
      if (!(std::fabs(value) <= max_candidate_number)) fail(line, "a number beyond 2^500");
      return value;
    } catch (const std::invalid_argument& error) {
      fail(line, error.what());
    }
  }

  double parameter(std::size_t line, std::string_view text) const {
    const double value = number(line, text);
    if (!(value >= -1 && value <= 2)) fail(line, "a parameter must be in [-1,2]");
    return value;
  }

  /// A whole number of at most nine digits, with a sign if `is_signed`.
  long whole(std::size_t line, std::string_view text, bool is_signed) const {
    std::string_view digits = text;
    const bool negative = is_signed && !digits.empty() && digits.front() == '-';
    if (negative) digits.remove_prefix(1);
    const bool fine = !digits.empty() && digits.size() <= 9 &&
                      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!fine) fail(line, "\"" + printable(text) + "\" is not a whole number");
    const long value = std::stol(std::string(digits));
    return negative ? -value : value;
  }

 private:
  const std::string& file_;
  std::vector<std::string_view> lines_;
};

// CSV

/// One row: what of x, y, z, u, v, r, s the columns give.
struct TableRow {
  std::string curve;
  std::array<double, 7> values;
};

class CsvReader {
 public:
  CsvReader(const std::string& text, const std::string& file) : lines_(text, file) {}

  Candidate operator()() {
    read_head();
    std::vector<TableRow> block;
    for (std::size_t i = head_ + 1; i < lines_.size(); ++i) {
      if (trimmed(lines_[i]).empty()) {
        finish(block);
        continue;
      }
      TableRow row = read_row(i);
      if (!block.empty() && block.back().curve != row.curve) finish(block);
      block.push_back(std::move(row));
    }
    finish(block);
    return std::move(candidate_);
  }

 private:
  static constexpr std::array<std::string_view, 7> names = {"x", "y", "z", "u", "v", "r", "s"};

  void read_head() {
    while (head_ < lines_.size() && trimmed(lines_[head_]).empty()) ++head_;
    if (head_ == lines_.size()) lines_.fail_at_end("a first line with the names of the columns is missing");
    std::set<std::string_view> seen;
    for (const std::string_view name : split(lines_[head_], ',')) {
      const auto it = std::find(names.begin(), names.end(), name);
      if (it == names.end() && name != "curve")
        lines_.fail(head_,
                    "unknown column \"" + printable(name) + "\", must be curve, x, y, z, u, v, r or s");
      if (!seen.insert(name).second) lines_.fail(head_, "column \"" + std::string(name) + "\" occurs twice");
      columns_.push_back(static_cast<std::size_t>(it - names.begin()));
    }
    const auto count = [&](std::initializer_list<std::string_view> of) {
      return std::count_if(of.begin(), of.end(), [&](std::string_view name) { return seen.contains(name); });
    };
    if (count({"x", "y", "z"}) % 3 != 0) lines_.fail(head_, "x, y and z must be there together");
    if (count({"u", "v"}) == 1) lines_.fail(head_, "u and v must be there together");
    if (count({"r", "s"}) == 1) lines_.fail(head_, "r and s must be there together");
    space_ = seen.contains("x");
    first_ = seen.contains("u");
    second_ = seen.contains("r");
    if (!space_ && !first_ && !second_) lines_.fail(head_, "no coordinates: x,y,z, u,v or r,s are needed");
  }

  TableRow read_row(std::size_t line) const {
    const auto cells = split(lines_[line], ',');
    if (cells.size() != columns_.size())
      lines_.fail(line, "has " + std::to_string(cells.size()) + " cells, must have " +
                            std::to_string(columns_.size()));
    TableRow row{"", {}};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns_[i] == names.size())
        row.curve = cells[i];
      else
        row.values[columns_[i]] =
            columns_[i] < 3 ? lines_.number(line, cells[i]) : lines_.parameter(line, cells[i]);
    }
    return row;
  }

  /// A block of one row is an isolated point.
  void finish(std::vector<TableRow>& block) {
    if (block.size() == 1) {
      const auto& v = block[0].values;
      CandidatePoint point;
      if (space_) point.point = {v[0], v[1], v[2]};
      if (first_) point.first = {v[3], v[4]};
      if (second_) point.second = {v[5], v[6]};
      candidate_.points.push_back(point);
    } else if (!block.empty()) {
      const auto line = [&](std::size_t at, std::size_t dimension) {
        std::vector<std::array<double, 3>> vertices;
        for (const TableRow& row : block)
          vertices.push_back({row.values[at], row.values[at + 1], dimension == 3 ? row.values[at + 2] : 0});
        return polyline(std::move(vertices));
      };
      CandidateCurve curve;
      if (space_) curve.space = line(0, 3);
      if (first_) curve.first = line(3, 2);
      if (second_) curve.second = line(5, 2);
      candidate_.curves.push_back(std::move(curve));
    }
    block.clear();
  }

  Lines lines_;
  std::size_t head_ = 0;
  std::vector<std::size_t> columns_;
  bool space_ = false;
  bool first_ = false;
  bool second_ = false;
  Candidate candidate_;
};

// Wavefront OBJ

class ObjReader {
 public:
  ObjReader(const std::string& text, const std::string& file) : lines_(text, file) {}

  /// A point element at the vertex of a line is no isolated point.
  Candidate operator()() {
    for (std::size_t i = 0; i < lines_.size(); ++i) read_line(i);
    if (vertices_.empty()) lines_.fail_at_end("holds no vertex");
    for (const std::array<double, 3>& point : points_)
      if (!on_lines_.contains(point)) candidate_.points.push_back({point, {}, {}});
    return std::move(candidate_);
  }

 private:
  void read_line(std::size_t i) {
    const auto parts = words(lines_[i]);
    if (parts.empty() || parts[0].front() == '#') return;
    if (parts[0] == "v") {
      if (parts.size() < 4 || parts.size() > 8) lines_.fail(i, "a vertex must have 3 coordinates");
      vertices_.push_back(
          {lines_.number(i, parts[1]), lines_.number(i, parts[2]), lines_.number(i, parts[3])});
    } else if (parts[0] == "l") {
      if (parts.size() < 3) lines_.fail(i, "a line must have at least 2 vertices");
      std::vector<std::array<double, 3>> vertices;
      for (std::size_t k = 1; k < parts.size(); ++k) vertices.push_back(vertex(i, parts[k]));
      on_lines_.insert(vertices.begin(), vertices.end());
      candidate_.curves.push_back({polyline(std::move(vertices)), {}, {}, false, {}});
    } else if (parts[0] == "p") {
      if (parts.size() < 2) lines_.fail(i, "a point must have a vertex");
      for (std::size_t k = 1; k < parts.size(); ++k) points_.push_back(vertex(i, parts[k]));
    } else {
      const std::set<std::string_view> ignored = {"vt", "vn", "vp",     "f",      "o",
                                                  "g",  "s",  "usemtl", "mtllib", "mg"};
      if (!ignored.contains(parts[0])) lines_.fail(i, "unknown element \"" + printable(parts[0]) + "\"");
    }
  }

  std::array<double, 3> vertex(std::size_t line, std::string_view text) const {
    const long index = lines_.whole(line, text.substr(0, text.find('/')), true);
    const auto count = static_cast<long>(vertices_.size());
    const long at = index < 0 ? count + index : index - 1;
    if (index == 0 || at < 0 || at >= count)
      lines_.fail(line, "vertex " + std::to_string(index) + " does not exist before this line");
    return vertices_[static_cast<std::size_t>(at)];
  }

  Lines lines_;
  std::vector<std::array<double, 3>> vertices_;
  std::vector<std::array<double, 3>> points_;
  std::set<std::array<double, 3>> on_lines_;
  Candidate candidate_;
};

// GoTools g2

class G2Reader {
 public:
  G2Reader(const std::string& text, const std::string& file) : lines_(text, file) {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (const std::string_view word : words(lines_[i])) tokens_.push_back({i, word});
  }

  Candidate operator()() {
    if (tokens_.empty()) lines_.fail_at_end("holds nothing");
    while (at_ < tokens_.size()) {
      const std::size_t line = tokens_[at_].line;
      const long type = whole("a class type");
      whole("a major version");
      whole("a minor version");
      for (long extra = whole("the size of further data"); extra > 0; --extra) whole("further data");
      if (type == 100)
        read_curve(line);
      else if (type == 400)
        read_points(line);
      else
        lines_.fail(line,
                    "class type " + std::to_string(type) + ", must be 100 (SplineCurve) or 400 (PointCloud)");
    }
    return std::move(candidate_);
  }

 private:
  struct Token {
    std::size_t line;
    std::string_view text;
  };

  const Token& next(const char* what) {
    if (at_ == tokens_.size()) lines_.fail_at_end("ends where " + std::string(what) + " is expected");
    return tokens_[at_++];
  }
  long whole(const char* what) {
    const Token& token = next(what);
    return lines_.whole(token.line, token.text, false);
  }
  double number(const char* what) {
    const Token& token = next(what);
    return lines_.number(token.line, token.text);
  }

  /// dimension, rational; number of points, order; knots; points, homogeneous if rational. Dimension 2 means
  /// (u,v), 3 space, 4 (u,v,r,s).
  void read_curve(std::size_t line) {
    const long dimension = whole("the dimension");
    const long rational = whole("a flag");
    if (dimension < 2 || dimension > 4 || rational > 1)
      lines_.fail(line, "a curve must have the dimension 2, 3 or 4 and the flag 0 or 1");
    const long count = whole("the number of points");
    const long order = whole("the order");
    if (order < 2 || order > max_spline_degree + 1 || count < order || count > 10000000)
      lines_.fail(line, "a curve must have an order from 2 to " + std::to_string(max_spline_degree + 1) +
                            " and at least as many points");
    std::vector<double> knots;
    for (long i = 0; i < count + order; ++i) knots.push_back(number("a knot"));
    std::array<SplineCurve, 2> curves = {SplineCurve{static_cast<int>(order) - 1, knots, {}, {}},
                                         SplineCurve{static_cast<int>(order) - 1, knots, {}, {}}};
    for (long i = 0; i < count; ++i) {
      std::array<double, 4> point = {0, 0, 0, 0};
      for (long k = 0; k < dimension; ++k) point[static_cast<std::size_t>(k)] = number("a coordinate");
      const double weight = rational == 1 ? number("a weight") : 1;
      if (!(weight > 0)) lines_.fail(line, "a weight must be > 0");
      for (double& c : point) c /= weight;
      curves[0].points.push_back({point[0], point[1], dimension == 3 ? point[2] : 0});
      curves[1].points.push_back({point[2], point[3], 0});
      for (SplineCurve& curve : curves)
        if (rational == 1) curve.weights.push_back(weight);
      for (long k = 0; dimension != 3 && k < dimension; ++k)
        if (!(point[static_cast<std::size_t>(k)] >= -1 && point[static_cast<std::size_t>(k)] <= 2))
          lines_.fail(line, "a parameter must be in [-1,2]");
    }
    const std::string wrong = violation(curves[0]);
    if (!wrong.empty()) lines_.fail(line, wrong);
    CandidateCurve curve;
    (dimension == 3 ? curve.space : curve.first) = curves[0];
    if (dimension == 4) curve.second = curves[1];
    candidate_.curves.push_back(std::move(curve));
  }

  void read_points(std::size_t line) {
    const long count = whole("the number of points");
    if (count > 1000000) lines_.fail(line, "more than 1000000 points");
    for (long i = 0; i < count; ++i) {
      CandidatePoint point;
      point.point.emplace();
      for (double& c : *point.point) c = number("a coordinate");
      candidate_.points.push_back(point);
    }
  }

  Lines lines_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  Candidate candidate_;
};

}  // namespace

CandidateFormat candidate_format(const std::string& filename) {
  const std::size_t dot = filename.rfind('.');
  std::string end = dot == std::string::npos ? "" : filename.substr(dot);
  for (char& c : end)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (end == ".json") return CandidateFormat::json;
  if (end == ".csv") return CandidateFormat::csv;
  if (end == ".obj") return CandidateFormat::obj;
  if (end == ".g2") return CandidateFormat::g2;
  throw InputError(filename, "", "the name of a candidate must end in .json, .csv, .obj or .g2");
}

Candidate parse_candidate(const std::string& text, const std::string& filename, CandidateFormat format) {
  return in_nearest_rounding([&]() -> Candidate {
    if (text.size() > max_candidate_file_bytes)
      throw InputError(filename, "", "longer than " + std::to_string(max_candidate_file_bytes) + " bytes");
    switch (format) {
      case CandidateFormat::json:
        return parse_json_candidate(text, filename);
      case CandidateFormat::csv:
        return CsvReader(text, filename)();
      case CandidateFormat::obj:
        return ObjReader(text, filename)();
      case CandidateFormat::g2:
        return G2Reader(text, filename)();
    }
    throw std::invalid_argument("unknown format of a candidate");
  });
}

Candidate read_candidate(const std::string& path) {
  const CandidateFormat format = candidate_format(path);
  return parse_candidate(read_text_file(path, max_candidate_file_bytes), path, format);
}

}  // namespace exsect
