// picture WIDTHxHEIGHT OUT.exr: what the commands of bench/table.py read, half floats of linear
// light, zip.
//
// Smooth light with the noise of a photograph, about 3 bits a sample in a PNG of 8 bits. Larger
// pictures repeat 3840x2160 pixels, shifted to the right so that no compressor sees a row twice.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <string_view>

#include "bench/pictures.h"
#include "tristim/image/io/exr.h"

namespace tristim::bench {
namespace {

constexpr int kShift = kHeight / 5;  // rows, from one repetition to the next on its right

void write_picture(int width, int height, const char* path) {
  const Image tile = photograph_light();
  const std::unique_ptr<RowSink> sink =
      open_exr_sink(path, {.width = width, .height = height}, {.replace = true});
  Image row(width, 1, 3);
  for (int y = 0; y < height; ++y) {
    const std::span<float> to = row.view().row(0);
    for (int part = 0; part * kWidth < width; ++part) {
      const std::span<const float> from = tile.view().row((y + part * kShift) % kHeight);
      const std::size_t begin = static_cast<std::size_t>(part) * from.size();
      std::copy_n(from.data(), std::min(from.size(), to.size() - begin), to.data() + begin);
    }
    sink->write(row.view());
  }
  sink->finish();
}

// The two numbers of WIDTHxHEIGHT; false for anything else.
bool read_size(std::string_view text, int& width, int& height) {
  const char* end = text.data() + text.size();
  const std::from_chars_result first = std::from_chars(text.data(), end, width);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x') return false;
  const std::from_chars_result second = std::from_chars(first.ptr + 1, end, height);
  return second.ec == std::errc() && second.ptr == end && width > 0 && height > 0;
}

}  // namespace
}  // namespace tristim::bench

int main(int count, char** arguments) {
  int width = 0;
  int height = 0;
  if (count != 3 || !tristim::bench::read_size(arguments[1], width, height)) {
    std::fputs("usage: picture WIDTHxHEIGHT OUT.exr\n", stderr);
    return 2;
  }
  try {
    tristim::bench::write_picture(width, height, arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "picture: %s\n", error.what());
    return 1;
  }
}
