#include "lib/frame/io/png_file.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr double kMetresPerInch = 0.0254;

int png_type(PngColour colour) {
  if (colour == PngColour::kPalette) return PNG_COLOR_TYPE_PALETTE;
  return colour == PngColour::kRgb ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY;
}

void set_colour(png_structp png, png_infop info, const FrameInfo& frame) {
  if (frame.srgb || !frame.palette.empty()) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
    return;
  }
  if (!frame.gamma) return;
  png_set_gAMA(png, info, 1 / *frame.gamma);
  const Primaries& p = frame.primaries;
  const Chromaticity points[] = {p.red, p.green, p.blue, p.white};
  // The chunk has no negative numbers, so the phosphors of ACES cannot be told.
  const bool representable = std::ranges::all_of(points, [](const Chromaticity& point) {
    return point.x >= 0 && point.y >= 0 && point.x + point.y <= 1;
  });
  if (!representable) return;
  png_set_cHRM(png, info, p.white.x, p.white.y, p.red.x, p.red.y, p.green.x, p.green.y, p.blue.x,
               p.blue.y);
}

void set_significant_bits(png_structp png, png_infop info, const FrameInfo& frame) {
  const auto& bits = frame.layout.packing.bits;
  png_color_8 significant{};
  significant.red = static_cast<png_byte>(bits[0]);
  significant.green = static_cast<png_byte>(bits[1]);
  significant.blue = static_cast<png_byte>(bits[2]);
  significant.gray = static_cast<png_byte>(bits[0]);
  png_set_sBIT(png, info, &significant);
}

void set_resolution(png_structp png, png_infop info, double dpi) {
  if (!(dpi > 0)) return;
  const auto dots = static_cast<png_uint_32>(std::min(std::round(dpi / kMetresPerInch), 1e9));
  png_set_pHYs(png, info, dots, dots, PNG_RESOLUTION_METER);
}

void set_software(png_structp png, png_infop info) {
  char key[] = "Software";
  char value[] = "tristim";
  png_text software{};
  software.compression = PNG_TEXT_COMPRESSION_NONE;
  software.key = key;
  software.text = value;
  png_set_text(png, info, &software, 1);
}

}  // namespace

bool is_widened(const FrameInfo& frame, const PngShape& shape) {
  const auto& bits = frame.layout.packing.bits;
  return shape.colour != PngColour::kPalette &&
         std::any_of(bits.begin(), bits.begin() + shape.samples,
                     [&](int sample) { return sample != shape.depth; });
}

struct PngFile::State {
  OutputFile& file;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::exception_ptr failure;
  std::array<char, 128> message{};

  explicit State(OutputFile& output) : file(output) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr) {
      png_destroy_write_struct(&png, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png, this, on_write, on_flush);
  }
  ~State() { png_destroy_write_struct(&png, &info); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// Runs calls of libpng, whose failures jump; `calls` makes nothing that needs destroying.
  template <typename Calls>
  void guarded(const Calls& calls) {
    if (setjmp(png_jmpbuf(png)) != 0) {
      if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
      throw Error(ErrorKind::kSystem, file.path(),
                  std::string("cannot be written as PNG: ") + message.data());
    }
    calls();
  }

  static void on_error(png_structp png, png_const_charp text) {
    auto* self = static_cast<State*>(png_get_error_ptr(png));
    std::snprintf(self->message.data(), self->message.size(), "%s", text);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_flush(png_structp) {}
  static void on_write(png_structp png, png_bytep bytes, std::size_t size) {
    auto* self = static_cast<State*>(png_get_io_ptr(png));
    try {
      self->file.write(std::as_bytes(std::span(bytes, size)));
    } catch (...) {
      self->failure = std::current_exception();
    }
    if (self->failure) png_error(png, "write");
  }
};

PngFile::PngFile(OutputFile& file, const FrameInfo& frame, const PngShape& shape)
    : state_(std::make_unique<State>(file)) {
  std::vector<png_color> palette;
  std::vector<png_byte> alpha;
  for (const PaletteEntry& entry : frame.palette) {
    palette.push_back({entry.srgb[0], entry.srgb[1], entry.srgb[2]});
    alpha.push_back(entry.alpha);
  }
  while (!alpha.empty() && alpha.back() == 255) alpha.pop_back();
  png_structp png = state_->png;
  png_infop info = state_->info;
  state_->guarded([&] {
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_benign_errors(png, 1);
    png_set_IHDR(png, info, static_cast<png_uint_32>(frame.width),
                 static_cast<png_uint_32>(frame.height), shape.depth, png_type(shape.colour),
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) {
      png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (!alpha.empty()) {
      png_set_tRNS(png, info, alpha.data(), static_cast<int>(alpha.size()), nullptr);
    }
    set_colour(png, info, frame);
    if (is_widened(frame, shape)) set_significant_bits(png, info, frame);
    set_resolution(png, info, frame.dpi);
    set_software(png, info);
    png_write_info(png, info);
  });
}

PngFile::~PngFile() = default;

void PngFile::write_chunk(const char* name, std::span<const std::uint8_t> bytes) {
  state_->guarded([&] {
    png_write_chunk(state_->png, reinterpret_cast<png_const_bytep>(name), bytes.data(),
                    bytes.size());
  });
}

}  // namespace tristim::detail
