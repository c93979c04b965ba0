// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked_amplitude.hpp"

#include <filesystem>

#include "pliant/base/system/path_text.hpp"
#include "pliant/model/ensemble_amplitude.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"

namespace pliant {

AmplitudeChoice asked_amplitude(const std::string& text, const Structure& structure,
                                const Log& log) {
  const std::filesystem::path extension = path_of(text).extension();
  if (extension != ".h5md" && extension != ".h5") return choose_amplitude(text, structure, log);
  return trajectory_amplitude(H5mdReader(path_of(text), {"", log}), text, structure, log);
}

}  // namespace pliant
