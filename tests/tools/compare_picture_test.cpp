#include <cmath>

#include "tests/plot/svg_reader.h"
#include "tests/tools/command_test.h"

namespace tristim {
namespace {

// The same numbers on every machine, 0..255.
class Bytes {
 public:
  int next() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<int>(state_ >> 24);
  }

 private:
  std::uint32_t state_ = 1;
};

std::string pnm(const std::string& kind, int width, int height, const std::string& samples) {
  return kind + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + samples;
}

struct Golden {
  const char* name;
  double value;
};

// Pictures that need no files of others: a colourful ramp and its codes of 0 and 255 by chance,
// and 1/16 of the light as dots by chance.
class ComparePicture : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    Bytes bytes;
    std::string ramp, dots;
    for (int y = 0; y < 70; ++y) {
      for (int x = 0; x < 90; ++x) {
        for (const int v : {x * 255 / 89, y * 255 / 69, (x + y) * 7 % 256}) {
          ramp += static_cast<char>(v);
          dots += static_cast<char>(bytes.next() < v ? 255 : 0);
        }
      }
    }
    write("ramp.ppm", pnm("P6", 90, 70, ramp));
    write("dots.ppm", pnm("P6", 90, 70, dots));
    std::string tone;
    for (int i = 0; i < 170 * 130; ++i) tone += static_cast<char>(bytes.next() < 16 ? 255 : 0);
    write("flat.pgm", pnm("P5", 170, 130, std::string(170 * 130, 71)));
    write("tone.pgm", pnm("P5", 170, 130, tone));
  }

  nlohmann::json figures(const std::string& arguments) const {
    return parsed(good(Words("compare " + arguments + " --json")));
  }

  void expect(const nlohmann::json& json, std::initializer_list<Golden> golden) const {
    for (const Golden& g : golden) {
      ASSERT_TRUE(json.contains(g.name)) << g.name;
      EXPECT_NEAR(json[g.name].get<double>(), g.value, 1e-3 * std::fabs(g.value) + 1e-5) << g.name;
    }
  }
};

// Figures of the independent judge that AgreesWithTheJudge runs, for where it is not.
TEST_F(ComparePicture, PrintsTheFiguresOfTheJudge) {
  expect(figures("ramp.ppm dots.ppm"), {{"unique", 8},
                                        {"mean_lin_ref", 0.31141},
                                        {"mean_lin_out", 0.49688},
                                        {"tone_rel", 0.59556},
                                        {"tone_max", 24.7769},
                                        {"tone_mean", 17.4128},
                                        {"de00_mean", 31.5017},
                                        {"de00_p95", 67.5969},
                                        {"psnr", 7.83837},
                                        {"scielab_mean@40", 34.538},
                                        {"scielab_p95@40", 84.9622},
                                        {"hvs_snr@40", 5.46635},
                                        {"hvs_snr_campbell@40", 3.04619},
                                        {"scielab_mean@20", 49.557},
                                        {"scielab_p95@20", 122.028},
                                        {"hvs_snr@20", 4.86863},
                                        {"hvs_snr_campbell@20", 1.10082}});
  expect(figures("ramp.ppm dots.ppm --border 5 --ref-transfer linear --out-transfer g2.2 --spd 25"),
         {{"mean_lin_ref", 0.49888},
          {"tone_max", 3.30559},
          {"scielab_mean@25", 37.1302},
          {"hvs_snr@25", 16.2553}});
}

TEST_F(ComparePicture, JudgesTextureAndPatches) {
  const auto json = figures("flat.pgm tone.pgm --rapsd --patches 5 --spd 30");
  expect(json, {{"unique", 2},
                {"tone_rel", 0.0341},
                {"scielab_mean@30", 39.4871},
                {"level", 0.06516},
                {"fg", 0.25526},
                {"lf_frac", 0.05031},
                {"lf_white", 0.05151},
                {"aniso_db", -0.19597},
                {"peak_frac", 0.00054},
                {"checker_frac", 0.00117},
                {"worm", 1.07343},
                {"nn_ratio", 0.52782},
                {"nn_cv", 0.47206},
                {"edge_bias", 0.01749},
                {"patch_dL_max", 1.76386},
                {"patch_dL_mean", 0.93123}});
  ASSERT_EQ(json["patches"].size(), 5U);
  EXPECT_NEAR(json["patches"][3][2].get<double>(), -0.490, 1e-3);
  EXPECT_EQ(json["spectrum"].size(), 92U);  // rings up to 64 sqrt(2)
}

// The Python judge where it and NumPy are; the same keys, each within 1 %.
TEST_F(ComparePicture, AgreesWithTheJudge) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  std::string python;
  for (const std::string name : {"python3", "/usr/bin/python3"}) {
    if (python.empty() && run_command({name, "-c", "import numpy"}).exit_code == 0) python = name;
  }
  if (python.empty()) GTEST_SKIP() << "no Python with NumPy";
  good("process s.exr -d srgb --dither none -o reference.png");
  good("process s.exr -d vga16 --fit none --size 64x36 -o indexed.png");
  good("process s.exr -d laser-300 --dither bayer8 -o bits.png");
  good("process s.exr -d laser-300 --dither bayer8 -o bits.pbm");
  for (const std::string pair :
       {"ramp.ppm dots.ppm", "flat.pgm tone.pgm --rapsd --patches 3", "reference.png indexed.png",
        "reference.png bits.png --spd 30", "reference.png bits.pbm --border 2"}) {
    SCOPED_TRACE(pair);
    std::vector<std::string> command{python, (*shared_dir() / "tools" / "dither_eval.py").string(),
                                     "--json"};
    for (const std::string& word : Words(pair)) command.push_back(word);
    CommandOptions options;
    options.directory = std::filesystem::path(file("")).parent_path();
    const CommandResult judge = run_command(command, options);
    ASSERT_EQ(judge.exit_code, 0) << judge.err;
    const auto ours = figures(pair);
    const auto theirs = parsed(judge.out);
    for (const auto& [name, value] : theirs.items()) {
      ASSERT_TRUE(ours.contains(name)) << name;
      if (!value.is_number()) continue;
      const auto expected = value.get<double>();
      EXPECT_NEAR(ours[name].get<double>(), expected, 0.01 * std::fabs(expected) + 1e-5) << name;
    }
  }
}

TEST_F(ComparePicture, TakesWhatProcessWritesAsItIsShown) {
  good("process flat.pgm -d laser-300 --size 170x130 --dither bayer8 -o bits.png");
  good("process flat.pgm -d laser-300 --size 170x130 --dither bayer8 -o bits.pbm");
  good("process ramp.ppm -d vga16 --size 90x70 --fit none --dither bayer8 -o indexed.png");
  EXPECT_EQ(good("compare flat.pgm bits.png"), good("compare flat.pgm bits.pbm"));
  EXPECT_EQ(figures("flat.pgm bits.png")["unique"], 2);
  const auto indexed = figures("ramp.ppm indexed.png");
  EXPECT_EQ(indexed["unique"], 16);
  EXPECT_LT(indexed["tone_max"], 10);
}

TEST_F(ComparePicture, ReadsFloats) {
  good("convert --to linear:srgb s.exr -o half.exr");
  const auto same = figures("s.exr half.exr");
  EXPECT_EQ(same["max_abs"], 0);
  EXPECT_EQ(same["psnr"], "inf");
  // two rows of three pixels
  const auto npy = [](const std::string& type, std::string numbers) {
    std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (2, 3), }";
    header.resize(117, ' ');
    return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + "\n" + numbers;
  };
  const std::string half("\0\0\0\x3f", 4);  // .5, little endian
  const std::string big("\x3f\0\0\0", 4);   // .5, big endian
  const auto six = [](const std::string& s) { return s + s + s + s + s + s; };
  write("half.npy", npy("<f4", six(half)));
  write("big.npy", npy(">f4", six(big)));
  EXPECT_NEAR(figures("half.npy big.npy --out-transfer linear")["mean_lin_out"], 0.5, 1e-9);
  EXPECT_NEAR(figures("half.npy big.npy")["mean_lin_out"], 0.214041, 1e-6);  // as codes
  write("cut.npy", npy("<f4", half));
  refuses("compare half.npy cut.npy", 3,
          "cut.npy: is damaged or cut off at row 0; write or copy it again");
  write("complex.npy", npy("<c8", six(half)));
  refuses("compare half.npy complex.npy", 3,
          "complex.npy: holds numbers of the type <c8; save floats: array.astype('float32')");
}

TEST_F(ComparePicture, HasGates) {
  EXPECT_EQ(run("compare ramp.ppm dots.ppm --max-error 32").exit_code, 0);
  EXPECT_EQ(run("compare ramp.ppm dots.ppm --gate tone_max=25,hvs_snr@40=5.4").exit_code, 0);
  const CommandResult missed = run("compare ramp.ppm dots.ppm --max-error 31 --gate psnr=8");
  EXPECT_EQ(missed.exit_code, 4);
  EXPECT_EQ(missed.err,
            "tristim: dots.ppm: psnr is 7.83837, below 8; de00_mean is 31.5017, beyond 31\n");
  EXPECT_NE(missed.out.find("de00_mean"), std::string::npos);
  EXPECT_EQ(run("compare flat.pgm tone.pgm --gate tone_rel=0.01").exit_code, 4);
  EXPECT_EQ(run("compare ramp.ppm dots.ppm --gate tone_mx=1").err,
            "tristim: --gate: there is no figure 'tone_mx'; did you mean tone_max?\n");
  EXPECT_EQ(run("compare ramp.ppm dots.ppm --gate tone_max").exit_code, 2);
}

TEST_F(ComparePicture, DrawsToneAndSpectrum) {
  good("compare flat.pgm tone.pgm --rapsd --plot plot.svg");
  EXPECT_EQ(xml_complaint(read("plot.svg")), "");
  EXPECT_NE(read("plot.svg").find("radial power"), std::string::npos);
  refuses("compare flat.pgm tone.pgm --plot plot.svg", 1,
          "plot.svg: exists already; give --force to replace it");
  good("compare flat.pgm tone.pgm --plot plot.svg --force");
  EXPECT_EQ(read("plot.svg").find("radial power"), std::string::npos);
  refuses("compare flat.pgm tone.pgm --plot plot.png", 2,
          "plot.png: does not end in .svg; drawings are SVG");
}

TEST_F(ComparePicture, TellsMistakes) {
  refuses("compare ramp.ppm flat.pgm", 3,
          "flat.pgm: is 170x130, but ramp.ppm is 90x70; compare pictures of one size");
  refuses("compare ramp.ppm nothing.png", 1,
          "nothing.png: cannot be opened: no such file or directory; check the path");
  refuses("compare ramp.ppm dots.ppm --border 35", 2,
          "--border: 35 pixels at each edge leave nothing of 90x70; give less");
  refuses("compare ramp.ppm dots.ppm --out-transfer gamma", 2,
          "--out-transfer: unknown curve 'gamma'; give g and an exponent, as in g2.2, or one of "
          "linear, srgb, bt709, bt2020, bt1886, smpte240m, romm, adobe, lstar, pq, hlg, acescc, "
          "acescct");
  refuses("compare ramp.ppm dots.ppm --spd 40,", 2,
          "--spd: '' is no number; give a number from 1 to 1000");
  refuses("compare ramp.ppm dots.ppm --patches 91", 2,
          "--patches: 91 do not fit into 90 columns; give the number of columns of one tone");
  refuses("compare ramp.ppm dots.ppm --from lab", 2,
          "--from: is for colours, not for pictures; leave it out");
  refuses("compare red blue --rapsd", 2,
          "--rapsd: is for pictures; give the files of a reference and a result");
  const std::string nan("\0\0\xc0\x7f\0\0\xc0\x7f\0\0\x80\x7f", 12);
  write("nan.pfm", "PF\n1 1\n-1\n" + nan);
  refuses("compare nan.pfm nan.pfm", 3,
          "nan.pfm: has 2 samples that are no numbers and 1 that are infinite; judges need finite "
          "light; tristim convert or process can replace them");
}

}  // namespace
}  // namespace tristim
