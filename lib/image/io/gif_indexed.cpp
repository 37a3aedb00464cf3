#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

#include "lib/image/io/indexed_readers.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

/// giflib's reader over an InputFile.
class GifInput {
 public:
  explicit GifInput(InputFilePtr file) : file_(std::move(file)) {
    int why = 0;
    gif_ = DGifOpen(this, read, &why);
    if (gif_ == nullptr) fail(why);
  }
  ~GifInput() { DGifCloseFile(gif_, nullptr); }
  GifInput(const GifInput&) = delete;
  GifInput& operator=(const GifInput&) = delete;

  const std::string& name() const noexcept { return file_->name(); }
  GifFileType& gif() noexcept { return *gif_; }

  void check(int result) const {
    if (result == GIF_ERROR) fail(gif_->Error);
  }

  [[noreturn]] void fail(int why) const {
    const char* text = GifErrorString(why);
    throw Error(
        ErrorKind::kContent, name(),
        std::string("is damaged or cut off: ") + (text != nullptr ? text : "it is no GIF picture"),
        "write or copy it again");
  }

 private:
  static int read(GifFileType* gif, GifByteType* bytes, int size) {
    auto* self = static_cast<GifInput*>(gif->UserData);
    try {  // nothing may be thrown through giflib
      const std::size_t count = self->file_->read_at(
          self->position_, {reinterpret_cast<std::byte*>(bytes), static_cast<std::size_t>(size)});
      self->position_ += count;
      return static_cast<int>(count);
    } catch (const Error&) {
      return 0;
    }
  }

  InputFilePtr file_;
  std::uint64_t position_ = 0;
  GifFileType* gif_ = nullptr;
};

/// Reads what stands in front of a picture; the transparent position of its control block, if any.
void read_extension(GifInput& input, int& transparent) {
  int code = 0;
  GifByteType* bytes = nullptr;
  input.check(DGifGetExtension(&input.gif(), &code, &bytes));
  while (bytes != nullptr) {
    GraphicsControlBlock control{};
    if (code == GRAPHICS_EXT_FUNC_CODE &&
        DGifExtensionToGCB(bytes[0], bytes + 1, &control) == GIF_OK) {
      transparent = control.TransparentColor;
    }
    input.check(DGifGetExtensionNext(&input.gif(), &bytes));
  }
}

struct Pass {
  int first, step;
};

// The order of the rows; interlaced ones come in four passes [GIF89a].
std::vector<int> row_order(int height, bool interlaced) {
  static constexpr Pass kPasses[] = {{0, 8}, {4, 8}, {2, 4}, {1, 2}};
  static constexpr Pass kAll[] = {{0, 1}};
  std::vector<int> order;
  for (const Pass& pass : interlaced ? std::span<const Pass>(kPasses) : kAll) {
    for (int y = pass.first; y < height; y += pass.step) order.push_back(y);
  }
  return order;
}

void read_picture(GifInput& input, int transparent, IndexedPicture& picture) {
  const GifFileType& gif = input.gif();
  const GifImageDesc& image = gif.Image;
  const ColorMapObject* map = image.ColorMap != nullptr ? image.ColorMap : gif.SColorMap;
  if (map == nullptr) {
    throw Error(ErrorKind::kContent, input.name(), "has no palette", "write it again");
  }
  for (int i = 0; i < map->ColorCount; ++i) {
    const GifColorType& c = map->Colors[i];
    picture.palette.push_back(
        {c.Red, c.Green, c.Blue, static_cast<std::uint8_t>(i == transparent ? 0 : 255)});
  }
  const auto view = picture.positions.view();
  if (image.Left + image.Width > view.width || image.Top + image.Height > view.height) {
    throw Error(ErrorKind::kContent, input.name(), "its picture lies outside of its screen",
                "write it again");
  }
  const int free = transparent >= 0 ? transparent : gif.SBackGroundColor;
  for (int y = 0; y < view.height; ++y) {
    std::ranges::fill(view.row(y), static_cast<std::uint8_t>(std::min(free, map->ColorCount - 1)));
  }
  for (const int y : row_order(image.Height, image.Interlace)) {
    if (image.Width == 0) break;
    input.check(DGifGetLine(&input.gif(), view.pixel(image.Left, image.Top + y), image.Width));
  }
}

void skip_picture(GifInput& input) {
  int code_size = 0;
  GifByteType* bytes = nullptr;
  input.check(DGifGetCode(&input.gif(), &code_size, &bytes));
  while (bytes != nullptr) input.check(DGifGetCodeNext(&input.gif(), &bytes));
}

}  // namespace

std::optional<IndexedPicture> read_indexed_gif(InputFilePtr file) {
  GifInput input(std::move(file));
  IndexedPicture picture;
  picture.positions = position_raster(input.name(), input.gif().SWidth, input.gif().SHeight);
  picture.pictures = 0;
  int transparent = NO_TRANSPARENT_COLOR;
  GifRecordType record = UNDEFINED_RECORD_TYPE;
  while (record != TERMINATE_RECORD_TYPE) {
    input.check(DGifGetRecordType(&input.gif(), &record));
    if (record == EXTENSION_RECORD_TYPE) read_extension(input, transparent);
    if (record != IMAGE_DESC_RECORD_TYPE) continue;
    input.check(DGifGetImageDesc(&input.gif()));
    ++picture.pictures == 1 ? read_picture(input, transparent, picture) : skip_picture(input);
  }
  if (picture.pictures == 0) {
    throw Error(ErrorKind::kContent, input.name(), "holds no picture", "write it again");
  }
  return picture;
}

}  // namespace tristim::detail
