#include <vector>

#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
namespace {

class RawSink final : public FileSink {
 public:
  RawSink(const std::string& path, const FrameInfo& info, bool replace)
      : FileSink(path, info, replace), bytes_(packed_row_bytes(info.layout.packing, info.width)) {}

 private:
  void write_row(std::span<const std::uint16_t> codes) override {
    pack_device_row(codes, info(), scratch_, bytes_);
    file().write(std::as_bytes(std::span(bytes_)));
  }

  std::vector<std::uint16_t> scratch_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::unique_ptr<CodeSink> open_raw(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options) {
  check_palette_codes(path, info);
  return std::make_unique<RawSink>(path, info, options.replace);
}

}  // namespace tristim::detail
