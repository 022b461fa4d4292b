#include "net/work_share.h"

#include <algorithm>

namespace tripoint {

Duration WorkShare::rest_after(Duration worked, TimePoint now) {
  beyond_ = std::max(beyond_ + (worked - worked_) - (now - now_) / 2, -kMostSaved);
  worked_ = worked;
  now_ = now;
  return beyond_ > kWorthARest ? 2 * beyond_ : Duration{0};
}

}  // namespace tripoint
