#include "tristim/frame/pack.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "tristim/core/find.h"

namespace tristim {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Codes = std::vector<std::uint16_t>;

FrameLayout layout_of(std::string_view packing, BitOrder bits = BitOrder::kMsb,
                      ByteOrder bytes = ByteOrder::kBig) {
  return {*find_by_name(kPackings, packing), bits, bytes, Store::kValue};
}

Bytes packed(const Codes& codes, const FrameLayout& layout) {
  const int width = static_cast<int>(codes.size()) / layout.packing.samples;
  Bytes bytes(packed_row_bytes(layout.packing, width), 0xee);
  pack_row(codes, layout, bytes);
  return bytes;
}

/// Calls `check(layout)` for every packing in every bit and byte order.
template <typename Check>
void for_each_layout(Check check) {
  for (const Packing& packing : kPackings) {
    for (const NamedBitOrder& bits : kBitOrders) {
      for (const NamedByteOrder& bytes : kByteOrders) {
        SCOPED_TRACE(std::string(packing.name) + " " + std::string(bits.name) + " " +
                     std::string(bytes.name));
        check(FrameLayout{packing, bits.order, bytes.order, Store::kValue});
      }
    }
  }
}

TEST(PackRow, FillsTheBytesThatTheFrameBufferHas) {
  EXPECT_EQ(packed({1, 2, 3, 254, 255, 0}, layout_of("rgb888")), (Bytes{1, 2, 3, 254, 255, 0}));
  EXPECT_EQ(packed({1, 2, 3, 254, 255, 0}, layout_of("bgr888")), (Bytes{3, 2, 1, 0, 255, 254}));
  EXPECT_EQ(packed({31, 0, 0}, layout_of("rgb565")), (Bytes{0xf8, 0x00}));
  EXPECT_EQ(packed({0, 63, 0}, layout_of("rgb565")), (Bytes{0x07, 0xe0}));
  EXPECT_EQ(packed({1, 2, 3}, layout_of("rgb565", BitOrder::kMsb, ByteOrder::kLittle)),
            (Bytes{0x43, 0x08}));
  EXPECT_EQ(packed({31, 0, 0}, layout_of("bgr565")), (Bytes{0x00, 0x1f}));
  EXPECT_EQ(packed({0, 0, 31}, layout_of("bgr565")), (Bytes{0xf8, 0x00}));
  EXPECT_EQ(packed({31, 31, 31}, layout_of("rgb555")), (Bytes{0x7f, 0xff}));
  EXPECT_EQ(packed({15, 1, 2}, layout_of("rgb444")), (Bytes{0x0f, 0x12}));
  EXPECT_EQ(packed({7, 0, 1}, layout_of("rgb332")), (Bytes{0xe1}));
  EXPECT_EQ(packed({0, 5, 2}, layout_of("rgb332")), (Bytes{0x16}));
  EXPECT_EQ(packed({0x0102, 0x0304, 0xffee}, layout_of("rgb48")), (Bytes{1, 2, 3, 4, 0xff, 0xee}));
  EXPECT_EQ(packed({0x0102}, layout_of("gray16", BitOrder::kMsb, ByteOrder::kLittle)),
            (Bytes{2, 1}));
  EXPECT_EQ(packed({1, 2, 3}, layout_of("gray4")), (Bytes{0x12, 0x30}));
  EXPECT_EQ(packed({1, 2, 3}, layout_of("index4", BitOrder::kLsb)), (Bytes{0x21, 0x03}));
  EXPECT_EQ(packed({0, 1, 2, 3, 3}, layout_of("gray2")), (Bytes{0x1b, 0xc0}));
  EXPECT_EQ(packed({0, 1, 2, 3, 3}, layout_of("index2", BitOrder::kLsb)), (Bytes{0xe4, 0x03}));
  EXPECT_EQ(packed({1, 1, 0, 0, 0, 0, 0, 0, 1}, layout_of("mono1")), (Bytes{0xc0, 0x80}));
  EXPECT_EQ(packed({1, 1, 0, 0, 0, 0, 0, 0, 1}, layout_of("index1", BitOrder::kLsb)),
            (Bytes{0x03, 0x01}));
}

TEST(PackRow, DropsBitsAboveTheDepth) {
  for_each_layout([](const FrameLayout& layout) {
    const Codes all(30, 0xffff);
    Codes highest(30);
    for (std::size_t i = 0; i < highest.size(); ++i) {
      const auto sample = i % static_cast<std::size_t>(layout.packing.samples);
      highest[i] = static_cast<std::uint16_t>((1u << layout.packing.bits[sample]) - 1);
    }
    EXPECT_EQ(packed(all, layout), packed(highest, layout));
  });
}

TEST(PackRow, PadsWithZeros) {
  for_each_layout([](const FrameLayout& layout) {
    const auto samples = static_cast<std::size_t>(layout.packing.samples);
    const Codes row(samples * 13, 0xffff);
    int set = 0;
    for (const std::uint8_t byte : packed(row, layout)) set += __builtin_popcount(byte);
    EXPECT_EQ(set, 13 * layout.packing.bits_per_pixel());
  });
}

RC_GTEST_PROP(UnpackRow, InvertsPackRow, ()) {
  FrameLayout layout;
  layout.packing = *rc::gen::elementOf(std::vector(kPackings.begin(), kPackings.end()));
  layout.bit_order = *rc::gen::element(BitOrder::kMsb, BitOrder::kLsb);
  layout.byte_order = *rc::gen::element(ByteOrder::kBig, ByteOrder::kLittle);
  const int width = *rc::gen::inRange(0, 70);
  const auto samples = static_cast<std::size_t>(layout.packing.samples);
  Codes codes = *rc::gen::container<Codes>(static_cast<std::size_t>(width) * samples,
                                           rc::gen::arbitrary<std::uint16_t>());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] =
        static_cast<std::uint16_t>(codes[i] & ((1u << layout.packing.bits[i % samples]) - 1));
  }
  const Bytes bytes = packed(codes, layout);
  Codes back(codes.size(), 0xeeee);
  unpack_row(bytes, layout, back);
  RC_ASSERT(back == codes);
}

}  // namespace
}  // namespace tristim
