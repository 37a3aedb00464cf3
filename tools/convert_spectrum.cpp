#include "tools/convert_spectrum.h"

#include <algorithm>
#include <cmath>

#include "tools/spectrum_source.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

std::string range_text(double first, double last) {
  return shortest(first) + " to " + shortest(last) + " nm";
}

// Says what a spectrum lacks of the rule's wavelengths.
void note_coverage(const std::string& name, const Spectrum& spectrum, const SumRule& rule) {
  const double first = spectrum.lambda_nm.front();
  const double last = spectrum.lambda_nm.back();
  const std::string wanted = range_text(rule.first_nm, rule.last_nm);
  if (last < rule.first_nm || first > rule.last_nm) {
    throw Error(ErrorKind::kContent, name, "has no wavelength from " + wanted,
                "wavelengths are in nm");
  }
  if (first <= rule.first_nm && last >= rule.last_nm) return;
  note(name + ": covers " + range_text(first, last) + " of " + wanted + "; it counts as 0 outside");
}

// Says that the rule leaves out samples.
void note_fine_steps(const std::string& name, const Spectrum& spectrum, const SumRule& rule) {
  const std::vector<double>& lambda = spectrum.lambda_nm;
  const auto finer = std::adjacent_find(lambda.begin(), lambda.end(), [&](double a, double b) {
    return a >= rule.first_nm && b <= rule.last_nm && b - a < rule.step_nm * (1 - 1e-9);
  });
  if (finer == lambda.end()) return;
  const std::string step = shortest(rule.step_nm) + " nm";
  note(name + ": has steps below " + step + ", of which the sum takes every " + step +
       (rule.step_nm > 1 ? "; --rule 1nm takes more" : ""));
}

std::string rule_text(const SpectrumSettings& settings) {
  const SumRule& rule = *settings.rule;
  return "observer " + std::string(settings.observer->name) + "; rule " + std::string(rule.name) +
         ": plain sum from " + range_text(rule.first_nm, rule.last_nm) + " at " +
         shortest(rule.step_nm) + " nm, linear between samples";
}

std::string light_text(const SpectrumSettings& settings) {
  const std::string divided =
      settings.white_luminance > 0
          ? ", divided by the white's " + shortest(settings.white_luminance) + " cd/m2"
          : "";
  return "spectrum to xyz: X = 683 lm/W sum(P xbar) " + shortest(settings.rule->step_nm) +
         " nm, likewise Y and Z [CIE15 7.1]; no illuminant is given, so the spectrum is light "
         "itself: Y in cd/m2 where P is in W/(m2 sr nm)" +
         divided + "; " + rule_text(settings);
}

std::string object_text(const NamedSpectrum& light, Chromaticity white,
                        const SpectrumSettings& settings) {
  return "spectrum to xyz: X = sum(R S xbar)/sum(S ybar), likewise Y and Z [CIE15 7.1]; S "
         "illuminant " +
         light.name + ", white " + shortest(white.x) + " " + shortest(white.y) + "; " +
         rule_text(settings);
}

nlohmann::ordered_json facts_of(const SpectrumSettings& settings) {
  const SumRule& rule = *settings.rule;
  return {{"kind", settings.illuminant.empty() ? "self-luminous" : "reflecting"},
          {"observer", settings.observer->name},
          {"rule", rule.name},
          {"first_nm", rule.first_nm},
          {"last_nm", rule.last_nm},
          {"step_nm", rule.step_nm}};
}

// From one spectrum to XYZ.
class SpectrumEye {
 public:
  explicit SpectrumEye(const SpectrumSettings& settings) : settings_(settings) {
    if (settings.illuminant.empty()) return;
    if (settings.white_luminance > 0) {
      throw Error(ErrorKind::kMisuse, "--white-luminance", "goes with light, not with --illuminant",
                  "under an illuminant the white is what reflects all");
    }
    light_ = read_illuminant(settings.illuminant, "--illuminant");
    note_coverage("illuminant " + light_.name, light_.spectrum, *settings.rule);
    white_ = chromaticity_of_light(light_.spectrum, *settings.observer, *settings.rule);
    if (!(white_.y > 0)) {
      throw Error(ErrorKind::kContent, light_.name,
                  "is no illuminant: its luminance is not above 0",
                  "an illuminant has a power above 0");
    }
  }

  Xyz operator()(const Spectrum& spectrum) const {
    if (!settings_.illuminant.empty()) {
      return xyz_of_object(spectrum, light_.spectrum, *settings_.observer, *settings_.rule);
    }
    const double unit = settings_.white_luminance > 0 ? settings_.white_luminance : 1;
    const Xyz xyz = xyz_of_light(spectrum, *settings_.observer, *settings_.rule);
    return {xyz.x / unit, xyz.y / unit, xyz.z / unit};
  }

  // Says in `colors` what the eye is adapted to.
  void describe(SpectrumColors& colors) const {
    colors.model = parse_model("xyz", "--from");
    colors.facts = facts_of(settings_);
    if (settings_.illuminant.empty()) {
      colors.explanation = light_text(settings_);
      return;
    }
    colors.model.white = white_;
    colors.explanation = object_text(light_, white_, settings_);
    colors.facts["illuminant"] = light_.name;
    colors.facts["white"] = {white_.x, white_.y};
  }

 private:
  const SpectrumSettings& settings_;
  NamedSpectrum light_;
  Chromaticity white_;
};

}  // namespace

void declare_spectrum_options(CommandLine& line, SpectrumSettings& settings) {
  line.section("Spectra (--from spectrum FILE...)");
  line.option("--illuminant", "LIGHT",
              "light on the objects: d65, f11, daylight:6500, planckian:2700 or a file; default: "
              "none, the spectra are light; spectrum --list shows all",
              [&](const std::string& v) {
                settings.illuminant = v;
                settings.given = true;
              });
  line.option("--observer", "2|10", "CIE 1931 or CIE 1964; default: 2", [&](const std::string& v) {
    settings.observer = find_observer(v);
    settings.given = true;
    if (settings.observer != nullptr) return;
    throw Error(ErrorKind::kMisuse, "--observer", "unknown observer '" + v + "'",
                "use one of: 2, 10, " + list_names(observers()));
  });
  line.option("--rule", list_names(kSumRules, "|"),
              "sum at 5 nm from 380 to 780 or at 1 nm from 360 to 830; default: 5nm",
              [&](const std::string& v) {
                settings.rule = &rule_option(v);
                settings.given = true;
              });
  line.option("--white-luminance", "CD_M2", "of light: what becomes Y = 1; default: 1 cd/m2",
              [&](const std::string& v) {
                settings.white_luminance = number_option("--white-luminance", v, 1e-12, 1e12);
                settings.given = true;
              });
}

SpectrumColors read_spectrum_colors(const std::vector<std::string>& files,
                                    const SpectrumSettings& settings) {
  const SpectrumEye eye(settings);
  SpectrumColors colors;
  eye.describe(colors);
  for (const std::string& file : files) {
    const std::vector<NamedSpectrum> spectra = read_spectra({file});
    const std::string name = file == "-" ? "standard input" : file;
    note_coverage(name, spectra[0].spectrum, *settings.rule);
    note_fine_steps(name, spectra[0].spectrum, *settings.rule);
    for (const NamedSpectrum& s : spectra) {
      const Xyz xyz = eye(s.spectrum);
      colors.rows.push_back({{xyz.x, xyz.y, xyz.z}});
      colors.facts["names"].push_back(s.name);
    }
  }
  return colors;
}

}  // namespace tristim::tools
