// SPDX-License-Identifier: MIT
// Edits of a framework by a person between two steps: bars and contacts that are cut, added and
// restored.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

enum class EditKind : std::uint8_t {
  cut,      ///< takes away what joins a and b: their bar, their limits, and all of those contacts
  bar,      ///< joins a and b by a bar of `length`, in place of a bar or limits between them
  restore,  ///< puts back what joined a and b at the start, and nothing else
};

/// "cut", "bar", "restore": the words of force files.
std::string_view name(EditKind kind);

struct FrameworkEdit {
  EditKind kind = EditKind::cut;
  Joint a = 0, b = 0;
  double length = 0.0;  ///< Angstrom, of a bar alone
  friend bool operator==(const FrameworkEdit&, const FrameworkEdit&) = default;
};

/// A framework after edits, with their list. Joints and pins are those of the start, masses to
/// rounding; what is left of its bars and limits stands in its order, added bars at the end.
struct EditedFramework {
  std::vector<FrameworkEdit> edits;
  Framework framework;
};

/// `start` after all of `edits`, one after the other; the last come at `positions` (N, Angstrom),
/// which become what it is drawn as where bars have been added and are whole there. Depends on the
/// arguments alone. Throws OptionError naming an edit that changes nothing, a joint that does not
/// exist, a joint with itself, or a length that is not from 1e-150 to 1e150 Angstrom.
EditedFramework edited(const Framework& start, std::vector<FrameworkEdit> edits,
                       std::span<const Vec3> positions);

/// "cut GLY10:N - VAL17:O", "bar 3 - 7, 2.5 Angstrom".
std::string text_of(const FrameworkEdit& edit, const Framework& framework);

}  // namespace pliant
