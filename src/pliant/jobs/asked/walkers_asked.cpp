// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/walkers_asked.hpp"

#include <optional>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr std::string_view run_group = "Run", technique_group = "Technique",
                           perturbation_group = "Perturbation";
constexpr std::int64_t most_walkers = 1'000'000;

template <auto Member>
constexpr auto at = place_at<WalkersAsked, Member>;

constexpr OptionField<WalkersAsked> table[] = {
    {{.name = "walkers",
      .group = run_group,
      .summary = "independent copies, each with its own output",
      .range = Range::positive,
      .most = most_walkers,
      .users = {.python = false, .file = false}},
     at<&WalkersAsked::walkers>},
    {{.name = "shard",
      .group = run_group,
      .summary = "run only these walkers, such as 800..899",
      .kind = "FIRST..LAST",
      .users = {.command = false, .python = false, .file = false}},
     at<&WalkersAsked::shard>},
    {{.name = "one_file",
      .group = run_group,
      .summary = "one trajectory for all walkers, one after another; the observable walker tells\n"
                 "them apart. A walker's frames wait in memory until it ends",
      .users = {.command = false, .python = false, .file = false}},
     at<&WalkersAsked::one_file>},
    {{.name = "threads",
      .group = run_group,
      .summary = "threads that share the walkers",
      .range = Range::positive,
      .is_optional = true,
      .most = 4096,
      .unset_means = "all cores",
      .users = {.python = false, .file = false}},
     at<&WalkersAsked::threads>},
    {{.name = "ordering",
      .group = technique_group,
      .summary = "visit the bars in the order listed in this file; replaces --technique",
      .kind = "FILE",
      .is_file = true,
      .users = {.python = false}},
     at<&WalkersAsked::ordering>},
    {{.name = "forces",
      .group = perturbation_group,
      .summary = "replay a force file: one push per step, or what was done by hand;\n"
                 "replaces --perturb. Options that the file holds need not be given",
      .kind = "FILE",
      .is_file = true,
      .users = {.python = false}},
     at<&WalkersAsked::forces>},
    {{.name = "record_forces",
      .group = perturbation_group,
      .summary = "write the push of each step to a force file, for --forces",
      .kind = "FILE",
      .in_python = "Force file to write: the push of each step, which `read_force_file` reads for\n"
                   "`replay`. Only for ``perturb=\"force\"`` or a replay, not for pushes of all "
                   "joints. It\nexists once the run has ended.",
      .users = {.file = false, .again = false},
      .type_in_python = "str | os.PathLike[str] | None"},
     at<&WalkersAsked::record_forces>},
};

}  // namespace

std::span<const OptionField<WalkersAsked>> walkers_fields() { return table; }

void number_walkers(WalkersAsked& asked) {
  if (asked.shard.empty()) return;
  const std::string_view text = asked.shard;
  const std::size_t dots = text.find("..");
  const auto first = parse_integer(text.substr(0, dots));
  const auto last = dots == text.npos ? std::nullopt : parse_integer(text.substr(dots + 2));
  if (!first || !last || *first < 0 || *last < *first || *last - *first >= most_walkers)
    throw OptionError("shard: expected FIRST..LAST, two walkers' numbers, at most " +
                      std::to_string(most_walkers) + " walkers, found " + quoted(text));
  asked.first = *first;
  asked.walkers = *last - *first + 1;
}

}  // namespace pliant
