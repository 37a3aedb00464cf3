#include "tristim/color/spectrum_text.h"

#include <gtest/gtest.h>

#include "tristim/color/illuminant.h"
#include "tristim/color/planckian.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

std::string refusal(std::string_view text) {
  try {
    parse_spectra(text, "s.csv");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kContent);
    const std::string what = e.what();
    return what.substr(0, what.find(';'));
  }
  return "read";
}

TEST(ParseSpectra, ReadsHeaderColumnsAndComments) {
  const auto spectra = parse_spectra(
      "\xef\xbb\xbf# measured\r\n\"lambda nm\",\"leaf\",bark\r\n400, 0.1,0.2 # first\r\n\r\n"
      "410,0.3,4e-1\r\n",
      "s.csv");
  ASSERT_EQ(spectra.size(), 2U);
  EXPECT_EQ(spectra[0].name, "leaf");
  EXPECT_EQ(spectra[1].name, "bark");
  EXPECT_EQ(spectra[0].spectrum, (Spectrum{{400, 410}, {0.1, 0.3}}));
  EXPECT_EQ(spectra[1].spectrum, (Spectrum{{400, 410}, {0.2, 0.4}}));
}

TEST(ParseSpectra, TakesAnySeparator) {
  const Spectrum expected{{400.5, 410}, {1, -2}};
  for (const char* text : {"400.5,1\n410,-2", "400.5;1\n410;-2\n", "400.5\t1\n410\t-2\n",
                           "400.5 1\n  410   -2\n", "// table\n400.5, 1,\n410, -2,\n"}) {
    const auto spectra = parse_spectra(text, "s.csv");
    ASSERT_EQ(spectra.size(), 1U) << text;
    EXPECT_EQ(spectra[0].spectrum, expected) << text;
    EXPECT_EQ(spectra[0].name, "2");
  }
}

TEST(ParseSpectra, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(refusal(""), "s.csv: has no sample");
  EXPECT_EQ(refusal("# nothing\n"), "s.csv: has no sample");
  EXPECT_EQ(refusal("nm,r\n"), "s.csv: has no sample of at least two");
  EXPECT_EQ(refusal("nm,r\n400,1\n"), "s.csv: has one sample of at least two");
  EXPECT_EQ(refusal("400,1\n500,x\n"), "s.csv, row 2, column 2: 'x' is no number");
  EXPECT_EQ(refusal("400,1\n500,\n"), "s.csv, row 2: has 1 of 2 columns");
  EXPECT_EQ(refusal("400,1,2\n500,,2\n"), "s.csv, row 2, column 2: '' is no number");
  EXPECT_EQ(refusal("400,1\n500,nan\n"), "s.csv, row 2, column 2: 'nan' is not finite");
  EXPECT_EQ(refusal("400\n500\n"), "s.csv, row 1: has one column");
  EXPECT_EQ(refusal("400,1\n500,1,2\n"), "s.csv, row 2: has 3 of 2 columns");
  EXPECT_EQ(refusal("500,1\n400,1\n"), "s.csv: has 400 nm behind 500 nm: wavelengths must rise");
  EXPECT_EQ(refusal("-400,1\n500,1\n"), "s.csv: has the wavelength -400 nm, which is not above 0");
  EXPECT_EQ(refusal("400,1\n400,1\n"), "s.csv: has 400 nm twice");
  EXPECT_EQ(refusal(",,\n400,1,2"), "s.csv, row 2: has 3 of 2 columns");
}

TEST(ParseIlluminant, TakesNamesAndTemperatures) {
  EXPECT_EQ(parse_illuminant("D65", "--illuminant").name, "d65");
  EXPECT_EQ(parse_illuminant("LED_B1", "--illuminant").spectrum,
            illuminant_spectrum(*find_by_name(illuminants(), "led-b1")));
  EXPECT_EQ(parse_illuminant("daylight:6500", "").spectrum, daylight_spectrum(6500));
  EXPECT_EQ(parse_illuminant("planckian:2700", "").spectrum, planckian_spectrum(2700));
  EXPECT_EQ(parse_illuminant("planckian:inf", "").name, "planckian:inf");
}

TEST(ParseIlluminant, RefusesOthersWithAHint) {
  const auto text = [](std::string_view illuminant) -> std::string {
    try {
      parse_illuminant(illuminant, "--illuminant");
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kMisuse);
      return e.what();
    }
    return "taken";
  };
  EXPECT_EQ(text("d56"), "--illuminant: unknown illuminant 'd56'; did you mean d50?");
  EXPECT_NE(text("zzzzzz").find("use one of: a, b, c, d50"), std::string::npos);
  EXPECT_EQ(text("daylight:3000"),
            "--illuminant: 'daylight:3000' is no illuminant; give daylight:KELVINS, from 4000 to "
            "25000");
  for (const char* bad :
       {"daylight", "planckian:", "planckian:0", "planckian:-5", "planckian:nan", "planckian:x"}) {
    EXPECT_NE(text(bad).find("is no illuminant"), std::string::npos) << bad;
  }
}

}  // namespace
}  // namespace tristim
