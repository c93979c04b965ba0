// SPDX-License-Identifier: MIT
// Finds the amplitude of an ensemble from a user's text.
#pragma once

#include <string>

#include "pliant/model/amplitude.hpp"

namespace pliant {

/// As choose_amplitude(), but the frames of an H5MD file are accepted, too. Throws as that function
/// and trajectory_amplitude() do.
AmplitudeChoice asked_amplitude(const std::string& text, const Structure& structure,
                                const Log& log);

}  // namespace pliant
