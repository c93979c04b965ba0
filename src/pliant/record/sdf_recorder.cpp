// SPDX-License-Identifier: MIT
#include "pliant/record/sdf_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_of_v2000 = 999;
constexpr std::size_t pairs_a_line = 8;
constexpr double least_of_v2000 = -9999.99995, most_of_v2000_place = 99999.99995;  // Angstrom
constexpr double largest_place = 1e9;  // Angstrom: what readers of ours take

template <class... Values>
void append(std::string& text, const char* format, Values... values) {
  char line[128];
  const int size = std::snprintf(line, sizeof line, format, values...);
  text.append(line, static_cast<std::size_t>(size));
}

/// The text as one line of at most 80 bytes: control characters would end it, and "$$$$" would end
/// the record.
std::string one_line(std::string text) {
  for (char& letter : text)
    if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
  for (std::size_t at; (at = text.find("$$$$")) != std::string::npos;) text.insert(at + 3, " ");
  std::size_t end = std::min<std::size_t>(text.size(), 80);
  const auto continues = [&] { return (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80; };
  while (end > 0 && end < text.size() && continues()) --end;  // never within a letter of UTF-8
  return text.substr(0, end);
}

bool fits_v2000(std::span<const Vec3> positions) {
  return std::ranges::all_of(positions, [](Vec3 x) {
    return std::min({x.x, x.y, x.z}) > least_of_v2000 &&
           std::max({x.x, x.y, x.z}) < most_of_v2000_place;
  });
}

std::string symbol_of(std::uint8_t element) {
  return element == 0 ? "*" : std::string(element_symbol(element));
}

int order_of(const RecordedBond& bond) { return bond.order == 0 ? 1 : bond.order; }

}  // namespace

class SdfRecorder::Writer {
 public:
  Writer(const std::filesystem::path& path, std::shared_ptr<const AtomTable> atoms,
         std::vector<RecordedBond> bonds, SdfMolecule molecule, const Options& options)
      : atoms_(std::move(atoms)),
        bonds_(std::move(bonds)),
        molecule_(std::move(molecule)),
        title_(one_line(molecule_.title)),
        file_(path, options.overwrite) {
    molecule_.charges.resize(atoms_->size(), 0);
    molecule_.isotopes.resize(atoms_->size(), 0);
    molecule_.radicals.resize(atoms_->size(), 0);
  }

  void record(const Frame& frame) {
    const std::string name = path_text(file_.target()) + ": ";
    if (is_closed_) throw FileError(name + "is closed: no frame can be recorded");
    if (frame.positions.size() != atoms_->size())
      throw InputError(name + std::to_string(frame.positions.size()) + " positions for " +
                       std::to_string(atoms_->size()) + " atoms");
    check(frame.positions);
    text_ = title_ + "\n  Pliant            3D\n\n";
    const bool is_small = atoms_->size() <= most_of_v2000 && bonds_.size() <= most_of_v2000 &&
                          fits_v2000(frame.positions);
    is_small ? add_v2000(frame.positions) : add_v3000(frame.positions);
    append(text_, "M  END\n> <frame>\n%lld\n\n$$$$\n", static_cast<long long>(frame.step));
    file_.write(text_);
    ++records_;
  }

  void close() {
    if (is_closed_) return;
    is_closed_ = true;
    if (records_ > 0) file_.publish();
    file_.close();
  }

 private:
  void check(std::span<const Vec3> positions) const {
    for (std::size_t k = 0; k < positions.size(); ++k)
      for (double value : {positions[k].x, positions[k].y, positions[k].z})
        if (!(std::abs(value) <= largest_place))
          throw InputError(path_text(file_.target()) + ": record " + std::to_string(records_ + 1) +
                           ": expected positions within 1e9 Angstrom of the origin, but atom " +
                           std::to_string(k + 1) + " is not");
  }

  void add_v2000(std::span<const Vec3> x) {
    append(text_, "%3zu%3zu  0  0  0  0  0  0  0  0999 V2000\n", atoms_->size(), bonds_.size());
    for (std::size_t k = 0; k < x.size(); ++k)
      append(text_, "%10.4f%10.4f%10.4f %-3s 0  0  0  0  0  0  0  0  0  0  0  0\n", x[k].x, x[k].y,
             x[k].z, symbol_of(atoms_->elements[k]).c_str());
    for (const RecordedBond& bond : bonds_)
      append(text_, "%3u%3u%3d  0\n", bond.a + 1, bond.b + 1, order_of(bond));
    add_pairs("CHG", molecule_.charges);
    add_pairs("RAD", molecule_.radicals);
    add_pairs("ISO", molecule_.isotopes);
  }

  template <class Value>
  void add_pairs(const char* name, const std::vector<Value>& values) {
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k] != 0) changed.push_back(k);
    for (std::size_t first = 0; first < changed.size(); first += pairs_a_line) {
      const std::size_t count = std::min(pairs_a_line, changed.size() - first);
      append(text_, "M  %s%3zu", name, count);
      for (std::size_t k = first; k < first + count; ++k)
        append(text_, " %3zu %3d", changed[k] + 1, int{values[changed[k]]});
      text_ += '\n';
    }
  }

  void add_v3000(std::span<const Vec3> x) {
    text_ += "  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\n";
    append(text_, "M  V30 COUNTS %zu %zu 0 0 0\nM  V30 BEGIN ATOM\n", atoms_->size(),
           bonds_.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      append(text_, "M  V30 %zu %s %.4f %.4f %.4f 0", k + 1, symbol_of(atoms_->elements[k]).c_str(),
             x[k].x, x[k].y, x[k].z);
      add_word(" CHG=%d", molecule_.charges[k]);
      add_word(" RAD=%d", molecule_.radicals[k]);
      add_word(" MASS=%d", molecule_.isotopes[k]);
      text_ += '\n';
    }
    text_ += "M  V30 END ATOM\nM  V30 BEGIN BOND\n";
    for (std::size_t k = 0; k < bonds_.size(); ++k)
      append(text_, "M  V30 %zu %d %u %u\n", k + 1, order_of(bonds_[k]), bonds_[k].a + 1,
             bonds_[k].b + 1);
    text_ += "M  V30 END BOND\nM  V30 END CTAB\n";
  }

  void add_word(const char* format, int value) {
    if (value != 0) append(text_, format, value);
  }

  std::shared_ptr<const AtomTable> atoms_;
  std::vector<RecordedBond> bonds_;
  SdfMolecule molecule_;
  std::string title_, text_;
  OutputFile file_;
  std::int64_t records_ = 0;
  bool is_closed_ = false;
};

namespace {

std::shared_ptr<const AtomTable> checked(std::shared_ptr<const AtomTable> atoms) {
  if (!atoms || atoms->size() == 0)
    throw InputError("a framework without names of atoms cannot be written as SDF");
  return atoms;
}

}  // namespace

SdfRecorder::SdfRecorder(const std::filesystem::path& path, std::shared_ptr<const AtomTable> atoms,
                         std::vector<RecordedBond> bonds, SdfMolecule molecule,
                         const Options& options)
    : writer_(std::make_unique<Writer>(path, checked(std::move(atoms)), std::move(bonds),
                                       std::move(molecule), options)) {}
SdfRecorder::~SdfRecorder() = default;
SdfRecorder::SdfRecorder(SdfRecorder&&) noexcept = default;
SdfRecorder& SdfRecorder::operator=(SdfRecorder&&) noexcept = default;

void SdfRecorder::record(const Frame& frame) { writer_->record(frame); }
void SdfRecorder::close() { writer_->close(); }

}  // namespace pliant
