// Times several ways of doing one thing side by side, so that a slow moment of the machine hits all of them.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <functional>
#include <vector>

namespace tripoint::bench {

/// What this process has computed for: others on the machine do not count, who interrupt a long case more often than a
/// short one.
struct ProcessorClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<ProcessorClock>;
  static constexpr bool is_steady = true;
  static time_point now() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return time_point(std::chrono::seconds(used.tv_sec) + duration(used.tv_nsec));
  }
};

/// Median time of each case in microseconds; each is called once a round with a running number.
template <typename Clock = std::chrono::steady_clock>
std::vector<double> interleaved_medians_us(const std::vector<std::function<void(std::size_t)>>& cases,
                                           std::size_t rounds) {
  constexpr std::size_t kWarmUp = 5;
  std::vector<std::vector<double>> times(cases.size());
  std::size_t number = 0;
  for (std::size_t round = 0; round < rounds + kWarmUp; ++round) {
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const auto start = Clock::now();
      cases[k](number++);
      const auto end = Clock::now();
      if (round >= kWarmUp) times[k].push_back(std::chrono::duration<double, std::micro>(end - start).count());
    }
  }
  std::vector<double> medians;
  for (auto& of_case : times) {
    std::nth_element(of_case.begin(), of_case.begin() + static_cast<std::ptrdiff_t>(rounds / 2), of_case.end());
    medians.push_back(of_case[rounds / 2]);
  }
  return medians;
}

}  // namespace tripoint::bench
