// SPDX-License-Identifier: MIT
// Options of a sample.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"

namespace pliant {

/// A number of frames that the task chooses: SamplerEntry::frames.
inline constexpr std::int64_t open_frames = std::numeric_limits<std::int64_t>::min();
/// Near frames are asked for in blocks of so many.
inline constexpr std::int64_t near_block = 100;
inline constexpr std::int64_t usual_frames = 200;  // of samplers whose row names no other
inline constexpr double usual_amplitude = 1.4;     // Angstrom
inline constexpr double largest_amplitude = 10.0;

/// What to sample: rows of sample_fields(). Checked once, when sample() begins.
struct SampleOptions {
  std::int64_t frames = usual_frames;  ///< from 1
  std::int64_t first_frame = 0;        ///< frames [first_frame, first_frame + frames) of the run
  double amplitude = usual_amplitude;  ///< mean r.m.s. fluctuation of nodes (Angstrom), 0.01 to 10
  /// Where that comes from: a number, `bfactors`, or a file of an ensemble; "": the default, which
  /// samplers without an amplitude accept. The job finds the amplitude: see SampleJob.
  std::string amplitude_from = {};
  std::uint64_t seed = 0;
  std::int64_t threads = 1;       ///< from 1; changes no result
  std::string sampler = "modes";  ///< a name in samplers()
  /// For `reach`: frames below this number are those of `modes`. 0: half of the frames, in whole
  /// blocks (see near_frames_of()).
  std::int64_t near_frames = 0;
  /// Selection of atoms, for `pocket`: frames open or close the place around them; "": everywhere.
  std::string around = {};
  std::vector<std::uint32_t> around_joints = {};  ///< what `around` selects, ascending
  /// Contacts of a ligand that `around` selects which all frames keep: kinds, `all` or `none`.
  std::vector<std::string> hold = {"metal", "salt_bridge"};
  /// kcal/mol, for `dilute`: a contact of energy E is off with probability exp(-|E| / this).
  double contact_energy = 3.0;
  bool ring_systems = true;  ///< for `torsions`: rings that share bonds take other forms
  bool amides = false;       ///< for `torsions`: secondary amides are cis or trans, too
  bool both_hands = false;   ///< for `torsions`: axes of atropisomers take both hands
  /// Called between batches of frames, which take up to about a second; true ends the sample.
  std::function<bool()> should_stop = {};
  Log log = {};  ///< receives warnings
};

/// How many frames of `reach` are those of `modes` if `near_frames` is 0: half of them in whole
/// blocks of `near_block`, but at least one. Throws OptionError if the frames do not begin at 0:
/// pieces of one ensemble must have the same.
std::int64_t near_frames_of(const SampleOptions& options);

/// Throws OptionError naming the option, its value and its range.
void check(const SampleOptions& options);

}  // namespace pliant
