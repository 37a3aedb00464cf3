#include "lib/pipeline/reduce_report.h"

#include <string>
#include <utility>

#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

void add_gain(const Dots& dots, StepReport& step) {
  const std::string gain = describe(dots.gain);
  if (!gain.empty()) step.numbers.emplace_back("dot gain", gain);
}

std::string end_of_scale(std::uint16_t code, float light) {
  return "code " + std::to_string(code) + " at light " + rounded(light, 8);
}

void add_diffusion(const DiffusionKernel& kernel, const DitherParameters& parameters,
                   StepReport& step) {
  const DiffusionOptions told = diffusion_options(kernel, parameters);
  step.numbers.emplace_back("serpentine", told.serpentine ? "yes" : "no");
  if (passed_on(kernel) < 1) {
    step.numbers.emplace_back(
        "passes on", shortest(passed_on(kernel)) + " of the error: gains contrast, loses tone");
  }
  if (told.jitter > 0) step.numbers.emplace_back("jitter", shortest(told.jitter));
}

}  // namespace

StepReport black_point_report(BlackPoint black_point) {
  const bool relative = black_point == BlackPoint::kRelative;
  return {"black and white",
          relative ? "picture [0, 1] to the device's black..white, in light"
                   : "picture light is the device's light: below its black it is lost",
          "",
          {}};
}

StepReport press_report(const Display& display) {
  const Press& press = *display.press;
  StepReport step{"inks", "light = product of 1 - area (1 - ink)", "[Neugebauer37]", {}};
  step.numbers.emplace_back("inks", list_names(press.inks));
  for (const NamedSeparation& separation : kSeparations) {
    if (separation.rule == press.rule) {
      step.numbers.emplace_back("separation", std::string(separation.name));
    }
  }
  step.numbers.emplace_back("black", shortest(press.black.replacement));
  step.numbers.emplace_back("ink limit", shortest(press.black.limit));
  if (display.dots) add_gain(*display.dots, step);
  return step;
}

StepReport palette_report(const Metric& metric, int size) {
  StepReport step{"palette", "the nearest entry", std::string(metric.source), {}};
  step.numbers.emplace_back("entries", std::to_string(size));
  step.numbers.emplace_back("metric", std::string(metric.name));
  return step;
}

StepReport response_report(const Display& display, std::span<const LevelScale> scales) {
  StepReport step{
      "response",
      display.palette.empty() ? describe_responses(display) : "levels are the palette's luminances",
      "",
      {}};
  if (display.levels) {
    step.formula += "; levels I_j from I0 to 1, V_j = floor((I_j/K)^(1/gamma) + .5)";
    step.source = "[Shoaff 2.1.1]";
    step.numbers.emplace_back("I0", shortest(display.levels->i0));
  }
  for (std::size_t c = 0; c < scales.size(); ++c) {
    const LevelScale& scale = scales[c];
    const std::string channel = scales.size() == 1 ? "" : std::string(1, "RGB"[c]) + " ";
    step.numbers.emplace_back(channel + "levels", std::to_string(scale.light.size()));
    step.numbers.emplace_back(channel + "first",
                              end_of_scale(scale.code.front(), scale.light.front()));
    step.numbers.emplace_back(channel + "last",
                              end_of_scale(scale.code.back(), scale.light.back()));
  }
  if (display.dots) add_gain(*display.dots, step);
  return step;
}

StepReport dither_report(const ReduceOptions& options) {
  StepReport step = std::visit(
      [](const auto& method) {
        return StepReport{"dither " + std::string(method.name), "", std::string(method.source), {}};
      },
      options.dither);
  if (!std::holds_alternative<NoDither>(options.dither)) {
    step.numbers.emplace_back("mixed in", options.mix == Mix::kLight ? "light" : "encoded numbers");
  }
  if (options.parameters.strength != 1) {
    step.numbers.emplace_back("strength", shortest(options.parameters.strength));
  }
  if (const auto* kernel = std::get_if<DiffusionKernel>(&options.dither)) {
    add_diffusion(*kernel, options.parameters, step);
  }
  return step;
}

}  // namespace tristim::detail
