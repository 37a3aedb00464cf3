#include "tools/progress.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tools/cli.h"

namespace tristim::tools {

Progress::Progress(const std::string& name, int height)
    : name_(one_line(name)), height_(height), shown_(isatty(STDERR_FILENO) == 1 && !quiet()) {}

// The line is overwritten by blanks: an escape sequence to clear it is not for every terminal.
Progress::~Progress() {
  if (drawn_) std::fprintf(stderr, "\r%*s\r", static_cast<int>(name_.size()) + 7, "");
}

void Progress::seen(ImageView<const float> /*light*/, ImageView<const std::uint16_t> codes) {
  constexpr auto kStep = std::chrono::milliseconds(200);
  done_ += codes.height;
  const auto now = std::chrono::steady_clock::now();
  if (!shown_ || now - last_ < kStep) return;
  last_ = now;
  drawn_ = true;
  std::fprintf(stderr, "\r%s: %3d %%", name_.c_str(), static_cast<int>(100.0 * done_ / height_));
}

}  // namespace tristim::tools
