#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "lib/frame/io/color_table.h"
#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kMostSide = 65535;
constexpr double kMostDelay_s = 655.35;  // 16 bits of hundredths

/// giflib's writer into an OutputFile.
class GifFile {
 public:
  explicit GifFile(OutputFile& file) : file_(&file) {
    int why = 0;
    gif_ = EGifOpen(this, write, &why);
    if (gif_ == nullptr) throw std::bad_alloc();
    EGifSetGifVersion(gif_, /*gif89=*/true);
  }
  ~GifFile() {
    file_ = nullptr;  // what giflib still has is for a file that nobody will see
    if (gif_ != nullptr) EGifCloseFile(gif_, nullptr);
  }
  GifFile(const GifFile&) = delete;
  GifFile& operator=(const GifFile&) = delete;

  void begin(const FrameInfo& info, const ColorTable& table) {
    const auto deleter = [](ColorMapObject* map) { GifFreeMapObject(map); };
    const std::unique_ptr<ColorMapObject, decltype(deleter)> map(
        GifMakeMapObject(1 << table.bits, nullptr), deleter);
    if (!map) throw std::bad_alloc();
    for (std::size_t i = 0; i < table.entries.size(); ++i) {
      const auto& srgb = table.entries[i].srgb;
      map->Colors[i] = {srgb[0], srgb[1], srgb[2]};
    }
    check(EGifPutScreenDesc(gif_, info.width, info.height, table.bits, 0, map.get()));
    if (info.frames > 1) put_loop();
  }

  void begin_picture(const FrameInfo& info, int transparent) {
    GraphicsControlBlock control{};
    control.DisposalMode = transparent >= 0 ? DISPOSE_BACKGROUND : DISPOSAL_UNSPECIFIED;
    control.DelayTime = static_cast<int>(std::lround(info.delay_s * 100));
    control.TransparentColor = transparent >= 0 ? transparent : NO_TRANSPARENT_COLOR;
    std::array<GifByteType, 4> bytes{};
    const std::size_t size = EGifGCBToExtension(&control, bytes.data());
    if (info.frames > 1 || transparent >= 0) {
      check(EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size), bytes.data()));
    }
    check(EGifPutImageDesc(gif_, 0, 0, info.width, info.height, false, nullptr));
  }

  void put_row(std::span<GifPixelType> row) {
    check(EGifPutLine(gif_, row.data(), static_cast<int>(row.size())));
  }

  void end() {
    int why = 0;
    const int good = EGifCloseFile(std::exchange(gif_, nullptr), &why);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (good == GIF_ERROR) fail(why);
  }

 private:
  // Shows the pictures again and again [GIF89a]; the extension is that of Netscape 2.0.
  void put_loop() {
    static constexpr char kName[] = "NETSCAPE2.0";
    static constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    check(EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(gif_, sizeof(kName) - 1, kName));
    check(EGifPutExtensionBlock(gif_, static_cast<int>(kForEver.size()), kForEver.data()));
    check(EGifPutExtensionTrailer(gif_));
  }

  void check(int result) {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (result == GIF_ERROR) fail(gif_->Error);
  }

  [[noreturn]] void fail(int why) const {
    const char* text = GifErrorString(why);
    throw Error(ErrorKind::kSystem, file_->path(),
                std::string("cannot be written as GIF: ") + (text != nullptr ? text : "unknown"));
  }

  static int write(GifFileType* gif, const GifByteType* bytes, int size) {
    auto* self = static_cast<GifFile*>(gif->UserData);
    if (self->file_ == nullptr) return size;
    try {
      self->file_->write(std::as_bytes(std::span(bytes, static_cast<std::size_t>(size))));
      return size;
    } catch (...) {
      self->failure_ = std::current_exception();
      return 0;
    }
  }

  OutputFile* file_;
  GifFileType* gif_ = nullptr;
  std::exception_ptr failure_;
};

class GifSink final : public FileSink {
 public:
  GifSink(const std::string& path, const FrameInfo& info, bool replace, const ColorTable& table)
      : FileSink(path, info, replace),
        gif_(file()),
        transparent_(transparent_entry(table.entries)),
        row_(static_cast<std::size_t>(info.width)) {
    gif_.begin(info, table);
  }

 private:
  void write_row(std::span<const std::uint16_t> codes) override {
    if (y_ == 0) gif_.begin_picture(info(), transparent_);
    std::ranges::transform(codes, row_.begin(),
                           [](std::uint16_t code) { return static_cast<GifPixelType>(code); });
    gif_.put_row(row_);
    y_ = (y_ + 1) % info().height;
  }

  void write_end() override { gif_.end(); }

  GifFile gif_;
  int transparent_;
  std::vector<GifPixelType> row_;
  int y_ = 0;
};

}  // namespace

std::unique_ptr<CodeSink> open_gif(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options) {
  const ColorTable table = color_table(path, info, "GIF");
  if (info.width > kMostSide || info.height > kMostSide) {
    throw Error(ErrorKind::kMisuse, path, "GIF holds at most 65535 pixels a side",
                "write PNG or TIFF");
  }
  if (!(info.delay_s >= 0 && info.delay_s <= kMostDelay_s)) {
    throw Error(ErrorKind::kMisuse, path, "GIF shows a picture for at most 655.35 seconds",
                "give a smaller --delay");
  }
  return std::make_unique<GifSink>(path, info, options.replace, table);
}

}  // namespace tristim::detail
