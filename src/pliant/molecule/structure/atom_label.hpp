// SPDX-License-Identifier: MIT
// Elements from the labels that stand for symbols in XYZ, SDF and mmCIF files: "O1", "HW2", "CA_3".
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

/// How an element was found.
enum class ElementSource : std::uint8_t {
  symbol,   ///< the label is an element's symbol, in any case
  number,   ///< the label is an atomic number
  guessed,  ///< the label begins with one
  dummy,    ///< a name for no atom: X, Bq, Du
  unknown,  ///< nothing of these
};

struct LabelElement {
  std::uint8_t element = 0;
  ElementSource source = ElementSource::unknown;
};

/// The element of a label. A longer label is cut at its first character that is no letter; of two
/// leading letters the pair is taken where it is written as a symbol ("Ca1") or can hardly be
/// anything else ("CL1", "BR2"), else the first letter ("HW2" is hydrogen, "CA1" carbon).
LabelElement element_of_label(std::string_view label);

/// The element of a two-letter beginning in capitals: of "CL" chlorine, of "CA" carbon.
std::uint8_t element_of_capitals(char first, char second);

}  // namespace pliant
