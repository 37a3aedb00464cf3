#include "tools/progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tools/cli.h"

namespace tristim::tools {

Progress::Progress(const std::string& name, int height, int width)
    : name_(one_line(name)),
      height_(height),
      width_(width),
      shown_(isatty(STDERR_FILENO) == 1 && !quiet()) {}

Progress::~Progress() { erase(); }

// The line is overwritten by blanks: an escape sequence to clear it is not for every terminal.
void Progress::erase() {
  if (drawn_ > 0) std::fprintf(stderr, "\r%*s\r", static_cast<int>(drawn_), "");
  drawn_ = 0;
}

void Progress::seen(ImageView<const float> /*light*/, ImageView<const std::uint16_t> codes) {
  advance(codes.height);
}

void Progress::advance(int rows) {
  constexpr auto kStep = std::chrono::milliseconds(200);
  done_ += rows;
  const auto now = std::chrono::steady_clock::now();
  if (!shown_ || now - last_ < kStep) return;
  last_ = now;
  std::array<char, 80> text{};
  const double part = static_cast<double>(done_) / height_;
  int size = std::snprintf(text.data(), text.size(), "%3d %%", static_cast<int>(100 * part));
  if (width_ > 0) {
    const double seconds = std::chrono::duration<double>(now - first_).count();
    const double rate = 1e-6 * done_ * width_ / seconds;
    size = std::snprintf(text.data(), text.size(), "%3d %%, %.2f Mpixel/s, %.0f s left",
                         static_cast<int>(100 * part), rate, std::ceil(seconds / part - seconds));
  }
  const std::size_t length = name_.size() + 2 + static_cast<std::size_t>(std::max(size, 0));
  // Blanks cover what is left of a longer line.
  const int rest = static_cast<int>(drawn_ > length ? drawn_ - length : 0);
  std::fprintf(stderr, "\r%s: %s%*s", name_.c_str(), text.data(), rest, "");
  drawn_ = std::max(drawn_, length);
}

std::unique_ptr<BandObserver> make_progress(const std::string& input, int height) {
  return std::make_unique<Progress>(input, height);
}

}  // namespace tristim::tools
