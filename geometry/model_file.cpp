#include "model_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <optional>
#include <system_error>
#include <unordered_set>

#include "patch_value.h"

namespace exsect {
namespace {

constexpr const char* model_version = "model/1";

struct Line {
  std::uint64_t offset;
  std::uint32_t length;
};

[[noreturn]] void fail_to_read(const std::string& path) {
  throw InputError(path, "", "cannot be read: " + std::generic_category().message(errno));
}

/// The lines of a file, one after the other.
class LineReader {
 public:
  explicit LineReader(const std::string& path)
      : path_(path), file_(std::fopen(path.c_str(), "rb"), std::fclose) {
    if (!file_) throw InputError(path, "", "cannot be opened: " + std::generic_category().message(errno));
  }

  /// The next line without its line feed; false at the end of the file.
  bool next(std::string& text) {
    text.clear();
    place_ = {place_.offset + place_.length, 0};
    ++number_;
    int c = EOF;
    while ((c = std::getc(file_.get())) != EOF) {
      ++place_.length;
      if (c == '\n') return true;
      text.push_back(static_cast<char>(c));
      if (text.size() > max_model_line_bytes)
        throw InputError(name(), "", "line longer than " + std::to_string(max_model_line_bytes) + " bytes");
    }
    if (std::ferror(file_.get()) != 0) fail_to_read(path_);
    return place_.length > 0;
  }

  /// File and number of the last line, from 1.
  std::string name() const { return path_ + ":" + std::to_string(number_); }
  Line place() const { return place_; }

 private:
  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  Line place_ = {0, 0};
  std::size_t number_ = 0;
};

NamedRationalPatch parse_line(const std::string& text, const std::string& name, NumberReader read) {
  const JsonTree tree = parse_json(text, name, max_depth_of_files);
  return read_named_patch(JsonValue(tree, name, "$"), read);
}

/// Reads again what a descriptor holds.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path) : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (number_ < 0) fail_to_read(path);
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  /// False if the file ends before.
  bool read(Line line, std::string& text) const {
    text.resize(line.length);
    for (std::size_t had = 0; had < text.size();) {
      const ssize_t got =
          pread(number_, text.data() + had, text.size() - had, static_cast<off_t>(line.offset + had));
      if (got <= 0) return false;
      had += static_cast<std::size_t>(got);
    }
    return true;
  }

 private:
  int number_;
};

}  // namespace

struct ModelFile::State {
  std::string path;
  std::string title;
  std::vector<NamedRationalPatch> patches;  // of a patches/1
  // Of a model/1:
  NumberReader read = nullptr;
  std::optional<Descriptor> file;
  std::vector<Line> lines;

  /// The header, if the text is one of a model/1.
  bool is_header(const std::string& text, const std::string& name) {
    std::optional<JsonTree> tree;
    try {
      tree = parse_json(text, name, max_depth_of_files);
    } catch (const InputError&) {
      return false;  // a patches/1 over several lines, or nothing known: parse_patches says what is wrong
    }
    const JsonValue root(*tree, name, "$");
    if (tree->kind != JsonTree::Kind::object || !root.has("exsect") ||
        root.member("exsect").string() != model_version)
      return false;
    root.require_object({"exsect", "title", "source", "numbers"});
    if (root.has("title")) title = root.member("title").string();
    if (root.has("source")) root.member("source").string();
    read = number_reader(root);
    return true;
  }

  void read_lines(LineReader& reader, const std::function<void(const NamedRationalPatch&)>& each) {
    file.emplace(path);
    std::unordered_set<std::string> names;
    for (std::string text; reader.next(text);) {
      if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
      const NamedRationalPatch patch = parse_line(text, reader.name(), read);
      if (!names.insert(patch.name).second)
        throw InputError(reader.name(), "$.name",
                         "name \"" + printable(patch.name) + "\" given to two patches");
      lines.push_back(reader.place());
      each(patch);
    }
    if (lines.empty()) throw InputError(path, "", "must hold at least one patch");
  }
};

ModelFile::ModelFile(const std::string& path, const std::function<void(const NamedRationalPatch&)>& each)
    : state_(std::make_unique<State>()) {
  state_->path = path;
  std::string text;
  LineReader reader(path);
  if (reader.next(text) && state_->is_header(text, reader.name())) {
    state_->read_lines(reader, each);
    return;
  }
  RationalPatchFile file = read_rational_patches(path);
  state_->title = file.title;
  state_->patches = std::move(file.patches);
  for (const NamedRationalPatch& patch : state_->patches) each(patch);
}

ModelFile::~ModelFile() = default;
ModelFile::ModelFile(ModelFile&&) noexcept = default;
ModelFile& ModelFile::operator=(ModelFile&&) noexcept = default;

std::size_t ModelFile::size() const { return state_->patches.size() + state_->lines.size(); }

const std::string& ModelFile::title() const { return state_->title; }

NamedRationalPatch ModelFile::patch(std::size_t i) const {
  if (!state_->patches.empty()) return state_->patches.at(i);
  std::string text;
  if (!state_->file->read(state_->lines.at(i), text))
    throw InputError(state_->path, "", "cannot be read again: it was changed");
  return parse_line(text, state_->path, state_->read);
}

}  // namespace exsect
