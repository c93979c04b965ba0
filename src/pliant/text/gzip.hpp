// SPDX-License-Identifier: MIT
// Undoing gzip (RFC 1952) in bounded memory.
#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// Whether `bytes` begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// What `bytes` hold, all members of the file one after the other. `name` is for messages.
/// Throws InputError where the file is damaged or cut, or inflates to more than 64 MiB and more
/// than 300 times its size (which no molecule does), or to more than largest_text.
std::string gunzip(std::string_view bytes, std::string_view name);

}  // namespace pliant
