#include "tests/tools/command_test.h"
#include "tristim/image/io/read.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/phong.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

class ShadePaper : public CommandTest {
 protected:
  Image picture(const std::string& name) const {
    const auto source = open_picture(file(name));
    Image image(source->info().width, source->info().height, source->info().channels);
    source->read(image.view());
    return image;
  }
};

TEST_F(ShadePaper, PrintsTheTablesWithTheirMisprintsMarked) {
  const std::string text = good("shade tables --paper fisher-woo");
  EXPECT_NE(text.find("Table 1. Required f for rho given any exponent, coplanar LNE"),
            std::string::npos);
  EXPECT_NE(text.find("     10.00   0.069    0.128    0.178*   0.220*   0.255 "),
            std::string::npos);
  EXPECT_NE(text.find("* The paper prints 0.179 for 0.178 at (10.00, 15.00), 0.221 for 0.220"),
            std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), '*'), 2 + 7 + 11 + 2);  // f* twice
}

TEST_F(ShadePaper, PrintsOneTableAsTheAuthorsComputedIt) {
  const std::string text = good("shade tables --paper fisher-woo --table 2 --single");
  EXPECT_EQ(text.find('*'), std::string::npos);
  EXPECT_NE(text.find("0.179"), std::string::npos);
  EXPECT_EQ(text.find("Table 1"), std::string::npos);
}

TEST_F(ShadePaper, PrintsCsvAndJson) {
  const std::string csv = good("shade tables --paper fisher-woo --format csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 10 + 81 + 63);
  EXPECT_NE(csv.find("\n3,300.00,90.00,63.7"), std::string::npos);
  EXPECT_NE(csv.find(",63.75,63.76,1\n3,300.00,120.00,"), std::string::npos);

  const auto json = parsed(good("shade tables --paper fisher-woo --json"));
  EXPECT_EQ(json["paper"], "fisher-woo");
  ASSERT_EQ(json["tables"].size(), 3U);
  EXPECT_EQ(json["tables"][0]["misprints"].size(), 0U);
  EXPECT_EQ(json["tables"][1]["misprints"].size(), 7U);
  EXPECT_EQ(json["tables"][2]["misprints"].size(), 11U);
  EXPECT_EQ(json["tables"][1]["values"].size(), 9U);
  EXPECT_EQ(json["tables"][2]["misprints"][0]["right"], -0.43);
  EXPECT_NEAR(json["limits"][3]["maximum_error_minimax_f"].get<double>(), 32.35, 0.005);
  EXPECT_EQ(good("shade tables --paper fisher-woo --format json"),
            good("shade tables --paper Fisher_Woo --json"));
}

TEST_F(ShadePaper, RefusesUnknownPapersAndFormats) {
  refuses("shade tables", 2, "--paper: is missing; give one of fisher-woo");
  refuses("shade tables --paper fisher", 2,
          "--paper: unknown paper 'fisher'; did you mean fisher-woo?");
  refuses("shade tables --paper fisher-woo --format xml", 2,
          "--format: unknown format 'xml'; use one of: text, csv, json");
  refuses("shade tables --paper fisher-woo --table 4", 2,
          "--table: '4' is out of range; give a whole number from 1 to 3");
}

TEST_F(ShadePaper, FigureTwoIsThePapersSpheres) {
  good("shade figures fisher-woo-2 -o f");
  const Image image = picture("f/fisher-woo-2.exr");
  ASSERT_EQ(image.view().width, 480);
  ASSERT_EQ(image.view().height, 480);
  const auto at = [&](int x, int y) { return *image.view().pixel(x, y); };
  EXPECT_EQ(at(0, 0), 0);
  EXPECT_NEAR(at(47, 47), 1, 0.004);  // R.E, light and eye in one place
  // Column 2 is [L,E] = 90, row 3 f = 4: (N.H)^32 at the pixel's own normal.
  const double x = (20 + 0.5) / 48 - 1;
  const double y = 1 - (40 + 0.5) / 48;
  const Eigen::Vector3d normal(x / 0.95, y / 0.95, std::sqrt(0.95 * 0.95 - x * x - y * y) / 0.95);
  const double expected =
      blinn_phong_lobe(normal, Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 0, 1), 32);
  EXPECT_NEAR(at(2 * 96 + 20, 3 * 96 + 40), expected, 1e-7);
  EXPECT_TRUE(exists("f/fisher-woo-2.png"));
  const auto info = parsed(good("info f/fisher-woo-2.png --json"));
  EXPECT_EQ(info["width"], 480);
}

TEST_F(ShadePaper, FigureThreeHasTheQuadricsInRows) {
  good("shade figures fisher-woo-3-re fisher-woo-3-nh -o f");
  const Image r_dot_e = picture("f/fisher-woo-3-re.exr");
  const Image n_dot_h = picture("f/fisher-woo-3-nh.exr");
  EXPECT_EQ(r_dot_e.view().width, 384);
  EXPECT_EQ(n_dot_h.view().height, 288);
  // The cylinder's first column: x = -.333, lit by (-1, 1, 1); diffuse and specular.
  const double x = (32 + 0.5) / 48 - 1;
  const Eigen::Vector3d normal(x / 0.9, 0, std::sqrt(0.81 - x * x) / 0.9);
  const Eigen::Vector3d light = normalize(Eigen::Vector3d(-1, 1, 1));
  const Eigen::Vector3d eye(0, 0, 1);
  EXPECT_NEAR(*r_dot_e.view().pixel(32, 96 + 48),
              0.25 * lambert(normal, light) + 0.75 * phong_lobe(normal, light, eye, 4), 1e-7);
  EXPECT_NEAR(*n_dot_h.view().pixel(32, 96 + 48),
              0.25 * lambert(normal, light) + 0.75 * blinn_phong_lobe(normal, light, eye, 16),
              1e-7);
}

TEST_F(ShadePaper, FigureFiveIsTheErrorByThetaAndPhi) {
  good("shade figures fisher-woo-5 -o f");
  const Image image = picture("f/fisher-woo-5.exr");
  ASSERT_EQ(image.view().width, 91);
  ASSERT_EQ(image.view().height, 91);
  // Row theta, column phi, 2 degrees a step.
  EXPECT_NEAR(*image.view().pixel(20, 37), pixel_error(highlight_frame(74, 40, 90), 10, 4), 1e-5);
  EXPECT_EQ(*image.view().pixel(0, 0), 0);
}

TEST_F(ShadePaper, EveryFigureIsMadeAndListed) {
  const std::string list = good("shade figures --list");
  good("shade figures -o new/directory");
  for (const std::string_view line : split(list, '\n')) {
    if (line.empty()) continue;
    const std::string name(line.substr(0, line.find(' ')));
    const bool drawing = line.find("SVG") != std::string_view::npos;
    for (const std::string& end : drawing ? Words(".svg") : Words(".exr .png")) {
      EXPECT_TRUE(exists("new/directory/" + name + end)) << name;
    }
    if (!drawing) continue;
    const std::string svg = read("new/directory/" + name + ".svg");
    EXPECT_TRUE(svg.ends_with("</svg>\n")) << name;
    EXPECT_EQ(svg.find("nan"), std::string::npos) << name;
  }
  EXPECT_GE(std::count(list.begin(), list.end(), '\n'), 15);
}

TEST_F(ShadePaper, FiguresAreReplacedOnlyByForce) {
  good("shade figures cosine-powers -o f");
  const CommandResult again = run("shade figures cosine-powers -o f");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(again.err,
            "tristim: f/cosine-powers.svg: exists already; give --force to replace it\n");
  good("shade figures cosine-powers -o f --force");
}

TEST_F(ShadePaper, RefusesUnknownFiguresAndNoDirectory) {
  refuses("shade figures", 2, "--output: is missing; give a directory: -o figures");
  refuses("shade figures fresnell -o f", 2, "fresnell: unknown figure; did you mean fresnel?");
  refuses("shade figures fresnel -o s.exr", 1,
          "s.exr: cannot be made: not a directory; give another directory with -o");
}

}  // namespace
}  // namespace tristim
