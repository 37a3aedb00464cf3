#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "lib/image/io/module.h"
#include "lib/image/io/readers.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kHdrHeaderBytes = 16384;

class NativeRowSource final : public RowSource {
 public:
  NativeRowSource(InputFilePtr file, NativePicture picture, const SampleLayout& layout,
                  PictureInfo info)
      : file_(std::move(file)),
        picture_(std::move(picture)),
        decoder_(layout),
        info_(std::move(info)),
        row_bytes_(static_cast<std::size_t>(info_.width) * decoder_.pixel_bytes()) {}

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      if (next_ == held_end_) hold_chunk();
      const std::size_t offset = static_cast<std::size_t>(next_ - held_first_) * row_bytes_;
      decoder_.decode(std::span(held_).subspan(offset, row_bytes_), rows.row(y));
    }
  }

 private:
  void hold_chunk() {
    const int count = std::min(info_.chunk_rows, info_.height - next_);
    held_.resize(row_bytes_ * static_cast<std::size_t>(count));
    picture_.rows->read(next_, count, held_);
    held_first_ = next_;
    held_end_ = next_ + count;
  }

  InputFilePtr file_;  // open as long as the module reads from it
  NativePicture picture_;
  SampleDecoder decoder_;
  PictureInfo info_;
  std::size_t row_bytes_;
  std::vector<std::byte> held_;
  int held_first_ = 0;
  int held_end_ = 0;
  int next_ = 0;
};

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

// The curve of the file, and in words where it comes from.
Curve curve_of(const NativePicture& picture, std::string& words) {
  const std::string& space = picture.colour_space;
  if (space.empty()) {
    words = is_integer(picture.type) ? "sRGB curve" : "linear";
    return {is_integer(picture.type) ? Curve::Kind::kSrgb : Curve::Kind::kLinear};
  }
  words = "curve " + space;
  if (space == "Linear" || space == "linear") return {Curve::Kind::kLinear};
  if (space == "sRGB") return {Curve::Kind::kSrgb};
  if (space == "Rec709") return {Curve::Kind::kBt709};
  if (space == "AdobeRGB") return {Curve::Kind::kGamma, 563.0 / 256};
  if (space.starts_with("Gamma")) {
    const auto gamma = parse_number(std::string_view(space).substr(5));
    if (gamma && *gamma > 0.1 && *gamma < 10) return {Curve::Kind::kGamma, *gamma};
  }
  words += " (not known here: taken for sRGB)";
  return {Curve::Kind::kSrgb};
}

// Radiance files may name their primaries, which OpenImageIO does not pass on [Ward].
std::optional<Primaries> hdr_primaries(const InputFile& file) {
  std::string header(kHdrHeaderBytes, '\0');
  header.resize(file.read_at(0, std::as_writable_bytes(std::span(header))));
  header.resize(std::min(header.size(), header.find("\n\n")));
  const std::size_t key = header.find("\nPRIMARIES=");
  if (key == std::string::npos) return {};
  const char* at = header.data() + key + std::strlen("\nPRIMARIES=");
  const char* end = header.data() + std::min(header.size(), header.find('\n', key + 1));
  double v[8];
  for (double& value : v) {
    while (at < end && *at == ' ') ++at;
    const auto result = std::from_chars(at, end, value);
    if (result.ec != std::errc{}) {
      throw Error(ErrorKind::kContent, file.name(), "its PRIMARIES are not eight numbers",
                  "correct or remove them");
    }
    at = result.ptr;
  }
  return Primaries{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}};
}

int index_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

// Which channels are the picture; none where the first is negative.
std::array<int, 4> choose_channels(const NativePicture& picture, const std::string& layer) {
  const std::vector<std::string>& names = picture.channels;
  if (!layer.empty()) {
    const int one = index_of(names, layer);
    return {one, one, one, -1};
  }
  const int r = index_of(names, "R");
  const int g = index_of(names, "G");
  const int b = index_of(names, "B");
  if (r >= 0 && g >= 0 && b >= 0) return {r, g, b, picture.alpha};
  const std::size_t colours = names.size() - (picture.alpha >= 0 ? 1 : 0);
  const int first = picture.alpha == 0 ? 1 : 0;
  if (colours == 1) return {first, first, first, picture.alpha};
  return {-1, -1, -1, -1};
}

std::string list_channels(const NativePicture& picture) {
  std::string list;
  for (const std::string& name : picture.channels) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

OpenedPicture open_with_oiio(InputFilePtr file, const std::string& format,
                             const ReadOptions& options) {
  NativePicture picture;
  auto* open = reinterpret_cast<OpenWithOiio*>(load_function(kOiioModule));
  open(file->reopen_path(), file->name(), format, picture);
  OpenedPicture opened;
  PictureFacts& facts = opened.facts;
  facts.format = format;
  facts.compression = picture.compression;
  facts.data_width = picture.width;
  facts.data_height = picture.height;
  for (const std::string& name : picture.channels) {
    facts.channels.push_back(name + ":" + std::string(sample_type_name(picture.type)));
  }
  SampleLayout layout{.type = picture.type, .samples = static_cast<int>(picture.channels.size())};
  layout.source = choose_channels(picture, options.layer);
  layout.alpha = picture.straight ? AlphaKind::kStraight : AlphaKind::kPremultiplied;
  layout.curve = curve_of(picture, facts.colour);
  if (options.codes && is_integer(picture.type)) layout.curve = kNoCurve;

  PictureInfo& info = facts.info;
  info.name = file->name();
  info.width = picture.width;
  info.height = picture.height;
  info.channels = layout.source[3] >= 0 ? 4 : 3;
  info.grey = layout.source[0] == layout.source[1];
  info.pixel_aspect = picture.pixel_aspect;
  info.orientation = picture.orientation;
  info.chunk_rows = std::min(picture.chunk_rows, picture.height);
  std::optional<Primaries> stated;
  if (format == "hdr") stated = hdr_primaries(*file);
  if (stated) {
    check_primaries(file->name(), *stated);
    info.primaries = *stated;
  }
  facts.colour += stated ? ", PRIMARIES of the file" : ", sRGB primaries: the file does not say";
  if (picture.has_icc_profile) facts.colour += "; its ICC profile is ignored";
  if (!picture.colour_model.empty()) {
    throw Error(ErrorKind::kContent, file->name(), "is " + picture.colour_model + ", not RGB",
                "convert it to RGB with its profile first");
  }
  if (layout.source[0] < 0) {
    opened.why_no_rows = options.layer.empty() ? "has no colour channels that are known: it has " +
                                                     list_channels(picture)
                                               : "has no channel called " + options.layer;
    opened.remedy = options.layer.empty() ? "choose one of them as the layer"
                                          : "it has " + list_channels(picture);
    return opened;
  }
  opened.rows =
      std::make_unique<NativeRowSource>(std::move(file), std::move(picture), layout, facts.info);
  return opened;
}

}  // namespace tristim::detail
