#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tristim {

/// How the codes of a pixel become bits.
struct Packing {
  std::string_view name;
  int samples;              // codes of a pixel: 3 (R G B) or 1 (grey, or index of a palette)
  std::array<int, 3> bits;  // of each sample, in R G B order; the others 0
  bool indexed;             // the sample is an index of a palette
  bool blue_first;          // B in the first byte or the highest bits
  int bits_per_pixel() const noexcept { return bits[0] + bits[1] + bits[2]; }
};

/// Every packing. rgb565, rgb555, rgb444 are one 16-bit word a pixel (unused high bits 0), rgb332
/// one byte; rgb888 and bgr888 are three bytes, rgb48 three 16-bit words; less than 8 bits are
/// packed into bytes and each row starts in a new byte.
inline constexpr std::array kPackings{
    Packing{"rgb888", 3, {8, 8, 8}, false, false},  Packing{"bgr888", 3, {8, 8, 8}, false, true},
    Packing{"rgb565", 3, {5, 6, 5}, false, false},  Packing{"bgr565", 3, {5, 6, 5}, false, true},
    Packing{"rgb555", 3, {5, 5, 5}, false, false},  Packing{"rgb444", 3, {4, 4, 4}, false, false},
    Packing{"rgb332", 3, {3, 3, 2}, false, false},  Packing{"rgb48", 3, {16, 16, 16}, false, false},
    Packing{"gray16", 1, {16, 0, 0}, false, false}, Packing{"gray8", 1, {8, 0, 0}, false, false},
    Packing{"gray4", 1, {4, 0, 0}, false, false},   Packing{"gray2", 1, {2, 0, 0}, false, false},
    Packing{"mono1", 1, {1, 0, 0}, false, false},   Packing{"index8", 1, {8, 0, 0}, true, false},
    Packing{"index4", 1, {4, 0, 0}, true, false},   Packing{"index2", 1, {2, 0, 0}, true, false},
    Packing{"index1", 1, {1, 0, 0}, true, false},
};

/// Which pixel of a byte comes first, where a byte holds several.
enum class BitOrder { kMsb, kLsb };

/// Which byte of a 16-bit word comes first.
enum class ByteOrder { kBig, kLittle };

struct NamedBitOrder {
  std::string_view name;
  BitOrder order;
};
inline constexpr NamedBitOrder kBitOrders[] = {{"msb", BitOrder::kMsb}, {"lsb", BitOrder::kLsb}};

struct NamedByteOrder {
  std::string_view name;
  ByteOrder order;
};
inline constexpr NamedByteOrder kByteOrders[] = {{"big", ByteOrder::kBig},
                                                 {"little", ByteOrder::kLittle}};

/// What the frame buffer holds of a channel with an intensity-level table [Shoaff 2.1.1].
enum class Store {
  kValue,  ///< V_j, the code that makes level j
  kIndex,  ///< j; entry j of the colour look-up table holds V_j
};

struct NamedStore {
  std::string_view name;
  Store store;
};
inline constexpr NamedStore kStores[] = {{"value", Store::kValue}, {"index", Store::kIndex}};

/// The frame buffer of a device.
struct FrameLayout {
  Packing packing = kPackings[0];
  BitOrder bit_order = BitOrder::kMsb;
  ByteOrder byte_order = ByteOrder::kBig;
  Store store = Store::kValue;
};

}  // namespace tristim
