#include <algorithm>
#include <iterator>

#include "tools/commands.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tools/spectrum_plot.h"
#include "tools/spectrum_source.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/spectral_table.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim spectrum cie1931\n"
    "  tristim spectrum cie1931-rgb --plot rgb.svg\n"
    "  tristim spectrum d65 f11 planckian:6500 --plot lamps.svg\n"
    "  tristim spectrum daylight:5000 > d.csv\n"
    "  tristim spectrum f2 | tristim convert --from spectrum --to xyy\n"
    "  tristim spectrum --list\n";

struct Options {
  std::vector<std::string> names;
  const SumRule* rule = nullptr;
  std::string plot;
  bool json = false, list = false, force = false;
};

// Columns over the same wavelengths, and what they are.
struct Table {
  std::vector<std::string> titles;
  std::vector<NamedSpectrum> columns;
};

Spectrum resampled(const Spectrum& spectrum, const SumRule& rule) {
  Spectrum result{{}, sampled(spectrum, rule)};
  for (std::size_t i = 0; i < rule.count(); ++i) result.lambda_nm.push_back(rule.lambda_nm(i));
  return result;
}

bool share_wavelengths(const std::vector<NamedSpectrum>& columns) {
  return std::all_of(columns.begin(), columns.end(), [&](const NamedSpectrum& c) {
    return c.spectrum.lambda_nm == columns[0].spectrum.lambda_nm;
  });
}

Table read_table(const Options& options) {
  Table table;
  for (const std::string& name : options.names) {
    SpectralColumns more = spectral_columns(name);
    table.titles.push_back(std::move(more.title));
    std::move(more.columns.begin(), more.columns.end(), std::back_inserter(table.columns));
  }
  const SumRule* rule = options.rule;
  if (rule == nullptr && !share_wavelengths(table.columns)) {
    rule = &kSumRules[0];
    table.titles.push_back("sampled at " + std::string(rule->name));
  }
  if (rule == nullptr) return table;
  for (NamedSpectrum& c : table.columns) c.spectrum = resampled(c.spectrum, *rule);
  return table;
}

// As `convert --from spectrum` reads it.
std::string table_text(const Table& table) {
  std::string text;
  for (const std::string& title : table.titles) text += "# " + one_line(title) + "\n";
  text += "lambda_nm";
  for (const NamedSpectrum& c : table.columns) text += "," + c.name;
  text += "\n";
  for (std::size_t i = 0; i < table.columns[0].spectrum.lambda_nm.size(); ++i) {
    text += shortest(table.columns[0].spectrum.lambda_nm[i]);
    for (const NamedSpectrum& c : table.columns) text += "," + shortest(c.spectrum.value[i]);
    text += "\n";
  }
  return text;
}

Json table_json(const Table& table) {
  Json columns = Json::object();
  for (const NamedSpectrum& c : table.columns) columns[c.name] = c.spectrum.value;
  return {{"titles", table.titles},
          {"lambda_nm", table.columns[0].spectrum.lambda_nm},
          {"columns", columns}};
}

std::string list_line(std::string_view name, std::string_view title, std::string_view more) {
  std::string line = "  " + std::string(name);
  line.resize(std::max<std::size_t>(24, line.size() + 2), ' ');
  return line + std::string(title) + (more.empty() ? "" : "  ") + std::string(more) + "\n";
}

void list_spectra(bool json) {
  Json tables = Json::array();
  Json lights = Json::array();
  std::string text = "Tables: columns, source\n";
  for (const SpectralTable& t : spectral_tables()) {
    tables.push_back(
        {{"name", t.name}, {"title", t.title}, {"columns", t.columns}, {"source", t.source}});
    text += list_line(t.name, t.title, std::string(t.columns) + "  " + std::string(t.source));
  }
  text += "\nIlluminants: source\n";
  for (const Illuminant& i : illuminants()) {
    lights.push_back({{"name", i.name}, {"title", i.title}, {"source", i.table->source}});
    text += list_line(i.name, i.title, i.table->source);
  }
  for (const ThermalLight& light : thermal_lights()) {
    text += list_line(std::string(light.name) + ":KELVINS", light.title, {});
  }
  print(json ? json_line({{"tables", tables}, {"illuminants", lights}}) : text);
}

void write_plot(const Table& table, const Options& options) {
  refuse_other_drawings(options.plot);
  refuse_taken_outputs({options.plot}, options.force);
  std::string title;
  for (const std::string& name : options.names) title += (title.empty() ? "" : ", ") + name;
  OutputFile file(options.plot, options.force);
  file.write(spectrum_plot(table.columns, title));
  file.commit();
}

}  // namespace

void run_spectrum(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "spectrum"), kExamples);
  line.positional("NAME...", "tables, illuminants, or files of spectra; see --list", options.names,
                  0, 1 << 10);
  line.option("--rule", list_names(kSumRules, "|"),
              "sample at 380..780 or 360..830 nm; default: as published",
              [&](const std::string& v) { options.rule = &rule_option(v); });
  line.option("--plot", "OUT.svg", "draw the curves instead", options.plot);
  line.flag("--force", "replace an existing file", options.force);
  line.flag("--json", "print as JSON", options.json);
  line.flag("--list", "print the tables and illuminants with their sources", options.list);
  if (!line.parse(arguments)) return;
  if (options.list) return list_spectra(options.json);
  if (options.names.empty()) {
    throw Error(ErrorKind::kMisuse, "spectrum", "no spectrum is named",
                "give one such as cie1931 or d65; spectrum --list shows all");
  }
  const Table table = read_table(options);
  if (!options.plot.empty()) return write_plot(table, options);
  print(options.json ? json_line(table_json(table)) : table_text(table));
}

}  // namespace tristim::tools
