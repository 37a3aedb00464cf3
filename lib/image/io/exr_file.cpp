#include "lib/image/io/exr_file.h"

#include <cmath>
#include <iterator>
#include <span>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr const char* kCompressions[] = {"none",  "rle", "zips", "zip",  "piz",
                                         "pxr24", "b44", "b44a", "dwaa", "dwab"};

constexpr double kMostPixelAspect = 100;  // what is beyond, or below its inverse, is taken for 1

// OpenEXR's core library calls these from C, so nothing may be thrown.
std::int64_t read_bytes(exr_const_context_t /*context*/, void* user_data, void* buffer,
                        std::uint64_t size, std::uint64_t offset,
                        exr_stream_error_func_ptr_t /*report*/) {
  const auto* file = static_cast<const InputFile*>(user_data);
  try {
    const std::span<std::byte> bytes(static_cast<std::byte*>(buffer), size);
    return static_cast<std::int64_t>(file->read_at(offset, bytes));
  } catch (...) {
    return -1;
  }
}

std::int64_t file_size(exr_const_context_t /*context*/, void* user_data) {
  return static_cast<std::int64_t>(static_cast<const InputFile*>(user_data)->size());
}

void ignore_message(exr_const_context_t /*context*/, exr_result_t /*code*/, const char* /*text*/) {}

PixelWindow window_of(const exr_attr_box2i_t& box) {
  return {box.min.x, box.min.y, std::int64_t{box.max.x} - box.min.x + 1,
          std::int64_t{box.max.y} - box.min.y + 1};
}

}  // namespace

ExrFile::ExrFile(InputFilePtr file) : file_(std::move(file)) {
  exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
  options.error_handler_fn = ignore_message;
  options.user_data = const_cast<InputFile*>(file_.get());
  options.read_fn = read_bytes;
  options.size_fn = file_size;
  // not strict, it takes a window of 64x64 where that attribute is damaged; and its search for lost
  // chunks reads the whole file, and may find wrong ones
  options.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_SILENT_HEADER_PARSE |
                  EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
  check(exr_start_read(&context_, file_->name().c_str(), &options));
}

ExrFile::~ExrFile() { exr_finish(&context_); }

int ExrFile::part_count() const {
  int count = 0;
  check(exr_get_count(context_, &count));
  return count;
}

ExrPart ExrFile::part(int index) const {
  ExrPart part;
  part.index = index;
  const char* name = nullptr;
  if (exr_get_name(context_, index, &name) == EXR_ERR_SUCCESS && name != nullptr) part.name = name;
  exr_storage_t storage = EXR_STORAGE_SCANLINE;
  check(exr_get_storage(context_, index, &storage));
  part.deep = storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED;
  part.tiled = storage == EXR_STORAGE_TILED;
  exr_compression_t compression = EXR_COMPRESSION_NONE;
  check(exr_get_compression(context_, index, &compression));
  if (static_cast<std::size_t>(compression) < std::size(kCompressions)) {
    part.compression = kCompressions[compression];
  }
  read_windows(part);
  read_channels(part);
  read_colour(part);
  if (!part.deep) read_chunks(part);
  return part;
}

void ExrFile::check(exr_result_t result) const {
  if (result == EXR_ERR_SUCCESS) return;
  if (result == EXR_ERR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw Error(ErrorKind::kContent, file_->name(), "its EXR header is damaged or cut off",
              "write or copy it again");
}

void ExrFile::read_windows(ExrPart& part) const {
  exr_attr_box2i_t box = {};
  check(exr_get_data_window(context_, part.index, &box));
  part.data = window_of(box);
  check(exr_get_display_window(context_, part.index, &box));
  part.display = window_of(box);
  float aspect = 1;
  check(exr_get_pixel_aspect_ratio(context_, part.index, &aspect));
  if (aspect >= 1 / kMostPixelAspect && aspect <= kMostPixelAspect)
    part.pixel_aspect = double{aspect};
}

void ExrFile::read_channels(ExrPart& part) const {
  const exr_attr_chlist_t* list = nullptr;
  check(exr_get_channels(context_, part.index, &list));
  for (int i = 0; i < list->num_channels; ++i) {
    const exr_attr_chlist_entry_t& entry = list->entries[i];
    part.channels.push_back(
        {entry.name.str, entry.pixel_type, entry.x_sampling != 1 || entry.y_sampling != 1});
  }
}

void ExrFile::read_colour(ExrPart& part) const {
  exr_attr_chromaticities_t c = {};
  if (exr_attr_get_chromaticities(context_, part.index, "chromaticities", &c) == EXR_ERR_SUCCESS) {
    const auto point = [](float x, float y) { return Chromaticity{double{x}, double{y}}; };
    part.chromaticities = Primaries{point(c.red_x, c.red_y), point(c.green_x, c.green_y),
                                    point(c.blue_x, c.blue_y), point(c.white_x, c.white_y)};
  }
  exr_attr_v2f_t neutral = {};
  if (exr_attr_get_v2f(context_, part.index, "adoptedNeutral", &neutral) == EXR_ERR_SUCCESS) {
    part.adopted_neutral = Chromaticity{double{neutral.x}, double{neutral.y}};
  }
}

void ExrFile::read_chunks(ExrPart& part) const {
  std::int32_t width =
      static_cast<std::int32_t>(std::min<std::int64_t>(part.data.width, INT32_MAX));
  std::int32_t rows = 1;
  if (part.tiled) {
    check(exr_get_tile_sizes(context_, part.index, 0, 0, &width, &rows));
  } else {
    check(exr_get_scanlines_per_chunk(context_, part.index, &rows));
  }
  if (width < 1 || rows < 1) check(EXR_ERR_FILE_BAD_HEADER);
  part.chunk_width = width;
  part.chunk_rows = rows;
}

}  // namespace tristim::detail
