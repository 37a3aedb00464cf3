#include "tools/lut.h"

#include <algorithm>

#include "tools/commands.h"
#include "tools/outputs.h"
#include "tristim/color/conversion.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kPrefix = "lut ";

struct JobName {
  std::string_view name;
};

std::vector<JobName> job_names() {
  std::vector<JobName> names;
  for (const Command& job : kLutJobs) names.push_back({job.name.substr(kPrefix.size())});
  return names;
}

std::string help() {
  const Command& command = *find_by_name(kCommands, "lut");
  std::string text = "Usage: tristim lut " + std::string(command.usage) + "\n\n";
  for (const Command& job : kLutJobs) {
    std::string line = "  " + std::string(job.name.substr(kPrefix.size()));
    line.resize(14, ' ');
    text += line + std::string(job.summary) + "\n";
  }
  text += "\nFormats:\n";
  for (const LutFormat& format : lut_formats()) {
    std::string line = "  " + std::string(format.name);
    line.resize(14, ' ');
    text += line + std::string(format.what) + "\n";
  }
  return text +
         "\ntristim lut <job> --help tells the options of a job.\n\nExamples:\n"
         "  tristim lut bake --device crt-p22 --tone-map reinhard:4 -o crt.cube\n"
         "  tristim lut info crt.cube\n"
         "  tristim lut invert crt.cube -o back.cube\n"
         "  tristim render spheres -o spheres.exr\n"
         "  tristim lut apply spheres.exr crt.cube -o spheres.png\n";
}

std::string size_words(const Lut1D& step) {
  return "curves of " + std::to_string(step.size) + " entries";
}
std::string size_words(const LutPoints& step) {
  return "curves through " + std::to_string(step.curves[0].in.size()) + " points";
}
std::string size_words(const Lut3D& step) {
  return "a cube of " + std::to_string(step.size) + " points an edge";
}
std::string size_words(const LutMatrix&) { return "a matrix"; }

}  // namespace

const Command* lut_job(std::string_view name) noexcept {
  for (const Command& job : kLutJobs) {
    if (same_name(job.name.substr(kPrefix.size()), name)) return &job;
  }
  return nullptr;
}

void declare_lut_output(CommandLine& line, LutOutput& output) {
  line.option("-o,--output", "OUT",
              "the table, in the format of its extension; - is standard output", output.path);
  line.option("--format", "F", list_names(lut_formats()) + ": whatever the name of the result",
              output.format);
  line.option(
      "--bits", "8..16", "of the format's integers; default: its own",
      [&output](const std::string& v) { output.file.bits = integer_option("--bits", v, 8, 16); });
  line.flag("--progmem", "C arrays lie in the program memory of AVR microcontrollers",
            output.file.progmem);
  line.flag("-f,--force", "replace existing files", output.force);
}

const LutFormat& check_lut_output(const LutOutput& output, const std::vector<std::string>& inputs) {
  if (output.path.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing",
                "give -o result.cube, or another name");
  }
  const LutFormat& format = lut_format_of(output.path, output.format);
  refuse_missing_inputs(inputs);
  refuse_inputs_as_outputs(inputs, {output.path});
  refuse_taken_outputs({output.path}, output.force);
  refuse_terminal(output.path);
  return format;
}

LutFile lut_file(const Lut& lut, const LutFormat& format, const LutOutput& output) {
  LutFile file;
  file.bytes = lut_bytes(lut, format, output.path, output.file);
  LutFileOptions options = output.file;
  options.cube = !lut.steps.empty() && std::holds_alternative<Lut3D>(lut.steps.back());
  file.stored = parse_lut(file.bytes, output.path, format.name, options);
  return file;
}

Lut sampled_lut(const Lut& lut, const LutFormat& format, LutSampling sampling,
                const std::string& path) {
  const auto within = [](int size, int most) { return std::min(size, most); };
  return fit_lut(lut, format,
                 {.curves = within(sampling.curves, format.holds.curves),
                  .cube = within(sampling.cube, format.holds.cube)},
                 path);
}

void write_lut_file(const LutFile& file, const LutOutput& output) {
  OutputFile to(output.path, output.force);
  to.write(file.bytes);
  to.commit();
}

const LutInterpolation& interpolation_option(const std::string& name) {
  if (const LutInterpolation* found = find_by_name(kLutInterpolations, name)) return *found;
  throw Error(ErrorKind::kMisuse, "--interpolation", "unknown interpolation '" + name + "'",
              name_hint(kLutInterpolations, name));
}

Look look_of(const std::string& model, std::string_view option) {
  const ModelReference from = parse_model(model, option);
  if (component_count(*from.model) != 3) {
    throw Error(ErrorKind::kMisuse, option, "'" + model + "' has not three components",
                "give a model such as rgb:srgb");
  }
  const auto conversion = std::make_shared<const ColorConversion>(from, parse_model("lab", option),
                                                                  Adaptation::kBradford);
  return [conversion](Rgb c) {
    const Components lab = (*conversion)({c.r, c.g, c.b, 0});
    return Lab{lab[0], lab[1], lab[2]};
  };
}

std::string lut_words(const Lut& lut) {
  std::string text;
  for (const LutStep& step : lut.steps) {
    text += (text.empty() ? "" : ", then ") +
            std::visit([](const auto& s) { return size_words(s); }, step);
  }
  return text.empty() ? "the identity" : text;
}

void run_lut(Arguments arguments) {
  if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h") return print(help());
  if (const Command* job = lut_job(arguments[0])) return job->run(arguments.subspan(1));
  throw Error(ErrorKind::kMisuse, arguments[0], "is nothing that lut does",
              name_hint(job_names(), arguments[0]));
}

}  // namespace tristim::tools
