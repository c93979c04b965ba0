// SPDX-License-Identifier: MIT
#include "options/conformers_asked.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "output/output_files.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::app {
namespace {

constexpr std::array<std::string_view, 12> only_conformers{
    "--smiles", "--max",      "-n",      "--starts", "--rms",    "--window",
    "--energy", "--minimise", "--embed", "--salts",  "--amides", "--shard"};
constexpr std::array<std::string_view, 11> of_both{
    "-o",     "--output", "--continue", "--frames",    "--seed",     "--threads",
    "--json", "--quiet",  "--verbose",  "--overwrite", "--max-input"};

bool has(const auto& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

bool is_compressed(const std::string& name) {
  const std::string extension = extension_of(name);
  return extension == ".gz" || extension == ".bz2" || extension == ".xz";
}

/// The extension in lower case, without that of a compression: ".sdf" of "X.SDF.gz".
std::string format_of(const std::string& name) {
  if (!is_compressed(name)) return extension_of(name);
  return extension_of(path_text(path_of(name).stem()));
}

bool is_sdf(const std::string& name) {
  const std::string format = format_of(name);
  return format == ".sdf" || format == ".sd" || format == ".mol" || format == ".mdl";
}

bool is_smiles(const std::string& name) {
  const std::string format = format_of(name);
  return format == ".smi" || format == ".smiles";
}

/// Whether text follows the first record of an SDF. A first record of a megabyte is no small
/// molecule.
bool has_more_records(const std::string& file) {
  std::string text(1'000'000, '\0');
  std::ifstream in(path_of(file), std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  const std::size_t end = text.find("\n$$$$");
  const std::size_t next = end == std::string::npos ? end : text.find('\n', end + 1);
  return next != std::string::npos && text.find_first_not_of(" \t\r\n", next) != std::string::npos;
}

/// The parts of a command line that decide.
struct Asked {
  std::string file, output;
  bool is_new = true;  ///< nothing is continued
  bool has_own = false, has_foreign = false;
};

Asked asked_in(const Arguments& words) {
  Asked asked;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (word.size() < 2 || word[0] != '-') {
      if (is_sdf(word) || is_smiles(word)) asked.file = word;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    asked.has_own |= has(only_conformers, name);
    asked.has_foreign |= !has(only_conformers, name) && !has(of_both, name);
    if (name != "-o" && name != "--output" && name != "--continue") continue;
    asked.is_new &= name != "--continue";
    if (equals != std::string::npos) {
      asked.output = word.substr(equals + 1);
    } else if (k + 1 < words.size()) {
      asked.output = words[++k];
    }
  }
  return asked;
}

}  // namespace

bool asks_for_conformers(const Arguments& words) {
  const Asked asked = asked_in(words);
  if (asked.has_own) return true;
  if (asked.has_foreign) return false;
  if (!asked.is_new) return format_of(asked.output) == ".sdf";
  if (asked.file.empty()) return false;
  if (!asked.output.empty()) return format_of(asked.output) == ".sdf";
  return is_smiles(asked.file) || is_compressed(asked.file) || has_more_records(asked.file);
}

}  // namespace pliant::app
