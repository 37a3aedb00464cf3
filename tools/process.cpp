#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "tools/commands.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/exr.h"
#include "tristim/image/io/read.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/proof.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim process spheres.exr --device srgb -o monitor.png\n"
    "  tristim process spheres.exr --device epaper-4grey --exposure -1 -o panel.raw --proof "
    "panel.png\n"
    "  tristim process spheres.exr --device laser-300 --size 1200x --dither floyd-steinberg -o "
    "page.png\n"
    "  tristim process spheres.exr --device lcd-rgb565 --tone-map reinhard:8 --explain -o "
    "frame.h\n";

struct Options {
  std::vector<std::string> inputs;
  std::string output, device, proof, format;
  Settings settings;
  int threads = 0;
  int png_level = 6;
  bool explain = false, json = false, force = false;
};

// One picture on its way: what is known before its rows, and what was counted with them.
struct Job {
  std::string input, output, proof;  // proof may be empty
  OddValues odd;
  StageCounts counts;
  std::uint64_t pixels = 0;
  double mean_ciede2000 = 0;
  double seconds = 0;
};

// Progress on standard error, where that is a terminal and the picture takes a while.
class Progress : public BandObserver {
 public:
  Progress(std::string name, int height)
      : name_(std::move(name)), height_(height), shown_(isatty(STDERR_FILENO) == 1 && !quiet()) {}
  ~Progress() override {
    if (drawn_) std::fputs("\r\033[K", stderr);
  }
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float> /*light*/, ImageView<const std::uint16_t> codes) override {
    done_ += codes.height;
    const auto now = std::chrono::steady_clock::now();
    constexpr auto kStep = std::chrono::milliseconds(200);
    if (!shown_ || now - last_ < kStep) return;
    last_ = now;
    drawn_ = true;
    std::fprintf(stderr, "\r%s: %d %%", name_.c_str(), static_cast<int>(100.0 * done_ / height_));
  }

 private:
  std::string name_;
  int height_;
  int done_ = 0;
  bool shown_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// A file that is read twice cannot be a pipe: keeps standard input in an unlinked file.
class SpooledInput {
 public:
  explicit SpooledInput(const std::string& input) : path_(input) {
    if (input != "-") return;
    file_ = std::tmpfile();
    if (file_ == nullptr) throw Error(ErrorKind::kSystem, "-", "no room for a temporary file");
    char buffer[65536];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, stdin)) {
      if (std::fwrite(buffer, 1, n, file_) != n) {
        throw Error(ErrorKind::kSystem, "-", "no room for a temporary file");
      }
    }
    std::fflush(file_);
    path_ = "/proc/self/fd/" + std::to_string(fileno(file_));
  }
  ~SpooledInput() {
    if (file_ != nullptr) std::fclose(file_);
  }
  SpooledInput(const SpooledInput&) = delete;
  SpooledInput& operator=(const SpooledInput&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::FILE* file_ = nullptr;
};

// The palette to choose for the picture; nothing where the device's own codes serve.
std::optional<PaletteChoice> palette_to_choose(const Display& display, const Settings& settings) {
  if (settings.palette.method != nullptr) return settings.palette;
  const bool has_codes = !display.palette.empty() || !display.frame.packing.indexed;
  if (has_codes) return std::nullopt;
  return PaletteChoice{find_by_name(kPaletteMethods, "median-cut"), 0};
}

Display with_chosen_palette(Display display, const PaletteChoice& choice, const Options& options,
                            const std::string& input) {
  const int colors = palette_colors(display, choice);
  if (!choice.method->needs_histogram) {
    return with_palette(std::move(display), choice.method->choose({}, colors));
  }
  const auto picture =
      prepare(open_picture(input, {options.settings.layer}), display, options.settings, nullptr);
  const StageList stages = stage_list(picture->info(), display, options.settings);
  const Histogram counted = histogram(*picture, stages, display, {.threads = options.threads});
  return with_palette(std::move(display), choice.method->choose(counted, colors));
}

bool is_exr(const Options& options, const std::string& output) {
  if (!options.format.empty()) return same_name(options.format, "exr");
  return same_name(std::filesystem::path(output).extension().string(), ".exr");
}

std::unique_ptr<CodeSink> open_sink(const Options& options, const std::string& output,
                                    const Display& display, const PictureInfo& picture) {
  if (is_exr(options, output)) {
    PictureInfo info;
    info.width = picture.width;
    info.height = picture.height;
    info.primaries = display.primaries;
    return decoding_sink(display, open_exr_sink(output, info, {.replace = options.force}));
  }
  const bool piped = output == "-" && options.format.empty();
  return open_code_sink(output, frame_info(display, picture.width, picture.height),
                        {.format = piped ? "png" : options.format,
                         .replace = options.force,
                         .png_level = options.png_level});
}

std::unique_ptr<CodeSink> open_proof(const Options& options, const std::string& path,
                                     const PictureInfo& picture) {
  return open_code_sink(
      path, frame_info(Display{}, picture.width, picture.height),
      {.format = "png", .replace = options.force, .png_level = options.png_level});
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return rounded(100.0 * static_cast<double>(part) / static_cast<double>(whole), 3) + " %";
}

void add_counts(std::vector<StepReport>& steps, const Job& job) {
  for (StepReport& step : steps) {
    if (!step.name.starts_with("gamut map")) continue;
    step.numbers.emplace_back("out of gamut", std::to_string(job.counts.out_of_gamut) +
                                                  " pixels, " +
                                                  percent(job.counts.out_of_gamut, job.pixels));
    step.numbers.emplace_back("clipped", std::to_string(job.counts.clipped) +
                                             " pixels brighter than white, " +
                                             percent(job.counts.clipped, job.pixels));
  }
}

std::string primaries_text(const Primaries& p) {
  const auto xy = [](Chromaticity c) { return shortest(c.x) + " " + shortest(c.y); };
  return "red " + xy(p.red) + ", green " + xy(p.green) + ", blue " + xy(p.blue) + ", white " +
         xy(p.white);
}

StepReport read_step(const PictureInfo& file, const Job& job) {
  StepReport step{"read " + job.input, "linear light in the file's primaries", "", {}};
  step.numbers.emplace_back("size", std::to_string(file.width) + "x" + std::to_string(file.height));
  step.numbers.emplace_back("primaries", primaries_text(file.primaries));
  step.numbers.emplace_back("alpha",
                            file.channels == 4 ? "premultiplied, over the background" : "none");
  step.numbers.emplace_back("NaN read as 0", std::to_string(job.odd.nan));
  step.numbers.emplace_back("infinities read as +-65504", std::to_string(job.odd.infinite));
  return step;
}

StepReport fit_step(const Options& options, const PictureInfo& fitted) {
  StepReport step{"fit", "resampled in light", std::string(options.settings.filter.source), {}};
  step.numbers.emplace_back("size",
                            std::to_string(fitted.width) + "x" + std::to_string(fitted.height));
  step.numbers.emplace_back("filter", std::string(options.settings.filter.name));
  return step;
}

StepReport write_step(const Job& job, const Display& display) {
  const FrameLayout& layout = display.frame;
  StepReport step{"pack and write " + job.output, "", "", {}};
  step.numbers.emplace_back("packing", std::string(layout.packing.name));
  step.numbers.emplace_back("bit order", layout.bit_order == BitOrder::kMsb ? "msb" : "lsb");
  step.numbers.emplace_back("byte order", layout.byte_order == ByteOrder::kBig ? "big" : "little");
  if (!job.proof.empty()) {
    step.numbers.emplace_back("proof", job.proof);
    step.numbers.emplace_back("mean CIEDE2000 of the proof", rounded(job.mean_ciede2000, 4));
  }
  return step;
}

void say_notes(const Job& job) {
  if (job.odd.nan + job.odd.infinite > 0) {
    note(job.input + ": note: " + std::to_string(job.odd.nan) + " NaN read as 0, " +
         std::to_string(job.odd.infinite) + " infinities as +-65504");
  }
  constexpr std::uint64_t kWorthSaying = 1000;  // one pixel in a thousand
  if (job.counts.clipped * kWorthSaying >= job.pixels && job.counts.clipped > 0) {
    note(job.input + ": note: " + percent(job.counts.clipped, job.pixels) +
         " of the pixels are brighter than the device's white and were clipped; see --exposure and "
         "--tone-map");
  }
}

nlohmann::ordered_json job_json(const Options& options, const Job& job, const Display& display,
                                const PictureInfo& picture, const std::vector<StepReport>& steps) {
  nlohmann::ordered_json json{{"input", job.input},       {"output", job.output},
                              {"device", options.device}, {"width", picture.width},
                              {"height", picture.height}, {"packing", display.frame.packing.name}};
  std::error_code unknown;
  const auto bytes = std::filesystem::file_size(job.output, unknown);
  json["bytes"] = unknown ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(bytes);
  json["seconds"] = job.seconds;
  json["nan"] = job.odd.nan;
  json["infinite"] = job.odd.infinite;
  json["out_of_gamut"] = job.counts.out_of_gamut;
  json["clipped"] = job.counts.clipped;
  if (!job.proof.empty()) {
    json["proof"] = job.proof;
    json["mean_ciede2000"] = number_json(job.mean_ciede2000);
  }
  if (options.explain) json["steps"] = steps_json(steps);
  return json;
}

void process_one(const Options& options, Job job) {
  const auto start = std::chrono::steady_clock::now();
  Display display = load_display(options.device);
  std::string path = job.input;
  std::optional<SpooledInput> spooled;
  if (const auto choice = palette_to_choose(display, options.settings)) {
    path = spooled.emplace(job.input).path();
    display = with_chosen_palette(std::move(display), *choice, options, path);
  }

  auto file = open_picture(path, {options.settings.layer});
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
  Progress progress(job.input, info.height);
  std::vector<BandObserver*> observers{&progress};
  if (!job.proof.empty()) {
    proof_sink = open_proof(options, job.proof, info);
    observers.push_back(&proof.emplace(display, *proof_sink));
    observers.push_back(&difference.emplace(info.primaries, options.settings.adaptation, display,
                                            stages.scene_stages));
  }
  job.counts =
      run(*picture, stages.stages, reducer, *sink, observers, {.threads = options.threads});
  sink->finish();
  if (proof_sink) proof_sink->finish();
  if (difference) job.mean_ciede2000 = difference->mean_ciede2000();
  job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::vector<StepReport> steps{read_step(file_info, job), fit_step(options, info)};
  for (const Stage& stage : stages.stages) steps.push_back(tristim::explain(stage));
  for (StepReport& step : reducer.explain()) steps.push_back(std::move(step));
  steps.push_back(write_step(job, display));
  add_counts(steps, job);
  if (options.json) {
    print(job_json(options, job, display, info, steps).dump() + "\n");
  } else if (options.explain) {
    print(steps_text(steps));
  }
  say_notes(job);
}

void declare(CommandLine& line, Options& options, std::string& pipeline) {
  line.positional("IN", "pictures; - is standard input", options.inputs, 1, 1 << 20);
  line.option("-o,--output", "OUT",
              "result, by its extension: " + list_names(kFrameFormats) +
                  ", exr; {stem} and %04d for several; - is standard output",
              options.output);
  line.option("-d,--device", "D", "a device of `tristim device list`, or a file: ./panel.toml",
              options.device);
  line.option("--pipeline", "P.toml", "settings from a file; options override it", pipeline);
  line.option("--proof", "P.png", "what the device will show, as sRGB", options.proof);
  line.option("--format", "F", "of the output, whatever its name", options.format);
  line.option(
      "--png-level", "0..9", "effort of PNG compression; default 6",
      [&](const std::string& v) { options.png_level = integer_option("--png-level", v, 0, 9); });
  line.option(
      "--threads", "N", "default: one for each processor; the result is the same",
      [&](const std::string& v) { options.threads = integer_option("--threads", v, 0, 1024); });
  line.flag("--explain", "print every step with its numbers, formula and source", options.explain);
  line.flag("--json", "print the facts as JSON, a line a picture", options.json);
  line.flag("-f,--force", "replace existing files", options.force);
}

// Settings of the command line are kept until the pipeline file has been read: they override it.
struct GivenSetting {
  const Setting* setting;
  std::string value;
};

void declare_settings(CommandLine& line, std::vector<GivenSetting>& given,
                      std::vector<std::unique_ptr<bool>>& flags) {
  for (const Setting& setting : settings_list()) {
    const std::string name = "--" + std::string(setting.name);
    if (setting.argument.empty()) {
      flags.push_back(std::make_unique<bool>(false));
      line.flag(name, setting.help, *flags.back());
      continue;
    }
    line.option(name, setting.argument, setting.help, [&given, &setting](const std::string& value) {
      given.push_back({&setting, value});
    });
  }
}

void apply_setting(Settings& settings, const Setting& setting, const std::string& value) {
  if (const auto refusal = setting.set(settings, value)) {
    throw Error(ErrorKind::kMisuse, "--" + std::string(setting.name), refusal->wrong,
                refusal->remedy);
  }
}

void check(const Options& options) {
  if (options.output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing",
                "give -o result.png, or another name");
  }
  if (options.device.empty()) {
    throw Error(ErrorKind::kMisuse, "--device", "is missing",
                "give one of " + list_names(built_in_displays()) + ", or a file");
  }
  if (options.output == "-" && (options.json || options.explain)) {
    throw Error(ErrorKind::kMisuse, options.json ? "--json" : "--explain",
                "standard output is taken by the picture", "give -o a file");
  }
  if (options.output == "-" && isatty(STDOUT_FILENO) == 1) {
    throw Error(ErrorKind::kMisuse, "-", "a picture is not written to a terminal",
                "give -o a file, or pipe it on");
  }
}

std::vector<Job> jobs_of(const Options& options) {
  const std::vector<std::string> outputs = output_names(options.output, options.inputs, "--output");
  std::vector<std::string> all = outputs;
  std::vector<std::string> proofs(options.inputs.size());
  if (!options.proof.empty()) {
    proofs = output_names(options.proof, options.inputs, "--proof");
    all.insert(all.end(), proofs.begin(), proofs.end());
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const std::string& proof : proofs) {
      const bool same = !proof.empty() && std::filesystem::path(proof).lexically_normal() ==
                                              std::filesystem::path(outputs[i]).lexically_normal();
      if (same && proof != "/dev/null") {
        throw Error(ErrorKind::kMisuse, "--proof", proof + " is the output too",
                    "choose another name for the proof");
      }
    }
  }
  refuse_inputs_as_outputs(options.inputs, all);
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    Job job;
    job.input = options.inputs[i];
    job.output = outputs[i];
    job.proof = proofs[i];
    jobs.push_back(std::move(job));
  }
  return jobs;
}

}  // namespace

void run_process(Arguments arguments) {
  Options options;
  std::string pipeline;
  std::vector<GivenSetting> given;
  std::vector<std::unique_ptr<bool>> flags;
  CommandLine line(*find_by_name(kCommands, "process"), kExamples);
  declare(line, options, pipeline);
  declare_settings(line, given, flags);
  if (!line.parse(arguments)) return;
  check(options);
  if (!pipeline.empty()) read_pipeline_file(pipeline, options.settings);
  for (const GivenSetting& one : given) apply_setting(options.settings, *one.setting, one.value);
  std::size_t flag = 0;
  for (const Setting& setting : settings_list()) {
    if (!setting.argument.empty()) continue;
    if (*flags[flag++]) apply_setting(options.settings, setting, "true");
  }
  for (Job& job : jobs_of(options)) process_one(options, std::move(job));
}

}  // namespace tristim::tools
