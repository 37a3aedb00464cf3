#include "tristim/pipeline/stage.h"

#include <algorithm>
#include <array>

#include "lib/core/math.h"
#include "lib/pipeline/stage_rows.h"
#include "tristim/core/text.h"
#include "tristim/pipeline/plan.h"

namespace tristim {
namespace {

// Calls `change` on every pixel of a band.
template <typename Change>
void each_pixel(Band band, Change&& change) {
  for (int y = 0; y < band.view.height; ++y) {
    float* pixel = band.view.row(y).data();
    for (int x = 0; x < band.view.width; ++x, pixel += 3) change(pixel);
  }
}

// By themselves these are the plan of a chain of one.
void apply_stage(const Exposure& stage, Band band, StageCounts& counts) {
  apply(plan_chain(std::array{Stage(stage)}, false), band, counts);
}

void apply_stage(const ConvertPrimaries& stage, Band band, StageCounts& counts) {
  apply(plan_chain(std::array{Stage(stage)}, false), band, counts);
}

void apply_stage(const ToneMap& stage, Band band, StageCounts&) {
  const auto white = static_cast<float>(stage.white);
  const Eigen::RowVector3f weights = stage.luminance.cast<float>();
  each_pixel(band, [&](float* p) {
    const float luminance = weights[0] * p[0] + weights[1] * p[1] + weights[2] * p[2];
    if (!(luminance > 0)) return;
    const float gain = stage.tone.luminance(luminance, white) / luminance;
    for (int c = 0; c < 3; ++c) p[c] *= gain;
  });
}

// A pixel outside of [0, 1], or any where the method moves those inside as well.
void map_pixels(const GamutMap& stage, std::span<float> row, StageCounts& counts) {
  const GamutSpace space = gamut_space(stage.srgb_from_device);
  for (std::size_t i = 0; i + 2 < row.size(); i += 3) {
    float* p = &row[i];
    const bool below = std::min({p[0], p[1], p[2]}) < 0;
    const bool above = std::max({p[0], p[1], p[2]}) > 1;
    counts.out_of_gamut += below ? 1 : 0;
    counts.clipped += above ? 1 : 0;
    if (!below && !above && stage.method.keeps_inside) continue;
    const Rgb mapped = stage.method.map({p[0], p[1], p[2]}, space);
    p[0] = static_cast<float>(mapped.r);
    p[1] = static_cast<float>(mapped.g);
    p[2] = static_cast<float>(mapped.b);
  }
}

void apply_stage(const GamutMap& stage, Band band, StageCounts& counts) {
  const bool clip = stage.method.map == gamut_clip;
  for (int y = 0; y < band.view.height; ++y) {
    const std::span<float> row = band.view.row(y);
    if (!clip) map_pixels(stage, row, counts);
    const StageCounts clipped =
        detail::stage_kernels().clip(row.data(), static_cast<std::size_t>(band.view.width));
    if (clip) counts += clipped;  // another method has counted them itself
  }
}

// The same for one colour in double.
Rgb scaled(Rgb rgb, double gain) { return {gain * rgb.r, gain * rgb.g, gain * rgb.b}; }

Rgb exact_stage(const Exposure& stage, Rgb rgb) { return scaled(rgb, detail::pow(2, stage.stops)); }

Rgb exact_stage(const ToneMap& stage, Rgb rgb) {
  const double luminance = stage.luminance * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  if (!(luminance > 0)) return rgb;
  return scaled(rgb, stage.tone.exact(luminance, stage.white) / luminance);
}

Rgb exact_stage(const ConvertPrimaries& stage, Rgb rgb) {
  if (stage.matrix.isIdentity(0)) return rgb;
  const Eigen::Vector3d out = stage.matrix * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  return {out.x(), out.y(), out.z()};
}

Rgb exact_stage(const GamutMap& stage, Rgb rgb) {
  const bool stays = stage.method.keeps_inside && in_gamut(rgb);
  const Rgb mapped = stays ? rgb : stage.method.map(rgb, gamut_space(stage.srgb_from_device));
  const auto inside = [](double x) { return std::min(std::max(0.0, x), 1.0); };  // NaN: 0
  return {inside(mapped.r), inside(mapped.g), inside(mapped.b)};
}

template <typename T>
T reinhard(T luminance, T white) noexcept {
  const T shoulder = white > 0 ? 1 + luminance / (white * white) : 1;
  return luminance * shoulder / (1 + luminance);
}

std::string row_text(const Eigen::Matrix3d& m, int row) {
  return shortest(m(row, 0)) + " " + shortest(m(row, 1)) + " " + shortest(m(row, 2));
}

// 7 digits: files keep chromaticities as floats.
std::string xy(Chromaticity c) { return rounded(c.x, 7) + " " + rounded(c.y, 7); }

StepReport explain_stage(const Exposure& stage) {
  return {"exposure",
          "RGB 2^stops",
          "",
          {{"stops", shortest(stage.stops)}, {"factor", shortest(detail::pow(2, stage.stops))}}};
}

StepReport explain_stage(const ToneMap& stage) {
  return {"tone map " + std::string(stage.tone.name),
          std::string(stage.tone.formula),
          std::string(stage.tone.source),
          {{"white W", stage.white > 0 ? shortest(stage.white) : "none: Ld = L/(1 + L)"}}};
}

StepReport explain_stage(const ConvertPrimaries& stage) {
  std::string_view method;
  std::string_view source;
  for (const AdaptationMethod& known : kAdaptations) {
    if (known.method != stage.adaptation) continue;
    method = known.name;
    source = known.source;
  }
  StepReport report{
      "primaries", "M2^-1 A M1, A: white to white", "[Shoaff 2.2.4], " + std::string(source), {}};
  const auto set = [&](const std::string& name, const Primaries& p) {
    report.numbers.emplace_back(name, "red " + xy(p.red) + ", green " + xy(p.green) + ", blue " +
                                          xy(p.blue) + ", white " + xy(p.white));
  };
  set("picture", stage.from);
  set("device", stage.to);
  report.numbers.emplace_back("adaptation A", method);
  for (int i = 0; i < 3; ++i) {
    report.numbers.emplace_back("matrix row " + std::to_string(i + 1), row_text(stage.matrix, i));
  }
  return report;
}

StepReport explain_stage(const GamutMap& stage) {
  const GamutMethod& method = stage.method;
  return {"gamut map " + std::string(method.name),
          std::string(method.formula),
          std::string(method.source),
          {}};
}

}  // namespace

float reinhard_luminance(float luminance, float white) noexcept {
  return reinhard(luminance, white);
}

double reinhard_luminance(double luminance, double white) noexcept {
  return reinhard(luminance, white);
}

void apply(const Stage& stage, Band band, StageCounts& counts) {
  std::visit([&](const auto& s) { apply_stage(s, band, counts); }, stage);
}

Rgb apply(const Stage& stage, Rgb rgb) {
  return std::visit([&](const auto& s) { return exact_stage(s, rgb); }, stage);
}

StepReport explain(const Stage& stage) {
  return std::visit([](const auto& s) { return explain_stage(s); }, stage);
}

}  // namespace tristim
