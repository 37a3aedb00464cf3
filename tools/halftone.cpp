#include "tools/halftone.h"

#include <filesystem>

#include "tools/commands.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/dither/io/matrix_file.h"
#include "tristim/dither/matrices.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kPrefix = "halftone ";

struct JobName {
  std::string_view name;
};

std::vector<JobName> job_names() {
  std::vector<JobName> names;
  for (const Command& job : kHalftoneJobs) names.push_back({job.name.substr(kPrefix.size())});
  return names;
}

std::string help() {
  const Command& command = *find_by_name(kCommands, "halftone");
  std::string text = "Usage: tristim halftone " + std::string(command.usage) + "\n\n";
  for (const Command& job : kHalftoneJobs) {
    std::string line = "  " + std::string(job.name.substr(kPrefix.size()));
    line.resize(14, ' ');
    text += line + std::string(job.summary) + "\n";
  }
  return text +
         "\ntristim halftone <job> --help tells the options of a job.\n\nExamples:\n"
         "  tristim halftone matrix d3\n"
         "  tristim halftone patterns d2 -o d2.svg\n"
         "  tristim halftone judge clustered8\n"
         "  tristim halftone screen --dpi 600 --lpi 85\n";
}

// A file's name has a folder or an extension, or the file is there.
bool looks_like_file(const std::string& name) {
  std::error_code ignored;
  const std::filesystem::path path = name;
  return name == "-" || path.has_parent_path() || path.has_extension() ||
         std::filesystem::exists(path, ignored);
}

}  // namespace

const Command* halftone_job(std::string_view name) noexcept {
  for (const Command& job : kHalftoneJobs) {
    if (same_name(job.name.substr(kPrefix.size()), name)) return &job;
  }
  return nullptr;
}

void declare_matrix_options(CommandLine& line, MatrixOptions& options) {
  line.option("--mask-size", "N", "side of a matrix that comes in sizes; default: its own",
              [&options](const std::string& v) {
                options.size = integer_option("--mask-size", v, 1, 1024);
              });
  line.option("--seed", "N", "of blue noise; default: 0", options.seed);
  line.option("--channel", "N", "of a colour device, 0 to 3; default: 0", options.channel);
  line.option("--frame", "N", "of an animation, for matrices that change with time", options.frame);
}

ThresholdMatrix halftone_matrix(const std::string& name, const MatrixOptions& options) {
  constexpr int kMost = 1'000'000'000;
  MatrixParameters parameters{.size = options.size};
  if (!options.seed.empty()) {
    parameters.seed = static_cast<std::uint64_t>(integer_option("--seed", options.seed, 0, kMost));
  }
  if (!options.channel.empty()) {
    parameters.channel = integer_option("--channel", options.channel, 0, 3);
  }
  if (!options.frame.empty()) {
    parameters.frame = integer_option("--frame", options.frame, 0, kMost);
  }
  if (const auto recipe = find_matrix_recipe(name)) return make_matrix(*recipe, parameters);
  if (looks_like_file(name)) return read_matrix(name);
  throw Error(ErrorKind::kMisuse, name, "unknown matrix", name_hint(kMatrixRecipes, name));
}

void run_halftone(Arguments arguments) {
  if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h") return print(help());
  if (const Command* job = halftone_job(arguments[0])) return job->run(arguments.subspan(1));
  throw Error(ErrorKind::kMisuse, arguments[0], "is nothing that halftone does",
              name_hint(job_names(), arguments[0]));
}

}  // namespace tristim::tools
