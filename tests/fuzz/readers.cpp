#include "fuzz/readers.h"

#include <cli/batch/batch_output.h>
#include <cli/batch/tally.h>
#include <exsect/checker/check_certificate.h>
#include <exsect/geometry/bpt_file.h>
#include <exsect/geometry/candidate_file.h>
#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/model_file.h>
#include <exsect/geometry/number.h>
#include <exsect/geometry/patch_file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace exsect::fuzz {
namespace {

const std::string file = "fuzzed";

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

/// A file without a name in memory, which can be opened by its path.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view text) : number_(memfd_create("fuzzed", 0)) {
    if (write(number_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      throw std::runtime_error("no memory for a file");
  }
  ~MemoryFile() { close(number_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(number_); }

 private:
  int number_;
};

/// The number by the given reader; the canonical text must mean the same number.
void read_one_number(Rational (*read)(std::string_view), std::string_view text) {
  Rational value;
  try {
    value = read(text);
  } catch (const std::invalid_argument&) {
    return;
  }
  require(parse_number(to_string(value)) == value, "the canonical text of a number means the number");
}

void read_number(std::string_view text) {
  read_one_number(parse_number, text);
  read_one_number(parse_binary64, text);
}

void require_same_when_written(const RationalPatchFile& patches) {
  require(parse_rational_patches(format_patches(patches), file) == patches,
          "patches are written as they were read");
}

void read_patch_file(std::string_view text) {
  try {
    require_same_when_written(parse_rational_patches(std::string(text), file));
    const PatchFile patches = parse_patches(std::string(text), file);
    require(parse_patches(format_patches(patches), file) == patches,
            "biquadratic patches are written as they were read");
  } catch (const InputError&) {
    return;
  }
}

void read_bpt_file(std::string_view text) {
  try {
    require_same_when_written(parse_bpt(std::string(text), file));
  } catch (const InputError&) {
    return;
  }
}

void read_model(std::string_view text) {
  const MemoryFile model(text);
  try {
    std::size_t count = 0;
    const ModelFile read(model.path(), [&](const NamedRationalPatch&) { ++count; });
    require(count == read.size() && count > 0, "a model tells how many patches it has");
    for (std::size_t i = 0; i < count; ++i) require(!read.patch(i).name.empty(), "a patch is read twice");
  } catch (const InputError&) {
    return;
  }
}

void read_curve_file(std::string_view text) {
  try {
    const CurveFile curve = parse_curve(std::string(text), file);
    require(parse_curve(format_curve(curve), file) == curve, "a curve is written as it was read");
  } catch (const InputError&) {
    return;
  }
}

template <CandidateFormat format>
void read_candidate_file(std::string_view text) {
  try {
    parse_candidate(std::string(text), file, format);
  } catch (const InputError&) {
    return;
  }
}

/// Whatever a certificate claims has to be replayed in full or be refused.
void read_certificate(std::string_view text) {
  try {
    checker::check_certificate(std::string(text));
  } catch (const checker::Unreadable&) {
    return;
  } catch (const checker::Rejected&) {
    return;
  }
}

void read_batch_line(std::string_view text) {
  try {
    cli::Tally tally;
    cli::count_line(text, tally);
    require(tally.lines == 1 && tally.complete + tally.incomplete + tally.failed == 1, "a line counts once");
  } catch (const std::invalid_argument&) {
    return;
  }
}

constexpr std::uint64_t journal_lines = 4;

/// The text is what follows the header in a journal of four lines.
void read_journal(std::string_view text) {
  namespace fs = std::filesystem;
  static const fs::path directory = [] {
    std::string name = "/dev/shm/exsect-journal-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no directory for the journal");
    return fs::path(name);
  }();
  const std::string header = "{}\n";
  const fs::path output = directory / "lines";
  std::ofstream(output.string() + ".partial", std::ios::binary) << header << text;
  try {
    cli::BatchOutput batch(output.string(), header, cli::BatchOutput::Journal::resume);
    cli::Tally tally;
    batch.read_earlier(journal_lines, [&](std::string_view line) { return cli::count_line(line, tally); });
    std::uint64_t done = 0;
    for (std::uint64_t place = 0; place < journal_lines; ++place) done += batch.done(place) ? 1 : 0;
    require(done == tally.lines, "each line has a place of its own");
  } catch (const InputError&) {
    return;
  }
}

constexpr Reader all[] = {{"number", read_number},
                          {"patches", read_patch_file},
                          {"bpt", read_bpt_file},
                          {"model", read_model},
                          {"curve", read_curve_file},
                          {"candidate-json", read_candidate_file<CandidateFormat::json>},
                          {"candidate-csv", read_candidate_file<CandidateFormat::csv>},
                          {"candidate-obj", read_candidate_file<CandidateFormat::obj>},
                          {"candidate-g2", read_candidate_file<CandidateFormat::g2>},
                          {"certificate", read_certificate},
                          {"batch-line", read_batch_line},
                          {"journal", read_journal}};

}  // namespace

std::span<const Reader> readers() { return all; }

}  // namespace exsect::fuzz
