#include "tools/process_report.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tools/cli.h"
#include "tools/report.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return rounded(100.0 * static_cast<double>(part) / static_cast<double>(whole), 3) + " %";
}

std::string size_text(const PictureInfo& info) {
  return std::to_string(info.width) + "x" + std::to_string(info.height);
}

// 7 digits: files keep chromaticities as floats.
std::string primaries_text(const Primaries& p) {
  const auto xy = [](Chromaticity c) { return rounded(c.x, 7) + " " + rounded(c.y, 7); };
  return "red " + xy(p.red) + ", green " + xy(p.green) + ", blue " + xy(p.blue) + ", white " +
         xy(p.white);
}

}  // namespace

StepReport read_step(const PictureInfo& file, const Job& job) {
  StepReport step{"read " + one_line(job.input), "linear light in the file's primaries", "", {}};
  step.numbers.emplace_back("size", size_text(file));
  step.numbers.emplace_back("primaries", primaries_text(file.primaries));
  step.numbers.emplace_back("alpha",
                            file.channels == 4 ? "premultiplied, over the background" : "none");
  step.numbers.emplace_back("NaN read as 0", std::to_string(job.odd.nan));
  step.numbers.emplace_back("infinities read as +-65504", std::to_string(job.odd.infinite));
  return step;
}

StepReport fit_step(const Settings& settings, const PictureInfo& file, const PictureInfo& fitted) {
  StepReport step{"fit", "", "", {}};
  step.numbers.emplace_back("size", size_text(fitted));
  if (size_text(fitted) == size_text(file) && settings.rotate_deg == 0 && file.pixel_aspect == 1) {
    step.formula = "the picture has that size";
    return step;
  }
  step.formula = "resampled in light";
  step.source = settings.filter.source;
  step.numbers.emplace_back("filter", std::string(settings.filter.name));
  if (settings.rotate_deg != 0) {
    step.numbers.emplace_back("turned clockwise", std::to_string(settings.rotate_deg) + " degrees");
  }
  return step;
}

StepReport palette_step(const PaletteChoice& choice, int colors) {
  StepReport step{"choose a palette, " + std::string(choice.method->name),
                  "",
                  std::string(choice.method->source),
                  {}};
  step.numbers.emplace_back("colours at most", std::to_string(colors));
  return step;
}

StepReport write_step(const Job& job, const FrameLayout& layout) {
  StepReport step{"pack and write " + one_line(job.output), "", "", {}};
  step.numbers.emplace_back("packing", std::string(layout.packing.name));
  step.numbers.emplace_back("bit order", layout.bit_order == BitOrder::kMsb ? "msb" : "lsb");
  step.numbers.emplace_back("byte order", layout.byte_order == ByteOrder::kBig ? "big" : "little");
  if (!job.proof.empty()) {
    step.numbers.emplace_back("proof", one_line(job.proof));
    step.numbers.emplace_back("mean CIEDE2000 of the proof", rounded(job.mean_ciede2000, 4));
  }
  return step;
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

namespace {

nlohmann::ordered_json job_json(const ProcessOptions& options, const Processed& processed) {
  const auto& [job, display, picture, steps] = processed;
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
  if (!steps.empty()) json["steps"] = steps_json(steps);
  return json;
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

}  // namespace

void report(const ProcessOptions& options, const Processed& processed) {
  if (options.json) {
    print(json_line(job_json(options, processed)));
  } else if (options.explain) {
    print(steps_text(processed.steps));
  }
  say_notes(processed.job);
}

}  // namespace tristim::tools
