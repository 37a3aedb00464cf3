#include "tristim/pipeline/reduce.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>

#include "lib/pipeline/channel_planes.h"
#include "lib/pipeline/reduce_inks.h"
#include "lib/pipeline/reduce_levels.h"
#include "lib/pipeline/reduce_palette.h"
#include "lib/pipeline/reduce_report.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Target = std::variant<detail::LevelReducer, detail::PaletteReducer, detail::InkReducer>;

Target make_target(const Display& display, const ReduceOptions& options, int width) {
  if (!takes_dither(display, options.dither)) {
    const auto& whole = std::get<WholePictureDither>(options.dither);
    throw std::invalid_argument("dither: " + std::string(whole.name) +
                                " works on the levels of channels, not on a palette; use a "
                                "kernel such as floyd-steinberg");
  }
  if (display.press) return detail::InkReducer(display, options, width);
  if (!display.frame.packing.indexed) return detail::LevelReducer(display, options, width);
  return detail::PaletteReducer(display, options, width);
}

}  // namespace

const NamedDither& default_dither(const Display& display) {
  const bool holds_dots = !display.dots || display.dots->isolated;
  const Packing& packing = display.frame.packing;
  const int least_bits = packing.samples == 3
                             ? *std::min_element(packing.bits.begin(), packing.bits.end())
                             : packing.bits[0];
  const bool chosen_palette = packing.indexed && !display.palette_has_white;
  const bool one_bit = least_bits == 1 && !packing.indexed;
  const char* name = one_bit || chosen_palette ? "blue-diffusion" : "floyd-steinberg";
  if (!holds_dots) name = "clustered8";
  if (display.press) name = "screen";
  if (least_bits >= 8 && !packing.indexed && display.palette.empty()) name = "none";
  return *find_by_name(dither_methods(), name);
}

bool takes_dither(const Display& display, const DitherMethod& dither) noexcept {
  const bool palette =
      display.frame.packing.indexed && !display.palette.empty() && !display.press.has_value();
  return !palette || !std::holds_alternative<WholePictureDither>(dither);
}

struct Reducer::State {
  Display display;
  ReduceOptions options;
  Target target;

  State(const Display& d, const ReduceOptions& o, int width)
      : display(d), options(o), target(make_target(display, options, width)) {}

  // Of a target that works on whole colours.
  void reduce_colors(const Band& band, ImageView<std::uint16_t> codes, int threads) {
    if (auto* palette = std::get_if<detail::PaletteReducer>(&target)) {
      palette->reduce(band, codes, threads);
    }
    if (auto* inks = std::get_if<detail::InkReducer>(&target)) inks->reduce(band, codes, threads);
  }
};

Reducer::Reducer(const Display& display, const ReduceOptions& options, int width)
    : state_(std::make_unique<State>(display, options, width)) {}

Reducer::Reducer(Reducer&&) noexcept = default;
Reducer::~Reducer() = default;

int Reducer::samples() const noexcept { return state_->display.frame.packing.samples; }

bool Reducer::whole_picture() const noexcept {
  return std::holds_alternative<WholePictureDither>(state_->options.dither);
}

void Reducer::reduce(Band band, ImageView<std::uint16_t> codes, int threads) {
  prepare(band, codes, {}, threads);
  for (int chain = 0; chain < chains(); ++chain) advance(chain, band, codes, threads);
  finish(codes);
}

int Reducer::chains() const noexcept {
  if (!std::holds_alternative<DiffusionKernel>(state_->options.dither)) return 0;
  return std::holds_alternative<detail::LevelReducer>(state_->target) ? samples() : 1;
}

bool Reducer::leads() const noexcept {
  const auto* levels = std::get_if<detail::LevelReducer>(&state_->target);
  return levels != nullptr && levels->leads();
}

StageCounts Reducer::prepare(Band band, ImageView<std::uint16_t> codes, const Lead& lead,
                             int threads) {
  if (auto* levels = std::get_if<detail::LevelReducer>(&state_->target)) {
    return chains() == 0 ? levels->reduce(band, codes, lead, threads) : levels->prepare(band, lead);
  }
  if (chains() == 0) state_->reduce_colors(band, codes, threads);
  return {};
}

void Reducer::advance(int chain, Band band, ImageView<std::uint16_t> codes, int threads) {
  if (auto* levels = std::get_if<detail::LevelReducer>(&state_->target)) {
    return levels->advance(chain, band, codes, threads);
  }
  state_->reduce_colors(band, codes, threads);
}

void Reducer::finish(ImageView<std::uint16_t> codes) const {
  if (chains() > 1) detail::join_rows(codes);
}

std::vector<StepReport> Reducer::explain() const {
  const State& s = *state_;
  std::vector<StepReport> steps{detail::black_point_report(s.options.black_point)};
  if (const auto* levels = std::get_if<detail::LevelReducer>(&s.target)) {
    steps.push_back(detail::response_report(s.display, levels->scales()));
  } else if (const auto* palette = std::get_if<detail::PaletteReducer>(&s.target)) {
    steps.push_back(detail::palette_report(s.options.metric, palette->size()));
  } else {
    steps.push_back(detail::press_report(s.display));
  }
  steps.push_back(detail::dither_report(s.options));
  return steps;
}

}  // namespace tristim
