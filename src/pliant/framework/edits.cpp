// SPDX-License-Identifier: MIT
#include "pliant/framework/edits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr std::string_view edit_words[] = {"cut", "bar", "restore"};
// Drawn positions may differ by rounding, as Framework checks them.
constexpr double drawn_rounding = 1e-10;

bool joins_pair(std::uint32_t a, std::uint32_t b, const auto& row) {
  return (row.a == a && row.b == b) || (row.a == b && row.b == a);
}

/// What is left of the start, and what has been added.
class Editing {
 public:
  explicit Editing(const Framework& start)
      : start_(start),
        bar_is_off_(start.bar_count(), false),
        limit_is_off_(start.limits().size(), false) {}

  void apply(const FrameworkEdit& edit) {
    check_joints(edit);
    if (edit.kind == EditKind::cut) return cut(edit);
    if (edit.kind == EditKind::bar) return add_bar(edit);
    restore(edit);
  }

  Framework made(std::span<const Vec3> positions) const {
    FrameworkParts parts = start_.parts();
    keep_bars(parts);
    keep_limits(parts);
    for (const FrameworkEdit& bar : added_) {
      parts.bars.push_back({bar.a, bar.b});
      parts.rest_lengths.push_back(bar.length);
    }
    if (parts.sterics && !added_.empty()) parts.sterics = without_added(*parts.sterics);
    if (!parts.drawn.empty() && !are_whole(parts, parts.drawn)) {
      parts.drawn.clear();
      if (are_whole(parts, positions)) parts.drawn.assign(positions.begin(), positions.end());
    }
    return Framework(std::move(parts));
  }

 private:
  [[noreturn]] void refuse(const FrameworkEdit& edit, const std::string& why) const {
    throw OptionError(text_of(edit, start_) + ": " + why);
  }

  void check_joints(const FrameworkEdit& edit) const {
    for (const Joint joint : {edit.a, edit.b})
      if (joint >= start_.joint_count())
        throw OptionError(std::string(name(edit.kind)) + ": joint " + std::to_string(joint) +
                          " of " + std::to_string(start_.joint_count()) + " does not exist");
    if (edit.a == edit.b) refuse(edit, "expected two joints");
  }

  std::optional<BarIndex> bar_of_start(Joint a, Joint b) const {
    for (const Incidence& at : start_.neighbours(a))
      if (at.joint == b) return at.bar;
    return std::nullopt;
  }

  /// The limits of the start between two joints; `with_contact`: and all of the same contacts.
  std::vector<LimitIndex> limits_of_start(Joint a, Joint b, bool with_contact) const {
    std::vector<LimitIndex> found;
    const auto all = start_.limits();
    for (const LimitIndex k : start_.limits_at(a)) {
      if (!joins_pair(a, b, all[k])) continue;
      found.push_back(k);
      if (!with_contact || all[k].group == no_limit_group) continue;
      for (LimitIndex other = 0; other < all.size(); ++other)
        if (other != k && all[other].group == all[k].group) found.push_back(other);
    }
    return found;
  }

  bool take_added(Joint a, Joint b) {
    return std::erase_if(added_, [&](const FrameworkEdit& bar) { return joins_pair(a, b, bar); }) >
           0;
  }

  bool switch_bar(Joint a, Joint b, bool off) {
    const auto bar = bar_of_start(a, b);
    if (!bar || bar_is_off_[*bar] == off) return false;
    bar_is_off_[*bar] = off;
    return true;
  }

  bool switch_limits(const std::vector<LimitIndex>& limits, bool off) {
    bool has_changed = false;
    for (const LimitIndex k : limits) {
      has_changed |= limit_is_off_[k] != off;
      limit_is_off_[k] = off;
    }
    return has_changed;
  }

  void cut(const FrameworkEdit& edit) {
    const auto [kind, a, b, length] = edit;
    bool has_changed = take_added(a, b);
    has_changed |= switch_bar(a, b, true);
    has_changed |= switch_limits(limits_of_start(a, b, true), true);
    if (!has_changed) refuse(edit, "neither a bar nor a contact joins them");
  }

  void add_bar(const FrameworkEdit& edit) {
    if (!(edit.length >= 1e-150 && edit.length <= 1e150))
      refuse(edit, "expected a length from 1e-150 to 1e150 Angstrom");
    const auto same = std::ranges::find_if(
        added_, [&](const FrameworkEdit& bar) { return joins_pair(edit.a, edit.b, bar); });
    if (same != added_.end() && same->length == edit.length) refuse(edit, "is there already");
    take_added(edit.a, edit.b);
    switch_bar(edit.a, edit.b, true);
    switch_limits(limits_of_start(edit.a, edit.b, false), true);
    added_.push_back(edit);
  }

  void restore(const FrameworkEdit& edit) {
    const auto [kind, a, b, length] = edit;
    bool has_changed = take_added(a, b);
    has_changed |= switch_bar(a, b, false);
    has_changed |= switch_limits(limits_of_start(a, b, true), false);
    if (!has_changed) refuse(edit, "is as it was at the start");
  }

  void keep_bars(FrameworkParts& parts) const {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < parts.bars.size(); ++k) {
      if (bar_is_off_[k]) continue;
      parts.bars[kept] = parts.bars[k];
      parts.rest_lengths[kept++] = parts.rest_lengths[k];
    }
    parts.bars.resize(kept);
    parts.rest_lengths.resize(kept);
  }

  /// A bar that was added replaces the limits of its pair, even where their contact is restored.
  void keep_limits(FrameworkParts& parts) const {
    const auto is_barred = [&](const Limit& limit) {
      return std::ranges::any_of(
          added_, [&](const FrameworkEdit& bar) { return joins_pair(limit.a, limit.b, bar); });
    };
    std::size_t kept = 0;
    for (std::size_t k = 0; k < parts.limits.size(); ++k)
      if (!limit_is_off_[k] && !is_barred(parts.limits[k])) parts.limits[kept++] = parts.limits[k];
    parts.limits.resize(kept);
  }

  /// What a bar joins may be as near as the bar is long.
  std::shared_ptr<const Sterics> without_added(Sterics sterics) const {
    for (const FrameworkEdit& bar : added_) {
      std::erase_if(sterics.own,
                    [&](const OwnDistance& own) { return joins_pair(bar.a, bar.b, own); });
      sterics.own.push_back({std::min(bar.a, bar.b), std::max(bar.a, bar.b), 0.0});
    }
    return std::make_shared<const Sterics>(std::move(sterics));
  }

  static bool are_whole(const FrameworkParts& parts, std::span<const Vec3> positions) {
    if (positions.size() != parts.joint_count) return false;
    for (std::size_t k = 0; k < parts.bars.size(); ++k) {
      const double rest = parts.rest_lengths[k];
      const double length = distance(positions[parts.bars[k].a], positions[parts.bars[k].b]);
      if (!(std::abs(length - rest) <= drawn_rounding * rest)) return false;
    }
    return true;
  }

  const Framework& start_;
  std::vector<bool> bar_is_off_, limit_is_off_;
  std::vector<FrameworkEdit> added_;
};

}  // namespace

std::string_view name(EditKind kind) { return edit_words[static_cast<std::size_t>(kind)]; }

EditedFramework edited(const Framework& start, std::vector<FrameworkEdit> edits,
                       std::span<const Vec3> positions) {
  Editing editing(start);
  for (const FrameworkEdit& edit : edits) editing.apply(edit);
  Framework framework = editing.made(positions);
  return {std::move(edits), std::move(framework)};
}

std::string text_of(const FrameworkEdit& edit, const Framework& framework) {
  std::string text = std::string(name(edit.kind)) + " " + framework.label(Bar{edit.a, edit.b});
  if (edit.kind == EditKind::bar) text += ", " + number_text(edit.length) + " Angstrom";
  return text;
}

}  // namespace pliant
