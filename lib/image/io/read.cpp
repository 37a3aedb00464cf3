#include "tristim/image/io/read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "lib/image/io/indexed_readers.h"
#include "lib/image/io/readers.h"
#include "tristim/core/error.h"

namespace tristim {
namespace detail {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::size_t position;
  std::string_view bytes;
  std::string_view format;  // OpenImageIO's name, but for the four that are read here
};

constexpr Signature kSignatures[] = {
    {0, "\x76\x2f\x31\x01"sv, "openexr"},
    {0, "\x89PNG\r\n\x1a\n"sv, "png"},
    {0, "\x93NUMPY"sv, "npy"},
    {0, "#?RADIANCE"sv, "hdr"},
    {0, "#?RGBE"sv, "hdr"},
    {0, "II*\0"sv, "tiff"},
    {0, "MM\0*"sv, "tiff"},
    {0, "II+\0"sv, "tiff"},
    {0, "MM\0+"sv, "tiff"},
    {0, "\xff\xd8\xff"sv, "jpeg"},
    {0, "BM"sv, "bmp"},
    {0, "P1"sv, "pnm"},
    {0, "P2"sv, "pnm"},
    {0, "P3"sv, "pnm"},
    {0, "P4"sv, "pnm"},
    {0, "P5"sv, "pnm"},
    {0, "P6"sv, "pnm"},
    {0, "P7"sv, "pnm"},
    {0, "Pf"sv, "pnm"},
    {0, "PF"sv, "pnm"},
    {0, "GIF8"sv, "gif"},
    {8, "WEBP"sv, "webp"},
    {0, "SDPX"sv, "dpx"},
    {0, "XPDS"sv, "dpx"},
    {0, "8BPS"sv, "psd"},
    {0, "\x01\xda"sv, "sgi"},
};
constexpr std::size_t kSniffedBytes = 16;

}  // namespace

std::string sniff_format(const InputFile& file) {
  std::array<std::byte, kSniffedBytes> head = {};
  const std::size_t count = file.read_at(0, head);
  const std::string_view bytes(reinterpret_cast<const char*>(head.data()), count);
  const auto* found = std::ranges::find_if(kSignatures, [&](const Signature& signature) {
    return bytes.size() >= signature.position &&
           bytes.substr(signature.position).starts_with(signature.bytes);
  });
  return std::string(found != std::ranges::end(kSignatures) ? found->format : std::string_view{});
}

namespace {

OpenedPicture open_any(const std::string& path, const ReadOptions& options) {
  const auto file = std::make_shared<const InputFile>(path);
  if (file->size() == 0) {
    throw Error(ErrorKind::kContent, file->name(), "is empty", "write or copy it again");
  }
  const std::string format = sniff_format(*file);
  if (format.empty()) {
    throw Error(ErrorKind::kContent, file->name(),
                "is no picture: its first bytes are of no known format",
                "give EXR, HDR, PFM, TIFF, PNG, PNM, BMP or JPEG");
  }
  if (format == "openexr") return open_exr(file, options);
  if (format == "png") return open_png(file, options);
  if (format == "pnm") return open_pnm(file, options);
  if (format == "npy") return open_npy(file, options);
  return open_with_oiio(file, format, options);
}

}  // namespace

void check_picture_size(const std::string& name, std::int64_t width, std::int64_t height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width < 1 || height < 1) {
    throw Error(ErrorKind::kContent, name, "has no pixels: its size is " + size);
  }
  if (width > kMaxSide || height > kMaxSide || width * height > kMaxPixels) {
    throw Error(ErrorKind::kContent, name, "is too large: " + size + " pixels",
                "at most " + std::to_string(kMaxSide) +
                    " a side and 2^32 pixels are read; if the file is "
                    "right, cut it into parts");
  }
}

void check_primaries(const std::string& name, const Primaries& primaries) {
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorKind::kContent, name, "its chromaticities make no colours: " + why,
                "correct or remove them");
  };
  for (const Chromaticity c : {primaries.red, primaries.green, primaries.blue, primaries.white}) {
    if (!std::isfinite(c.x) || !std::isfinite(c.y)) refuse("a coordinate is not finite");
    if (std::fabs(c.x) > 10 || std::fabs(c.y) > 10) refuse("a coordinate is beyond 10");
  }
  if (!(primaries.white.y > 0)) refuse("the white has y = " + std::to_string(primaries.white.y));
  try {
    if (!rgb_from_xyz(primaries).allFinite()) refuse("a phosphor has no part in the white");
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
}

}  // namespace detail

std::unique_ptr<RowSource> open_picture(const std::string& path, const ReadOptions& options) {
  detail::OpenedPicture opened = detail::open_any(path, options);
  if (!opened.rows) {
    throw Error(ErrorKind::kContent, opened.facts.info.name, opened.why_no_rows, opened.remedy);
  }
  return std::move(opened.rows);
}

PictureFacts picture_facts(const std::string& path, const ReadOptions& options) {
  detail::OpenedPicture opened = detail::open_any(path, options);
  if (!opened.rows && !options.layer.empty()) {
    throw Error(ErrorKind::kContent, opened.facts.info.name, opened.why_no_rows, opened.remedy);
  }
  return std::move(opened.facts);
}

}  // namespace tristim
