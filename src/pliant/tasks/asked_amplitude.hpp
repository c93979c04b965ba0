// SPDX-License-Identifier: MIT
// How far frames of an ensemble are to go, as users say it.
#pragma once

#include <string>

#include "pliant/model/amplitude.hpp"

namespace pliant {

/// As choose_amplitude(), and from the frames of an H5MD file too. Throws as it and
/// trajectory_amplitude() do.
AmplitudeChoice asked_amplitude(const std::string& text, const Structure& structure,
                                const Log& log);

}  // namespace pliant
