#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>

#include "lib/image/io/module.h"
#include "lib/image/io/readers.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

struct NativeRequest {
  std::string path;
  std::string name;
  std::string format;
};

constexpr int kScanlines = 16;  // read at once from files without tiles
constexpr int kMaxChannels = 64;

// Formats that OpenImageIO reads in rows; of all others it holds the whole picture.
constexpr std::string_view kInRows[] = {"tiff", "hdr", "bmp", "dpx", "sgi"};
// of a progressive JPEG the library holds 6 bytes a pixel
constexpr std::int64_t kMaxJpegPixels = std::int64_t{1} << 28;

void set_up_library() {
  static const bool done = [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("debug", 0);
    OIIO::attribute("plugin_searchpath", "");
    OIIO::attribute("limits:channels", kMaxChannels);
    OIIO::attribute("limits:imagesize_MB", 64 * 1024);  // sizes are checked here
    return true;
  }();
  static_cast<void>(done);
}

// The library's own words, on one line after ": "; taken out, or it prints them when the process
// ends.
std::string reason(const OIIO::ImageInput* input) {
  std::string text = input != nullptr && input->has_error() ? input->geterror() : OIIO::geterror();
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text.empty() ? text : ": " + text;
}

[[noreturn]] void refuse(const NativeRequest& request, const std::string& wrong,
                         const std::string& remedy = "") {
  throw Error(ErrorKind::kContent, request.name, wrong, remedy);
}

[[noreturn]] void refuse_too_large(const NativeRequest& request) {
  refuse(request, "is too large for its format, of which too much has to be held at once",
         "convert it to EXR, or to TIFF in strips");
}

bool sample_type(const OIIO::TypeDesc& type, SampleType& out) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
      out = SampleType::kUint8;
      return true;
    case OIIO::TypeDesc::UINT16:
      out = SampleType::kUint16;
      return true;
    case OIIO::TypeDesc::UINT32:
      out = SampleType::kUint32;
      return true;
    case OIIO::TypeDesc::HALF:
      out = SampleType::kHalf;
      return true;
    case OIIO::TypeDesc::FLOAT:
      out = SampleType::kFloat;
      return true;
    case OIIO::TypeDesc::DOUBLE:
      out = SampleType::kDouble;
      return true;
    default:
      return false;
  }
}

// What the file's colours are, where they are none of grey and RGB.
std::string colour_model(const OIIO::ImageSpec& spec) {
  for (const char* key : {"tiff:ColorSpace", "jpeg:ColorSpace", "psd:ColorMode"}) {
    std::string space = spec.get_string_attribute(key);
    if (space == "CMYK" || space == "YCCK" || space == "CIELAB" || space == "ICCLAB" ||
        space == "ITULAB") {
      return space;
    }
  }
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
  if (photometric == 5) return "CMYK";
  if (photometric == 8 || photometric == 9 || photometric == 10) return "CIELAB";
  const bool unnamed = spec.nchannels == 4 && spec.alpha_channel < 0 && spec.channel_name(0) != "R";
  return unnamed ? "four colour channels" : "";
}

class OiioRows final : public NativeRows {
 public:
  OiioRows(std::unique_ptr<OIIO::ImageInput> input, NativeRequest request)
      : input_(std::move(input)), request_(std::move(request)) {}

  void read(int first, int count, std::span<std::byte> bytes) override {
    const OIIO::ImageSpec& spec = input_->spec();
    const int y = spec.y + first;
    const bool good =
        spec.tile_width > 0
            ? input_->read_tiles(0, 0, spec.x, spec.x + spec.width, y, y + count, spec.z,
                                 spec.z + 1, 0, spec.nchannels, spec.format, bytes.data())
            : input_->read_native_scanlines(0, 0, y, y + count, spec.z, bytes.data());
    if (good) return;
    refuse(request_, "is damaged or cut off at row " + std::to_string(first) + reason(input_.get()),
           "write or copy it again");
  }

 private:
  std::unique_ptr<OIIO::ImageInput> input_;
  NativeRequest request_;
};

std::unique_ptr<OIIO::ImageInput> open_input(const NativeRequest& request, OIIO::ImageSpec& spec) {
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(request.format);
  if (!input) {
    static_cast<void>(reason(nullptr));
    refuse(request, "is a " + request.format + " file, which this OpenImageIO does not read",
           "convert it to EXR, TIFF or PNG");
  }
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // multiplied here, in light
  if (!input->open(request.path, spec, config)) {
    refuse(request, "is no " + request.format + " picture that can be read" + reason(input.get()),
           "write or copy it again");
  }
  return input;
}

// A GIF is held as a whole, 4 bytes a pixel, as soon as it is open: its size is looked up before.
void check_gif_canvas(const NativeRequest& request) {
  std::array<unsigned char, 10> head = {};  // signature, width, height: little-endian
  std::ifstream(request.path, std::ios::binary)
      .read(reinterpret_cast<char*>(head.data()), std::ssize(head));
  const std::uint64_t width = head[6] + 256U * head[7];
  const std::uint64_t height = head[8] + 256U * head[9];
  if (4 * width * height > kMaxHeldBytes) refuse_too_large(request);
}

void check_size(const NativeRequest& request, const OIIO::ImageSpec& spec,
                const NativePicture& picture) {
  check_picture_size(request.name, spec.width, spec.height);
  if (spec.depth > 1) refuse(request, "is a volume", "give one slice of it");
  const auto pixel_bytes = static_cast<std::uint64_t>(spec.nchannels) * sample_bytes(picture.type);
  const std::uint64_t row_bytes = pixel_bytes * static_cast<std::uint64_t>(spec.width);
  const bool in_rows =
      std::ranges::find(kInRows, std::string_view(request.format)) != std::end(kInRows);
  const bool is_jpeg = request.format == "jpeg";
  const auto held_rows =
      static_cast<std::uint64_t>(in_rows || is_jpeg ? picture.chunk_rows : spec.height);
  const bool too_many = is_jpeg && std::int64_t{spec.width} * spec.height > kMaxJpegPixels;
  if (row_bytes * held_rows > kMaxHeldBytes || too_many) refuse_too_large(request);
}

void open_with_oiio_library(const NativeRequest& request, NativePicture& picture) {
  set_up_library();
  if (request.format == "gif") check_gif_canvas(request);
  OIIO::ImageSpec spec;
  std::unique_ptr<OIIO::ImageInput> input = open_input(request, spec);
  if (!sample_type(spec.format, picture.type)) {
    refuse(request, std::string("has samples of a kind that is not read: ") + spec.format.c_str(),
           "write it with unsigned integers or floats");
  }
  picture.width = spec.width;
  picture.height = spec.height;
  picture.channels.assign(spec.channelnames.begin(), spec.channelnames.end());
  picture.channels.resize(static_cast<std::size_t>(spec.nchannels));
  picture.alpha = spec.alpha_channel;
  picture.straight = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  picture.chunk_rows = spec.tile_width > 0 ? spec.tile_height : kScanlines;
  check_size(request, spec, picture);
  const float aspect = spec.get_float_attribute("PixelAspectRatio", 1.0F);
  if (aspect >= 0.01F && aspect <= 100.0F) picture.pixel_aspect = static_cast<double>(aspect);
  const int orientation = spec.get_int_attribute("Orientation", 1);
  if (orientation >= 1 && orientation <= 8) picture.orientation = orientation;
  picture.compression = spec.get_string_attribute("compression");
  picture.colour_space = spec.get_string_attribute("oiio:ColorSpace");
  picture.colour_model = colour_model(spec);
  picture.has_icc_profile = spec.find_attribute("ICCProfile") != nullptr;
  picture.rows = std::make_unique<OiioRows>(std::move(input), request);
}

}  // namespace
}  // namespace tristim::detail

extern "C" __attribute__((visibility("default"))) void tristim_open_with_oiio(
    const std::string& path, const std::string& name, const std::string& format,
    tristim::detail::NativePicture& picture) {
  tristim::detail::open_with_oiio_library({path, name, format}, picture);
}
