#include <cmath>

#include "tests/tools/command_test.h"
#include "tristim/color/illuminant.h"

namespace tristim {
namespace {

class ConvertSpectrum : public CommandTest {
 protected:
  std::vector<double> numbers(const Words& arguments, const CommandOptions& options = {}) const {
    std::vector<double> all;
    for (const std::string& word : Words(good(arguments, options))) {
      for (const std::string_view line : split(word, '\n')) {
        if (!line.empty()) all.push_back(parse_number(line).value_or(std::nan("")));
      }
    }
    return all;
  }
};

// A bump of reflectance under illuminant D50 for the observer of 10 degrees, Y = 1 for the white.
TEST_F(ConvertSpectrum, ReflectsUnderAnIlluminant) {
  std::string csv = "lambda,reflectance\n";
  for (int lambda = 380; lambda <= 780; lambda += 5) {
    const double z = (lambda - 765.7007720372111) / 19.672779033874015;
    csv += std::to_string(lambda) + "," +
           shortest(0.07182118940449755 + 0.5339115678204412 * std::exp(-z * z)) + "\n";
  }
  write("r.csv", csv);
  const auto xyz = numbers("convert --from spectrum r.csv --to xyz --illuminant d50 --observer 10");
  ASSERT_EQ(xyz.size(), 3U);
  EXPECT_NEAR(xyz[0], 0.069482299338549325, 1e-15);
  EXPECT_NEAR(xyz[1], 0.07182786922640569, 1e-15);
  EXPECT_NEAR(xyz[2], 0.05848163228642527, 1e-15);
}

// What reflects all is the white, whatever the light; a grey is neutral.
TEST_F(ConvertSpectrum, KeepsGreysNeutral) {
  write("grey.csv", "300 0.5 1\n900 0.5 1\n");
  for (const Illuminant& light : illuminants()) {
    for (const std::string observer : {"2", "10"}) {
      const std::string words =
          " --illuminant " + std::string(light.name) + " --observer " + observer;
      const auto lab = numbers("convert --from spectrum grey.csv --to lab" + words);
      ASSERT_EQ(lab.size(), 6U) << words;
      EXPECT_NEAR(lab[0], 76.0692610142, 1e-9) << words;
      EXPECT_NEAR(lab[3], 100, 1e-12);
      for (const std::size_t i : {1U, 2U, 4U, 5U}) EXPECT_NEAR(lab[i], 0, 1e-12) << words;
    }
  }
}

TEST_F(ConvertSpectrum, IsLightWithoutAnIlluminant) {
  const std::string lamp = good("spectrum planckian:2856");
  const auto cct = numbers("convert --from spectrum --to cct --rule 1nm", {.input = lamp});
  ASSERT_EQ(cct.size(), 3U);
  EXPECT_NEAR(cct[0], 2856, 1e-6);
  EXPECT_NEAR(cct[1], 0, 1e-12);
  // 555 nm alone, .01 W/(m2 sr nm) over 5 nm.
  write("line.csv", "550,0\n555,0.01\n560,0\n");
  EXPECT_NEAR(numbers("convert --from spectrum line.csv --to xyz")[1], 683 * 0.01 * 5, 1e-12);
  EXPECT_NEAR(numbers("convert --from spectrum line.csv --to xyz --white-luminance 34.15")[1], 1,
              1e-14);
}

TEST_F(ConvertSpectrum, ExplainsAndNamesItsRule) {
  write("s.csv", "# bark and leaf\nnm;leaf;bark\n380;.1;.2\n780;.5;.5\n");
  const auto json =
      parsed(good("convert --from spectrum s.csv --to lab --illuminant D65 --observer 10 --json "
                  "--explain"));
  const auto& facts = json["spectrum"];
  EXPECT_EQ(facts["kind"], "reflecting");
  EXPECT_EQ(facts["rule"], "5nm");
  EXPECT_EQ(facts["first_nm"], 380);
  EXPECT_EQ(facts["last_nm"], 780);
  EXPECT_EQ(facts["observer"], "cie1964");
  EXPECT_EQ(facts["illuminant"], "d65");
  EXPECT_NEAR(facts["white"][0].get<double>(), 0.313805, 1e-6);
  EXPECT_EQ(facts["names"], nlohmann::json::array({"leaf", "bark"}));
  EXPECT_TRUE(
      json["steps"][0].get<std::string>().starts_with("spectrum to xyz: X = sum(R S xbar)"));
  const std::string text = good("convert --from spectrum s.csv --to xyz --rule 1nm --explain");
  EXPECT_NE(text.find("no illuminant is given, so the spectrum is light itself"),
            std::string::npos);
  EXPECT_NE(text.find("rule 1nm: plain sum from 360 to 830 nm at 1 nm"), std::string::npos);
}

TEST_F(ConvertSpectrum, TellsWhatIsMissing) {
  write("short.csv", "400,1\n700,1\n");
  const CommandResult result = run("convert --from spectrum short.csv --to xyz");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err,
            "tristim: short.csv: covers 400 to 700 nm of 380 to 780 nm; it counts as 0 outside\n");
  write("fine.csv", "380,1\n381,2\n780,1\n");
  EXPECT_EQ(run("convert --from spectrum fine.csv --to xyz").err,
            "tristim: fine.csv: has steps below 5 nm, of which the sum takes every 5 nm; --rule "
            "1nm takes more\n");
  EXPECT_EQ(run("convert --from spectrum fine.csv --to xyz --illuminant d65 --quiet").err, "");
}

TEST_F(ConvertSpectrum, RefusesBadSpectra) {
  const std::string form = "; a row is a wavelength in nm and the value of each spectrum";
  const std::pair<const char*, const char*> bad[] = {
      {"400,1\n", "has one sample of at least two"},
      {"500,1\n400,1\n", "has 400 nm behind 500 nm: wavelengths must rise"},
      {"-400,1\n500,1\n", "has the wavelength -400 nm, which is not above 0"},
      {"400,1\n400,1\n", "has 400 nm twice"},
  };
  for (const auto& [csv, wrong] : bad) {
    write("bad.csv", csv);
    refuses("convert --from spectrum bad.csv --to xyz", 3, "bad.csv: " + std::string(wrong) + form);
  }
  write("bad.csv", "400,1\n500,one\n");
  refuses("convert --from spectrum bad.csv --to xyz", 3,
          "bad.csv, row 2, column 2: 'one' is no number" + form);
  write("bad.csv", "0.4,1\n0.7,1\n");
  refuses("convert --from spectrum bad.csv --to xyz", 3,
          "bad.csv: has no wavelength from 380 to 780 nm; wavelengths are in nm");
  refuses("convert --from spectrum none.csv --to xyz", 1,
          "none.csv: there is no such file; check the name");
}

TEST_F(ConvertSpectrum, RefusesBadOptions) {
  write("s.csv", "380,1\n780,1\n");
  const std::string convert = "convert --from spectrum s.csv --to xyz ";
  refuses(convert + "--illuminant d66", 2,
          "--illuminant: unknown illuminant 'd66'; did you mean d65?");
  refuses(convert + "--observer 3", 2,
          "--observer: unknown observer '3'; use one of: 2, 10, cie1931, cie1964");
  refuses(convert + "--rule 2nm", 2, "--rule: unknown rule '2nm'; use one of: 5nm, 1nm");
  refuses(convert + "--illuminant d65 --white-luminance 5", 2,
          "--white-luminance: goes with light, not with --illuminant; under an illuminant the "
          "white is what reflects all");
  refuses("convert --to lab red --illuminant d65", 2,
          "--from: 'rgb:srgb' is no spectrum; --illuminant, --observer, --rule and "
          "--white-luminance go with --from spectrum");
}

TEST_F(ConvertSpectrum, ListsIlluminantsAndObservers) {
  const std::string text = good("convert --list");
  for (const Illuminant& light : illuminants()) {
    EXPECT_NE(text.find("\n  " + std::string(light.name) + " "), std::string::npos) << light.name;
  }
  EXPECT_NE(text.find("cie1964, 10"), std::string::npos);
  EXPECT_EQ(parsed(good("convert --list --json"))["illuminants"].size(), illuminants().size());
}

TEST_F(ConvertSpectrum, TakesAnIlluminantOfAFile) {
  write("grey.csv", "300,0.5\n900,0.5\n");
  write("lamp.csv", good("spectrum f11"));
  EXPECT_EQ(good("convert --from spectrum grey.csv --to xyz --illuminant lamp.csv"),
            good("convert --from spectrum grey.csv --to xyz --illuminant f11"));
  write("two.csv", "300,1,1\n900,1,1\n");
  refuses("convert --from spectrum grey.csv --to xyz --illuminant two.csv", 3,
          "two.csv: has 2 spectra; an illuminant is one");
  write("dark.csv", "300,0\n900,0\n");
  refuses("convert --from spectrum grey.csv --to xyz --illuminant dark.csv", 3,
          "dark.csv: is no illuminant: its luminance is not above 0; an illuminant has a power "
          "above 0");
}

}  // namespace
}  // namespace tristim
