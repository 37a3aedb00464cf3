#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tristim::detail {

/// How one sample is stored, in the processor's own byte order.
enum class SampleType { kUint8, kUint16, kUint32, kHalf, kFloat, kDouble };

std::size_t sample_bytes(SampleType type) noexcept;
std::string_view sample_type_name(SampleType type) noexcept;
bool is_integer(SampleType type) noexcept;

/// The transfer function by which samples were encoded.
struct Curve {
  enum class Kind { kLinear, kSrgb, kBt709, kGamma };
  Kind kind = Kind::kSrgb;
  double gamma = 1;  // light = sample^gamma, of kGamma
};

inline constexpr Curve kNoCurve{Curve::Kind::kLinear};

/// Light of an encoded sample, odd below 0. BT.709 by the inverse of its camera curve [BT709 1.2].
double decode(const Curve& curve, double sample) noexcept;

/// What alpha has done to the colours of a file.
enum class AlphaKind {
  kStraight,       ///< nothing
  kPremultiplied,  ///< the encoded samples are multiplied by it
};

/// One pixel of a file.
struct SampleLayout {
  SampleType type = SampleType::kUint8;
  int samples = 3;                         // of a pixel
  std::array<int, 4> source{0, 1, 2, -1};  // sample that is R, G, B, A; -1: no alpha
  AlphaKind alpha = AlphaKind::kStraight;
  Curve curve = {};
  int maximum = 0;  // highest code of 8 and 16 bits, full light; 0: the type's own
};

/// Turns rows as a file holds them into linear light, premultiplied by alpha in light. Integers of
/// 8 and 16 bits go through a table, which is filled as codes turn up: small pictures do not pay
/// for all.
class SampleDecoder {
 public:
  explicit SampleDecoder(const SampleLayout& layout);

  /// Of what decode() makes: 3, or 4 where there is alpha.
  int channels() const noexcept { return layout_.source[3] >= 0 ? 4 : 3; }

  /// Bytes of one pixel of `samples`.
  std::size_t pixel_bytes() const noexcept;

  /// `light` holds channels() floats for each pixel of `samples`.
  void decode(std::span<const std::byte> samples, std::span<float> light);

 private:
  template <typename T>
  void decode_pixels(std::span<const std::byte> samples, std::span<float> light);
  template <typename T>
  double number(T sample) const noexcept;
  template <typename T>
  float colour(T sample);
  template <typename T>
  float premultiplied(T sample, double alpha);

  SampleLayout layout_;
  std::vector<float> table_;  // NaN: not yet known
};

}  // namespace tristim::detail
