#include "lib/image/io/sample_decoder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "lib/core/math.h"
#include "lib/image/io/half_row.h"
#include "tristim/color/transfer.h"

namespace tristim::detail {
namespace {

struct Half {
  std::uint16_t bits;
};

struct TypeFacts {
  std::size_t bytes;
  std::string_view name;
  bool integer;
};
constexpr TypeFacts kTypes[] = {{1, "uint8", true}, {2, "uint16", true}, {4, "uint32", true},
                                {2, "half", false}, {4, "float", false}, {8, "double", false}};

const TypeFacts& facts(SampleType type) { return kTypes[static_cast<std::size_t>(type)]; }

double bt709_decode(double e) noexcept {
  if (e < 0.081) return e / 4.5;
  return pow((e + 0.099) / 1.099, 1 / 0.45);
}

template <typename T>
constexpr bool kHasTable = std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::uint16_t>;

}  // namespace

std::size_t sample_bytes(SampleType type) noexcept { return facts(type).bytes; }
std::string_view sample_type_name(SampleType type) noexcept { return facts(type).name; }
bool is_integer(SampleType type) noexcept { return facts(type).integer; }

double decode(const Curve& curve, double sample) noexcept {
  const double magnitude = std::fabs(sample);
  switch (curve.kind) {
    case Curve::Kind::kLinear:
      return sample;
    case Curve::Kind::kSrgb:
      return srgb_decode(sample);
    case Curve::Kind::kBt709:
      return std::copysign(bt709_decode(magnitude), sample);
    case Curve::Kind::kGamma:
      return gamma_decode(sample, curve.gamma);
  }
  return sample;
}

SampleDecoder::SampleDecoder(const SampleLayout& layout) : layout_(layout) {
  if (layout.type != SampleType::kUint8 && layout.type != SampleType::kUint16) return;
  const int highest = layout.type == SampleType::kUint8 ? 255 : 65535;
  if (layout_.maximum == 0) layout_.maximum = highest;
  table_.assign(static_cast<std::size_t>(highest) + 1, std::numeric_limits<float>::quiet_NaN());
}

std::size_t SampleDecoder::pixel_bytes() const noexcept {
  return static_cast<std::size_t>(layout_.samples) * sample_bytes(layout_.type);
}

void SampleDecoder::decode(std::span<const std::byte> samples, std::span<float> light) {
  switch (layout_.type) {
    case SampleType::kUint8:
      return decode_pixels<std::uint8_t>(samples, light);
    case SampleType::kUint16:
      return decode_pixels<std::uint16_t>(samples, light);
    case SampleType::kUint32:
      return decode_pixels<std::uint32_t>(samples, light);
    case SampleType::kHalf:
      return decode_pixels<Half>(samples, light);
    case SampleType::kFloat:
      return decode_pixels<float>(samples, light);
    case SampleType::kDouble:
      return decode_pixels<double>(samples, light);
  }
}

template <typename T>
void SampleDecoder::decode_pixels(std::span<const std::byte> samples, std::span<float> light) {
  const auto out_channels = static_cast<std::size_t>(channels());
  const std::size_t pixels = light.size() / out_channels;
  const std::byte* pixel = samples.data();
  float* out = light.data();
  const auto sample_at = [&](std::size_t channel) {
    T sample;
    std::memcpy(&sample, pixel + static_cast<std::size_t>(layout_.source[channel]) * sizeof(T),
                sizeof(T));
    return sample;
  };
  for (std::size_t i = 0; i < pixels; ++i, pixel += pixel_bytes(), out += out_channels) {
    if (out_channels == 3) {
      for (std::size_t c = 0; c < 3; ++c) out[c] = colour(sample_at(c));
      continue;
    }
    const double alpha = number(sample_at(3));
    for (std::size_t c = 0; c < 3; ++c) out[c] = premultiplied(sample_at(c), alpha);
    out[3] = static_cast<float>(alpha);
  }
}

// The sample as a number: integers fill [0, 1].
template <typename T>
double SampleDecoder::number(T sample) const noexcept {
  if constexpr (kHasTable<T>) {
    return std::min(static_cast<double>(sample) / layout_.maximum, 1.0);
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<double>(sample) / static_cast<double>(std::numeric_limits<T>::max());
  } else if constexpr (std::is_same_v<T, Half>) {
    return static_cast<double>(float_from_half(sample.bits));
  } else {
    return static_cast<double>(sample);
  }
}

template <typename T>
float SampleDecoder::colour(T sample) {
  if constexpr (kHasTable<T>) {
    float& light = table_[sample];
    if (std::isnan(light))
      light = static_cast<float>(detail::decode(layout_.curve, number(sample)));
    return light;
  } else {
    return static_cast<float>(detail::decode(layout_.curve, number(sample)));
  }
}

template <typename T>
float SampleDecoder::premultiplied(T sample, double alpha) {
  if (layout_.alpha == AlphaKind::kStraight) {
    return static_cast<float>(static_cast<double>(colour(sample)) * alpha);
  }
  if (layout_.curve.kind == Curve::Kind::kLinear || alpha == 0) return colour(sample);
  return static_cast<float>(detail::decode(layout_.curve, number(sample) / alpha) * alpha);
}

}  // namespace tristim::detail
