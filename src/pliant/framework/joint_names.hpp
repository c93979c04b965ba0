// SPDX-License-Identifier: MIT
// How text files speak of joints: by the name that belongs to one joint alone, else by its index.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "pliant/base/error.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Both ways between joints and words; looks at every name once, when it is made. The framework
/// must outlive it.
class JointNames {
 public:
  explicit JointNames(const Framework& framework);

  /// The joint whose name is `word`, else, if `word` is a number, the joint of that index, from 0.
  /// Throws InputError at `place` if there is none or if several joints have the name.
  Joint find(std::string_view word, const Place& place) const;

  /// A word by which find() finds that joint: its name if it has one of its own, else its index.
  /// Throws InputError, beginning with `file`, where even the index is the name of other joints.
  std::string word_for(Joint joint, std::string_view file) const;

 private:
  const Framework& framework_;
  std::unordered_map<std::string_view, Joint> joints_;
  std::unordered_map<std::string_view, std::size_t> repeats_;
};

}  // namespace pliant
