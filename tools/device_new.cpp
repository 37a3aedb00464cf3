#include <unistd.h>

#include <cstdio>
#include <functional>

#include "tools/device_actions.h"
#include "tools/device_options.h"
#include "tools/measured_input.h"
#include "tools/outputs.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim device new --name 'My CRT' --packing rgb888 --response gamma --gamma 2.35 --levels "
    "255 --i0 0.01 -o crt.toml\n"
    "  tristim device new --name 'LED strip' --packing rgb888 --response linear --red 0.69,0.31 "
    "--green 0.17,0.70 --blue 0.14,0.06 --white 0.28,0.29\n"
    "  tristim device new --like lcd-rgb565 --name 'TFT 2.4' --size 320x240 -o tft.toml && tristim "
    "device check tft.toml\n"
    "  tristim device new --name 'E-paper' --packing gray2 --response srgb --size 800x480\n";

constexpr std::string_view kResponseKinds[] = {"srgb", "linear", "gamma", "bt1886", "gog", "table"};

struct Kind {
  std::string_view name;
};

std::vector<Kind> response_kinds() {
  std::vector<Kind> kinds;
  for (const std::string_view name : kResponseKinds) kinds.push_back({name});
  return kinds;
}

struct Options {
  DeviceOptions device;
  std::string like, output;
  std::string response;
  std::vector<std::string> measured;
  double gamma = 2.2, black = 0, offset = 0;
  std::optional<double> i0;
  std::optional<int> levels;
  const LevelSpacing* spacing = nullptr;
  std::optional<Store> store;
  bool monotone = false, force = false;
};

std::string response_option(const std::string& name) {
  const std::vector<Kind> kinds = response_kinds();
  const Kind* kind = find_by_name(kinds, name);
  if (kind != nullptr) return std::string(kind->name);
  throw Error(ErrorKind::kMisuse, "--response", "unknown response '" + name + "'",
              name_hint(kinds, name));
}

double gamma_option(const std::string& text) { return number_option("--gamma", text, 0.01, 100); }

void declare_response(CommandLine& line, Options& o) {
  constexpr double kOpen = 1e-12;
  line.section("Response");
  line.option("--response", list_names(response_kinds(), "|"), "of light to codes; default: srgb",
              [&](const std::string& v) { o.response = response_option(v); });
  line.option("--gamma", "G", "exponent of gamma and gog; default: 2.2",
              [&](const std::string& v) { o.gamma = gamma_option(v); });
  line.option("--black", "B", "light of code 0 relative to the white, of gamma, bt1886, gog",
              [&](const std::string& v) {
                o.black =
                    number_option("--black", v, 0, 1 - kOpen, "from 0 up to, not including, 1");
              });
  line.option("--offset", "O", "of gog, between -1 and 1; default: 0", [&](const std::string& v) {
    o.offset = number_option("--offset", v, kOpen - 1, 1 - kOpen, "between -1 and 1");
  });
  line.option("--measured", "FILE", "CSV of code and luminance, of table",
              [&](const std::string& v) {
                for (const std::string_view part : split(v, ',')) o.measured.emplace_back(part);
              });
  line.flag("--monotone", "level out measured luminances that fall", o.monotone);
  line.section("Intensity levels");
  line.option("--levels", "N", "codes are levels 0 to N",
              [&](const std::string& v) { o.levels = integer_option("--levels", v, 1, 65535); });
  line.option("--i0", "I", "lowest intensity, between 0 and 1; default: 0.02",
              [&](const std::string& v) {
                o.i0 = number_option("--i0", v, kOpen, 1 - kOpen, "between 0 and 1");
              });
  line.option("--spacing", list_names(level_spacings(), "|"), "default: ratio",
              [&](const std::string& v) {
                o.spacing = find_by_name(level_spacings(), v);
                if (o.spacing == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--spacing", "unknown spacing '" + v + "'",
                              name_hint(level_spacings(), v));
                }
              });
  line.option("--store", list_names(kStores, "|"), "what the frame buffer holds; default: value",
              [&](const std::string& v) {
                const NamedStore* store = find_by_name(kStores, v);
                if (store == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--store", "unknown arrangement '" + v + "'",
                              name_hint(kStores, v));
                }
                o.store = store->store;
              });
}

// A line of the terminal; empty at its end.
std::string answer(const std::string& question, const std::string& fallback) {
  std::fprintf(stderr, "%s [%s]: ", question.c_str(), fallback.c_str());
  std::string text;
  for (int c = std::getchar(); c != EOF && c != '\n'; c = std::getchar()) {
    text += static_cast<char>(c);
  }
  return text.empty() ? fallback : text;
}

// Asks until `take` accepts the answer; at the end of the input it is the caller's mistake.
void ask(const std::string& question, const std::string& fallback,
         const std::function<void(const std::string&)>& take) {
  while (true) {
    try {
      return take(answer(question, fallback));
    } catch (const Error& error) {
      if (std::feof(stdin) != 0) throw;
      std::fprintf(stderr, "  %s\n", error.what());
    }
  }
}

void ask_for_missing(Options& o) {
  if (!o.device.name) {
    ask("name of the device", "my display", [&](const std::string& v) { o.device.name = v; });
  }
  if (!o.device.packing) {
    ask("packing of its codes (" + list_names(kPackings) + ")", "rgb888",
        [&](const std::string& v) { o.device.packing = packing_option(v); });
  }
  const DeviceOptions& d = o.device;
  if (!d.set && !d.red && !d.green && !d.blue && o.device.packing->samples == 3) {
    ask("set of primaries (srgb, display-p3, bt2020, ...)", "srgb",
        [&](const std::string& v) { o.device.set = primaries_option(v); });
  }
  if (!o.response.empty() || !o.measured.empty()) return;
  ask("response (" + list_names(response_kinds()) + ")", "gamma",
      [&](const std::string& v) { o.response = response_option(v); });
  if (o.response == "gamma" || o.response == "gog") {
    ask("gamma", "2.2", [&](const std::string& v) { o.gamma = gamma_option(v); });
  }
  if (o.response == "table") {
    ask("file of measured luminances", "measured.csv",
        [&](const std::string& v) { o.measured = {v}; });
  }
}

void take_response(const Options& o, Display& display) {
  if (o.response.empty() && o.measured.empty()) return;
  if (o.response == "linear") display.response = LinearResponse{};
  if (o.response == "srgb") display.response = SrgbResponse{};
  if (o.response == "gamma") display.response = GammaResponse{.gamma = o.gamma, .i0 = o.black};
  if (o.response == "bt1886") display.response = Bt1886Response{o.black};
  if (o.response == "gog") display.response = GogResponse{o.gamma, o.offset, o.black};
  display.channel_response = {};
  if (o.measured.empty()) return;
  const std::vector<TableResponse> tables = read_measured(o.measured, o.monotone);
  display.response = tables[0];
  for (std::size_t c = 0; c < 3 && tables.size() == 3; ++c) display.channel_response[c] = tables[c];
}

void take_levels(const Options& o, Display& display) {
  if (o.levels && !display.levels) display.levels = LevelTable{};
  if (!display.levels && (o.i0 || o.spacing != nullptr)) {
    throw Error(ErrorKind::kMisuse, o.i0 ? "--i0" : "--spacing", "needs levels", "add --levels N");
  }
  if (o.levels) display.levels->n = *o.levels;
  if (o.i0) display.levels->i0 = *o.i0;
  if (o.spacing != nullptr) display.levels->spacing = o.spacing;
  if (o.store) display.frame.store = *o.store;
}

void check_together(const Options& o) {
  const auto misuse = [](const std::string& option, const std::string& wrong,
                         const std::string& remedy) {
    throw Error(ErrorKind::kMisuse, option, wrong, remedy);
  };
  if (!o.device.name && o.like.empty()) misuse("--name", "is missing", "give --name NAME");
  if (!o.measured.empty() && !o.response.empty() && o.response != "table") {
    misuse("--measured", "does not go with --response " + o.response, "give one of them");
  }
  if (o.response == "table" && o.measured.empty()) {
    misuse("--response", "table has no figures", "add --measured FILE.csv");
  }
}

}  // namespace

void run_device_new(Arguments arguments) {
  Options options;
  CommandLine line(kDeviceMakers[0], kExamples);
  line.option("-o,--output", "OUT.toml", "the device file; default: standard output",
              options.output);
  line.option("--like", "D", "a device to start from: a name of `tristim device list`, or a file",
              options.like);
  line.flag("-f,--force", "replace an existing file", options.force);
  declare_device_options(line, options.device);
  declare_response(line, options);
  if (!line.parse(arguments)) return;
  if (!options.output.empty()) refuse_taken_outputs({options.output}, options.force);
  if (isatty(STDIN_FILENO) != 0 && options.like.empty()) ask_for_missing(options);
  check_together(options);
  Display display;
  if (!options.like.empty()) display = load_display(options.like);
  apply_device_options(options.device, display);
  take_response(options, display);
  take_levels(options, display);
  const std::string output = options.output.empty() ? "-" : options.output;
  write_device_file(display,
                    "A device file of tristim; `tristim device show` tells what follows from it.",
                    output, options.force);
}

}  // namespace tristim::tools
