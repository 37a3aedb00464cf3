#include "tristim/color/spectrum_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tristim/color/illuminant.h"
#include "tristim/color/planckian.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::string_view kForm = "a row is a wavelength in nm and the value of each spectrum";

[[noreturn]] void refuse(const std::string& place, const std::string& wrong) {
  throw Error(ErrorKind::kContent, place, wrong, kForm);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\"";  // headers may be quoted
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string_view without_comment(std::string_view line) {
  line = trimmed(line.substr(0, line.find('#')));
  return line.starts_with("//") ? std::string_view{} : line;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  char separator = ' ';
  for (const char c : {'\t', ',', ';'}) {
    if (line.find(c) != std::string_view::npos) separator = c;
  }
  std::vector<std::string_view> cells;
  for (const std::string_view cell : split(line, separator)) {
    if (separator != ' ' || !trimmed(cell).empty()) cells.push_back(trimmed(cell));
  }
  if (cells.back().empty()) cells.pop_back();  // a separator ends the row
  return cells;
}

// Reads rows one after another.
class SpectraReader {
 public:
  explicit SpectraReader(std::string_view name) : name_(name) {}

  void read(std::size_t row, const std::vector<std::string_view>& cells) {
    const std::string place = name_ + ", row " + std::to_string(row);
    const bool numbers = std::all_of(cells.begin(), cells.end(), parse_number);
    if (spectra_.empty()) {
      if (cells.size() < 2) refuse(place, "has one column");
      name_columns(cells, numbers);
      if (!numbers) return;
    }
    if (cells.size() != spectra_.size() + 1) {
      refuse(place, "has " + std::to_string(cells.size()) + " of " +
                        std::to_string(spectra_.size() + 1) + " columns");
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      read_cell(place + ", column " + std::to_string(i + 1), i, cells[i]);
    }
  }

  std::vector<NamedSpectrum> finish() {
    if (spectra_.empty()) refuse(name_, "has no sample");
    const std::string fault = spectrum_fault(spectra_[0].spectrum);
    if (!fault.empty()) refuse(name_, fault);
    return std::move(spectra_);
  }

 private:
  void name_columns(const std::vector<std::string_view>& cells, bool numbers) {
    for (std::size_t i = 1; i < cells.size(); ++i) {
      spectra_.push_back({numbers ? std::to_string(i + 1) : std::string(cells[i]), {}});
    }
  }

  void read_cell(const std::string& place, std::size_t column, std::string_view cell) {
    const auto number = parse_number(cell);
    if (!number) refuse(place, "'" + std::string(cell) + "' is no number");
    if (!std::isfinite(*number)) refuse(place, "'" + std::string(cell) + "' is not finite");
    if (column > 0) return spectra_[column - 1].spectrum.value.push_back(*number);
    for (NamedSpectrum& s : spectra_) s.spectrum.lambda_nm.push_back(*number);
  }

  std::string name_;
  std::vector<NamedSpectrum> spectra_;
};

constexpr ThermalLight kThermalLights[] = {
    {"daylight", "CIE daylight [Judd64]", 4000, 25000, daylight_spectrum},
    {"planckian", "Planckian radiator [CIE15]", 20, HUGE_VAL,
     [](double t) { return planckian_spectrum(t); }},
};

std::string_view before_colon(std::string_view text) { return text.substr(0, text.find(':')); }

}  // namespace

std::span<const ThermalLight> thermal_lights() noexcept { return kThermalLights; }

bool names_thermal_light(std::string_view text) noexcept {
  return find_by_name(kThermalLights, before_colon(text)) != nullptr;
}

std::vector<NamedSpectrum> parse_spectra(std::string_view text, std::string_view name) {
  text = without_utf8_mark(text);
  SpectraReader reader(name);
  std::size_t row = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++row;
    const std::string_view content = without_comment(line);
    if (!content.empty()) reader.read(row, cells_of(content));
  }
  return reader.finish();
}

NamedSpectrum parse_illuminant(std::string_view text, std::string_view thing) {
  if (const Illuminant* known = find_by_name(illuminants(), text)) {
    return {std::string(known->name), illuminant_spectrum(*known)};
  }
  const std::string_view name = before_colon(text);
  const ThermalLight* thermal = find_by_name(kThermalLights, name);
  if (thermal == nullptr) {
    throw Error(ErrorKind::kMisuse, thing, "unknown illuminant '" + std::string(text) + "'",
                name_hint(illuminants(), text));
  }
  const auto kelvins = parse_number(name == text ? "" : text.substr(name.size() + 1));
  if (!kelvins || !(*kelvins >= thermal->least_k && *kelvins <= thermal->most_k)) {
    throw Error(ErrorKind::kMisuse, thing, "'" + std::string(text) + "' is no illuminant",
                "give " + std::string(thermal->name) + ":KELVINS, from " +
                    shortest(thermal->least_k) + " to " + shortest(thermal->most_k));
  }
  return {std::string(text), thermal->spectrum(*kelvins)};
}

}  // namespace tristim
