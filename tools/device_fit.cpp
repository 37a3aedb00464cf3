#include <algorithm>
#include <cmath>

#include "tools/device_actions.h"
#include "tools/device_fit_report.h"
#include "tools/device_options.h"
#include "tools/measured_input.h"
#include "tools/measured_primaries.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/channels.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  printf '0,0.4\\n64,6\\n128,22\\n192,55\\n255,102\\n' > panel.csv && tristim device fit "
    "panel.csv "
    "--packing gray8 -o panel.toml\n"
    "  printf 'code,red,green,blue\\n0,.1,.1,.1\\n64,1.3,3.9,.6\\n128,5.2,17,2\\n192,12,41,4.6\\n"
    "255,22,76,8.5\\n' > ramps.csv && tristim device fit ramps.csv --red 0.64,0.33 --green 0.3,0.6 "
    "--blue 0.15,0.06 --white d65 --json\n"
    "  printf 'name,X,Y,Z\\nred,42,22,2\\ngreen,36,71,12\\nblue,18,7.3,95\\nwhite,95,100,108\\n' > "
    "xyz.csv && tristim device fit panel.csv --primaries xyz.csv -o rgb.toml --plot fit.svg\n"
    "  tristim device check rgb.toml --plot rgb.svg\n";

struct Options {
  DeviceOptions device;
  std::vector<std::string> files;
  std::string primaries, output, plot;
  std::string model, response = "auto";
  std::optional<double> max_error;
  bool monotone = false, json = false, force = false;
};

struct Choice {
  std::string_view name;
};
constexpr Choice kWritten[] = {{"auto"}, {"model"}, {"table"}};

void declare(CommandLine& line, Options& o) {
  line.positional("MEASURED.csv",
                  "rows of code,luminance or of code,red,green,blue; or three files, of red, green "
                  "and blue",
                  o.files, 1, 3);
  line.option("-o,--output", "OUT.toml", "write the device file", o.output);
  line.option("--primaries", "XYZ.csv",
              "measured primaries: rows of red, green, blue, white and black with X,Y,Z or, under "
              "the heading name,x,y,Y, with x,y,Y",
              o.primaries);
  line.option("--model", list_names(kFitModels, "|"), "default: the one that pays",
              [&](const std::string& v) {
                const FitModel* model = find_by_name(kFitModels, v);
                if (model == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--model", "unknown model '" + v + "'",
                              name_hint(kFitModels, v));
                }
                o.model = model->name;
              });
  line.option("--write", list_names(kWritten, "|"),
              "what the file holds; default: the model where no row misses it by more than 1 "
              "CIEDE2000, else the table",
              [&](const std::string& v) {
                const Choice* choice = find_by_name(kWritten, v);
                if (choice == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--write", "unknown choice '" + v + "'",
                              name_hint(kWritten, v));
                }
                o.response = choice->name;
              });
  line.option(
      "--max-error", "E", "exit code 4 where a row misses the model by more CIEDE2000",
      [&](const std::string& v) { o.max_error = number_option("--max-error", v, 0, 1000); });
  line.flag("--monotone", "level out measured luminances that fall", o.monotone);
  line.option("--plot", "OUT.svg", "draw the measured points and the fitted curves", o.plot);
  line.flag("--json", "print the fit as JSON", o.json);
  line.flag("-f,--force", "replace existing files", o.force);
  declare_device_options(line, o.device);
}

// The display as it is before its response is known.
Display display_of(const Options& o, std::size_t channels, const FitReport& report) {
  Display display;
  display.name = "measured display";
  display.source = "measured: " + one_line(o.files[0]);
  const bool grey = channels == 1 && !report.measured;
  display.frame.packing = *find_by_name(kPackings, grey ? "gray8" : "rgb888");
  if (report.measured) display.primaries = primaries_of(*report.measured);
  apply_device_options(o.device, display);
  if (channels == 3 && display.frame.packing.samples != 3) {
    throw Error(ErrorKind::kMisuse, "--packing",
                std::string(display.frame.packing.name) + " has one channel, the measurement three",
                "give a packing such as rgb888");
  }
  return display;
}

// Vmax of a channel: the packing's highest code, unless codes beyond it were measured.
double code_max_of(const Display& display, std::size_t channel, const TableResponse& ramp) {
  const auto bits = static_cast<unsigned>(display.frame.packing.bits[channel]);
  const double most = (1U << bits) - 1;
  if (ramp.code.back() <= most) return most;
  throw Error(ErrorKind::kMisuse, "--packing",
              std::string(display.frame.packing.name) + " ends at code " + shortest(most) +
                  ", the measurement at " + shortest(ramp.code.back()),
              "give the packing that was measured");
}

// A good digit more than a meter has.
double trimmed(double value) { return parse_number(rounded(value, 6)).value_or(value); }

Response written_response(const ChannelFit& channel, bool table) {
  if (table) return channel.ramp;
  const GogResponse& g = channel.fit.response;
  return GogResponse{trimmed(g.gamma), trimmed(g.offset), trimmed(g.black)};
}

void take_responses(const FitReport& report, Display& display) {
  for (std::size_t c = 0; c < report.channels.size(); ++c) {
    const Response response = written_response(report.channels[c], report.writes_table);
    if (c == 0) display.response = response;
    if (report.channels.size() == 3) display.channel_response[c] = response;
  }
}

std::string remarks(const FitReport& report) {
  std::string text = "Fitted by tristim device fit.";
  for (const ChannelFit& channel : report.channels) {
    text += "\n" + (channel.name.empty() ? "" : channel.name + ": ") + "model " +
            std::string(channel.fit.model->name) + ", white " + rounded(channel.fit.white, 5) +
            ", largest error " + rounded(channel.fit.largest_ciede2000, 3) + " CIEDE2000, RMS " +
            rounded(channel.fit.rms_lstar, 3) + " L*";
  }
  return text +
         (report.writes_table ? "\nThe measured table stands here instead of the model." : "");
}

void check_outputs(const Options& o) {
  if (o.output == "-" && o.json) {
    throw Error(ErrorKind::kMisuse, "--json", "does not go with -o -", "write the file elsewhere");
  }
  std::vector<std::string> outputs;
  for (const std::string& output : {o.output, o.plot}) {
    if (!output.empty() && output != "-") outputs.push_back(output);
  }
  if (!o.plot.empty()) refuse_other_drawings(o.plot);
  refuse_taken_outputs(outputs, o.force);
  refuse_inputs_as_outputs(o.files, outputs);
}

FitReport fitted(const Options& o) {
  FitReport report;
  if (!o.primaries.empty()) report.measured = read_measured_primaries(o.primaries);
  const std::vector<TableResponse> ramps = read_measured(o.files, o.monotone);
  report.display = display_of(o, ramps.size(), report);
  report.has_primaries = report.measured || o.device.set || o.device.red || o.device.white;
  for (std::size_t c = 0; c < ramps.size(); ++c) {
    const double code_max = code_max_of(report.display, c, ramps[c]);
    const FitModel* model = o.model.empty() ? nullptr : find_by_name(kFitModels, o.model);
    report.channels.push_back({ramps.size() == 3 ? std::string(kChannelNames[c]) : "", ramps[c],
                               code_max, fit_response(ramps[c], code_max, model)});
  }
  double worst = 0;
  for (const ChannelFit& c : report.channels) worst = std::max(worst, c.fit.largest_ciede2000);
  report.largest_ciede2000 = worst;
  report.writes_table = o.response == "table" || (o.response == "auto" && worst > kGoodFit);
  take_responses(report, report.display);
  return report;
}

void write_plot(const FitReport& report, const Options& o) {
  OutputFile file(o.plot, o.force);
  file.write(fit_plot(report));
  file.commit();
}

}  // namespace

void run_device_fit(Arguments arguments) {
  Options options;
  CommandLine line(kDeviceMakers[1], kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  check_outputs(options);
  const FitReport report = fitted(options);
  if (!options.plot.empty()) write_plot(report, options);
  if (!options.output.empty()) {
    write_device_file(report.display, remarks(report), options.output, options.force);
  }
  if (options.output != "-" && options.plot != "-") {
    print(options.json ? json_line(fit_json(report)) : fit_text(report));
  }
  if (options.max_error && report.largest_ciede2000 > *options.max_error) {
    throw Error(ErrorKind::kGate, options.files[0],
                "the fit misses a row by " + rounded(report.largest_ciede2000, 4) +
                    " CIEDE2000, more than --max-error " + shortest(*options.max_error),
                "write the table: --write table");
  }
}

}  // namespace tristim::tools
