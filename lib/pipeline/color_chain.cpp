#include "tristim/pipeline/color_chain.h"

#include "tristim/color/primaries.h"
#include "tristim/core/error.h"

namespace tristim {
namespace {

void refuse_palette(const Display& display) {
  if (display.palette.empty() && !display.frame.packing.indexed && !display.press) return;
  throw Error(ErrorKind::kMisuse, "device " + display.name,
              "has a palette: no curves lead from light to its codes",
              "choose a device whose codes are levels of channels");
}

std::vector<Stage> stages_of(const Primaries& picture, const Display& display,
                             const Settings& settings) {
  PictureInfo info;
  info.primaries = picture;
  return stage_list(info, display, settings).stages;
}

}  // namespace

DisplayDrive::DisplayDrive(const Display& display, BlackPoint black_point)
    : grey_(is_monochrome(display)), luminance_(xyz_from_rgb(display.primaries).row(1)) {
  refuse_palette(display);
  for (std::size_t c = 0; c < 3; ++c) {
    response_[c] = response_of(display, static_cast<int>(c));
    code_max_[c] = (1 << display.frame.packing.bits[grey_ ? 0 : c]) - 1;
    const double lowest = display.levels ? lowest_intensity(*display.levels)
                                         : light_of_code(response_[c], 0, code_max_[c]);
    black_[c] = black_point == BlackPoint::kRelative ? lowest : 0;
  }
}

EncodedRgb DisplayDrive::drive(Rgb light) const noexcept {
  if (grey_) {
    const double y = luminance_ * Eigen::Vector3d(light.r, light.g, light.b);
    light = {y, y, y};
  }
  const auto code = [&](std::size_t c, double picture) {
    const double emitted = black_[c] + picture * (1 - black_[c]);
    return code_of_light(response_[c], emitted, code_max_[c]) / code_max_[c];
  };
  return {code(0, light.r), code(1, light.g), code(2, light.b)};
}

Rgb DisplayDrive::light(EncodedRgb drive) const noexcept {
  const auto emitted = [&](std::size_t c, double d) {
    return light_of_code(response_[c], d * code_max_[c], code_max_[c]);
  };
  return {emitted(0, drive.r), emitted(1, drive.g), emitted(2, drive.b)};
}

Rgb DisplayDrive::picture(EncodedRgb drive) const noexcept {
  const Rgb emitted = light(drive);
  const auto relative = [&](std::size_t c, double x) { return (x - black_[c]) / (1 - black_[c]); };
  return {relative(0, emitted.r), relative(1, emitted.g), relative(2, emitted.b)};
}

ColorChain::ColorChain(const Primaries& picture, const Display& display, const Settings& settings)
    : stages_(stages_of(picture, display, settings)),
      drive_(display, settings.black_point),
      xyz_from_light_(xyz_from_rgb(display.primaries)),
      white_(white_xyz(display.primaries.white)) {}

EncodedRgb ColorChain::operator()(Rgb light) const {
  for (const Stage& stage : stages_) light = apply(stage, light);
  return drive_.drive(light);
}

Lab ColorChain::appearance(EncodedRgb drive) const noexcept {
  const Rgb light = drive_.light(drive);
  const Eigen::Vector3d xyz = xyz_from_light_ * Eigen::Vector3d(light.r, light.g, light.b);
  return xyz_to_lab({xyz.x(), xyz.y(), xyz.z()}, white_);
}

}  // namespace tristim
