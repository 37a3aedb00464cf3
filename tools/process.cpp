#include <algorithm>
#include <filesystem>

#include "tools/commands.h"
#include "tools/outputs.h"
#include "tools/process_job.h"
#include "tools/process_output.h"
#include "tools/process_sequence.h"
#include "tools/setting_options.h"
#include "tools/spot_picture.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/dither/io/matrix_file.h"
#include "tristim/frame/io/write.h"
#include "tristim/pipeline/chain.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim process spheres.exr --device srgb -o monitor.png\n"
    "  tristim process spheres.exr --device epaper-4grey -o panel.raw --proof panel.png\n"
    "  tristim process spheres.exr --device laser-300 --size 1200x -o page.png\n"
    "  tristim process spheres.exr --device laser-300 --dither screen --lpi 50 --angle 30 -o "
    "s.tif\n"
    "  tristim process spheres.exr --device vga16 --tone-map reinhard:8 --explain -o vga.h\n"
    "  tristim process spheres.exr --device srgb --palette best:16 -o spheres.gif\n"
    "  tristim process *.exr --device srgb --exposure -1 -o '{stem}-%04d.png'\n"
    "  tristim process *.exr --device srgb --exposure -1 -o '{stem}-%04d.png' --resume\n";

std::string extensions() {
  std::string all;
  for (const FrameFormat& format : kFrameFormats) all += std::string(format.extensions) + ", ";
  return all + "exr";
}

void declare(CommandLine& line, ProcessOptions& options, std::string& pipeline) {
  line.positional("IN...", "pictures; - is standard input", options.inputs, 1, 1 << 20);
  line.option("-o,--output", "OUT",
              "result, in the format of its extension: " + extensions() +
                  "; for several pictures with {stem} or %04d in it, or one GIF that moves; - is "
                  "standard output",
              options.output);
  line.option("-d,--device", "D", "one of `tristim device list`, or a file: ./panel.toml",
              options.device);
  line.option("--proof", "P.png", "what the device will show, as sRGB", options.proof);
  line.option("--format", "F",
              list_names(kFrameFormats) +
                  ", exr: whatever the name of the result; "
                  "default on standard output: png",
              options.format);
  line.option(
      "--png-level", "0..9", "effort of PNG compression; default: 6",
      [&](const std::string& v) { options.png_level = integer_option("--png-level", v, 0, 9); });
  line.option(
      "--threads", "N", "default: one for each processor; the result is the same",
      [&](const std::string& v) { options.threads = integer_option("--threads", v, 0, 256); });
  line.option(
      "--delay", "SECONDS", "of each picture of a moving GIF; default: 0.1",
      [&](const std::string& v) { options.delay_s = number_option("--delay", v, 0, 655.35); });
  line.flag("--explain", "print every step with its numbers, formula and source", options.explain);
  line.flag("--json", "print the facts as JSON, a line a picture", options.json);
  line.flag("-f,--force", "replace existing files", options.force);
  line.flag("--resume", "leave out pictures whose results are there: files are whole or absent",
            options.resume);
  line.option("--pipeline", "P.toml", "settings from a file; options override it", pipeline);
}

// The streams by one name, so that nothing is asked of them twice.
void name_streams(ProcessOptions& options) {
  for (std::string& input : options.inputs) {
    if (input == "/dev/stdin" || input == "/dev/fd/0") input = "-";
  }
  for (std::string* output : {&options.output, &options.proof}) {
    if (*output == "/dev/stdout" || *output == "/dev/fd/1") *output = "-";
  }
}

void check_streams(const ProcessOptions& options, const std::string& pipeline) {
  const auto readers = std::count(options.inputs.begin(), options.inputs.end(), "-") +
                       int{options.device == "-"} + int{pipeline == "-"};
  if (readers > 1) {
    throw Error(ErrorKind::kMisuse, "-", "standard input is asked for more than once",
                "give the names of files");
  }
  const bool picture = options.output == "-" || options.proof == "-";
  if (picture && (options.json || options.explain)) {
    throw Error(ErrorKind::kMisuse, options.json ? "--json" : "--explain",
                "standard output is taken by the picture", "write the picture to a file");
  }
  refuse_terminal(options.output);
  refuse_terminal(options.proof);
}

// A matrix from a file takes the place of a dither with a name.
void read_own_matrix(Settings& settings) {
  if (settings.dither_file.empty()) return;
  const ThresholdMatrix matrix = read_matrix(settings.dither_file);
  settings.dither = NamedDither{matrix.name, matrix, matrix.source};
}

void check(const ProcessOptions& options) {
  if (options.resume && options.force) {
    throw Error(ErrorKind::kMisuse, "--resume", "keeps the files that --force replaces",
                "give one of them");
  }
  if (options.output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing",
                "give -o result.png, or another name");
  }
  if (options.device.empty()) {
    throw Error(ErrorKind::kMisuse, "--device", "is missing",
                "give one of " + list_names(built_in_displays()) + ", or a file");
  }
}

void check_proofs(const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    check_proof_format(job.proof);
    for (const Job& other : jobs) {
      if (!same_output(job.proof, other.output)) continue;
      throw Error(ErrorKind::kMisuse, "--proof", job.proof + " is the output too",
                  "choose another name for the proof");
    }
  }
}

// Several pictures whose output has one name, which is a format that moves.
bool is_animation(const ProcessOptions& options) {
  const std::string& output = options.output;
  return options.inputs.size() > 1 && is_indexed_only(options, output) &&
         output.find("{stem}") == std::string::npos && output.find('%') == std::string::npos;
}

// The files that a job writes.
std::vector<std::string> files_of(const ProcessOptions& options, const Display& device,
                                  const Job& job) {
  std::vector<std::string> files = output_files(options, device, job.output);
  if (!job.proof.empty()) files.push_back(job.proof);
  return files;
}

// Files come into being when they are whole, so what is there needs no second look.
void leave_out_done(const ProcessOptions& options, const Display& device, std::vector<Job>& jobs) {
  const auto done = [&](const Job& job) {
    std::error_code ignored;
    return std::ranges::all_of(files_of(options, device, job), [&](const std::string& file) {
      return std::filesystem::is_regular_file(file, ignored);
    });
  };
  const std::size_t left_out = std::erase_if(jobs, done);
  if (left_out == 0) return;
  note("--resume: note: " + std::to_string(left_out) +
       (left_out == 1 ? " picture is" : " pictures are") + " there already, " +
       std::to_string(jobs.size()) + " to do");
}

std::vector<Job> jobs_of(const ProcessOptions& options, const Display& device,
                         const std::string& pipeline) {
  refuse_missing_inputs(options.inputs);
  const bool moves = is_animation(options);
  std::vector<std::string> outputs =
      moves ? std::vector<std::string>(options.inputs.size(), options.output)
            : output_names(options.output, options.inputs, "--output");
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    Job job;
    job.input = options.inputs[i];
    job.output = outputs[i];
    jobs.push_back(std::move(job));
  }
  if (!options.proof.empty()) {
    const std::vector<std::string> proofs = output_names(options.proof, options.inputs, "--proof");
    for (std::size_t i = 0; i < proofs.size(); ++i) jobs[i].proof = proofs[i];
    check_proofs(jobs);
  }
  if (options.resume) leave_out_done(options, device, jobs);
  outputs.clear();
  for (const Job& job : jobs) {
    for (std::string& file : files_of(options, device, job)) outputs.push_back(std::move(file));
  }
  std::vector<std::string> read = options.inputs;
  read.push_back(options.device);
  read.push_back(pipeline);
  refuse_inputs_as_outputs(read, outputs);
  refuse_taken_outputs(outputs, options.force || options.resume);
  for (const Job& job : jobs) check_format(options, job.output);
  return jobs;
}

// A press's separations hold where dots of its inks overlap by chance.
void note_dots_on_dots(const Settings& settings, const Display& device) {
  if (!device.press || device.press->inks.size() < 2) return;
  if (!has_one_matrix(reduce_options(device, settings).dither)) return;
  note(
      "--dither: note: all inks share one matrix, so their dots fall on one another and prints are "
      "too light; screen, blue-noise and error diffusion keep the tone");
}

}  // namespace

void run_process(Arguments arguments) {
  ProcessOptions options;
  std::string pipeline;
  std::vector<GivenSetting> given;
  CommandLine line(*find_by_name(kCommands, "process"), kExamples);
  declare(line, options, pipeline);
  line.section("Settings, also keys of a pipeline file (exposure = -1)");
  declare_settings(line, given);
  if (!line.parse(arguments)) return;
  check(options);
  name_streams(options);
  check_streams(options, pipeline);
  if (!pipeline.empty()) read_pipeline_file(pipeline, options.settings);
  apply_settings(options.settings, given);
  read_own_matrix(options.settings);
  Settings& settings = options.settings;
  if (!settings.spot_picture.empty()) {
    settings.dither_parameters.screen.spot = read_spot_picture(settings.spot_picture);
  }
  const Display device = load_display(options.device);
  std::vector<Job> jobs = jobs_of(options, device, pipeline);
  if (jobs.empty()) return;
  note_dots_on_dots(settings, device);
  if (options.resume) options.force = true;  // a picture that lacks one of its files is made anew
  if (is_animation(options)) return process_animation(options, device, jobs);
  process_sequence(options, device, std::move(jobs));
}

}  // namespace tristim::tools
