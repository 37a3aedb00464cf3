#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfTiledOutputFile.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tristim::fixture {

using Value = std::function<float(const std::string& channel, int x, int y)>;

/// A value that differs in every channel and pixel, exact in a half.
inline float plain_value(const std::string& channel, int x, int y) {
  return static_cast<float>(channel.back() % 16) + static_cast<float>((x * 7 + y * 13) % 64) / 64;
}

/// A header of a picture from (0, 0) with half channels of these names.
inline Imf::Header header(int width, int height, const std::vector<std::string>& channels,
                          Imf::PixelType type = Imf::HALF) {
  Imf::Header result(width, height);
  for (const std::string& name : channels) result.channels().insert(name, Imf::Channel(type));
  return result;
}

/// The samples of every channel of a header, as OpenEXR takes them.
class Planes {
 public:
  Planes(const Imf::Header& header, const Value& value) {
    const Imath::Box2i window = header.dataWindow();
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
      add(window, c.name(), c.channel(), value);
    }
  }
  const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  void add(const Imath::Box2i& window, const std::string& name, const Imf::Channel& channel,
           const Value& value) {
    const int columns = (window.max.x - window.min.x) / channel.xSampling + 1;
    std::vector<char>& bytes = planes_.emplace_back();
    const std::size_t size = channel.type == Imf::HALF ? 2 : 4;
    for (int y = window.min.y; y <= window.max.y; y += channel.ySampling) {
      for (int x = window.min.x; x <= window.max.x; x += channel.xSampling) {
        append(bytes, channel.type, value(name, x, y));
      }
    }
    const std::ptrdiff_t first = window.min.x / channel.xSampling +
                                 std::ptrdiff_t{window.min.y / channel.ySampling} * columns;
    frame_.insert(
        name,
        Imf::Slice(channel.type, bytes.data() - first * static_cast<std::ptrdiff_t>(size), size,
                   size * static_cast<std::size_t>(columns), channel.xSampling, channel.ySampling));
  }

  static void append(std::vector<char>& bytes, Imf::PixelType type, float value) {
    const half rounded(value);
    const auto whole = static_cast<std::uint32_t>(value);
    const char* from = type == Imf::HALF    ? reinterpret_cast<const char*>(&rounded)
                       : type == Imf::FLOAT ? reinterpret_cast<const char*>(&value)
                                            : reinterpret_cast<const char*>(&whole);
    bytes.insert(bytes.end(), from, from + (type == Imf::HALF ? 2 : 4));
  }

  std::vector<std::vector<char>> planes_;
  Imf::FrameBuffer frame_;
};

/// A file of one part; tiled, with all its levels, where the header has a tile description.
inline void write_exr(const std::string& path, const Imf::Header& header,
                      const Value& value = plain_value) {
  const Planes planes(header, value);
  if (!header.hasTileDescription()) {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(planes.frame());
    file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
    return;
  }
  Imf::TiledOutputFile file(path.c_str(), header);
  file.setFrameBuffer(
      planes.frame());  // further levels are cut out of the first: nobody reads them
  for (int level = 0; level < file.numLevels(); ++level) {
    file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
  }
}

/// A file of several scanline parts, each with a name.
inline void write_parts(const std::string& path, std::vector<Imf::Header> headers) {
  for (Imf::Header& part : headers) part.setType("scanlineimage");
  Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
  for (std::size_t i = 0; i < headers.size(); ++i) {
    const Planes planes(headers[i], plain_value);
    Imf::OutputPart part(file, static_cast<int>(i));
    part.setFrameBuffer(planes.frame());
    part.writePixels(headers[i].dataWindow().max.y - headers[i].dataWindow().min.y + 1);
  }
}

}  // namespace tristim::fixture
