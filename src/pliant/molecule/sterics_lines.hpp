// SPDX-License-Identifier: MIT
// The sterics in a bars file: gathered line by line and put together at the end, because the kind
// of a joint may come before the distances of that kind.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// The kind of joints that touch nothing.
inline constexpr std::string_view no_kind = "none";

/// The kind of a joint that has no line: the symbol of its element.
std::string_view usual_kind(const Framework& joints, Joint joint);

/// Sterics and the names of their kinds: "" is the kind of joints that touch nothing.
struct NamedSterics {
  Sterics sterics;
  std::vector<std::string> kind_names;
};

class StericsLines {
 public:
  /// The add functions throw InputError at `place` for repeated or invalid values.
  void add_least(std::string_view one, std::string_view other, double least, const Place& place);
  void add_kind(Joint joint, std::string_view name, const Place& place);
  void add_own(Joint a, Joint b, double least, const Place& place);
  void add_bonds_apart(int bonds, const Place& place);

  /// Returns nothing if no line gave a distance. Kinds are sorted by name, the nameless one last.
  /// Throws InputError naming `file` and the line of a kind without distances.
  std::optional<NamedSterics> put_together(const Framework& joints, std::string_view file) const;

 private:
  struct StatedKind {
    std::string name;
    std::size_t line;
  };
  NamedSterics table_of(const Framework& joints) const;
  void check_kinds(const Place& file) const;

  std::map<std::pair<std::string, std::string>, double> least_;  ///< names in their order
  std::map<std::string, std::uint16_t, std::less<>> kinds_;      ///< the kinds named in least_
  std::map<Joint, StatedKind> stated_;
  std::map<std::pair<Joint, Joint>, std::size_t> own_lines_;
  std::vector<OwnDistance> own_;
  std::optional<int> bonds_apart_;
  std::size_t bonds_apart_line_ = 0;
};

}  // namespace pliant
