// SPDX-License-Identifier: MIT
#include "pliant/path/matching.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/path/sequence.hpp"

namespace pliant {
namespace {

using Indices = std::vector<std::uint32_t>;
using Pairs = std::vector<ResiduePair>;

/// Residues are matched by number where so many of those of the shorter chain are found and called
/// the same.
constexpr double least_by_number = 0.9;
/// Chains are the same molecule where so many residues of the shorter one are the same.
constexpr double least_alike = 0.3;
constexpr double least_shared = 0.5;  // of our residues
constexpr std::size_t least_residues = 3;
constexpr std::size_t most_named = 6;  // residues that differ, in a line

/// Two chains that may be the same.
struct Candidate {
  std::size_t same;
  bool has_other_name;
  std::size_t ours, theirs;  ///< places among the chains of each
  Pairs pairs;

  auto rank() const {
    return std::tuple(-static_cast<std::ptrdiff_t>(same), has_other_name, ours, theirs);
  }
};

class Matcher {
 public:
  Matcher(const Trace& ours, const Trace& theirs) : ours_(ours), theirs_(theirs) {}

  /// Pairs of residues, chain by chain; those that share most come first.
  std::vector<Pairs> by_chain() const {
    std::vector<Candidate> candidates = all_candidates();
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.rank() < b.rank(); });
    std::vector<Pairs> found;
    std::map<std::size_t, bool> ours_taken, theirs_taken;
    for (Candidate& one : candidates) {
      if (ours_taken[one.ours] || theirs_taken[one.theirs]) continue;
      ours_taken[one.ours] = theirs_taken[one.theirs] = true;
      found.push_back(std::move(one.pairs));
    }
    return found;
  }

 private:
  /// Residues of each chain and kind.
  static std::vector<Indices> chains_of(const Trace& trace) {
    std::map<std::pair<std::string, PolymerKind>, std::size_t> places;
    std::vector<Indices> chains;
    for (std::uint32_t k = 0; k < trace.size(); ++k) {
      const auto [at, is_new] =
          places.try_emplace({trace[k].residue.chain, trace[k].kind}, chains.size());
      if (is_new) chains.emplace_back();
      chains[at->second].push_back(k);
    }
    return chains;
  }

  std::vector<Candidate> all_candidates() const {
    const std::vector<Indices> ours = chains_of(ours_), theirs = chains_of(theirs_);
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < ours.size(); ++i)
      for (std::size_t j = 0; j < theirs.size(); ++j) {
        const TracedResidue &mine = ours_[ours[i][0]], &other = theirs_[theirs[j][0]];
        if (mine.kind != other.kind) continue;
        Pairs pairs = paired(ours[i], theirs[j]);
        const std::size_t same = same_of(pairs);
        if (double(same) >= std::max(1.0, least_alike * shorter(ours[i], theirs[j])))
          found.push_back(
              {same, mine.residue.chain != other.residue.chain, i, j, std::move(pairs)});
      }
    return found;
  }

  static double shorter(const Indices& mine, const Indices& other) {
    return double(std::min(mine.size(), other.size()));
  }

  Pairs paired(const Indices& mine, const Indices& other) const {
    Pairs pairs = by_number(mine, other);
    const double least = least_by_number * std::max(shorter(mine, other), double(pairs.size()));
    return double(same_of(pairs)) >= least ? pairs : by_sequence(mine, other);
  }

  Pairs by_number(const Indices& mine, const Indices& other) const {
    const auto key = [](const TracedResidue& one) {
      return std::pair(one.residue.number, one.residue.insertion_code);
    };
    std::map<std::pair<std::int64_t, char>, std::uint32_t> places;
    for (std::uint32_t k : other) places[key(theirs_[k])] = k;
    Pairs pairs;
    for (std::uint32_t k : mine)
      if (const auto at = places.find(key(ours_[k])); at != places.end())
        pairs.push_back({k, at->second});
    return pairs;
  }

  static std::string letters(const Trace& trace, const Indices& residues) {
    std::string text;
    for (std::uint32_t k : residues) text += trace[k].letter;
    return text;
  }

  Pairs by_sequence(const Indices& mine, const Indices& other) const {
    Pairs pairs = align(letters(ours_, mine), letters(theirs_, other));
    for (ResiduePair& pair : pairs) pair = {mine[pair[0]], other[pair[1]]};
    return pairs;
  }

  std::size_t same_of(const Pairs& pairs) const {
    return std::size_t(std::count_if(pairs.begin(), pairs.end(), [&](const ResiduePair& pair) {
      return ours_[pair[0]].letter == theirs_[pair[1]].letter;
    }));
  }

  const Trace& ours_;
  const Trace& theirs_;
};

/// What is said of a match.
class MatchNotes {
 public:
  MatchNotes(const Trace& ours, const Trace& theirs, std::string_view source)
      : ours_(ours), theirs_(theirs), source_(std::string(source) + ": ") {}

  std::vector<std::string> of(const std::vector<Pairs>& chains, const ResidueMatch& match) {
    notes_.clear();
    tell(std::to_string(match.ours.size()) + " of our " + std::to_string(ours_.size()) +
         " residues are in it" + renamed(chains));
    tell_different(match);
    tell_left_out("ours", ours_, match.ours);
    tell_left_out("theirs", theirs_, match.theirs);
    return std::move(notes_);
  }

 private:
  void tell(const std::string& text) { notes_.push_back(source_ + text); }

  /// " (chains A with B)"; nothing where all are called the same.
  std::string renamed(const std::vector<Pairs>& chains) const {
    const auto name = [](const TracedResidue& one) {
      return one.residue.chain.empty() ? "-" : one.residue.chain;
    };
    std::string text;
    for (const Pairs& pairs : chains) {
      const std::string mine = name(ours_[pairs[0][0]]), other = name(theirs_[pairs[0][1]]);
      if (mine != other) text += (text.empty() ? "" : ", ") + mine + " with " + other;
    }
    return text.empty() ? text : " (chains " + text + ")";
  }

  void tell_different(const ResidueMatch& match) {
    std::string shown;
    std::size_t count = 0;
    for (std::size_t k = 0; k < match.ours.size(); ++k) {
      const TracedResidue& other = theirs_[match.theirs[k]];
      if (ours_[match.ours[k]].letter == other.letter || ++count > most_named) continue;
      shown += (shown.empty() ? "" : ", ") + ours_.label(match.ours[k]) + " is " +
               other.residue.name + std::to_string(other.residue.number);
    }
    if (count == 0) return;
    if (count > most_named) shown += " and " + std::to_string(count - most_named) + " more";
    tell((count == 1 ? "1 residue differs" : std::to_string(count) + " residues differ") +
         ", compared all the same: " + shown);
  }

  void tell_left_out(const std::string& whose, const Trace& trace, Indices used) {
    std::sort(used.begin(), used.end());
    Indices all(trace.size()), rest;
    std::iota(all.begin(), all.end(), 0u);
    std::set_difference(all.begin(), all.end(), used.begin(), used.end(), std::back_inserter(rest));
    if (!rest.empty()) tell("left out, of " + whose + " alone: " + trace.ranges(rest));
  }

  const Trace& ours_;
  const Trace& theirs_;
  std::string source_;
  std::vector<std::string> notes_;
};

}  // namespace

ResidueMatch match_residues(const Trace& ours, const Trace& theirs, std::string_view source) {
  const std::vector<Pairs> chains = Matcher(ours, theirs).by_chain();
  Pairs table;
  for (const Pairs& pairs : chains) table.insert(table.end(), pairs.begin(), pairs.end());
  if (double(table.size()) < std::max(double(least_residues), least_shared * double(ours.size())))
    throw InputError(std::string(source) + ": only " + std::to_string(table.size()) + " of " +
                     std::to_string(ours.size()) +
                     " residues of ours are in it, matched by sequence: is it the same molecule? "
                     "pliant compare --select chooses parts of both");
  std::sort(table.begin(), table.end());
  ResidueMatch match;
  for (const auto& [mine, other] : table) {
    match.ours.push_back(mine);
    match.theirs.push_back(other);
  }
  match.notes = MatchNotes(ours, theirs, source).of(chains, match);
  return match;
}

}  // namespace pliant
