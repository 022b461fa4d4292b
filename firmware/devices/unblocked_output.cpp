#include "devices/unblocked_output.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <climits>

namespace tripoint {

static_assert(UnblockedOutput::kLongest <= PIPE_BUF);

void UnblockedOutput::write(std::string_view line) {
  if (!ready()) {
    ++dropped_;
    return;
  }
  std::string text =
      dropped_ == 0 ? std::string{} : fmt::format("({} lines were dropped: nobody read them)\n", dropped_);
  text += line;
  if (text.size() > kLongest) {
    text.resize(kLongest - 1);
    text += '\n';
  }
  // What cannot be written now is lost: there is no other place to say so.
  dropped_ = ::write(descriptor_, text.data(), text.size()) < 0 ? dropped_ + 1 : 0;
}

bool UnblockedOutput::ready() const {
  pollfd asked{.fd = descriptor_, .events = POLLOUT, .revents = 0};
  return ::poll(&asked, 1, 0) == 1 && asked.revents == POLLOUT;  // POLLERR: the reader is gone, and SIGPIPE would come
}

}  // namespace tripoint
