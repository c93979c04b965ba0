// SPDX-License-Identifier: MIT
// pliant_angle_race [--bars bonds|angles] [--displacement A] [--least-sine S] [--rounds N] FILE...
//
// Ours against Newton with a sparse factorization, at equal error: every joint of a molecule is
// displaced, and both make the bars whole, by turns, each displacement anew. Times are those of the
// thread; plans, the order of elimination among them, are made before. Ends with 1 if bars that
// were said to be whole are not.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <deque>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "bench/sparse_newton.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/random.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/resolve/resolve.hpp"

namespace pliant::bench {
namespace {

struct Options {
  BarKind bars = BarKind::angles;
  double displacement = 0.1;  // Angstrom
  double least_sine = 0.1;
  int rounds = 9;
  std::vector<std::string> files = {};
};

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// What came of one contender: seconds of each round and the errors of the worst.
struct Result {
  std::vector<double> seconds = {};
  double own_error = 0.0;  // of the bars that it was given
  double error = 0.0;      // of all bars
  int steps = 0, failed = 0;
};

std::vector<Vec3> displaced(std::span<const Vec3> whole, double size, std::uint64_t seed) {
  std::vector<Vec3> positions(whole.begin(), whole.end());
  for (std::size_t joint = 0; joint < positions.size(); ++joint) {
    RandomSequence random({.seed = seed, .domain = Domain::displacement, .joint = joint});
    positions[joint] += size * random.direction();
  }
  return positions;
}

void run_ours(Result& result, Resolver& resolver, const Framework& framework,
              std::vector<Vec3> positions, double tolerance) {
  const double start = thread_seconds();
  const ResolveSummary summary = resolver.resolve(positions);
  result.seconds.push_back(thread_seconds() - start);
  const double error = measure(framework, positions).max_relative;
  result.own_error = result.error = std::max(result.error, error);
  result.steps = std::max(result.steps, static_cast<int>(summary.sweeps));
  result.failed += error <= tolerance * (1 + 1e-9) ? 0 : 1;
}

void run_newton(Result& result, SparseNewton& newton, const Framework& framework,
                std::vector<Vec3> positions, std::span<const Vec3> whole, double tolerance) {
  const double start = thread_seconds();
  const int steps = newton.resolve(positions, whole, tolerance);
  result.seconds.push_back(thread_seconds() - start);
  result.failed += steps < 0 ? 1 : 0;
  if (steps < 0) return;
  result.steps = std::max(result.steps, steps);
  result.own_error = std::max(result.own_error, newton.error(positions));
  result.error = std::max(result.error, measure(framework, positions).max_relative);
}

void print(const char* name, const Result& result, std::size_t bars, double theirs, int rounds) {
  const double seconds = median(result.seconds);
  std::printf("  %-14s %9.1f us %7.2f ns a bar %6.2f x  %2d steps, error %.1e", name, 1e6 * seconds,
              1e9 * seconds / static_cast<double>(bars), theirs / seconds, result.steps,
              result.own_error);
  if (result.error > 2 * result.own_error) std::printf(", of all bars %.1e", result.error);
  std::printf(result.failed > 0 ? ", %d of %d failed\n" : "\n", result.failed, rounds);
}

/// Ours and theirs, ready for one tolerance.
struct Contenders {
  std::vector<Resolver> ours = {};
  std::deque<SparseNewton>& theirs;
};

const std::vector<const char*> our_names = {"units", "auto"};
const std::vector<const char*> their_names = {"Newton, LU", "quasi-N., LDL"};

/// One displacement for all, who take turns.
void run_round(Contenders& all, std::vector<Result>& results, const Framework& framework,
               std::span<const Vec3> whole, const std::vector<Vec3>& broken, double tolerance) {
  auto result = results.begin();
  for (SparseNewton& newton : all.theirs)
    run_newton(*result++, newton, framework, broken, whole, tolerance);
  for (Resolver& resolver : all.ours) run_ours(*result++, resolver, framework, broken, tolerance);
}

/// The least time of those of theirs that never failed; of all, if all did.
double their_seconds(std::span<const Result> results) {
  double least = std::numeric_limits<double>::infinity(), any = least;
  for (const Result& result : results) {
    any = std::min(any, median(result.seconds));
    if (result.failed == 0) least = std::min(least, median(result.seconds));
  }
  return std::isfinite(least) ? least : any;
}

/// How many rounds of ours ended with a bar that is not whole.
int race(const Framework& framework, std::span<const Vec3> whole, std::deque<SparseNewton>& theirs,
         double tolerance, const Options& options) {
  Contenders all{.theirs = theirs};
  for (const char* name : our_names) {
    ResolveOptions asked;
    asked.tolerance.relative = tolerance;
    all.ours.emplace_back(framework, Technique{name}, asked);
  }
  std::vector<Result> results(their_names.size() + our_names.size());
  for (int round = -1; round < options.rounds; ++round) {
    const auto seed = static_cast<std::uint64_t>(round + 1);
    const auto broken = displaced(whole, options.displacement, seed);
    if (round == 0) std::fill(results.begin(), results.end(), Result{});  // plans are made
    run_round(all, results, framework, whole, broken, tolerance);
  }
  const double least = their_seconds(std::span(results).first(their_names.size()));
  std::printf(" to %.0e\n", tolerance);
  int failed = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const bool is_ours = k >= their_names.size();
    const char* name = is_ours ? our_names[k - their_names.size()] : their_names[k];
    print(name, results[k], framework.bar_count(), least, options.rounds);
    if (is_ours) failed += results[k].failed;
  }
  return failed;
}

int race_on(const std::string& file, const Options& options) {
  Structure structure = read_structure(file);
  perceive_bonds(structure);
  const Framework framework = build_framework(structure, {.bars = options.bars});
  const auto kept = independent_bars(framework, structure.positions, options.least_sine);
  std::deque<SparseNewton> theirs;
  for (const NewtonMatrix kind : {NewtonMatrix::unsymmetric, NewtonMatrix::symmetric})
    theirs.emplace_back(framework, kept, kind);
  std::printf(
      "%s: %zu joints, %zu bars; theirs: %zu independent (sine %.2g or more); each joint "
      "off by %.2g A\n",
      std::filesystem::path(file).filename().c_str(), framework.joint_count(),
      framework.bar_count(), kept.size(), options.least_sine, options.displacement);
  int failed = 0;
  for (const double tolerance : {1e-8, 1e-10})
    failed += race(framework, structure.positions, theirs, tolerance, options);
  return failed;
}

Options parse(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool has_value = word.starts_with("--");
    const std::string value = has_value && k + 1 < count ? words[++k] : "";
    if (word == "--bars")
      options.bars = value == "bonds" ? BarKind::bonds : BarKind::angles;
    else if (word == "--displacement")
      options.displacement = std::stod(value);
    else if (word == "--least-sine")
      options.least_sine = std::stod(value);
    else if (word == "--rounds")
      options.rounds = std::stoi(value);
    else
      options.files.push_back(word);
  }
  return options;
}

}  // namespace
}  // namespace pliant::bench

int main(int count, char** words) try {
  const pliant::bench::Options options = pliant::bench::parse(count, words);
  int failed = 0;
  for (const std::string& file : options.files) failed += pliant::bench::race_on(file, options);
  return failed > 0 ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "pliant_angle_race: %s\n", error.what());
  return 1;
}
