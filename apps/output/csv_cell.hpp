// SPDX-License-Identifier: MIT
// Text as a cell of a CSV file (RFC 4180).
#pragma once

#include <string>

namespace pliant::app {

/// Text in quotes if necessary. Text that a spreadsheet would take for a formula gets an apostrophe
/// before it.
std::string csv_cell(const std::string& text);

}  // namespace pliant::app
