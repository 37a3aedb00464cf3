#include "tests/image/picture_support.h"
#include "tests/tools/command_test.h"
#include "tristim/color/difference.h"
#include "tristim/color/xyz.h"

namespace tristim {
namespace {

class ProcessResult : public CommandTest {
 protected:
  std::vector<std::string> pictures(const std::string& folder) const {
    std::vector<std::string> all;
    for (const auto& entry :
         std::filesystem::directory_iterator(*shared_dir() / "images" / folder)) {
      all.push_back(entry.path().string());
    }
    std::sort(all.begin(), all.end());
    return all;
  }
};

TEST_F(ProcessResult, IsTheSameForAnyNumberOfThreads) {
  for (const std::string device : kDevices) {
    SCOPED_TRACE(device);
    for (const std::string threads : {"1", "2", "7"}) {
      good("process s.exr -d " + device + " --tone-map reinhard --quiet --threads " + threads +
           " --size 100x1100 --proof proof" + threads + ".png --force -o " + threads + ".png");
    }
    for (const std::string threads : {"2", "7"}) {
      EXPECT_EQ(read(threads + ".png"), read("1.png"));
      EXPECT_EQ(read("proof" + threads + ".png"), read("proof1.png"));
    }
  }
}

TEST_F(ProcessResult, TakesOnePixel) {
  write("one.pfm", std::string("PF\n1 1\n-1.0\n") + std::string(12, '\0'));
  for (const std::string device : kDevices) {
    SCOPED_TRACE(device);
    const auto facts = parsed(good("process one.pfm -d " + device + " --size 1x1 --json -o " +
                                   device + ".png --proof p-" + device + ".png"));
    EXPECT_EQ(facts["width"], 1);
    EXPECT_EQ(facts["height"], 1);
    good("process one.pfm -d " + device + " --size 1x1 -o " + device + ".h");
  }
}

TEST_F(ProcessResult, HasTheSizeOfThePanel) {
  const auto panel = parsed(good("process s.exr -d epaper-4grey --json --quiet -o o.png"));
  EXPECT_EQ(panel["width"], 800);
  EXPECT_EQ(panel["height"], 480);
  const auto asked =
      parsed(good("process s.exr -d epaper-4grey --size 32x --json --quiet -o a.png"));
  EXPECT_EQ(asked["width"], 32);
  EXPECT_EQ(asked["height"], 18);
}

TEST_F(ProcessResult, HasTheSizeOfTheDisplayWindow) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  constexpr int kDisplaySize[][2] = {{400, 300}, {400, 300}, {370, 280}, {370, 280}};
  for (std::size_t i = 0; i < std::size(kDisplaySize); ++i) {
    const std::string path = pictures("windows").at(i);
    SCOPED_TRACE(path);
    for (const std::string& facts :
         {good({"info", path, "--json"}),
          good({"process", path, "-d", "srgb", "-o", "o.png", "--json", "--quiet", "-f"})}) {
      EXPECT_EQ(parsed(facts)["width"], kDisplaySize[i][0]);
      EXPECT_EQ(parsed(facts)["height"], kDisplaySize[i][1]);
    }
  }
}

TEST_F(ProcessResult, EveryPictureGoesThroughEveryDevice) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  std::vector<std::string> arguments{"process"};
  for (const char* folder : {"photos", "charts"}) {
    for (std::string& path : pictures(folder)) arguments.push_back(std::move(path));
  }
  const std::size_t count = arguments.size() - 1;
  EXPECT_GE(count, 11U);
  for (const std::string device : kDevices) {
    SCOPED_TRACE(device);
    std::vector<std::string> all = arguments;
    for (const char* rest : {"--quiet", "--json", "--size", "160x90", "-d"}) all.emplace_back(rest);
    all.push_back(device);
    all.insert(all.end(), {"-o", device + "-{stem}.png", "--proof", device + "-{stem}-proof.png"});
    const std::string lines = good(all);
    EXPECT_EQ(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')), count);
  }
}

// Mean CIEDE2000 of two sRGB pictures.
double mean_difference(const std::string& first, const std::string& second) {
  const WholePicture a = read_whole(first);
  const WholePicture b = read_whole(second);
  EXPECT_EQ(a.info.width, b.info.width);
  EXPECT_EQ(a.info.height, b.info.height);
  const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  const auto lab = [&](const WholePicture& picture, int x, int y) {
    const Eigen::Vector3d xyz =
        matrix * Eigen::Vector3d(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
    return xyz_to_lab({xyz.x(), xyz.y(), xyz.z()}, white_xyz(kD65));
  };
  double sum = 0;
  for (int y = 0; y < a.info.height; ++y) {
    for (int x = 0; x < a.info.width; ++x) sum += ciede2000(lab(a, x, y), lab(b, x, y));
  }
  return sum / a.info.width / a.info.height;
}

TEST_F(ProcessResult, DoesNotDependOnThePrimariesOfTheFile) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  const std::string folder = (*shared_dir() / "images/chromaticities").string();
  for (const std::string device : kDevices) {
    for (const std::string adapt : {"bradford", "none"}) {
      SCOPED_TRACE(device + " " + adapt);
      for (const std::string name : {"XYZ", "Rec709"}) {
        good({"process", folder + "/" + name + ".exr", "-d", device, "--adapt", adapt, "--dither",
              "none", "--size", "122x81", "--quiet", "-f", "-o", "o.png", "--proof",
              name + ".png"});
      }
      // Largest measured: 0.03, of halves on both sides. Nearest entries may flip where two are
      // equally far, which costs more on a device of few colours.
      EXPECT_LT(mean_difference(file("XYZ.png"), file("Rec709.png")), 0.1);
    }
  }
}

TEST_F(ProcessResult, ExplainsEveryStep) {
  const std::string text = good(
      "process s.exr -d crt-p22 --exposure 1 --tone-map reinhard:4 --explain -o o.png --proof "
      "p.png");
  for (const char* part : {"1. read s.exr",
                           "NaN read as 0",
                           "fit",
                           "exposure",
                           "tone map",
                           "Ld = L (1 + L/W^2)/(1 + L)",
                           "[Reinhard02 eq 4]",
                           "primaries",
                           "matrix row 1  1.339",
                           "matrix row 3",
                           "bradford",
                           "gamut map clip",
                           "out of gamut",
                           "pixels brighter than white",
                           "response",
                           "R first   code 47 at light 0",
                           "B last    code 255 at light 1",
                           "[Shoaff 2.1.1]",
                           "dither none",
                           "pack and write o.png",
                           "rgb888",
                           "mean CIEDE2000 of the proof"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  const std::string palette =
      good("process s.exr -d vga16 --palette median-cut:5 --explain -o q.png");
  EXPECT_NE(palette.find("choose a palette, median-cut  [Heckbert82]"), std::string::npos)
      << palette;
}

TEST_F(ProcessResult, PrintsFactsAsJson) {
  const std::string lines =
      good("process s.exr s.exr -d laser-300 --json --explain -o %d.png --proof p%d.png");
  const std::vector<std::string_view> rows = split(lines, '\n');
  ASSERT_EQ(rows.size(), 3U);
  const auto facts = parsed(std::string(rows[1]));
  EXPECT_EQ(facts["input"], "s.exr");
  EXPECT_EQ(facts["output"], "2.png");
  EXPECT_EQ(facts["proof"], "p2.png");
  EXPECT_EQ(facts["device"], "laser-300");
  EXPECT_EQ(facts["packing"], "mono1");
  EXPECT_EQ(facts["bytes"], std::filesystem::file_size(file("2.png")));
  EXPECT_GT(facts["mean_ciede2000"], 1);
  for (const char* key :
       {"width", "height", "seconds", "nan", "infinite", "out_of_gamut", "clipped"})
    EXPECT_TRUE(facts[key].is_number()) << key;
  ASSERT_TRUE(facts["steps"].is_array());
  for (const auto& step : facts["steps"]) {
    EXPECT_TRUE(step["name"].is_string() && step["formula"].is_string() &&
                step["source"].is_string() && step["numbers"].is_object());
  }
}

}  // namespace
}  // namespace tristim
