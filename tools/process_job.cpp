#include "tools/process_job.h"

#include <chrono>
#include <optional>
#include <utility>
#include <variant>

#include "tools/process_output.h"
#include "tools/process_palette.h"
#include "tools/process_report.h"
#include "tools/progress.h"
#include "tools/spool.h"
#include "tristim/core/error.h"
#include "tristim/image/io/read.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/proof.h"

namespace tristim::tools {
namespace {

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
                                      Prepared& prepared, CodeSink& file, Job& job,
                                      const MakeWatcher& make_watcher) {
  const Display& display = palette.display;
  const PictureInfo& info = prepared.picture->info();
  const StageList stages = stage_list(info, display, options.settings);
  const ReduceOptions reduced = reduce_options(display, options.settings);
  Reducer reducer(display, reduced, info.width);
  const auto sink = picture_sink(options, palette, job.input, file);
  std::unique_ptr<CodeSink> proof_sink;
  std::optional<ProofObserver> proof;
  std::optional<DifferenceObserver> difference;
  const auto mask = open_dither_mask(options, display, info);
  std::unique_ptr<BandObserver> watcher = make_watcher(job.input, info.height);
  std::vector<BandObserver*> observers{watcher.get()};
  if (!job.proof.empty()) {
    proof_sink = open_proof(options, job.proof, info);
    observers.push_back(&proof.emplace(display, *proof_sink, seen_dots(display, reduced)));
    observers.push_back(&difference.emplace(info.primaries, options.settings.adaptation, display,
                                            stages.scene_stages));
  }
  job.counts = run(*prepared.picture, stages.stages, reducer, *sink, observers,
                   {.threads = options.threads, .band_rows = 0, .dither_mask = mask.get()});
  watcher.reset();  // the line that it may have is free again
  if (proof) proof->finish();
  if (difference) job.mean_ciede2000 = difference->mean_ciede2000();
  if (!options.explain) return {};
  std::vector<StepReport> steps{read_step(prepared.file_info, job),
                                fit_step(options.settings, prepared.file_info, info)};
  for (const Stage& stage : stages.stages) steps.push_back(tristim::explain(stage));
  if (palette.step) steps.push_back(*palette.step);
  std::string codes;
  for (StepReport& step : reducer.explain()) {
    codes += (codes.empty() ? "" : ", ") + step.name;
    steps.push_back(std::move(step));
  }
  steps.push_back(explain(plan_chain(stages.stages, reducer.leads()), codes));
  steps.push_back(write_step(job, display.frame));
  add_counts(steps, job);
  return steps;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Processed process_picture(const ProcessOptions& options, const Display& device, Job job,
                          const MakeWatcher& watcher) {
  const auto start = std::chrono::steady_clock::now();
  const PaletteDisplay palette =
      choose_palette(options, device, {job.input}, is_indexed_format(options, job.output));
  if (palette.transparent) make_rereadable(job.input);
  Prepared prepared = prepare_picture(options, palette.display, job);
  const PictureInfo info = prepared.picture->info();
  const auto file = open_sink(options, job.output, palette, info);
  auto steps = write_picture(options, palette, prepared, *file, job, watcher);
  file->finish();
  job.seconds = seconds_since(start);
  return {std::move(job), palette.display, info, std::move(steps)};
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
    auto steps = write_picture(all, palette, prepared, *file, job, make_progress);
    if (frame) ++*frame;
    job.seconds = seconds_since(start);
    report(all, {std::move(job), palette.display, info, std::move(steps)});
  }
  file->finish();
}

}  // namespace tristim::tools
