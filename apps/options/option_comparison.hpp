// SPDX-License-Identifier: MIT
// Options given again when a run or a sample continues, compared with those of its file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant::app {

/// An option and the path below /parameters where it is recorded.
struct RecordedOption {
  const char* option;
  const char* path;
};

/// Throws OptionError at the first of `options` that was given.
void refuse_options_of_a_new_file(const CommandLine& line, std::span<const char* const> options,
                                  const std::filesystem::path& file);

/// Throws OptionError if --output names another file than `file`.
void refuse_another_output(const CommandLine& line, const std::string& output,
                           const std::string& file);

/// Compares options that are given again with the file.
class OptionComparison {
 public:
  /// `given` are the parameters of the command line; both others must outlive it.
  OptionComparison(const CommandLine& line, std::vector<NamedParameter> given,
                   const H5mdCheckpoint& recorded);

  /// Throws OptionError if the option was given and differs from the file.
  void check(const std::string& option, const std::string& path) const;
  void check(std::span<const RecordedOption> options) const;

  /// Options that runs and samples have: of the molecule and of the file.
  void check_both() const;

  /// A number is that of a model of the file, a name that of a kind of model.
  void check_model() const;

 private:
  const CommandLine& line_;
  const H5mdCheckpoint& recorded_;
  std::vector<NamedParameter> given_;
};

}  // namespace pliant::app
