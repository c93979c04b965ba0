// SPDX-License-Identifier: MIT
// Ordering files (the thesis' constraint files): the sequence in which a sweep visits the bars, one
// bar a line.
//
//   pliant-ordering 1
//   bar a b tree             # near joint, far joint: the weighting shares the correction
//   bar e d non_tree         # closes a cycle: shared half and half
#pragma once

#include <filesystem>
#include <string>

#include "pliant/order/ordering.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// The ordering of a file that names each bar of `framework` once; JointNames says how it speaks of
/// joints. Throws InputError naming file, line, what was expected and found; FileError if the file
/// cannot be read.
Ordering read_ordering_file(const std::filesystem::path& path, const Framework& framework);
Ordering parse_ordering_file(const SourceText& source, const Framework& framework);

/// The text that parse_ordering_file reads back to the same visits. Throws InputError if `ordering`
/// does not visit each bar of `framework` once, or as JointNames::word_for does.
std::string write_ordering_file(const Ordering& ordering, const Framework& framework);

}  // namespace pliant
