#include "tools/spectrum_source.h"

#include <filesystem>

#include "tristim/color/illuminant.h"
#include "tristim/color/spectral_table.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

// Names win over files of the same name: "./d65" is a file.
bool is_file(const std::string& text) {
  std::error_code ignored;
  return text == "-" || std::filesystem::exists(text, ignored);
}

std::string spoken(const std::string& file) { return file == "-" ? "standard input" : file; }

SpectralColumns table_columns(const SpectralTable& table) {
  SpectralColumns result{std::string(table.title) + " " + std::string(table.source), {}};
  for (std::size_t i = 0; i < table.column_count(); ++i) {
    result.columns.push_back({std::string(split(table.columns, ' ')[i]), column_of(table, i)});
  }
  return result;
}

// Every name that spectral_columns knows.
struct Name {
  std::string_view name;
};

std::vector<Name> all_names() {
  std::vector<Name> names;
  for (const SpectralTable& table : spectral_tables()) names.push_back({table.name});
  for (const Illuminant& illuminant : illuminants()) names.push_back({illuminant.name});
  for (const ThermalLight& light : thermal_lights()) names.push_back({light.name});
  return names;
}

}  // namespace

SpectralColumns spectral_columns(const std::string& text) {
  if (const SpectralTable* table = find_by_name(spectral_tables(), text)) {
    return table_columns(*table);
  }
  if (const Illuminant* known = find_by_name(illuminants(), text)) {
    return {std::string(known->title) + " " + std::string(known->table->source),
            {{std::string(known->name), illuminant_spectrum(*known)}}};
  }
  if (names_thermal_light(text)) return {"relative power", {parse_illuminant(text, text)}};
  if (is_file(text)) return {spoken(text), read_spectra({text})};
  throw Error(ErrorKind::kMisuse, text, "is no spectral table, illuminant or file",
              name_hint(all_names(), text));
}

std::vector<NamedSpectrum> read_spectra(const std::vector<std::string>& files) {
  std::vector<NamedSpectrum> all;
  for (const std::string& file : files) {
    for (NamedSpectrum& spectrum : parse_spectra(read_text_file(file), spoken(file))) {
      all.push_back(std::move(spectrum));
    }
  }
  return all;
}

NamedSpectrum read_illuminant(const std::string& text, const std::string& option) {
  const bool named = find_by_name(illuminants(), text) != nullptr || names_thermal_light(text);
  if (named || !is_file(text)) return parse_illuminant(text, option);
  std::vector<NamedSpectrum> spectra = read_spectra({text});
  if (spectra.size() == 1) return {text, spectra[0].spectrum};
  throw Error(ErrorKind::kContent, text, "has " + std::to_string(spectra.size()) + " spectra",
              "an illuminant is one");
}

const SumRule& rule_option(const std::string& text) {
  if (const SumRule* rule = find_by_name(kSumRules, text)) return *rule;
  throw Error(ErrorKind::kMisuse, "--rule", "unknown rule '" + text + "'",
              "use one of: " + list_names(kSumRules));
}

}  // namespace tristim::tools
