#include "tools/swatches.h"

#include <unistd.h>

#include <array>
#include <cstdlib>

#include "tristim/palette/palette.h"

namespace tristim::tools {
namespace {

// Of xterm's cube, whose steps are not equal, and of its greys.
constexpr std::array kCube{0, 95, 135, 175, 215, 255};
constexpr int kFirstGrey = 232;
constexpr int kGreys = 24;

int grey_code(int i) { return 8 + 10 * i; }

std::string variable(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): never set here
  return value == nullptr ? "" : value;
}

int nearest_step(int code) {
  int best = 0;
  for (int i = 1; i < static_cast<int>(kCube.size()); ++i) {
    const auto at = [&](int k) { return std::abs(kCube[static_cast<std::size_t>(k)] - code); };
    if (at(i) < at(best)) best = i;
  }
  return best;
}

int distance2(std::array<int, 3> a, std::array<int, 3> b) {
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

}  // namespace

TerminalColors terminal_colors(std::string_view when) {
  const bool automatic = when != "always";
  const bool plain = isatty(STDOUT_FILENO) != 1 || !variable("NO_COLOR").empty() ||
                     variable("TERM") == "dumb" || variable("TERM").empty();
  if (when == "never" || (automatic && plain)) return TerminalColors::kNone;
  const std::string kind = variable("COLORTERM");
  return kind == "truecolor" || kind == "24bit" ? TerminalColors::kTrue : TerminalColors::k256;
}

int terminal_color256(const EncodedRgb& color) {
  const auto [r, g, b] = color_codes8(color);
  const std::array<int, 3> asked{r, g, b};
  std::array<int, 3> cube{};
  int index = 16;
  for (std::size_t c = 0; c < 3; ++c) {
    const int step = nearest_step(asked[c]);
    cube[c] = kCube[static_cast<std::size_t>(step)];
    index += step * (c == 0 ? 36 : c == 1 ? 6 : 1);
  }
  int least = distance2(asked, cube);
  for (int i = 0; i < kGreys; ++i) {
    const int grey = grey_code(i);
    if (distance2(asked, {grey, grey, grey}) >= least) continue;
    least = distance2(asked, {grey, grey, grey});
    index = kFirstGrey + i;
  }
  return index;
}

std::string swatch(const EncodedRgb& color, TerminalColors colors, int width) {
  const std::string blanks(static_cast<std::size_t>(width), ' ');
  if (colors == TerminalColors::kNone) return blanks;
  std::string code = "5;" + std::to_string(terminal_color256(color));
  if (colors == TerminalColors::kTrue) {
    const auto [r, g, b] = color_codes8(color);
    code = "2;" + std::to_string(r) + ";" + std::to_string(g) + ";" + std::to_string(b);
  }
  return "\x1b[48;" + code + "m" + blanks + "\x1b[0m";
}

}  // namespace tristim::tools
