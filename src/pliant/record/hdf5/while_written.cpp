// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/while_written.hpp"

#include <system_error>

namespace pliant {

bool is_new(const std::filesystem::path& path) {
  constexpr std::chrono::seconds new_age{5};
  std::error_code error;
  const auto written = std::filesystem::last_write_time(path, error);
  return !error && std::filesystem::file_time_type::clock::now() - written < new_age;
}

}  // namespace pliant
