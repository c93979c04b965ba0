// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/remarks.hpp"

#include <utility>

namespace pliant {

bool Remarks::seen_before(std::string_view kind) {
  for (Remark& remark : remarks_) {
    if (remark.kind != kind) continue;
    ++remark.count;
    return true;
  }
  return false;
}

void Remarks::add(std::string_view kind, Severity severity, std::string message) {
  remarks_.push_back({kind, severity, std::move(message), 1});
}

void Remarks::tell() {
  for (Remark& remark : remarks_) {
    if (remark.count > 1) remark.message += " (and " + std::to_string(remark.count - 1) + " more)";
    if (log_.function) log_.function(remark.severity, remark.message);
  }
  remarks_.clear();
}

}  // namespace pliant
