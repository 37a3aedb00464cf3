#include "tests/tools/command_test.h"

namespace tristim {
namespace {

// What the height of a picture costs in memory: nothing, once it is more than a stripe of a PNG.
class ProcessMemory : public CommandTest {
 protected:
  // Black, and no more on the disk than its header.
  std::string tall(int width, int height) const {
    const std::string name = std::to_string(height) + ".pgm";
    const std::string header =
        "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
    write(name, header);
    std::filesystem::resize_file(file(name),
                                 header.size() + std::uintmax_t(width) * std::uintmax_t(height));
    return name;
  }

  double peak_mb(const std::string& arguments) const {
    const CommandResult result = run("process " + arguments + " --quiet --force");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return static_cast<double>(result.peak_bytes) / 1e6;
  }
};

TEST_F(ProcessMemory, IsThatOfAFewBandsAtAnyHeight) {
  const std::string low = tall(3000, 3000);
  const std::string high = tall(3000, 8000);
  for (const std::string& job : {std::string(" -d laser-300 --dither bayer8 -o o.pbm"),
                                 std::string(" -d laser-300 --dither floyd-steinberg -o o.png"),
                                 std::string(" -d laser-300 --dither none -o o.exr"),
                                 std::string(" -d srgb --dither bayer8 -o o.tif")}) {
    SCOPED_TRACE(job);
    const double few = peak_mb(low + job + " --threads 1");
    EXPECT_LT(peak_mb(high + job + " --threads 1"), 1.05 * few);
    EXPECT_LT(peak_mb(high + job), 64);
  }
}

TEST_F(ProcessMemory, OfVeryWideRowsIsThatOfAFewRows) {
  const double base = peak_mb("s.exr -d laser-300 -o o.pbm");
  EXPECT_LT(peak_mb(tall(1000000, 12) + " -d laser-300 --dither bayer8 -o o.pbm --threads 2"),
            base + 32);
}

}  // namespace
}  // namespace tristim
