// Identification of identical LEDs by geometry: 100,000 views of each target, with seeds that no test looks at.
//
// usage: bench_identity [VIEWS]
#include <cstdio>
#include <cstdlib>

#include "bench/figure.h"
#include "bench/identity_score.h"

namespace tripoint::bench {
namespace {

constexpr std::uint64_t kFirstSeed = 1'000'001;

int run(int views) {
  IdentityScore sum;
  for (const ScoredTarget& target : scored_targets()) {
    const IdentityScore score = identity_score(target.leds_mm, {}, kFirstSeed, views);
    std::fprintf(stderr, "identity, %-12s: %d of %d found, %d wrong in %d views (%d without confirmation)\n",
                 target.name.data(), score.found, score.whole, score.wrong, score.views, score.wrong_alone);
    sum.whole += score.whole;
    sum.found += score.found;
    sum.wrong += score.wrong;
  }
  print({at_least({.name = "identity_found_share", .value = 1.0 * sum.found / sum.whole, .unit = "share"}, 0.99),
         at_most({.name = "identity_wrong", .value = 1.0 * sum.wrong, .unit = "views"}, 0.0)});
  return 0;
}

}  // namespace
}  // namespace tripoint::bench

int main(int count, char** words) {
  return tripoint::bench::run(count > 1 ? static_cast<int>(std::strtol(words[1], nullptr, 10)) : 100'000);
}
