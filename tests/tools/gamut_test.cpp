#include "tests/plot/svg_reader.h"
#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class GamutCommand : public CommandTest {};

TEST_F(GamutCommand, PrintsAreasAndCoverage) {
  const std::string text = good("gamut srgb display-p3 BT_2020");
  for (const char* part :
       {"srgb             0.11205   0.0648918\n", "display-p3         0.152   0.0814802\n",
        "coverage of the column by the row in percent, CIE 1931\n",
        "srgb                 100     73.7171     52.8871\n",
        "bt2020               100     99.9801         100\n",
        "CIE 1931: area 0.11205, corners 0.64 0.33, 0.3 0.6, 0.15 0.06\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
}

TEST_F(GamutCommand, PrintsJson) {
  const auto json = parsed(good("gamut srgb ntsc1953 --json"));
  ASSERT_EQ(json["planes"].size(), 2U);
  const auto& plane = json["planes"][0];
  EXPECT_EQ(plane["plane"], "1931");
  EXPECT_NEAR(plane["area"]["srgb"].get<double>(), 0.11205, 1e-16);
  EXPECT_EQ(plane["coverage"]["srgb"]["srgb"], 1);
  EXPECT_EQ(plane["common"]["corners"].size(), 4U);  // blue of sRGB lies outside of NTSC
  // One intersection, seen from both sides.
  EXPECT_NEAR(plane["coverage"]["srgb"]["ntsc-1953"].get<double>() * 0.1582,
              plane["coverage"]["ntsc-1953"]["srgb"].get<double>() * 0.11205, 1e-15);
  EXPECT_EQ(json.count("colors"), 0U);
}

TEST_F(GamutCommand, TellsWhatIsOutside) {
  const auto json =
      parsed(good({"gamut", "ntsc1953", "bt2020", "--colors", "teal,#00ff40", "--json"}));
  ASSERT_EQ(json["colors"].size(), 2U);
  const auto& green = json["colors"][1];
  EXPECT_EQ(green["name"], "#00ff40");
  EXPECT_EQ(green["sets"]["bt2020"]["inside"], true);
  EXPECT_EQ(green["sets"]["ntsc-1953"]["inside"], false);
  EXPECT_EQ(green["sets"]["ntsc-1953"]["distance_uv76"], 0);  // too bright, no more
  EXPECT_GT(green["sets"]["ntsc-1953"]["above_1"], 0.04);
  EXPECT_EQ(json["illuminant"], "d65");
  EXPECT_GT(json["colors"][0]["macadam_limit"], json["colors"][0]["xyY"][2]);

  const std::string text = good("gamut srgb --from xyy --colors 0.2,0.7,0.9");
  EXPECT_NE(text.find("\n1: x 0.2 y 0.7 Y 90 %, MacAdam limit 53.68"), std::string::npos) << text;
  EXPECT_NE(text.find("brighter than any surface\n  srgb      outside, 0.05326 in u' v' from the "
                      "triangle, 0.6144 below 0"),
            std::string::npos)
      << text;
}

TEST_F(GamutCommand, AdaptsColorsToTheWhiteOfASet) {
  // White stays white, unless it is told to stay as it is.
  const auto adapted = parsed(good("gamut ntsc1953 --colors white --json"));
  EXPECT_EQ(adapted["colors"][0]["sets"]["ntsc-1953"]["inside"], true);
  const auto absolute = parsed(good("gamut ntsc1953 --colors white --adapt none --json"));
  EXPECT_EQ(absolute["colors"][0]["sets"]["ntsc-1953"]["inside"], false);
}

TEST_F(GamutCommand, DrawsADiagram) {
  good("gamut srgb 0.65,0.32,0.28,0.62,0.15,0.05,0.3127,0.329 --colors teal,gold --diagram d.svg");
  const std::string svg = read("d.svg");
  EXPECT_EQ(xml_complaint(svg), "");
  for (const char* text :
       {">CIE 1931 chromaticity diagram<", ">srgb<", ">0.65 0.32, 0.28 0.62, 0.15 0.05<", ">teal<",
        ">gold: 575.6 nm, purity 0.810<", ">520<", ">Planckian locus<"}) {
    EXPECT_GE(count_of(svg, text), 1U) << text;
  }
  refuses("gamut srgb --diagram d.svg", 1, "d.svg: exists already; give --force to replace it");
  good("gamut srgb --diagram d.svg --force --diagram-plane 1976 --limits 20,50 --ellipses");
  const std::string uv = read("d.svg");
  EXPECT_EQ(xml_complaint(uv), "");
  EXPECT_EQ(count_of(uv, ">CIE 1976 chromaticity diagram<"), 2U);  // title and text
  EXPECT_EQ(count_of(uv, ">MacAdam ellipses, 10 times<"), 1U);
  EXPECT_EQ(good("gamut srgb --diagram -").rfind("<svg", 0), 0U);
}

TEST_F(GamutCommand, ConvertDrawsItsColors) {
  EXPECT_EQ(good("convert tomato teal --diagram c.svg --gamuts bt2020,ntsc-j"), "");
  const std::string svg = read("c.svg");
  EXPECT_EQ(xml_complaint(svg), "");
  for (const char* text : {">srgb<", ">bt2020<", ">ntsc-j<", ">tomato<", ">white, D65<"}) {
    EXPECT_EQ(count_of(svg, text), 1U) << text;
  }
  const std::string lab =
      good("convert --from lab@d50 --to rgb:display-p3/pq --diagram l.svg 60 40 -20");
  EXPECT_EQ(std::count(lab.begin(), lab.end(), '\n'), 1);
  EXPECT_EQ(count_of(read("l.svg"), ">display-p3<"), 1U);
  EXPECT_EQ(count_of(read("l.svg"), ">white, D50<"), 1U);
  EXPECT_EQ(count_of(read("l.svg"), ">1: 534.8 nm c, purity 0.353<"), 1U);
  // Black has no chromaticity.
  good("convert black --diagram b.svg");
  EXPECT_EQ(count_of(read("b.svg"), ">black<"), 0U);
}

TEST_F(GamutCommand, RefusesWhatItDoesNotKnow) {
  refuses("gamut", 2, "gamut: SET is missing; use: tristim gamut SET... [options]");
  refuses("gamut srgbb", 2, "SET: unknown primaries 'srgbb'; did you mean srgb?");
  refuses("gamut 0.2,0.3,0.3,0.4,0.4,0.5,0.3127,0.329", 2,
          "SET: primaries: the three chromaticities lie on a line; give three chromaticities that "
          "span a triangle, and a white in it");
  refuses("gamut srgb --colors tomatoe", 3,
          "value 1: 'tomatoe' is no number and no colour; did you mean tomato?");
  refuses("gamut srgb --illuminant d66", 2,
          "--illuminant: unknown illuminant 'd66'; did you mean d65?");
  refuses("gamut srgb --diagram-plane 1960", 2,
          "--diagram-plane: unknown diagram '1960'; use one of: 1931, 1976");
  refuses("gamut srgb --limits 20,x", 2, "--limits: 'x' is no number; give a number from 0 to 100");
  refuses("gamut srgb --gamuts bt2021 --diagram x.svg", 2,
          "--gamuts: unknown primaries 'bt2021'; did you mean bt2020?");
  refuses("convert red --diagram nowhere/x.svg", 1,
          "nowhere/x.svg: there is no directory nowhere; create it first");
}

}  // namespace
}  // namespace tristim
