#include "tristim/image/io/exr.h"

#include <ImfDeepScanLineOutputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tests/image/exr_fixture.h"
#include "tests/image/picture_support.h"
#include "tests/support.h"
#include "tristim/color/primaries.h"

namespace tristim {
namespace {

using fixture::plain_value;
using fixture::write_exr;

void expect_plain(const WholePicture& picture, int x0 = 0, int y0 = 0) {
  const std::string names[] = {"R", "G", "B", "A"};
  for (int y = 0; y < picture.info.height; ++y) {
    for (int x = 0; x < picture.info.width; ++x) {
      for (int c = 0; c < picture.info.channels; ++c) {
        ASSERT_EQ(picture.at(x, y, c), plain_value(names[c], x + x0, y + y0))
            << x << ", " << y << ", " << names[c];
      }
    }
  }
}

bool same_bits(const Image& a, const Image& b) {
  const ImageView<const float> left = a.view();
  const ImageView<const float> right = b.view();
  for (int y = 0; y < left.height; ++y) {
    for (std::size_t i = 0; i < left.row(y).size(); ++i) {
      if (std::bit_cast<std::uint32_t>(left.row(y)[i]) !=
          std::bit_cast<std::uint32_t>(right.row(y)[i])) {
        return false;
      }
    }
  }
  return true;
}

class ExrRead : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string path_ = directory_.file("picture.exr");
};

TEST_F(ExrRead, ReadsEveryLosslessCompressionAndLayoutExactly) {
  for (const Imf::Compression compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
        Imf::PIZ_COMPRESSION}) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
      for (const bool tiled : {false, true}) {
        SCOPED_TRACE("compression " + std::to_string(compression) + ", type " +
                     std::to_string(type) + (tiled ? ", tiled" : ""));
        Imf::Header header = fixture::header(53, 41, {"R", "G", "B", "A"}, type);
        header.compression() = compression;
        if (tiled) header.setTileDescription(Imf::TileDescription(16, 11));
        write_exr(path_, header);
        expect_plain(read_whole(path_));
      }
    }
  }
}

// Flat areas survive the lossy ones: B44 and DWA are not bit-exact between versions of OpenEXR
// otherwise.
TEST_F(ExrRead, ReadsEveryLossyCompression) {
  for (const Imf::Compression compression :
       {Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION,
        Imf::DWAB_COMPRESSION}) {
    SCOPED_TRACE("compression " + std::to_string(compression));
    Imf::Header header = fixture::header(53, 41, {"R", "G", "B"});
    header.compression() = compression;
    write_exr(path_, header,
              [](const std::string& name, int, int) { return name == "G" ? 0.5F : 0.25F; });
    const WholePicture picture = read_whole(path_, {}, 5);
    for (int y = 0; y < 41; ++y) {
      EXPECT_NEAR(picture.at(y, y, 0), 0.25F, 0.003);  // DWA's default loss
      EXPECT_NEAR(picture.at(y, y, 1), 0.5F, 0.003);
      EXPECT_NEAR(picture.at(y, y, 2), 0.25F, 0.003);
    }
  }
}

TEST_F(ExrRead, ReadsLevelZeroOfAMipMap) {
  Imf::Header header = fixture::header(64, 40, {"R", "G", "B"});
  header.setTileDescription(Imf::TileDescription(16, 16, Imf::MIPMAP_LEVELS));
  write_exr(path_, header);
  expect_plain(read_whole(path_));
}

TEST_F(ExrRead, ReadsDecreasingLineOrder) {
  Imf::Header header = fixture::header(20, 37, {"R", "G", "B"});
  header.lineOrder() = Imf::DECREASING_Y;
  write_exr(path_, header,
            [](const std::string& name, int x, int y) { return plain_value(name, x, 36 - y); });
  // OutputFile takes the rows from the last on; its frame is addressed by y all the same
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.at(3, 0, 0), plain_value("R", 3, 36));
  EXPECT_EQ(picture.at(3, 36, 0), plain_value("R", 3, 0));
}

TEST_F(ExrRead, RowsDoNotDependOnBandsOrThreads) {
  for (const bool tiled : {false, true}) {
    Imf::Header header = fixture::header(300, 150, {"R", "G", "B"}, Imf::FLOAT);
    header.compression() = Imf::ZIP_COMPRESSION;
    if (tiled) header.setTileDescription(Imf::TileDescription(32, 32));
    header.dataWindow() = {{-5, -7}, {290, 160}};
    write_exr(path_, header);
    const WholePicture whole = read_whole(path_, {.threads = 1});
    for (const int threads : {1, 2, 7}) {
      for (const int band : {1, 7, 16, 64}) {
        SCOPED_TRACE(std::to_string(threads) + " threads, bands of " + std::to_string(band));
        const WholePicture other = read_whole(path_, {.threads = threads}, band);
        EXPECT_TRUE(same_bits(whole.image, other.image));
      }
    }
  }
}

TEST_F(ExrRead, SurroundsTheDataWindowWithTransparentBlack) {
  for (const Imf::Compression compression : {Imf::ZIP_COMPRESSION, Imf::DWAA_COMPRESSION}) {
    Imf::Header header = fixture::header(40, 30, {"R", "G", "B"}, Imf::FLOAT);
    header.compression() = compression;
    header.displayWindow() = {{100, 50}, {139, 79}};
    header.dataWindow() = {{110, 45}, {149, 69}};  // beyond it at the top and on the right
    write_exr(path_, header, [](const std::string&, int, int) { return 0.5F; });
    const WholePicture picture = read_whole(path_, {}, 7);
    ASSERT_EQ(picture.info.width, 40);
    ASSERT_EQ(picture.info.height, 30);
    ASSERT_EQ(picture.info.channels, 4);
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        const bool inside = x >= 10 && y < 20;
        ASSERT_NEAR(picture.at(x, y, 0), inside ? 0.5F : 0.0F, 0.003) << x << ", " << y;
        ASSERT_EQ(picture.at(x, y, 3), inside ? 1.0F : 0.0F) << x << ", " << y;
      }
    }
    const PictureFacts facts = picture_facts(path_);
    EXPECT_EQ(facts.data_x, 10);
    EXPECT_EQ(facts.data_y, -5);
    EXPECT_EQ(facts.data_width, 40);
    EXPECT_EQ(facts.data_height, 25);
  }
}

TEST_F(ExrRead, CropsADataWindowThatIsLarger) {
  Imf::Header header = fixture::header(10, 8, {"R", "G", "B"});
  header.dataWindow() = {{-20, -9}, {30, 40}};
  write_exr(path_, header);
  const WholePicture picture = read_whole(path_, {}, 3);
  EXPECT_EQ(picture.info.channels, 3);
  expect_plain(picture);
}

TEST_F(ExrRead, ADataWindowThatIsNotSeenIsBlack) {
  Imf::Header header = fixture::header(10, 8, {"R", "G", "B"});
  header.dataWindow() = {{50, 50}, {60, 60}};
  write_exr(path_, header);
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.at(9, 7, 0), 0);
  EXPECT_EQ(picture.at(9, 7, 3), 0);
}

TEST_F(ExrRead, ChoosesRgbThenXyzThenGrey) {
  write_exr(path_, fixture::header(4, 4, {"R", "G", "B", "Y", "Z"}));
  EXPECT_EQ(read_whole(path_).at(1, 1, 1), plain_value("G", 1, 1));
  EXPECT_FALSE(read_whole(path_).info.grey);

  write_exr(path_, fixture::header(4, 4, {"Y", "A"}));
  const WholePicture grey = read_whole(path_);
  EXPECT_TRUE(grey.info.grey);
  ASSERT_EQ(grey.info.channels, 4);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(grey.at(2, 3, c), plain_value("Y", 2, 3));
  EXPECT_EQ(grey.at(2, 3, 3), plain_value("A", 2, 3));

  write_exr(path_, fixture::header(4, 4, {"G"}));  // OpenEXR: what is missing is 0
  EXPECT_EQ(read_whole(path_).at(0, 0, 0), 0);
  EXPECT_EQ(read_whole(path_).at(0, 0, 1), plain_value("G", 0, 0));
}

TEST_F(ExrRead, FindsLayersAndChannelsByName) {
  write_exr(path_, fixture::header(
                       4, 4, {"R", "G", "B", "diffuse.R", "diffuse.G", "diffuse.B", "depth.Z"}));
  EXPECT_EQ(read_whole(path_, {.layer = "diffuse"}).at(1, 2, 2), plain_value("B", 1, 2));
  const WholePicture depth = read_whole(path_, {.layer = "depth.Z"});
  EXPECT_TRUE(depth.info.grey);
  EXPECT_EQ(depth.at(1, 2, 0), plain_value("Z", 1, 2));
  EXPECT_EQ(reading_error(path_, {.layer = "difuse"}).substr(0, 2), "3 ");
  EXPECT_NE(reading_error(path_, {.layer = "difuse"}).find("no layer or channel called difuse"),
            std::string::npos);
}

TEST_F(ExrRead, FindsLayersInFurtherParts) {
  std::vector<Imf::Header> parts = {fixture::header(8, 8, {"Z"}),
                                    fixture::header(8, 8, {"R", "G", "B"}),
                                    fixture::header(8, 8, {"glow.R", "glow.G", "glow.B"})};
  parts[0].setName("depth");
  parts[1].setName("beauty");
  parts[2].setName("extra");
  fixture::write_parts(path_, parts);
  expect_plain(read_whole(path_));
  EXPECT_EQ(read_whole(path_, {.layer = "depth"}).at(3, 3, 0), plain_value("Z", 3, 3));
  EXPECT_EQ(read_whole(path_, {.layer = "glow"}).at(3, 3, 0), plain_value("R", 3, 3));
  const std::vector<std::string> channels = picture_facts(path_).channels;
  EXPECT_EQ(channels.front(), "depth/Z:half");
  EXPECT_EQ(channels.size(), 7U);
}

TEST_F(ExrRead, ReadsWholeNumbers) {
  write_exr(path_, fixture::header(4, 4, {"R", "G", "B"}, Imf::UINT),
            [](const std::string&, int x, int y) { return static_cast<float>(1000 * x + y); });
  EXPECT_EQ(read_whole(path_).at(3, 2, 1), 3002.0F);
}

TEST_F(ExrRead, WithoutAttributesThePrimariesAreSrgb) {
  write_exr(path_, fixture::header(4, 4, {"R", "G", "B"}));
  EXPECT_EQ(read_whole(path_).info.primaries, Primaries{});
}

TEST_F(ExrRead, HonoursChromaticities) {
  Imf::Header header = fixture::header(4, 4, {"R", "G", "B"});
  Imf::addChromaticities(header,
                         {{0.7F, 0.3F}, {0.2F, 0.75F}, {0.125F, 0.0625F}, {0.3125F, 0.34375F}});
  header.pixelAspectRatio() = 2;
  write_exr(path_, header);
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.info.primaries.blue, (Chromaticity{0.125, 0.0625}));
  EXPECT_EQ(picture.info.primaries.white, (Chromaticity{0.3125, 0.34375}));
  EXPECT_EQ(picture.info.pixel_aspect, 2);
  expect_plain(picture);
}

// The adopted neutral becomes the white of the light delivered, while each colour keeps its XYZ.
TEST_F(ExrRead, AdoptedNeutralMovesTheWhiteAndKeepsXyz) {
  Imf::Header header = fixture::header(4, 4, {"R", "G", "B"}, Imf::FLOAT);
  Imf::addAdoptedNeutral(header, {0.34375F, 0.359375F});
  write_exr(path_, header);
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.info.primaries.white, (Chromaticity{0.34375, 0.359375}));
  EXPECT_EQ(picture.info.primaries.red, Primaries{}.red);
  const Eigen::Vector3d stored(plain_value("R", 1, 1), plain_value("G", 1, 1),
                               plain_value("B", 1, 1));
  const Eigen::Vector3d delivered(picture.at(1, 1, 0), picture.at(1, 1, 1), picture.at(1, 1, 2));
  const Eigen::Vector3d difference =
      xyz_from_rgb(picture.info.primaries) * delivered - xyz_from_rgb({}) * stored;
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 2e-6);  // rounding to float, of values below 16
  EXPECT_NE(picture.at(1, 1, 0), plain_value("R", 1, 1));
}

TEST_F(ExrRead, XyzFilesBecomeSrgbUnderD65) {
  for (const bool named : {false, true}) {
    Imf::Header header = fixture::header(
        2, 2,
        named ? std::vector<std::string>{"X", "Y", "Z"} : std::vector<std::string>{"R", "G", "B"},
        Imf::FLOAT);
    if (!named) Imf::addChromaticities(header, {{1, 0}, {0, 1}, {0, 0}, {1 / 3.F, 1 / 3.F}});
    const Xyz white = white_xyz(kD65);
    write_exr(path_, header, [&](const std::string& name, int, int) {
      const bool x = name == "R" || name == "X";
      const bool y = name == "G" || name == "Y";
      return static_cast<float>(x ? white.x : y ? white.y : white.z);
    });
    const WholePicture picture = read_whole(path_);
    EXPECT_EQ(picture.info.primaries, Primaries{});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(1, 1, c), 1, 3e-7);  // the file holds floats
  }
}

TEST_F(ExrRead, RefusesChromaticitiesThatMakeNoColours) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Imf::Chromaticities& bad :
       {Imf::Chromaticities{{0.1F, 0.1F}, {0.2F, 0.2F}, {0.4F, 0.4F}, {0.3F, 0.3F}},
        Imf::Chromaticities{{nan, 0.1F}, {0.3F, 0.6F}, {0.15F, 0.06F}, {0.3F, 0.3F}},
        Imf::Chromaticities{{0.64F, 0.33F}, {0.3F, 0.6F}, {0.15F, 0.06F}, {0.3F, 0}}}) {
    Imf::Header header = fixture::header(4, 4, {"R", "G", "B"});
    Imf::addChromaticities(header, bad);
    write_exr(path_, header);
    const std::string error = reading_error(path_);
    EXPECT_NE(error.find("3 " + path_ + ": its chromaticities make no colours"), std::string::npos)
        << error;
  }
}

TEST_F(ExrRead, ReconstructsLuminanceAndChroma) {
  {
    Imf::RgbaOutputFile file(path_.c_str(), 64, 48, Imf::WRITE_YCA);
    std::vector<Imf::Rgba> pixels;
    for (int i = 0; i < 64 * 48; ++i) {
      pixels.emplace_back(static_cast<float>(i % 64) / 64, static_cast<float>(i / 64) / 48, 0.25F,
                          0.5F);
    }
    file.setFrameBuffer(pixels.data(), 1, 64);
    file.writePixels(48);
  }
  const WholePicture picture = read_whole(path_, {}, 5);
  ASSERT_EQ(picture.info.channels, 4);
  EXPECT_FALSE(picture.info.grey);
  // away from the edges the filters keep a gradient; the rest is rounding to half
  for (int y = 16; y < 32; ++y) {
    for (int x = 16; x < 48; ++x) {
      ASSERT_NEAR(picture.at(x, y, 0), static_cast<float>(x) / 64, 0.01);
      ASSERT_NEAR(picture.at(x, y, 1), static_cast<float>(y) / 48, 0.01);
      ASSERT_NEAR(picture.at(x, y, 2), 0.25, 0.01);
      ASSERT_EQ(picture.at(x, y, 3), 0.5F);
    }
  }
  EXPECT_TRUE(read_whole(path_, {.layer = "Y"}).info.grey);
}

TEST_F(ExrRead, RefusesOtherSubsampledChannels) {
  Imf::Header header = fixture::header(8, 8, {"R", "G"});
  header.channels().insert("B", Imf::Channel(Imf::HALF, 2, 2));
  write_exr(path_, header);
  EXPECT_NE(reading_error(path_).find("its channel B has fewer samples"), std::string::npos);
  EXPECT_EQ(read_whole(path_, {.layer = "G"}).at(5, 5, 0), plain_value("G", 5, 5));
}

TEST_F(ExrRead, RefusesDeepFilesInOneLine) {
  {
    Imf::Header header = fixture::header(4, 4, {"R", "G", "B", "A"});
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    Imf::DeepScanLineOutputFile file(path_.c_str(), header);
  }
  EXPECT_NE(reading_error(path_).find("is deep"), std::string::npos) << reading_error(path_);
}

TEST_F(ExrRead, WithoutColoursListsTheChannelsAndStillHasFacts) {
  write_exr(path_, fixture::header(4, 4, {"Z", "id"}));
  const std::string error = reading_error(path_);
  EXPECT_EQ(
      error,
      "3 " + path_ +
          ": has no colour channels (R G B, Y or X Y Z); choose a layer or a channel of those it "
          "has: Z, id");
  EXPECT_EQ(picture_facts(path_).channels, (std::vector<std::string>{"Z:half", "id:half"}));
}

TEST_F(ExrRead, ACutFileNamesItsRow) {
  Imf::Header header = fixture::header(200, 160, {"R", "G", "B"});
  header.compression() = Imf::NO_COMPRESSION;
  write_exr(path_, header);
  const auto size = std::filesystem::file_size(path_);
  std::filesystem::resize_file(path_,
                               size - 1208 * 10 - 1);  // of a row 1200 bytes and 8 before them
  EXPECT_EQ(reading_error(path_),
            "3 " + path_ + ": is damaged or cut off at row 149; write or copy it again");
  std::filesystem::resize_file(path_, 100);
  EXPECT_EQ(reading_error(path_),
            "3 " + path_ + ": its EXR header is damaged or cut off; write or copy it again");
}

TEST_F(ExrRead, RefusesAbsurdSizesBeforeAllocating) {
  Imf::Header header = fixture::header(4, 4, {"R", "G", "B"});
  header.displayWindow() = {{0, 0}, {1'000'000'000, 3}};
  write_exr(path_, header);
  EXPECT_NE(reading_error(path_).find("is too large: 1000000001x4 pixels"), std::string::npos);
}

class ExrWrite : public ExrRead {
 protected:
  PictureInfo info_ = [] {
    PictureInfo info;
    info.width = 61;
    info.height = 37;
    return info;
  }();

  void write(const Image& image, const ExrWriteOptions& options, int band) {
    const auto sink = open_exr_sink(path_, info_, options);
    for (int y = 0; y < info_.height; y += band) {
      sink->write(image.view().rows(y, std::min(band, info_.height - y)));
    }
    sink->finish();
  }

  Image noise() const {
    Image image(info_.width, info_.height, info_.channels);
    std::uint32_t state = 1;
    for (int y = 0; y < info_.height; ++y) {
      for (float& value : image.view().row(y)) {
        state = state * 1664525 + 1013904223;
        value = static_cast<float>(state >> 8) / 0x1p20F - 4;
      }
    }
    return image;
  }
};

TEST_F(ExrWrite, FloatsComeBackBitForBit) {
  info_.channels = 4;
  info_.primaries.blue = {0.125, 0.0625};
  info_.primaries.white = {0.3125, 0.34375};
  info_.pixel_aspect = 1.5;
  const Image image = noise();
  for (const int band : {1, 7, 37}) {
    write(image, {.pixel = ExrPixel::kFloat, .replace = true}, band);
    const WholePicture picture = read_whole(path_);
    EXPECT_TRUE(same_bits(image, picture.image)) << band;
    EXPECT_EQ(picture.info.primaries.blue, info_.primaries.blue);
    EXPECT_EQ(picture.info.primaries.white, info_.primaries.white);
    EXPECT_EQ(picture.info.pixel_aspect, 1.5);
    EXPECT_EQ(picture_facts(path_).compression, "zip");
  }
}

TEST_F(ExrWrite, HalvesAreTheNearestAndOverflowToInfinity) {
  Image image = noise();
  image.view().pixel(3, 3)[0] = 1e6F;
  image.view().pixel(3, 3)[1] = -1e6F;
  image.view().pixel(3, 3)[2] = 65504;
  write(image, {}, 16);
  const WholePicture picture = read_whole(path_);
  EXPECT_EQ(picture.at(3, 3, 0), std::numeric_limits<float>::infinity());
  EXPECT_EQ(picture.at(3, 3, 1), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(picture.at(3, 3, 2), 65504);
  for (int y = 4; y < info_.height; ++y) {
    for (int x = 0; x < info_.width; ++x) {
      ASSERT_EQ(picture.at(x, y, 1), static_cast<float>(half(image.view().pixel(x, y)[1])));
    }
  }
}

TEST_F(ExrWrite, GreyIsOneChannel) {
  info_.grey = true;
  write(Image(61, 37, 3), {}, 37);
  EXPECT_EQ(picture_facts(path_).channels, std::vector<std::string>{"Y:half"});
  EXPECT_TRUE(read_whole(path_).info.grey);
}

TEST_F(ExrWrite, OpenExrReadsItToo) {
  const Image image = noise();
  write(image, {.pixel = ExrPixel::kFloat}, 11);
  Imf::RgbaInputFile file(path_.c_str());
  std::vector<Imf::Rgba> pixels(61 * 37);
  file.setFrameBuffer(pixels.data(), 1, 61);
  file.readPixels(0, 36);
  EXPECT_EQ(pixels[61 * 20 + 30].g, half(image.view().pixel(30, 20)[1]));
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("software").value(), "tristim");
}

TEST_F(ExrWrite, PublishedPrimariesComeBackInAllTheirDigits) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    PictureInfo info;
    info.width = info.height = 1;
    info.primaries = set.primaries;
    const auto sink = open_exr_sink(path_, info, {.replace = true});
    const Image pixel(1, 1, 3);
    sink->write(pixel.view());
    sink->finish();
    EXPECT_EQ(picture_facts(path_).info.primaries, set.primaries);
  }
}

TEST_F(ExrWrite, NothingIsLeftWithoutFinish) {
  {
    const auto sink = open_exr_sink(path_, info_);
    sink->write(Image(61, 20, 3).view());
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory_.path()));
}

TEST_F(ExrWrite, DoesNotReplaceUnasked) {
  write_bytes(path_, "mine");
  EXPECT_THROW(open_exr_sink(path_, info_), Error);
  EXPECT_EQ(read_bytes(path_), "mine");
}

TEST(SharedPictures, XyzAndRec709AreTheSamePicture) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  const auto folder = *shared / "images" / "chromaticities";
  const WholePicture xyz = read_whole((folder / "XYZ.exr").string());
  const WholePicture rec709 = read_whole((folder / "Rec709.exr").string());
  EXPECT_EQ(xyz.info.primaries, rec709.info.primaries);
  double sum = 0;
  for (int y = 0; y < xyz.info.height; ++y) {
    for (std::size_t i = 0; i < xyz.image.view().row(y).size(); ++i) {
      sum += std::fabs(static_cast<double>(xyz.image.view().row(y)[i]) -
                       static_cast<double>(rec709.image.view().row(y)[i]));
    }
  }
  EXPECT_LT(sum / (3.0 * xyz.info.width * xyz.info.height), 2e-4);  // measured: 1.0e-4
}

TEST(SharedPictures, CarrotsHaveAp0PrimariesUnderD60) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  const PictureFacts facts =
      picture_facts((*shared / "images" / "photos" / "Carrots.exr").string());
  EXPECT_NEAR(facts.info.primaries.white.x, 0.32168, 1e-6);
  EXPECT_NEAR(facts.info.primaries.blue.y, -0.077, 1e-6);
}

}  // namespace
}  // namespace tristim
