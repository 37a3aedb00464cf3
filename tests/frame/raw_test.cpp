#include <gtest/gtest.h>

#include "tests/frame/frames.h"
#include "tests/support.h"
#include "tristim/frame/pack.h"

namespace tristim {
namespace {

TEST(RawWriter, HoldsWhatUnpackRowReads) {
  const TemporaryDirectory directory;
  for (const Packing& packing : kPackings) {
    for (const BitOrder bit_order : {BitOrder::kMsb, BitOrder::kLsb}) {
      for (const ByteOrder byte_order : {ByteOrder::kBig, ByteOrder::kLittle}) {
        SCOPED_TRACE(packing.name);
        FrameInfo info = frame_info(packing.name, 13, 5);
        info.layout.bit_order = bit_order;
        info.layout.byte_order = byte_order;
        const TestFrame frame = random_frame(info);
        FrameWriteOptions options;
        options.replace = true;
        write_frame(frame, directory.file("out.raw"), options);

        const std::string file = read_bytes(directory.file("out.raw"));
        const std::vector<std::uint8_t> bytes(file.begin(), file.end());
        const std::size_t stride = packed_row_bytes(packing, 13);
        ASSERT_EQ(bytes.size(), stride * 5);
        std::vector<std::uint16_t> row(13 * static_cast<std::size_t>(packing.samples));
        for (int y = 0; y < 5; ++y) {
          unpack_row(std::span(bytes).subspan(static_cast<std::size_t>(y) * stride, stride),
                     info.layout, row);
          const auto expected = frame.view().row(y);
          EXPECT_TRUE(std::equal(row.begin(), row.end(), expected.begin(), expected.end()));
        }
      }
    }
  }
}

TEST(RawWriter, StoresTheCodesOfAPalette) {
  const TemporaryDirectory directory;
  FrameInfo info = frame_info("index4", 4, 1);
  info.palette = {{{0, 0, 0}, 5, ""}, {{255, 255, 255}, 12, ""}};
  write_frame({info, {0, 1, 1, 0}}, directory.file("out.raw"));
  EXPECT_EQ(read_bytes(directory.file("out.raw")), "\x5c\xc5");
}

TEST(RawWriter, RefusesACodeThatDoesNotFit) {
  const TemporaryDirectory directory;
  FrameInfo info = frame_info("index4", 4, 1);
  info.palette = {{{0, 0, 0}, 5, ""}, {{255, 255, 255}, 16, ""}};
  const std::string path = directory.file("out.raw");
  EXPECT_EQ(open_error(info, path), "2 " + path +
                                        ": palette entry 1 has code 16, more than the 4 bits of "
                                        "packing index4; use a wider packing or smaller codes");
}

}  // namespace
}  // namespace tristim
