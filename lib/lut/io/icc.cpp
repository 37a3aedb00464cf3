#include <lcms2.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kMostCode = 65535;
constexpr int kFormulaEntries = 1024;  // of a vcgt that is a formula
constexpr cmsUInt32Number kMostTable = 65536;
constexpr int kResponseEntries = 4096;

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

struct FreeCurve {
  void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
using ToneCurve = std::unique_ptr<cmsToneCurve, FreeCurve>;

template <typename Pointer>
Pointer checked(Pointer pointer) {
  if (!pointer) throw std::bad_alloc();  // nothing else can fail
  return pointer;
}

void check_done(cmsBool done) {
  if (done == 0) throw std::bad_alloc();
}

// A table as it stands; a formula (gamma with ends) is sampled.
int entries_of(const std::array<const cmsToneCurve*, 3>& curves) {
  cmsUInt32Number most = 2;
  for (const cmsToneCurve* curve : curves) {
    if (cmsGetToneCurveParametricType(curve) != 0) return kFormulaEntries;
    most = std::max(most, cmsGetToneCurveEstimatedTableEntries(curve));
  }
  return static_cast<int>(std::min(most, kMostTable));
}

// Entry `i` of `size` of a curve: exactly where it has as many.
float entry_of(const cmsToneCurve* curve, std::size_t i, std::size_t size) {
  const bool table = cmsGetToneCurveParametricType(curve) == 0;
  if (table && cmsGetToneCurveEstimatedTableEntries(curve) == size) {
    return static_cast<float>(cmsGetToneCurveEstimatedTable(curve)[i]) /
           static_cast<float>(kMostCode);
  }
  const float x = static_cast<float>(i) / static_cast<float>(size - 1);
  return std::clamp(cmsEvalToneCurveFloat(curve, x), 0.0F, 1.0F);
}

void append_big(std::string& bytes, unsigned value, int count) {
  for (int byte = count - 1; byte >= 0; --byte) {
    bytes += static_cast<char>(value >> (8 * byte) & 0xff);
  }
}

// The tag as Apple defines it [VCGT]; the library would make it 256 entries.
std::string vcgt_tag(const Lut1D& curves) {
  std::string tag = "vcgt";
  append_big(tag, 0, 4);
  append_big(tag, 0, 4);  // a table
  append_big(tag, 3, 2);
  append_big(tag, static_cast<unsigned>(curves.size), 2);
  append_big(tag, 2, 2);  // bytes an entry
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = c; i < curves.rgb.size(); i += 3) {
      append_big(tag, table_code(curves.rgb[i], kMostCode), 2);
    }
  }
  return tag;
}

// Light of the code relative to the device's black and white.
ToneCurve response_curve(const Response& response) {
  std::vector<cmsUInt16Number> light;
  const double black = light_of_code(response, 0, 1);
  for (int i = 0; i < kResponseEntries; ++i) {
    const double code = i / static_cast<double>(kResponseEntries - 1);
    const double relative = (light_of_code(response, code, 1) - black) / (1 - black);
    light.push_back(table_code(static_cast<float>(relative), kMostCode));
  }
  return checked(ToneCurve(cmsBuildTabulatedToneCurve16(nullptr, kResponseEntries, light.data())));
}

Profile display_profile(const Display& display) {
  const auto point = [](const Chromaticity& c) { return cmsCIExyY{c.x, c.y, 1}; };
  const cmsCIExyY white = point(display.primaries.white);
  const cmsCIExyYTRIPLE primaries{point(display.primaries.red), point(display.primaries.green),
                                  point(display.primaries.blue)};
  const ToneCurve red = response_curve(response_of(display, 0));
  const ToneCurve green = response_curve(response_of(display, 1));
  const ToneCurve blue = response_curve(response_of(display, 2));
  cmsToneCurve* const curves[3] = {red.get(), green.get(), blue.get()};
  return checked(Profile(cmsCreateRGBProfile(&white, &primaries, curves)));
}

void write_text(const Profile& profile, cmsTagSignature tag, const std::string& words) {
  struct FreeText {
    void operator()(cmsMLU* text) const { cmsMLUfree(text); }
  };
  const auto text = checked(std::unique_ptr<cmsMLU, FreeText>(cmsMLUalloc(nullptr, 1)));
  check_done(cmsMLUsetASCII(text.get(), "en", "US", words.c_str()));
  check_done(cmsWriteTag(profile.get(), tag, text.get()));
}

std::string ascii(std::string_view text) {
  std::string out = one_line(text);
  std::ranges::replace_if(
      out, [](char c) { return static_cast<unsigned char>(c) > 0x7e; }, '?');
  return out;
}

}  // namespace

// The curves of the tag 'vcgt' [VCGT], which go into the graphics card.
Lut read_icc(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  const Profile profile(
      cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
  if (!profile) throw Error(ErrorKind::kContent, file, "is no ICC profile, or damaged");
  if (cmsIsTag(profile.get(), cmsSigVcgtTag) == 0) {
    throw Error(ErrorKind::kContent, file, "has no curves for the graphics card (vcgt)",
                "give the profile of a calibrated display");
  }
  const auto* const tag =
      static_cast<cmsToneCurve* const*>(cmsReadTag(profile.get(), cmsSigVcgtTag));
  if (tag == nullptr) {
    throw Error(ErrorKind::kContent, file, "has a damaged tag vcgt", "write or copy it again");
  }
  const std::array<const cmsToneCurve*, 3> channels{tag[0], tag[1], tag[2]};
  Lut1D curves{{}, entries_of(channels), {}};
  const auto size = static_cast<std::size_t>(curves.size);
  for (std::size_t i = 0; i < 3 * size; ++i) {
    curves.rgb.push_back(entry_of(channels[i % 3], i / 3, size));
  }
  return {"", {std::move(curves)}};
}

// A profile of a display with these curves in its graphics card.
std::string write_icc(const Lut& lut, const LutFileOptions& options) {
  const Display srgb;
  const Display& display = options.display != nullptr ? *options.display : srgb;
  const Profile profile = display_profile(display);
  const std::string title = !lut.title.empty() ? lut.title : display.name;
  write_text(profile, cmsSigProfileDescriptionTag, ascii(title.empty() ? "tristim" : title));
  write_text(profile, cmsSigCopyrightTag, "No copyright, use freely");
  const std::string tag = vcgt_tag(*parts_of(lut).curves);
  check_done(cmsWriteRawTag(profile.get(), cmsSigVcgtTag, tag.data(),
                            static_cast<cmsUInt32Number>(tag.size())));
  cmsUInt32Number size = 0;
  check_done(cmsSaveProfileToMem(profile.get(), nullptr, &size));
  std::string bytes(size, '\0');
  check_done(cmsSaveProfileToMem(profile.get(), bytes.data(), &size));
  // The time of writing, in bytes 24 to 35 [ICC 7.2]: the same table gives the same file.
  constexpr std::string_view kDate("\x07\xd0\0\1\0\1\0\0\0\0\0\0", 12);  // 2000-01-01
  return bytes.replace(24, kDate.size(), kDate);
}

}  // namespace tristim::detail
