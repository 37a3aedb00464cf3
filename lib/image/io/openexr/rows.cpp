#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <span>
#include <vector>

#include "lib/image/io/module.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kThreads = 0;  // decode in the caller's

[[noreturn]] void refuse(const std::string& name, const std::string& wrong) {
  throw Error(ErrorKind::kContent, name, wrong, "write or copy it again");
}

// Buffers are made for the window that the caller has read from the header.
void check_window(const Imath::Box2i& window, const ExrRowsRequest& request) {
  const PixelWindow& data = request.data;
  const bool same = window.min.x == data.x && window.min.y == data.y &&
                    window.max.x == data.x + data.width - 1 &&
                    window.max.y == data.y + data.height - 1;
  if (!same) refuse(request.name, "its EXR header is damaged");
}

/// Channels as they are, for the compressions that OpenEXR's core library does not decode.
class ChannelRows final : public NativeRows {
 public:
  explicit ChannelRows(const ExrRowsRequest& request)
      : request_(request),
        file_(request.path.c_str(), kThreads),
        part_(file_, request.part),
        window_(part_.header().dataWindow()) {
    check_window(window_, request);
  }

  void read(int first, int count, std::span<std::byte> bytes) override {
    const std::ptrdiff_t width = window_.max.x - window_.min.x + 1;
    auto* pixels = reinterpret_cast<float*>(bytes.data());
    std::fill_n(pixels, 4 * width * count, 0.0F);
    const int y = window_.min.y + first;
    // OpenEXR's addresses are relative to its origin, not to the first pixel
    float* origin = pixels - 4 * (window_.min.x + width * y);
    const auto row_bytes = static_cast<std::size_t>(width) * 4 * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t slot = 0; slot < 4; ++slot) {
      const std::string& channel = request_.channels[slot];
      if (channel.empty() || frame.findSlice(channel.c_str()) != nullptr) continue;
      frame.insert(channel.c_str(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(origin + slot),
                                               4 * sizeof(float), row_bytes));
    }
    try {
      part_.setFrameBuffer(frame);
      part_.readPixels(y, y + count - 1);
    } catch (const std::exception&) {
      const int display_y = part_.header().displayWindow().min.y;
      refuse(request_.name,
             "is damaged or cut off at row " + std::to_string(std::max(y - display_y, 0)));
    }
    complete(std::span(pixels, static_cast<std::size_t>(4 * width * count)));
  }

 private:
  // What no slice has filled: copies of a channel that is asked for twice, and the alpha of a file
  // without.
  void complete(std::span<float> pixels) const {
    for (std::size_t slot = 1; slot < 4; ++slot) {
      const std::string& channel = request_.channels[slot];
      const auto first = static_cast<std::size_t>(std::ranges::find(request_.channels, channel) -
                                                  request_.channels.begin());
      const bool copied = !channel.empty() && first < slot;
      const bool opaque = slot == 3 && channel.empty();
      if (!copied && !opaque) continue;
      for (std::size_t i = 0; i < pixels.size(); i += 4)
        pixels[i + slot] = opaque ? 1.0F : pixels[i + first];
    }
  }

  ExrRowsRequest request_;
  Imf::MultiPartInputFile file_;
  Imf::InputPart part_;
  Imath::Box2i window_;
};

/// Luminance and chroma made RGB by OpenEXR's own filters.
class ChromaRows final : public NativeRows {
 public:
  explicit ChromaRows(const ExrRowsRequest& request)
      : name_(request.name), file_(request.path.c_str(), kThreads), window_(file_.dataWindow()) {
    check_window(window_, request);
  }

  void read(int first, int count, std::span<std::byte> bytes) override {
    const std::ptrdiff_t width = window_.max.x - window_.min.x + 1;
    row_.resize(static_cast<std::size_t>(width));
    auto* out = reinterpret_cast<float*>(bytes.data());
    for (int y = window_.min.y + first; y < window_.min.y + first + count; ++y) {
      read_row(y);
      for (const Imf::Rgba& pixel : row_) {
        *out++ = pixel.r;
        *out++ = pixel.g;
        *out++ = pixel.b;
        *out++ = pixel.a;
      }
    }
  }

 private:
  void read_row(int y) {
    try {
      file_.setFrameBuffer(row_.data() - window_.min.x, 1, 0);
      file_.readPixels(y);
    } catch (const std::exception&) {
      const int display_y = file_.displayWindow().min.y;
      refuse(name_, "is damaged or cut off at row " + std::to_string(std::max(y - display_y, 0)));
    }
  }

  std::string name_;
  Imf::RgbaInputFile file_;
  Imath::Box2i window_;
  std::vector<Imf::Rgba> row_;
};

void open_rows(const ExrRowsRequest& request, std::unique_ptr<NativeRows>& rows) {
  try {
    if (request.chroma) {
      rows = std::make_unique<ChromaRows>(request);
    } else {
      rows = std::make_unique<ChannelRows>(request);
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception&) {
    refuse(request.name, "its EXR header is damaged or cut off");
  }
}

}  // namespace
}  // namespace tristim::detail

extern "C" __attribute__((visibility("default"))) void tristim_open_exr_rows(
    const tristim::detail::ExrRowsRequest& request,
    std::unique_ptr<tristim::detail::NativeRows>& rows) {
  tristim::detail::open_rows(request, rows);
}
