#include <lcms2.h>

#include <memory>
#include <stdexcept>
#include <type_traits>

#include "bench/peers/peers.h"

namespace tristim::bench {
namespace {

struct Close {
  void operator()(void* profile) const noexcept { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<std::remove_pointer_t<cmsHPROFILE>, Close>;
using Transform = std::shared_ptr<std::remove_pointer_t<cmsHTRANSFORM>>;

Profile rgb_profile(const Primaries& primaries, cmsToneCurve* curve) {
  const auto point = [](const Chromaticity& c) { return cmsCIExyY{c.x, c.y, 1}; };
  const cmsCIExyY white = point(primaries.white);
  const cmsCIExyYTRIPLE triple = {point(primaries.red), point(primaries.green),
                                  point(primaries.blue)};
  cmsToneCurve* curves[] = {curve, curve, curve};
  Profile made(cmsCreateRGBProfile(&white, &triple, curves));
  cmsFreeToneCurve(curve);
  return made;
}

Transform transform(cmsHPROFILE from, cmsUInt32Number in, cmsHPROFILE to, cmsUInt32Number out) {
  Transform made(cmsCreateTransform(from, in, to, out, INTENT_RELATIVE_COLORIMETRIC, 0),
                 &cmsDeleteTransform);
  if (!made) throw std::runtime_error("Little CMS refuses");
  return made;
}

}  // namespace

ToBytes lcms_to_bytes(const DisplayJob& job) {
  // Type 4: (a x + b)^g from d on, below it c x.
  constexpr double kSrgb[] = {2.4, 1 / 1.055, .055 / 1.055, 1 / 12.92, .04045};
  const Profile from = rgb_profile(job.from, cmsBuildGamma(nullptr, 1));
  const Profile to = rgb_profile(Primaries{}, cmsBuildParametricToneCurve(nullptr, 4, kSrgb));
  const Transform made = transform(from.get(), TYPE_RGB_FLT, to.get(), TYPE_RGB_8);
  return [made, pixels = static_cast<cmsUInt32Number>(job.width) *
                         static_cast<cmsUInt32Number>(job.height)](
             const float* in, std::uint8_t* out) { cmsDoTransform(made.get(), in, out, pixels); };
}

FloatPixels lcms_cube(const Lut3D& cube) {
  const auto size = static_cast<std::size_t>(cube.size);
  std::vector<float> blue_fastest;  // as Little CMS has them
  for (std::size_t i = 0; i < size * size * size; ++i) {
    const std::size_t r = i / (size * size);
    const std::size_t g = i / size % size;
    const std::size_t b = i % size;
    const float* p = &cube.rgb[3 * ((b * size + g) * size + r)];
    blue_fastest.insert(blue_fastest.end(), p, p + 3);
  }
  cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, 3, 3);
  cmsPipelineInsertStage(pipeline, cmsAT_END,
                         cmsStageAllocCLutFloat(nullptr, static_cast<cmsUInt32Number>(size), 3, 3,
                                                blue_fastest.data()));
  const Profile link(cmsCreateProfilePlaceholder(nullptr));
  cmsSetProfileVersion(link.get(), 4.4);
  cmsSetDeviceClass(link.get(), cmsSigLinkClass);
  cmsSetColorSpace(link.get(), cmsSigRgbData);
  cmsSetPCS(link.get(), cmsSigRgbData);
  const bool written = cmsWriteTag(link.get(), cmsSigDToB0Tag, pipeline) != 0;
  cmsPipelineFree(pipeline);
  if (!written) throw std::runtime_error("Little CMS refuses the cube");
  const Transform made = transform(link.get(), TYPE_RGB_FLT, nullptr, TYPE_RGB_FLT);
  return [made](const float* in, float* out, int pixels) {
    cmsDoTransform(made.get(), in, out, static_cast<cmsUInt32Number>(pixels));
  };
}

}  // namespace tristim::bench
