// SPDX-License-Identifier: MIT
// How text files refer to joints: by name if it is unique, else by index.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "pliant/base/error.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Translates between joints and words. Reads all names once, when it is made. The framework must
/// outlive it.
class JointNames {
 public:
  explicit JointNames(const Framework& framework);

  /// Returns the joint whose name is `word`; if none has it and `word` is a number, the joint of
  /// that index, from 0. Throws InputError at `place` if there is none or if several joints have
  /// the name.
  Joint find(std::string_view word, const Place& place) const;

  /// Returns a word by which find() finds the joint: its name if that is unique, else its index.
  /// Throws InputError, beginning with `file`, where the index is the name of another joint.
  std::string word_for(Joint joint, std::string_view file) const;

 private:
  const Framework& framework_;
  std::unordered_map<std::string_view, Joint> joints_;
  std::unordered_map<std::string_view, std::size_t> repeats_;
};

}  // namespace pliant
