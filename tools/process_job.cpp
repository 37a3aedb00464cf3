#include "tools/process_job.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "tools/cli.h"
#include "tools/process_palette.h"
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

// The name of an output's format; "" where it is exr or unknown.
std::string format_of(const ProcessOptions& options, const std::string& output) {
  if (!options.format.empty()) return options.format;
  if (is_stream(output)) return "png";
  for (const FrameFormat& format : kFrameFormats) {
    for (const std::string_view name : split(format.extensions, ' ')) {
      if (same_name(name, extension_of(output))) return std::string(format.name);
    }
  }
  return "";
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
                                    const PaletteDisplay& palette, const PictureInfo& picture,
                                    int frames = 1) {
  if (is_exr(options, output)) {
    PictureInfo info;
    info.width = picture.width;
    info.height = picture.height;
    info.primaries = palette.display.primaries;
    return decoding_sink(palette.display, open_exr_sink(output, info, {.replace = options.force}));
  }
  FrameInfo info = palette_frame_info(palette, picture.width, picture.height);
  info.frames = frames;
  info.delay_s = options.delay_s;
  const FrameWriteOptions how{.format = format_of(options, output),
                              .replace = options.force,
                              .threads = options.threads,
                              .png_level = options.png_level};
  const std::optional<Press>& press = palette.display.press;
  if (press && is_separated(output, how)) {
    return open_separations(output, info, ink_names(*press), how);
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

bool is_indexed_format(const ProcessOptions& options, const std::string& output) {
  const FrameFormat* format = find_by_name(kFrameFormats, format_of(options, output));
  return format != nullptr && format->indexed;
}

bool is_indexed_only(const ProcessOptions& options, const std::string& output) {
  return same_name(format_of(options, output), "gif");
}

namespace {

// Takes the codes of one picture of several, whose file is finished later.
class PartSink final : public CodeSink {
 public:
  explicit PartSink(CodeSink& file) : file_(&file) {}
  void write(ImageView<const std::uint16_t> rows) override { file_->write(rows); }
  void finish() override {}

 private:
  CodeSink* file_;
};

std::unique_ptr<CodeSink> picture_sink(const ProcessOptions& options, const PaletteDisplay& palette,
                                       const std::string& input, CodeSink& file) {
  if (!palette.transparent) return std::make_unique<PartSink>(file);
  return std::make_unique<TransparentSink>(
      file, *palette.transparent,
      open_coverage(input, palette.display, options.settings, options.threads));
}

// A picture that is ready to go into a file.
struct Prepared {
  PictureInfo file_info;
  std::unique_ptr<RowSource> picture;
};

Prepared prepare_picture(const ProcessOptions& options, const Display& display, Job& job) {
  auto file =
      open_picture(job.input, {.layer = options.settings.layer, .threads = options.threads});
  Prepared prepared{file->info(), nullptr};
  prepared.picture = prepare(std::move(file), display, options.settings, &job.odd);
  const PictureInfo& info = prepared.picture->info();
  job.pixels = static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
  return prepared;
}

// Puts one picture into `file` and its proof into a file of its own; the steps for --explain.
std::vector<StepReport> write_picture(const ProcessOptions& options, const PaletteDisplay& palette,
                                      Prepared& prepared, CodeSink& file, Job& job) {
  const Display& display = palette.display;
  const PictureInfo& info = prepared.picture->info();
  const StageList stages = stage_list(info, display, options.settings);
  Reducer reducer(display, reduce_options(display, options.settings), info.width);
  const auto sink = picture_sink(options, palette, job.input, file);
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
  job.counts = run(*prepared.picture, stages.stages, reducer, *sink, observers,
                   {.threads = options.threads, .band_rows = 0, .dither_mask = mask.get()});
  progress.reset();  // its line is free again
  if (proof_sink) proof_sink->finish();
  if (difference) job.mean_ciede2000 = difference->mean_ciede2000();
  if (!options.explain) return {};
  std::vector<StepReport> steps{read_step(prepared.file_info, job),
                                fit_step(options.settings, prepared.file_info, info)};
  for (const Stage& stage : stages.stages) steps.push_back(tristim::explain(stage));
  if (palette.step) steps.push_back(*palette.step);
  for (StepReport& step : reducer.explain()) steps.push_back(std::move(step));
  steps.push_back(write_step(job, display.frame));
  add_counts(steps, job);
  return steps;
}

void report(const ProcessOptions& options, const Job& job, const Display& display,
            const PictureInfo& info, const std::vector<StepReport>& steps) {
  if (options.json) {
    print(json_line(job_json(options, job, display, info, steps)));
  } else if (options.explain) {
    print(steps_text(steps));
  }
  say_notes(job);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void process_picture(const ProcessOptions& options, const Display& device, Job job) {
  const auto start = std::chrono::steady_clock::now();
  const PaletteDisplay palette =
      choose_palette(options, device, {job.input}, is_indexed_format(options, job.output));
  if (palette.transparent) make_rereadable(job.input);
  Prepared prepared = prepare_picture(options, palette.display, job);
  const PictureInfo info = prepared.picture->info();
  const auto file = open_sink(options, job.output, palette, info);
  const auto steps = write_picture(options, palette, prepared, *file, job);
  file->finish();
  job.seconds = seconds_since(start);
  report(options, job, palette.display, info, steps);
}

void process_animation(const ProcessOptions& options, const Display& device,
                       const std::vector<Job>& jobs) {
  std::vector<std::string> inputs;
  for (const Job& job : jobs) inputs.push_back(job.input);
  const PaletteDisplay palette = choose_palette(options, device, inputs, /*indexed=*/true);
  ProcessOptions all = options;
  std::optional<int>& frame = all.settings.dither_parameters.frame;
  const DitherMethod dither = reduce_options(palette.display, all.settings).dither;
  const auto* matrix = std::get_if<MatrixRecipe>(&dither);
  // What can change with time does so from picture to picture.
  if (matrix != nullptr && matrix->by_frame) frame = frame.value_or(0);
  std::unique_ptr<CodeSink> file;
  for (Job job : jobs) {
    const auto start = std::chrono::steady_clock::now();
    if (palette.transparent) make_rereadable(job.input);
    Prepared prepared = prepare_picture(all, palette.display, job);
    const PictureInfo info = prepared.picture->info();
    if (!file) {
      file = open_sink(all, job.output, palette, info, static_cast<int>(jobs.size()));
      all.settings.width = info.width;
      all.settings.height = info.height;
    }
    const auto steps = write_picture(all, palette, prepared, *file, job);
    if (frame) ++*frame;
    job.seconds = seconds_since(start);
    report(all, job, palette.display, info, steps);
  }
  file->finish();
}

}  // namespace tristim::tools
