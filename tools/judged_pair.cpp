#include "tools/judged_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <unordered_set>

#include "tools/spool.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/flatten.h"
#include "tristim/image/io/read.h"

namespace tristim::tools {
namespace {

using Curve = std::function<double(double)>;

// "srgb", "linear", "g2.2".
Curve parse_curve(std::string_view text, std::string_view option) {
  if (const TransferFunction* named = find_by_name(kTransferFunctions, text)) return named->decode;
  const auto gamma = text.starts_with('g') ? parse_number(text.substr(1)) : std::nullopt;
  if (!gamma || !(*gamma > 0) || !std::isfinite(*gamma)) {
    throw Error(ErrorKind::kMisuse, option, "unknown curve '" + std::string(text) + "'",
                "give g and an exponent, as in g2.2, or one of " + list_names(kTransferFunctions));
  }
  return [exponent = *gamma](double code) { return gamma_decode(code, exponent); };
}

struct ReadPicture {
  PictureInfo info;
  bool floats = false;
  Image light;
  std::size_t colors = 0;
};

bool holds_floats(const PictureFacts& facts) {
  return facts.format == "npy" || facts.format == "pfm" ||
         std::any_of(facts.channels.begin(), facts.channels.end(), [](const std::string& channel) {
           return channel.ends_with(":half") || channel.ends_with(":float") ||
                  channel.ends_with(":double");
         });
}

void refuse_odd(const OddValues& odd, const std::string& name) {
  if (odd == OddValues{}) return;
  throw Error(ErrorKind::kContent, name,
              "has " + std::to_string(odd.nan) + " samples that are no numbers and " +
                  std::to_string(odd.infinite) + " that are infinite",
              "judges need finite light; tristim convert or process can replace them");
}

struct ColorHash {
  std::size_t operator()(const std::array<float, 3>& color) const noexcept {
    std::size_t hash = 0;
    for (const float sample : color) hash = hash * 1000003 + std::hash<float>()(sample);
    return hash;
  }
};

std::size_t count_colors(ImageView<const float> picture, bool floats) {
  constexpr float kMost = 65535;  // 16 bits
  std::unordered_set<std::array<float, 3>, ColorHash> colors;
  std::array<float, 3> last{};
  for (int y = 0; y < picture.height; ++y) {
    const float* p = picture.row(y).data();
    for (int x = 0; x < picture.width; ++x, p += 3) {
      std::array<float, 3> color{p[0], p[1], p[2]};
      if (floats) {
        for (float& sample : color) sample = std::nearbyint(sample * kMost);
      }
      if (color == last && !colors.empty()) continue;
      colors.insert(color);
      last = color;
    }
  }
  return colors.size();
}

void decode(ImageView<float> picture, const Curve& curve) {
  for (int y = 0; y < picture.height; ++y) {
    float known = 0;
    float light = static_cast<float>(curve(0));
    for (float& sample : picture.row(y)) {
      if (sample != known) {
        known = sample;
        light = static_cast<float>(curve(double{sample}));
      }
      sample = light;
    }
  }
}

void to_srgb_primaries(ImageView<float> picture, const Primaries& primaries) {
  if (primaries == Primaries{}) return;
  const Eigen::Matrix3d matrix = rgb_from_rgb({}, primaries, Adaptation::kBradford);
  for (int y = 0; y < picture.height; ++y) {
    float* p = picture.row(y).data();
    for (int x = 0; x < picture.width; ++x, p += 3) {
      const Eigen::Vector3d c = matrix * Eigen::Vector3d(p[0], p[1], p[2]);
      for (int i = 0; i < 3; ++i) p[i] = static_cast<float>(c[i]);
    }
  }
}

// NumPy arrays that are a result hold what a device was given, behind the sRGB curve.
std::string transfer_of(const std::string& asked, const PictureFacts& facts, bool is_result) {
  if (!asked.empty()) return asked;
  return is_result && facts.format == "npy" ? "srgb" : "";
}

ReadPicture read_picture(const std::string& path, const std::string& asked, std::string_view option,
                         bool is_result) {
  make_rereadable(path);
  const PictureFacts facts = picture_facts(path);
  const std::string transfer = transfer_of(asked, facts, is_result);
  const Curve curve = transfer.empty() ? Curve() : parse_curve(transfer, option);
  OddValues odd;
  const auto source = flatten(open_picture(path, {.codes = bool(curve)}), {}, &odd);
  const PictureInfo& info = source->info();
  ReadPicture picture{info, holds_floats(facts), Image(info.width, info.height, 3), 0};
  source->read(picture.light.view());
  refuse_odd(odd, info.name);
  if (is_result) picture.colors = count_colors(picture.light.view(), picture.floats);
  if (curve) decode(picture.light.view(), curve);
  to_srgb_primaries(picture.light.view(), info.primaries);
  return picture;
}

void to_luminance(ImageView<float> picture) {
  const LuminanceMap map = luminance(picture);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      std::fill_n(picture.pixel(x, y), 3, static_cast<float>(map.at(x, y)));
    }
  }
}

std::string size_text(const PictureInfo& info) {
  return std::to_string(info.width) + "x" + std::to_string(info.height);
}

void check_sizes(const PictureInfo& reference, const PictureInfo& result, int border) {
  if (reference.width != result.width || reference.height != result.height) {
    throw Error(
        ErrorKind::kContent, result.name,
        "is " + size_text(result) + ", but " + reference.name + " is " + size_text(reference),
        "compare pictures of one size");
  }
  if (2 * border >= std::min(reference.width, reference.height)) {
    throw Error(
        ErrorKind::kMisuse, "--border",
        std::to_string(border) + " pixels at each edge leave nothing of " + size_text(reference),
        "give less");
  }
}

ImageView<const float> inside(const Image& image, int border) noexcept {
  ImageView<const float> view = image.view();
  view.data = view.pixel(border, border);
  view.width -= 2 * border;
  view.height -= 2 * border;
  return view;
}

}  // namespace

PicturePair JudgedPair::pictures() const noexcept {
  return {inside(reference, border), inside(result, border)};
}

JudgedPair read_pair(const PairOptions& options) {
  ReadPicture reference =
      read_picture(options.reference, options.reference_transfer, "--ref-transfer", false);
  ReadPicture result =
      read_picture(options.result, options.result_transfer, "--out-transfer", true);
  check_sizes(reference.info, result.info, options.border);
  if (result.info.grey && !reference.info.grey) to_luminance(reference.light.view());
  return {std::move(reference.light), std::move(result.light), result.colors, options.border};
}

}  // namespace tristim::tools
