// SPDX-License-Identifier: MIT
// Elements from labels used in place of symbols in XYZ, SDF and mmCIF files: "O1", "HW2", "CA_3".
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

/// How an element was found.
enum class ElementSource : std::uint8_t {
  symbol,   ///< the label is an element's symbol, in any case
  number,   ///< the label is an atomic number
  guessed,  ///< the label begins with a symbol
  dummy,    ///< a name for something that is no atom: X, Bq, Du
  unknown,  ///< none of these
};

struct LabelElement {
  std::uint8_t element = 0;
  ElementSource source = ElementSource::unknown;
};

/// The element of a label. A longer label is cut at its first character that is not a letter. Two
/// leading letters are taken as a symbol if written as one ("Ca1") or if hardly anything else is
/// possible ("CL1", "BR2"); otherwise the first letter decides ("HW2" is hydrogen, "CA1" carbon).
LabelElement element_of_label(std::string_view label);

/// The element of a label's first two letters, both capitals: "CL" is chlorine, "CA" carbon.
std::uint8_t element_of_capitals(char first, char second);

}  // namespace pliant
