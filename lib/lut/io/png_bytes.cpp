#include "lib/lut/io/png_bytes.h"

#include <png.h>

#include <new>

namespace tristim::detail {
namespace {

void append_bytes(png_structp png, png_bytep bytes, size_t size) {
  auto& out = *static_cast<std::string*>(png_get_io_ptr(png));
  try {
    out.append(reinterpret_cast<const char*>(bytes), size);
  } catch (const std::bad_alloc&) {
    png_error(png, "no memory");  // an exception must not pass through C
  }
}

void flush(png_structp /*png*/) {}

// False where memory ran out. No object with a destructor between setjmp and the jump.
bool write(png_structp png, png_infop info, int width, int height, int bits, const char* samples) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const auto row_bytes = static_cast<std::size_t>(width) * 3 * static_cast<std::size_t>(bits / 8);
  for (int y = 0; y < height; ++y) {
    png_write_row(
        png, reinterpret_cast<png_const_bytep>(samples) + static_cast<std::size_t>(y) * row_bytes);
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string png_bytes(int width, int height, int bits, const std::string& samples) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) throw std::bad_alloc();
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append_bytes, flush);
  const bool done = info != nullptr && write(png, info, width, height, bits, samples.data());
  png_destroy_write_struct(&png, &info);
  if (!done) throw std::bad_alloc();  // nothing else can fail
  return bytes;
}

}  // namespace tristim::detail
