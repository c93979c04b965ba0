// SPDX-License-Identifier: MIT
#include "output/guide_end.hpp"

#include <fmt/format.h>

#include <cmath>

#include "pliant/base/printable.hpp"

namespace pliant::app {
namespace {

std::string asked_text(const PairDistance& pair) {
  if (pair.least == pair.most) return fmt::format("{:g} A", pair.least);
  return fmt::format("{:g} to {:g} A", pair.least, pair.most);
}

}  // namespace

bool GuideEnd::is_reached() const {
  return guide_.empty() || !guide_.rock.empty() || has_arrived(guide_, last_);
}

bool GuideEnd::is_there(const PairDistance& pair) const {
  return std::abs(excess_of(pair, last_)) <= guide_slack;
}

bool GuideEnd::is_there(const Pull& pull) const { return norm(way_of(pull, last_)) <= guide_slack; }

void GuideEnd::print() const {
  for (std::size_t k = 0; k < guide_.pulls.size(); ++k) {
    const Pull& pull = guide_.pulls[k];
    fmt::print("pulled          {}: {:.2f} A away at first, {:.2f} A now{}\n",
               printable(settings_.pulls[k][0]), norm(way_of(pull, first_)),
               norm(way_of(pull, last_)), is_there(pull) ? "" : ": did not arrive");
  }
  for (std::size_t k = 0; k < guide_.pairs.size(); ++k) {
    const PairDistance& pair = guide_.pairs[k];
    fmt::print("pair distance   {} - {}: {:.2f} A at first, {:.2f} A now, {} asked for{}\n",
               printable(settings_.pairs[k][0]), printable(settings_.pairs[k][1]),
               norm(line_of(pair, first_)), norm(line_of(pair, last_)), asked_text(pair),
               is_there(pair) ? "" : ": not reached");
  }
}

Json GuideEnd::json() const {
  std::vector<Json> pulls, pairs;
  for (std::size_t k = 0; k < guide_.pulls.size(); ++k) {
    const Pull& pull = guide_.pulls[k];
    pulls.push_back({{"selection", settings_.pulls[k][0]},
                     {"away_at_first", norm(way_of(pull, first_))},
                     {"away", norm(way_of(pull, last_))},
                     {"is_reached", is_there(pull)}});
  }
  for (std::size_t k = 0; k < guide_.pairs.size(); ++k) {
    const PairDistance& pair = guide_.pairs[k];
    pairs.push_back({{"first", settings_.pairs[k][0]},
                     {"second", settings_.pairs[k][1]},
                     {"least", pair.least},
                     {"most", pair.most},
                     {"at_first", norm(line_of(pair, first_))},
                     {"reached", norm(line_of(pair, last_))},
                     {"is_reached", is_there(pair)}});
  }
  return {{"pulls", Json::array(pulls)}, {"pair_distances", Json::array(pairs)}};
}

}  // namespace pliant::app
