#include "tools/levels_options.h"

#include <algorithm>

#include "tools/measured_input.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"

namespace tristim::tools {
namespace {

[[noreturn]] void misuse(const std::string& option, const std::string& wrong,
                         const std::string& remedy) {
  throw Error(ErrorKind::kMisuse, option, wrong, remedy);
}

struct NamedResponse {
  std::string_view name;
  Response (*make)(double gamma, double k, double black);
};

// What --response names; `black` is that of --lw and --lb, which the device shows at code 0.
constexpr NamedResponse kResponses[] = {
    {"gamma",
     [](double gamma, double k, double black) {
       return Response(GammaResponse{.gamma = gamma, .i0 = black, .k = k});
     }},
    {"linear", [](double, double, double) { return Response(LinearResponse{}); }},
    {"srgb", [](double, double, double) { return Response(SrgbResponse{}); }},
    {"bt1886",
     [](double, double, double black) { return Response(Bt1886Response{.black = black}); }}};

template <typename List>
auto named(const List& list, const std::string& option, const std::string& what,
           const std::string& name) {
  const auto* item = find_by_name(list, name);
  if (item == nullptr) misuse(option, "unknown " + what + " '" + name + "'", name_hint(list, name));
  return item;
}

std::vector<double> numbers_option(const std::string& option, const std::string& list, double least,
                                   double most) {
  std::vector<double> numbers;
  for (const std::string_view part : split(list, ',')) {
    numbers.push_back(number_option(option, part, least, most));
  }
  if (numbers.size() != 1 && numbers.size() != 3) {
    misuse(option, "gives " + std::to_string(numbers.size()) + " numbers",
           "give one, or three for red, green and blue");
  }
  return numbers;
}

void declare_spacing(CommandLine& line, LevelsOptions& options) {
  constexpr double kOpen = 1e-12;
  line.section("Levels");
  line.option("--n", "N", "highest level: N + 1 levels; default: 255",
              [&](const std::string& v) { options.n = integer_option("--n", v, 1, 65535); });
  line.option("--i0", "I",
              "lowest intensity, between 0 and 1; default: the measured black over the white, else "
              "0.02",
              [&](const std::string& v) {
                options.i0 = number_option("--i0", v, kOpen, 1 - kOpen, "between 0 and 1");
              });
  line.option("--spacing", list_names(level_spacings(), "|"), "of the levels; default: ratio",
              [&](const std::string& v) {
                options.spacing = named(level_spacings(), "--spacing", "spacing", v);
              });
  line.flag("--from-zero", "level 0 is no light at all; not for ratio", options.from_zero);
  line.option("--peak", "CD", "luminance of intensity 1 for pq, cd/m2; default: 10000",
              [&](const std::string& v) {
                options.peak = number_option("--peak", v, kOpen, 1e6, "above 0, up to 1000000");
              });
  line.flag("--dimming",
            "equal steps of L* from no light on, for a light proportional to the code: --spacing "
            "lstar --from-zero --response linear",
            options.dimming);
}

void declare_device(CommandLine& line, LevelsOptions& options) {
  line.section("Device");
  line.option(
      "--gamma", "G[,G,G]",
      "exponent of the device (and of the spacing gamma), of red, green and blue where "
      "three are given; default: 2.2",
      [&](const std::string& v) { options.gamma = numbers_option("--gamma", v, 0.01, 100); });
  line.option(
      "--k", "K", "factor of I = K V^gamma; default: Vmax^-gamma",
      [&](const std::string& v) { options.k = number_option("--k", v, 1e-300, 1e300, "above 0"); });
  line.option("--vmax", "V", "highest code; default: 255",
              [&](const std::string& v) { options.vmax = integer_option("--vmax", v, 1, 65535); });
  line.option("--response", list_names(kResponses, "|"), "of light to codes; default: gamma",
              [&](const std::string& v) {
                options.response = named(kResponses, "--response", "response", v)->name;
              });
  line.option("--measured", "FILE[,FILE,FILE]",
              "measured response: CSV of code and luminance, or of code, red, green and blue",
              [&](const std::string& v) {
                for (const std::string_view part : split(v, ',')) {
                  options.measured.emplace_back(part);
                }
              });
  line.flag("--monotone", "level out measured luminances that fall", options.monotone);
  line.option("--lw", "CD", "measured luminance of the white, cd/m2", [&](const std::string& v) {
    options.white = number_option("--lw", v, 1e-9, 1e9, "above 0");
  });
  line.option("--lb", "CD", "measured luminance of the black, cd/m2: I0 is Lb/Lw",
              [&](const std::string& v) { options.black = number_option("--lb", v, 0, 1e9); });
  line.option("--device", "D", "response, highest code and levels of a device", options.device);
}

void declare_tables(CommandLine& line, LevelsOptions& options) {
  line.section("Tables");
  line.option("--store", list_names(kStores, "|"),
              "V_j in the frame buffer, or j there and V_j in the colour table; default: value",
              [&](const std::string& v) {
                options.store = named(kStores, "--store", "arrangement", v)->store;
              });
  line.flag("--dead-reckoned", "every code above the one before it, where there are codes enough",
            options.dead_reckoned);
  line.option(
      "--temporal", "BITS", "show each level by neighbouring codes over 2^BITS frames, 1 to 8",
      [&](const std::string& v) { options.temporal_bits = integer_option("--temporal", v, 1, 8); });
}

std::vector<Response> named_responses(const LevelsOptions& options, double black) {
  const std::vector<double> gammas =
      options.gamma.empty() ? std::vector<double>{GammaResponse{}.gamma} : options.gamma;
  const std::string name = options.dimming && options.response.empty() ? "linear"
                           : options.response.empty()                  ? "gamma"
                                                                       : options.response;
  std::vector<Response> responses;
  for (const double gamma : gammas) {
    responses.push_back(find_by_name(kResponses, name)->make(gamma, options.k.value_or(0), black));
  }
  return responses;
}

double most_code(const std::vector<TableResponse>& tables) {
  double most = 1;
  for (const TableResponse& table : tables) most = std::max(most, table.code.back());
  return most;
}

// The least 2^b - 1 that holds every code of a measurement.
int measured_vmax(const std::vector<TableResponse>& tables) {
  const double most = most_code(tables);
  if (most > 65535) misuse("--measured", "has codes above 65535", "give codes of 16 bits at most");
  int vmax = 1;
  while (vmax < most) vmax = 2 * vmax + 1;
  return vmax;
}

void take_measured(const LevelsOptions& options, LevelsJob& job) {
  const std::vector<TableResponse> tables = read_measured(options.measured, options.monotone);
  const int needed = measured_vmax(tables);
  const int vmax = options.vmax.value_or(needed);
  if (vmax < needed && vmax < most_code(tables)) {
    misuse("--vmax", std::to_string(vmax) + " is below the highest measured code",
           "give " + std::to_string(needed));
  }
  for (const TableResponse& table : tables) job.drives.push_back({table, vmax});
  const TableResponse& first = tables[0];
  const double black = first.luminance.front() / first.luminance.back();
  if (black > 0) job.table.i0 = black;
  job.table.measured = first;
}

void take_device(const LevelsOptions& options, LevelsJob& job) {
  const Display display = load_display(options.device);
  const Packing& packing = display.frame.packing;
  if (packing.indexed || !display.palette.empty()) {
    misuse("--device", "has a palette, not levels", "name a device whose codes are levels");
  }
  const bool alike = has_one_response(display) && packing.bits[0] == packing.bits[1];
  for (int c = 0; c < (alike ? 1 : packing.samples); ++c) {
    const int highest = (1 << packing.bits[static_cast<std::size_t>(c)]) - 1;
    job.drives.push_back({response_of(display, c), options.vmax.value_or(highest)});
  }
  if (display.levels) job.table = *display.levels;
  job.table.n = display.levels ? display.levels->n : most_code(job);
  job.store = display.frame.store;
}

void take_black(const LevelsOptions& options, LevelsJob& job) {
  if (options.black.has_value() != options.white.has_value()) {
    misuse(options.black ? "--lb" : "--lw", "stands alone", "give both --lw and --lb");
  }
  if (!options.black) return;
  job.bt1886 = bt1886_constants(*options.white, *options.black);
  if (*options.black > 0) {
    job.table.i0 = *options.black / *options.white;
  } else {
    job.table.from_zero = true;
  }
}

void check_together(const LevelsOptions& options) {
  const bool formula =
      !options.gamma.empty() || options.k || !options.response.empty() || options.black;
  if (!options.measured.empty() && !options.device.empty()) {
    misuse("--measured", "does not go with --device", "give one of them");
  }
  const bool spacing_gamma = options.spacing != nullptr && options.spacing->name == "gamma" &&
                             !options.k && options.response.empty() && !options.black;
  if (formula && !spacing_gamma && !(options.measured.empty() && options.device.empty())) {
    misuse(options.measured.empty() ? "--device" : "--measured",
           "does not go with --gamma, --k, --response, --lw and --lb", "give one response");
  }
  if (options.monotone && options.measured.empty()) {
    misuse("--monotone", "needs a measurement", "add --measured");
  }
  if (options.dimming && (options.spacing != nullptr || options.i0)) {
    misuse("--dimming", "does not go with --spacing and --i0",
           "give --spacing and --from-zero instead");
  }
  if (options.from_zero && options.i0) {
    misuse("--from-zero", "does not go with --i0", "give one of them");
  }
}

}  // namespace

void declare_levels(CommandLine& line, LevelsOptions& options) {
  declare_spacing(line, options);
  declare_device(line, options);
  declare_tables(line, options);
}

LevelsJob levels_job(const LevelsOptions& options) {
  check_together(options);
  LevelsJob job;
  job.table.spacing = &level_spacings().front();
  if (!options.device.empty()) {
    take_device(options, job);
  } else if (!options.measured.empty()) {
    take_measured(options, job);
  } else {
    take_black(options, job);
    const double black = options.black ? *options.black / *options.white : 0;
    for (const Response& response : named_responses(options, black)) {
      job.drives.push_back({response, options.vmax.value_or(DriveChannel{}.vmax)});
    }
  }
  job.table.n = options.n.value_or(job.table.n);
  job.table.i0 = options.i0.value_or(job.table.i0);
  job.table.peak_cd_m2 = options.peak.value_or(job.table.peak_cd_m2);
  if (!options.gamma.empty()) job.table.gamma = options.gamma[0];
  if (options.spacing != nullptr) job.table.spacing = options.spacing;
  if (options.dimming) job.table.spacing = find_by_name(level_spacings(), "lstar");
  job.table.from_zero = job.table.from_zero || options.from_zero || options.dimming;
  job.store = options.store.value_or(job.store);
  job.dead_reckoned = options.dead_reckoned;
  job.temporal_bits = options.temporal_bits;
  return job;
}

}  // namespace tristim::tools
