#include "tests/plot/svg_reader.h"
#include "tests/tools/command_test.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/spectral_table.h"

namespace tristim {
namespace {

class SpectrumCommand : public CommandTest {};

TEST_F(SpectrumCommand, PrintsTables) {
  const std::string text = good("spectrum cie1931");
  EXPECT_TRUE(
      text.starts_with("# matching functions of the 2 degree observer [CIE15]\n"
                       "lambda_nm,xbar,ybar,zbar\n360,0.0001299,3.917e-06,0.0006061\n"));
  EXPECT_NE(text.find("\n555,0.5120501,1,0.005749999\n"), std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 + 471);
  EXPECT_NE(good("spectrum cie1931-rgb").find("\n500,-0.07173,0.08536,0.04776\n"),
            std::string::npos);
}

TEST_F(SpectrumCommand, PrintsIlluminantsAsPublished) {
  const auto d65 = parsed(good("spectrum D65 --json"));
  EXPECT_EQ(d65["lambda_nm"].front(), 300);
  EXPECT_EQ(d65["columns"]["d65"].size(), 531U);
  const auto d50 = parsed(good("spectrum d50 --rule 5nm --json"));
  EXPECT_EQ(d50["columns"]["d50"].size(), 81U);
  EXPECT_EQ(d50["lambda_nm"].front(), 380);
  EXPECT_EQ(d50["columns"]["d50"][36], 100);  // 560 nm
}

TEST_F(SpectrumCommand, SamplesWhatHasNoCommonWavelengths) {
  const std::string text = good("spectrum d65 f11 planckian:2856");
  EXPECT_NE(text.find("# sampled at 5nm\nlambda_nm,d65,f11,planckian:2856\n380,49.9755,0.91,"),
            std::string::npos)
      << text.substr(0, 200);
}

TEST_F(SpectrumCommand, ReadsWhatItPrints) {
  for (const std::string name : {"cie1964", "f12", "daylight:5000", "photopic"}) {
    const std::string text = good("spectrum " + name);
    const std::string again = good("spectrum -", {.input = text});
    EXPECT_EQ(again.substr(again.find('\n')), text.substr(text.find('\n'))) << name;
  }
}

TEST_F(SpectrumCommand, ListsEverything) {
  const auto list = parsed(good("spectrum --list --json"));
  EXPECT_EQ(list["tables"].size(), spectral_tables().size());
  EXPECT_EQ(list["illuminants"].size(), illuminants().size());
  const std::string text = good("spectrum --list");
  for (const Illuminant& i : illuminants()) {
    EXPECT_NE(text.find("\n  " + std::string(i.name) + " "), std::string::npos) << i.name;
  }
}

TEST_F(SpectrumCommand, DrawsCurvesWithNamesAndAxes) {
  good("spectrum cie1931-rgb photopic --plot p.svg");
  const std::string svg = read("p.svg");
  EXPECT_EQ(xml_complaint(svg), "");
  EXPECT_EQ(count_of(svg, "<polyline"), 4U);
  for (const char* text : {">rbar<", ">gbar<", ">bbar<", ">V<", ">wavelength in nm<", ">500<"}) {
    EXPECT_EQ(count_of(svg, text), 1U) << text;
  }
  refuses("spectrum d65 --plot p.svg", 1, "p.svg: exists already; give --force to replace it");
  good("spectrum d65 --plot p.svg --force");
}

TEST_F(SpectrumCommand, RefusesWhatItDoesNotKnow) {
  refuses("spectrum d66", 2, "d66: is no spectral table, illuminant or file; did you mean d65?");
  refuses("spectrum", 2,
          "spectrum: no spectrum is named; give one such as cie1931 or d65; spectrum --list shows "
          "all");
  refuses("spectrum d65 --rule 2nm", 2, "--rule: unknown rule '2nm'; use one of: 5nm, 1nm");
  refuses("spectrum daylight:100", 2,
          "daylight:100: 'daylight:100' is no illuminant; give daylight:KELVINS, from 4000 to "
          "25000");
  write("one.csv", "nm,r\n400,1\n");
  refuses("spectrum one.csv", 3,
          "one.csv: has one sample of at least two; a row is a wavelength in nm and the value of "
          "each spectrum");
}

}  // namespace
}  // namespace tristim
