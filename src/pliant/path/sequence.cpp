// SPDX-License-Identifier: MIT
#include "pliant/path/sequence.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr ResidueLetter amino_acids[] = {
    {"ALA", 'A'}, {"ARG", 'R'}, {"ASN", 'N'}, {"ASP", 'D'}, {"CYS", 'C'}, {"GLN", 'Q'},
    {"GLU", 'E'}, {"GLY", 'G'}, {"HIS", 'H'}, {"ILE", 'I'}, {"LEU", 'L'}, {"LYS", 'K'},
    {"MET", 'M'}, {"PHE", 'F'}, {"PRO", 'P'}, {"SER", 'S'}, {"THR", 'T'}, {"TRP", 'W'},
    {"TYR", 'Y'}, {"VAL", 'V'}, {"MSE", 'M'}, {"SEC", 'C'}, {"CSO", 'C'}, {"CME", 'C'},
    {"CYX", 'C'}, {"HID", 'H'}, {"HIE", 'H'}, {"HIP", 'H'}, {"HSD", 'H'}, {"HSE", 'H'},
    {"HSP", 'H'}};

constexpr ResidueLetter nucleotides[] = {
    {"A", 'A'},   {"C", 'C'},   {"G", 'G'},   {"U", 'U'},   {"DA", 'A'}, {"DC", 'C'},
    {"DG", 'G'},  {"DT", 'T'},  {"RA", 'A'},  {"RC", 'C'},  {"RG", 'G'}, {"RU", 'U'},
    {"ADE", 'A'}, {"CYT", 'C'}, {"GUA", 'G'}, {"URA", 'U'}, {"THY", 'T'}};

constexpr std::int32_t match = 2, mismatch = -1, gap = -2;

enum class Came : std::uint8_t { paired, gap_in_theirs, gap_in_ours };

/// Where the best score of each two beginnings comes from. Scores are kept for one row only.
class AlignmentTable {
 public:
  AlignmentTable(std::string_view ours, std::string_view theirs)
      : ours_(ours), theirs_(theirs), came_(ours.size() * theirs.size()) {
    std::vector<std::int32_t> row(theirs.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = gap * std::int32_t(j);
    for (std::size_t i = 0; i < ours.size(); ++i) fill(i, row);
  }

  std::vector<ResiduePair> pairs() const {
    std::vector<ResiduePair> found;
    std::size_t i = ours_.size(), j = theirs_.size();
    while (i > 0 && j > 0) {
      const Came came = came_[(i - 1) * theirs_.size() + j - 1];
      if (came != Came::gap_in_ours) --i;
      if (came != Came::gap_in_theirs) --j;
      if (came == Came::paired) found.push_back({std::uint32_t(i), std::uint32_t(j)});
    }
    std::reverse(found.begin(), found.end());
    return found;
  }

 private:
  /// Row i + 1 of the scores in place of row i.
  void fill(std::size_t i, std::vector<std::int32_t>& row) {
    std::int32_t before = row[0];
    row[0] += gap;
    for (std::size_t j = 0; j < theirs_.size(); ++j) {
      const std::int32_t paired = before + (ours_[i] == theirs_[j] ? match : mismatch);
      const std::int32_t above = row[j + 1] + gap, beside = row[j] + gap;
      before = row[j + 1];
      row[j + 1] = std::max({paired, above, beside});
      came_[i * theirs_.size() + j] = row[j + 1] == paired  ? Came::paired
                                      : row[j + 1] == above ? Came::gap_in_theirs
                                                            : Came::gap_in_ours;
    }
  }

  std::string_view ours_, theirs_;
  std::vector<Came> came_;
};

}  // namespace

std::span<const ResidueLetter> amino_acid_letters() { return amino_acids; }
std::span<const ResidueLetter> nucleotide_letters() { return nucleotides; }

char letter_of(std::string_view name, std::span<const ResidueLetter> table) {
  const auto row = std::find_if(table.begin(), table.end(),
                                [&](const ResidueLetter& one) { return one.name == name; });
  return row == table.end() ? unknown_letter : row->letter;
}

std::vector<ResiduePair> align(std::string_view ours, std::string_view theirs) {
  return AlignmentTable(ours, theirs).pairs();
}

}  // namespace pliant
