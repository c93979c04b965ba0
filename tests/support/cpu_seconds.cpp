// SPDX-License-Identifier: MIT
// Each test's report has its CPU seconds, with those of processes that it waited for, and its file.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <string>

namespace {

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

double seconds_of(int whom) {
  rusage used{};
  getrusage(whom, &used);
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double spent() { return seconds_of(RUSAGE_SELF) + seconds_of(RUSAGE_CHILDREN); }

class CpuSeconds : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& /*test*/) override { before_ = spent(); }

  void OnTestEnd(const testing::TestInfo& test) override {
    testing::Test::RecordProperty("cpu", std::to_string(spent() - before_));
    testing::Test::RecordProperty("source", test.file());
  }

  double before_ = 0.0;
};

[[maybe_unused]] const bool is_listening = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new CpuSeconds);  // which owns it
  return true;
}();

}  // namespace
