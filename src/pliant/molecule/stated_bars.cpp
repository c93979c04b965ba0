// SPDX-License-Identifier: MIT
#include "pliant/molecule/stated_bars.hpp"

#include <algorithm>
#include <map>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant {

void add_stated(std::span<const StatedBar> stated, const std::function<double(Bar)>& measured,
                FrameworkParts& parts) {
  if (stated.empty()) return;
  std::map<std::pair<Joint, Joint>, std::size_t> bar_of;
  for (std::size_t k = 0; k < parts.bars.size(); ++k)
    bar_of[std::minmax(parts.bars[k].a, parts.bars[k].b)] = k;
  for (const auto& [bar, length] : stated) {
    const double rest = length ? *length : measured(bar);
    const auto [at, is_new] = bar_of.emplace(std::minmax(bar.a, bar.b), parts.bars.size());
    if (is_new) {
      parts.bars.push_back(bar);
      parts.rest_lengths.push_back(rest);
    } else {
      parts.rest_lengths[at->second] = rest;
    }
  }
}

namespace {

FrameworkParts parts_with(const Framework& framework, std::span<const Vec3> positions,
                          BarsFile file) {
  FrameworkParts parts = framework.parts();
  if (file.bars == BarKind::angles)
    throw InputError("bars angles: only molecules have angles; expected bonds or none");
  if (file.bars == BarKind::none) {
    parts.bars.clear();
    parts.rest_lengths.clear();
  }
  parts.drawn.clear();
  add_stated(
      file.stated, [&](Bar bar) { return distance(positions[bar.a], positions[bar.b]); }, parts);
  parts.limits = std::move(file.limits);
  if (file.sterics)
    parts.sterics = std::make_shared<const Sterics>(std::move(file.sterics->sterics));
  return parts;
}

}  // namespace

Framework with_stated_bars(const Framework& framework, std::span<const Vec3> positions,
                           const std::filesystem::path& path) {
  BarsFile file = read_bars_file(path, framework);
  try {
    return Framework(parts_with(framework, positions, std::move(file)));
  } catch (const InputError& error) {
    throw InputError(at({path_text(path)}, error.what()));
  }
}

}  // namespace pliant
