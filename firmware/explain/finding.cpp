#include "explain/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "explain/why.h"

namespace tripoint {
namespace {

/// The causes are listed in the order of the gates, apart from this one.
int gates_passed(DropCause cause) { return cause == DropCause::kSeenBefore ? 0 : static_cast<int>(cause); }

/// Of one cause, the stronger spot first.
bool stands_out_more(const Finding& a, const Finding& b) {
  return std::tuple(b.candidate.contrast, b.candidate.peak) < std::tuple(a.candidate.contrast, a.candidate.peak);
}

struct Ranked {
  Finding finding;
  int place_in_cause = 0;
};

bool earlier(const Ranked& a, const Ranked& b) {
  if (a.place_in_cause != b.place_in_cause) return a.place_in_cause < b.place_in_cause;
  return gates_passed(a.finding.candidate.cause) > gates_passed(b.finding.candidate.cause);
}

std::vector<Finding> by_interest(std::vector<Finding> dropped) {
  std::stable_sort(dropped.begin(), dropped.end(), stands_out_more);
  std::array<int, kDropCauseNames.size()> seen{};
  std::vector<Ranked> ranked;
  ranked.reserve(dropped.size());
  for (const Finding& finding : dropped) {
    ranked.push_back({finding, seen[static_cast<std::size_t>(finding.candidate.cause)]++});
  }
  std::stable_sort(ranked.begin(), ranked.end(), earlier);
  std::transform(ranked.begin(), ranked.end(), dropped.begin(), [](const Ranked& entry) { return entry.finding; });
  return dropped;
}

}  // namespace

std::vector<Finding> findings_of(const CandidateLog& log, const Detection& detection) {
  std::vector<Finding> kept;
  std::vector<Finding> dropped;
  for (const Candidate& candidate : log) {
    const int number = static_cast<int>(kept.size() + dropped.size()) + 1;
    if (candidate.cause == DropCause::kKept) {
      kept.push_back({number, candidate, detection.points[kept.size()].covariance_px2});
    } else {
      dropped.push_back({number, candidate, std::nullopt});
    }
  }
  dropped = by_interest(std::move(dropped));
  kept.insert(kept.end(), dropped.begin(), dropped.end());
  return kept;
}

std::string tally_of_dropped(std::span<const Finding> findings) {
  std::array<std::pair<int, DropCause>, kDropCauseNames.size()> counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i].second = static_cast<DropCause>(i);
  for (const Finding& finding : findings) {
    if (!finding.kept()) ++counts[static_cast<std::size_t>(finding.candidate.cause)].first;
  }
  std::stable_sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [count, cause] : counts) {
    if (count == 0) break;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, cause_in_words(cause));
  }
  return text;
}

}  // namespace tripoint
