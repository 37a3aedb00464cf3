#include <algorithm>
#include <filesystem>

#include "tools/gallery_sheet.h"
#include "tools/halftone.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/read.h"
#include "tristim/image/memory.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/dither_trial.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRampHeight = 24;
constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim halftone gallery spheres.exr -o gallery.png\n"
    "  tristim halftone gallery spheres.exr --device epaper-4grey -o greys.png --csv\n"
    "  tristim halftone gallery spheres.exr --dithers bayer8,atkinson --width 400 -o folder/\n";

struct Options {
  std::vector<std::string> inputs;
  std::string output, device, dithers;
  Settings settings;
  bool json = false, csv = false, force = false;
};

// A method with what it made of the picture.
struct Trial {
  const NamedDither* dither;
  DitheredPicture picture;
  Image ramp;
  DitherFigures figures;
};

struct NamedFigure {
  const char* name;
  double DitherFigures::*value;
};
constexpr NamedFigure kFigures[] = {{"tone_max", &DitherFigures::tone_lstar},
                                    {"hvs_snr@40", &DitherFigures::hvs_snr_db},
                                    {"scielab_mean@40", &DitherFigures::scielab_mean}};

std::vector<const NamedDither*> chosen_dithers(const std::string& names, const Display& display) {
  std::vector<const NamedDither*> chosen;
  if (names.empty()) {
    for (const NamedDither& dither : dither_methods()) {
      if (takes_dither(display, dither.method)) chosen.push_back(&dither);
    }
    return chosen;
  }
  for (const std::string_view name : split(names, ',')) {
    const NamedDither* found = find_by_name(dither_methods(), name);
    if (found == nullptr) {
      throw Error(ErrorKind::kMisuse, "--dithers", "unknown dither '" + std::string(name) + "'",
                  name_hint(dither_methods(), name));
    }
    chosen.push_back(found);
  }
  return chosen;
}

// The picture as the device is asked for it: light in its primaries, [0, 1].
Image asked_light(const Options& options, const Display& display) {
  OddValues odd;
  const auto source = prepare(open_picture(options.inputs[0]), display, options.settings, &odd);
  const PictureInfo& info = source->info();
  Image light(info.width, info.height, 3);
  source->read(light.view());
  StageCounts counts;
  for (const Stage& stage : stage_list(info, display, options.settings).stages) {
    apply(stage, {light.view(), 0}, counts);
  }
  for (int y = 0; y < info.height; ++y) {
    for (float& sample : light.view().row(y)) sample = std::clamp(sample, 0.0F, 1.0F);
  }
  return light;
}

std::vector<Trial> try_all(const std::vector<const NamedDither*>& dithers,
                           ImageView<const float> light, const Display& display) {
  const Image ramp = grey_ramp(light.width, kRampHeight);
  std::vector<Trial> trials;
  for (const NamedDither* dither : dithers) {
    const DitherTrial trial{display, *dither};
    DitheredPicture picture = dither_picture(light, trial);
    const DitherFigures figures = judge_dither(light, picture, trial);
    trials.push_back(
        {dither, std::move(picture), dither_picture(ramp.view(), trial).light, figures});
  }
  return trials;
}

Json json_of(const std::vector<Trial>& trials, const Display& display) {
  Json list = Json::array();
  for (const Trial& trial : trials) {
    Json one{{"dither", trial.dither->name}, {"source", trial.dither->source}};
    for (const NamedFigure& f : kFigures) {
      one[f.name] = parse_number(rounded(trial.figures.*f.value, 6)).value_or(0);
    }
    list.push_back(std::move(one));
  }
  return {{"device", display.name}, {"dithers", list}};
}

std::string csv_of(const std::vector<Trial>& trials) {
  std::string text = "dither";
  for (const NamedFigure& f : kFigures) text += std::string(",") + f.name;
  text += "\n";
  for (const Trial& trial : trials) {
    text += trial.dither->name;
    for (const NamedFigure& f : kFigures) text += "," + rounded(trial.figures.*f.value, 6);
    text += "\n";
  }
  return text;
}

std::string table_of(const std::vector<Trial>& trials) {
  constexpr std::size_t kNameWidth = 24;
  constexpr std::size_t kWidth = 17;
  std::string text(kNameWidth, ' ');
  const auto cell = [&text](std::string word, std::size_t width) {
    word.resize(std::max(word.size() + 1, width), ' ');
    text += word;
  };
  for (const NamedFigure& f : kFigures) cell(f.name, kWidth);
  text += "\n";
  for (const Trial& trial : trials) {
    cell(trial.dither->name, kNameWidth);
    for (const NamedFigure& f : kFigures) cell(rounded(trial.figures.*f.value, 4), kWidth);
    text += "\n";
  }
  return text;
}

GalleryCell cell_of(Trial trial) {
  const DitherFigures& f = trial.figures;
  return {trial.dither->name,
          {"tone " + rounded(f.tone_lstar, 2) + "  HVS " + rounded(f.hvs_snr_db, 4) +
           " dB  S-CIELAB " + rounded(f.scielab_mean, 3)},
          std::move(trial.picture.light),
          std::move(trial.ramp)};
}

void write_codes(const std::string& path, const FrameInfo& info,
                 ImageView<const std::uint16_t> codes, bool replace) {
  const auto sink = open_code_sink(path, info, {.format = "png", .replace = replace});
  sink->write(codes);
  sink->finish();
}

void write_sheet(const Options& options, std::vector<Trial> trials, ImageView<const float> light,
                 const Display& display) {
  std::vector<GalleryCell> cells;
  cells.push_back({"as asked for",
                   {display.name},
                   shown_light(light, display),
                   shown_light(grey_ramp(light.width, kRampHeight).view(), display)});
  for (Trial& trial : trials) cells.push_back(cell_of(std::move(trial)));
  const Raster<std::uint16_t> sheet = gallery_sheet(cells);
  const ImageView<const std::uint16_t> view = sheet.view();
  write_codes(options.output, frame_info(Display{}, view.width, view.height), view, options.force);
}

bool is_folder(const std::string& output) {
  std::error_code ignored;
  return output.ends_with('/') || std::filesystem::is_directory(output, ignored);
}

// The names of the results in the folder, which is made.
std::vector<std::string> names_in(const std::string& folder,
                                  const std::vector<const NamedDither*>& dithers) {
  std::vector<std::string> names;
  for (const NamedDither* dither : dithers) {
    names.push_back((std::filesystem::path(folder) / (dither->name + ".png")).string());
  }
  return names;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorKind::kSystem, folder, system_message(error.value()));
}

void check(const Options& options) {
  if (options.output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing",
                "give -o gallery.png, or a folder for a picture each");
  }
  const std::string extension = std::filesystem::path(options.output).extension().string();
  if (!is_folder(options.output) && !same_name(extension, ".png")) {
    throw Error(ErrorKind::kMisuse, options.output, "does not end in .png or /",
                "the sheet is a PNG; name a folder for a picture each");
  }
  refuse_missing_inputs(options.inputs);
  std::error_code ignored;
  const std::string name = options.output.substr(0, options.output.find_last_not_of('/') + 1);
  if (options.output.ends_with('/') && std::filesystem::is_regular_file(name, ignored)) {
    throw Error(ErrorKind::kSystem, options.output, "is a file, not a folder",
                "choose another name");
  }
}

void gallery(const Options& options) {
  check(options);
  const Display display = options.device.empty() ? one_bit_display() : load_display(options.device);
  const std::vector<const NamedDither*> dithers = chosen_dithers(options.dithers, display);
  const bool folder = is_folder(options.output);
  const std::vector<std::string> outputs =
      folder ? names_in(options.output, dithers) : std::vector<std::string>{options.output};
  refuse_inputs_as_outputs(options.inputs, outputs);
  refuse_taken_outputs(outputs, options.force);
  if (display.frame.packing.indexed && display.palette.empty()) {
    throw Error(ErrorKind::kMisuse, "--device", display.name + " has no palette of its own",
                "give a device with one");
  }
  const Image light = asked_light(options, display);
  std::vector<Trial> trials = try_all(dithers, light.view(), display);
  const std::string text = options.json  ? json_line(json_of(trials, display))
                           : options.csv ? csv_of(trials)
                                         : table_of(trials);
  if (folder) {
    make_folder(options.output);
    const FrameInfo info = frame_info(display, light.view().width, light.view().height);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      write_codes(outputs[i], info, trials[i].picture.codes.view(), options.force);
    }
  } else {
    write_sheet(options, std::move(trials), light.view(), display);
  }
  print(text);
}

}  // namespace

void run_halftone_gallery(Arguments arguments) {
  Options options;
  options.settings.width = 256;
  CommandLine line(*halftone_job("gallery"), kExamples);
  line.positional("IN", "the picture; - is standard input", options.inputs, 1, 1);
  line.option("-o,--output", "OUT", "the sheet, a PNG; or a folder/ for a PNG of each method",
              options.output);
  line.option("-d,--device", "D", "to dither for; default: one bit, black and white",
              options.device);
  line.option("--dithers", "NAME,...", "methods to try; default: all that the device takes",
              options.dithers);
  line.option("--width", "N", "of the picture on the sheet; default: 256",
              [&options](const std::string& v) {
                options.settings.width = integer_option("--width", v, 16, 4096);
              });
  line.option("--exposure", "STOPS", "of the picture; default: 0",
              [&options](const std::string& v) {
                options.settings.exposure_stops = number_option("--exposure", v, -100, 100);
              });
  line.flag("--json", "print the figures as JSON", options.json);
  line.flag("--csv", "print the figures as CSV", options.csv);
  line.flag("-f,--force", "replace existing files", options.force);
  if (!line.parse(arguments)) return;
  gallery(options);
}

}  // namespace tristim::tools
