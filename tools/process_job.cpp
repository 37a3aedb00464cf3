#include "tools/process_job.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "tools/cli.h"
#include "tools/process_report.h"
#include "tools/progress.h"
#include "tools/report.h"
#include "tools/spool.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/frame/io/separations.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/exr.h"
#include "tristim/image/io/read.h"
#include "tristim/palette/mixing.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/proof.h"

namespace tristim::tools {
namespace {

std::string extension_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? extension : extension.substr(1);
}

bool is_exr(const ProcessOptions& options, const std::string& output) {
  return same_name(options.format.empty() ? extension_of(output) : options.format, "exr");
}

// What is no file, such as standard output and a pipe with a name, has no extension.
bool is_stream(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return path == "-" ||
         (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status));
}

// The palette to choose for the picture; nothing where the device's own codes serve.
std::optional<PaletteChoice> palette_to_choose(const Display& display, const Settings& settings) {
  if (settings.palette.method != nullptr) return settings.palette;
  const bool has_codes = !display.palette.empty() || !display.frame.packing.indexed;
  if (has_codes) return std::nullopt;
  constexpr const PaletteMethod& kUsual = kPaletteMethods[0];
  static_assert(kUsual.name == "best");
  return PaletteChoice{&kUsual, 0};
}

Display with_chosen_palette(const Display& display, const PaletteChoice& choice,
                            const ProcessOptions& options, const std::string& input) {
  const int colors = palette_colors(display, choice);
  PaletteOptions wanted{.colors = colors, .metric = options.settings.metric, .bits = choice.bits};
  if (!choice.inks.empty()) wanted.inks = choice.inks;
  if (!choice.method->needs_histogram) {
    return with_palette(display, build_palette({}, *choice.method, wanted));
  }
  make_rereadable(input);
  const auto picture =
      prepare(open_picture(input, {.layer = options.settings.layer, .threads = options.threads}),
              display, options.settings, nullptr);
  const StageList stages = stage_list(picture->info(), display, options.settings);
  const Histogram counted = histogram(*picture, stages, display, {.threads = options.threads},
                                      options.settings.palette_weights);
  std::vector<Color8> palette = build_palette(counted, *choice.method, wanted);
  const bool dithered = !std::holds_alternative<NoDither>(
      reduce_options(with_palette(display, palette), options.settings).dither);
  const bool free = choice.method->name == "best";  // the others are what their sources say
  if (dithered && free) palette = refine_for_mixing(counted, std::move(palette));
  return with_palette(display, palette);
}

// The strength of the dither, turned and fitted as the picture is; null where none was asked for.
std::unique_ptr<RowSource> open_dither_mask(const ProcessOptions& options, const Display& display,
                                            const PictureInfo& picture) {
  if (options.settings.dither_mask.empty()) return nullptr;
  auto mask = prepare(open_picture(options.settings.dither_mask, {.threads = options.threads}),
                      display, options.settings, nullptr);
  const PictureInfo& info = mask->info();
  if (info.width != picture.width || info.height != picture.height) {
    throw Error(ErrorKind::kContent, options.settings.dither_mask,
                "is " + std::to_string(info.width) + "x" + std::to_string(info.height) +
                    " where the picture is " + std::to_string(picture.width) + "x" +
                    std::to_string(picture.height),
                "give a mask of the picture's size, or --size");
  }
  return mask;
}

std::vector<std::string> ink_names(const Press& press) {
  std::vector<std::string> names;
  for (const Ink& ink : press.inks) names.push_back(ink.name);
  return names;
}

std::unique_ptr<CodeSink> open_sink(const ProcessOptions& options, const std::string& output,
                                    const Display& display, const PictureInfo& picture) {
  if (is_exr(options, output)) {
    PictureInfo info;
    info.width = picture.width;
    info.height = picture.height;
    info.primaries = display.primaries;
    return decoding_sink(display, open_exr_sink(output, info, {.replace = options.force}));
  }
  const bool unnamed = options.format.empty() && is_stream(output);
  const FrameWriteOptions how{.format = unnamed ? "png" : options.format,
                              .replace = options.force,
                              .threads = options.threads,
                              .png_level = options.png_level};
  const FrameInfo info = frame_info(display, picture.width, picture.height);
  if (display.press && is_separated(output, how)) {
    return open_separations(output, info, ink_names(*display.press), how);
  }
  return open_code_sink(output, info, how);
}

std::unique_ptr<CodeSink> open_proof(const ProcessOptions& options, const std::string& path,
                                     const PictureInfo& picture) {
  return open_code_sink(path, frame_info(Display{}, picture.width, picture.height),
                        {.format = "png",
                         .replace = options.force,
                         .threads = options.threads,
                         .png_level = options.png_level});
}

struct FormatName {
  std::string_view name;
};

void check_format_name(const std::string& name) {
  std::vector<FormatName> known;
  for (const FrameFormat& format : kFrameFormats) known.push_back({format.name});
  known.push_back({"exr"});
  if (find_by_name(known, name) != nullptr) return;
  throw Error(ErrorKind::kMisuse, "--format", "unknown format '" + name + "'",
              name_hint(known, name));
}

}  // namespace

std::vector<std::string> output_files(const ProcessOptions& options, const Display& device,
                                      const std::string& output) {
  if (!device.press || !is_separated(output, {.format = options.format})) return {output};
  return separation_paths(output, ink_names(*device.press));
}

void check_format(const ProcessOptions& options, const std::string& output) {
  if (!options.format.empty()) return check_format_name(options.format);
  const std::string extension = extension_of(output);
  if (is_stream(output) || same_name(extension, "exr")) return;
  std::string known;
  for (const FrameFormat& format : kFrameFormats) {
    for (const std::string_view name : split(format.extensions, ' ')) {
      if (same_name(name, extension)) return;
    }
    known += std::string(format.extensions) + " ";
  }
  throw Error(ErrorKind::kMisuse, output,
              extension.empty() ? "has no extension that tells the format"
                                : "unknown extension '" + extension + "'",
              "use one of: " + known + "exr");
}

void check_proof_format(const std::string& proof) {
  if (is_stream(proof) || same_name(extension_of(proof), "png")) return;
  const std::string name = std::filesystem::path(proof).replace_extension("png").string();
  throw Error(ErrorKind::kMisuse, "--proof", "'" + proof + "' does not end in .png",
              "proofs are PNG: give " + name);
}

void process_picture(const ProcessOptions& options, const Display& device, Job job) {
  const auto start = std::chrono::steady_clock::now();
  const auto choice = palette_to_choose(device, options.settings);
  const Display display =
      choice ? with_chosen_palette(device, *choice, options, job.input) : device;

  auto file =
      open_picture(job.input, {.layer = options.settings.layer, .threads = options.threads});
  const PictureInfo file_info = file->info();
  const auto picture = prepare(std::move(file), display, options.settings, &job.odd);
  const PictureInfo& info = picture->info();
  job.pixels = static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
  const StageList stages = stage_list(info, display, options.settings);
  Reducer reducer(display, reduce_options(display, options.settings), info.width);

  const auto sink = open_sink(options, job.output, display, info);
  std::unique_ptr<CodeSink> proof_sink;
  std::optional<ProofObserver> proof;
  std::optional<DifferenceObserver> difference;
  const auto mask = open_dither_mask(options, display, info);
  std::optional<Progress> progress(std::in_place, job.input, info.height);
  std::vector<BandObserver*> observers{&*progress};
  if (!job.proof.empty()) {
    proof_sink = open_proof(options, job.proof, info);
    observers.push_back(&proof.emplace(display, *proof_sink));
    observers.push_back(&difference.emplace(info.primaries, options.settings.adaptation, display,
                                            stages.scene_stages));
  }
  job.counts = run(*picture, stages.stages, reducer, *sink, observers,
                   {.threads = options.threads, .band_rows = 0, .dither_mask = mask.get()});
  progress.reset();  // its line is free again
  sink->finish();
  if (proof_sink) proof_sink->finish();
  if (difference) job.mean_ciede2000 = difference->mean_ciede2000();
  job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::vector<StepReport> steps;
  if (options.explain) {
    steps = {read_step(file_info, job), fit_step(options.settings, file_info, info)};
    for (const Stage& stage : stages.stages) steps.push_back(tristim::explain(stage));
    if (choice) steps.push_back(palette_step(*choice, palette_colors(device, *choice)));
    for (StepReport& step : reducer.explain()) steps.push_back(std::move(step));
    steps.push_back(write_step(job, display.frame));
    add_counts(steps, job);
  }
  if (options.json) {
    print(json_line(job_json(options, job, display, info, steps)));
  } else if (options.explain) {
    print(steps_text(steps));
  }
  say_notes(job);
}

}  // namespace tristim::tools
