#include "lib/image/io/png_input.h"

#include <algorithm>
#include <csetjmp>
#include <new>
#include <string_view>
#include <utility>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr png_alloc_size_t kMaxChunkBytes = png_alloc_size_t{16} << 20;

}  // namespace

PngInput::PngInput(InputFilePtr file, bool keep_positions)
    : file_(std::move(file)), keep_positions_(keep_positions) {
  png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
  info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
  if (info_ == nullptr) {
    png_destroy_read_struct(&png_, nullptr, nullptr);
    throw std::bad_alloc();
  }
}

PngInput::~PngInput() { png_destroy_read_struct(&png_, &info_, nullptr); }

void PngInput::fail(png_structp png, png_const_charp text) {
  auto* self = static_cast<PngInput*>(png_get_error_ptr(png));
  const std::string_view words(text);
  const std::size_t size = std::min(words.size(), sizeof(self->message_) - 1);
  words.copy(self->message_, size);
  self->message_[size] = '\0';
  png_longjmp(png, 1);
}

void PngInput::read_bytes(png_structp png, png_bytep bytes, size_t size) {
  auto* self = static_cast<PngInput*>(png_get_io_ptr(png));
  std::size_t count = 0;
  try {  // nothing may be thrown through libpng
    count = self->file_->read_at(self->position_, {reinterpret_cast<std::byte*>(bytes), size});
  } catch (const Error&) {
    count = 0;
  }
  if (count < size) png_error(png, "the file ends early");
  self->position_ += size;
}

bool PngInput::read_header() {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(modernize-avoid-setjmp): libpng's way
  png_set_read_fn(png_, this, read_bytes);
  png_set_user_limits(png_, kMaxSide, kMaxSide);
  png_set_chunk_malloc_max(png_, kMaxChunkBytes);
  png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS,
                              reinterpret_cast<png_const_bytep>("cICP"), 1);
  png_read_info(png_, info_);
  width_ = png_get_image_width(png_, info_);
  height_ = png_get_image_height(png_, info_);
  stored_depth_ = png_get_bit_depth(png_, info_);
  stored_type_ = png_get_color_type(png_, info_);
  interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
  read_metadata();
  choose_transformations();
  return true;
}

void PngInput::read_metadata() {
  read_png_colour(png_, info_, colour_);
  png_uint_32 across = 0;
  png_uint_32 down = 0;
  int unit = PNG_RESOLUTION_UNKNOWN;
  png_get_pHYs(png_, info_, &across, &down, &unit);
  if (across > 0 && down > 0 && across / 100 <= down && down / 100 <= across) {
    pixel_aspect_ = static_cast<double>(down) / across;
  }
  png_uint_32 size = 0;
  png_bytep exif = nullptr;
  if (png_get_eXIf_1(png_, info_, &size, &exif) != 0) orientation_ = exif_orientation(exif, size);
}

void PngInput::choose_transformations() {
  if (stored_type_ == PNG_COLOR_TYPE_PALETTE && keep_positions_) {
    png_set_packing(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    samples_ = 1;
    depth_ = 8;
    return;
  }
  if (stored_type_ == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
  if (stored_type_ == PNG_COLOR_TYPE_GRAY && stored_depth_ < 8)
    png_set_expand_gray_1_2_4_to_8(png_);
  if (png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png_);
  if (stored_depth_ == 16) png_set_swap(png_);  // to little endian
  png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  samples_ = png_get_channels(png_, info_);
  depth_ = png_get_bit_depth(png_, info_);
}

bool PngInput::read_rows(png_bytepp rows, int count) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(modernize-avoid-setjmp): libpng's way
  if (interlaced_) {
    png_read_image(png_, rows);
  } else {
    png_read_rows(png_, rows, nullptr, static_cast<png_uint_32>(count));
  }
  return true;
}

std::span<const png_color> PngInput::palette() const noexcept {
  png_colorp colors = nullptr;
  int count = 0;
  if (png_get_PLTE(png_, info_, &colors, &count) == 0) return {};
  return {colors, static_cast<std::size_t>(count)};
}

std::span<const png_byte> PngInput::alphas() const noexcept {
  png_bytep alphas = nullptr;
  int count = 0;
  if (png_get_tRNS(png_, info_, &alphas, &count, nullptr) == 0 || alphas == nullptr) return {};
  return {alphas, static_cast<std::size_t>(count)};
}

}  // namespace tristim::detail
