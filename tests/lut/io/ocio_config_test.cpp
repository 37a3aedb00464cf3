#include <OpenColorIO/OpenColorIO.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/lut/io/ocio.h"
#include "tristim/lut/io/ocio_config.h"

namespace tristim {
namespace {

std::vector<OcioDisplay> built_in() {
  std::vector<OcioDisplay> displays;
  for (const BuiltInDisplay& device : built_in_displays()) {
    displays.push_back({std::string(device.name), load_display(std::string(device.name))});
  }
  return displays;
}

/// A config in a folder of its own.
class ConfigFolder {
 public:
  explicit ConfigFolder(std::vector<OcioDisplay> displays) : displays_(std::move(displays)) {
    const OcioConfig config = ocio_config(displays_);
    write_bytes(path(), config.text);
    for (const OcioConfigFile& file : config.files)
      write_bytes(scratch_.file(file.name), file.bytes);
  }
  std::string path() const { return scratch_.file("config.ocio"); }
  OcioTransform view(const std::string& display, const std::string& view) const {
    return open_ocio_transform({.config = path(), .display = display, .view = view});
  }

 private:
  TemporaryDirectory scratch_;
  std::vector<OcioDisplay> displays_;
};

/// Light of linear sRGB, most of it inside the gamut, much of it dark.
std::vector<Rgb> test_light() {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> exponent(-30, 1);
  std::uniform_real_distribution<double> level(-0.1, 1.1);
  std::vector<Rgb> light{{0, 0, 0}, {1, 1, 1}, {65504, -3, 1e-8}, {1.3e-8, 1e-7, 1e-6}};
  for (int i = 0; i < 3000; ++i) {
    light.push_back({level(generator), level(generator), level(generator)});
    light.push_back({std::exp2(exponent(generator)), std::exp2(exponent(generator)),
                     std::exp2(exponent(generator))});
  }
  return light;
}

/// The device's light for picture light, from black to white, before its response.
Eigen::Vector3d device_light(const Display& display, Rgb rgb) {
  const auto as_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const Eigen::Vector3d light =
      rgb_from_rgb(display.primaries, Primaries{}, Adaptation::kBradford) *
      Eigen::Vector3d(as_float(rgb.r), as_float(rgb.g), as_float(rgb.b));
  return light.cwiseMax(0).cwiseMin(1);
}

TEST(OcioConfig, CodesAreThoseOfTheResponse) {
  std::vector<OcioDisplay> displays;
  const auto add = [&](const char* name, const Response& response) {
    Display display = load_display("srgb");
    display.primaries = load_display("crt-p22").primaries;
    display.response = response;
    displays.push_back({name, display});
  };
  add("srgb", SrgbResponse{});
  add("linear", LinearResponse{});
  add("gamma", GammaResponse{2.2});
  add("gain", GammaResponse{2.4, 0.02});
  add("k", GammaResponse{2.2, 0, 1e-5});
  add("studio", Bt1886Response{0.001});
  add("studio without black", Bt1886Response{});
  add("fitted", GogResponse{2.2, 0.05, 0.001});
  add("measured", TableResponse{{0, 64, 128, 255}, {1, 10, 35, 100}});
  const ConfigFolder folder(displays);
  for (const OcioDisplay& item : displays) {
    SCOPED_TRACE(item.name);
    const OcioTransform codes = folder.view(item.name, "Codes");
    const double black = light_of_code(item.display.response, 0, 255);
    double most = 0;
    for (const Rgb& rgb : test_light()) {
      const Eigen::Vector3d light = device_light(item.display, rgb);
      const Rgb out = codes(rgb);
      const double found[] = {out.r, out.g, out.b};
      for (int c = 0; c < 3; ++c) {
        const double emitted = black + light(c) * (1 - black);
        const double code = code_of_light(item.display.response, emitted, 255) / 255;
        most = std::max(most, std::fabs(found[c] - code));
      }
    }
    EXPECT_LE(most, 1e-4);
  }
}

// A float where two levels meet may get a value between them: of so many colours by chance few do.
TEST(OcioConfig, StepsAreThoseOfTheDevice) {
  const ConfigFolder folder(built_in());
  const std::vector<Rgb> colors = test_light();
  for (const char* name : {"crt-p22", "lcd-rgb565"}) {
    SCOPED_TRACE(name);
    const Display display = load_display(name);
    const OcioTransform codes = folder.view(name, "Codes");
    int between = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int bits = display.frame.packing.bits[c];
      const double most = std::ldexp(1.0, bits) - 1;
      const LevelScale scale = level_scale(display, bits, BlackPoint::kRelative);
      for (const Rgb& rgb : colors) {
        const Rgb out = codes(rgb);
        const double found = (c == 0 ? out.r : c == 1 ? out.g : out.b) * most;
        const auto light = static_cast<float>(device_light(display, rgb)(static_cast<int>(c)));
        const auto above = std::ranges::upper_bound(scale.threshold, light);
        const int code = scale.nearest[static_cast<std::size_t>(above - scale.threshold.begin())];
        if (std::fabs(found - code) > 1e-4 * most) ++between;
        EXPECT_LE(std::fabs(found - code), 1.01);
      }
    }
    EXPECT_LE(between, static_cast<int>(colors.size()) * 3 / 100);
  }
}

TEST(OcioConfig, ProofsAreWhatTheDeviceShows) {
  const ConfigFolder folder(built_in());
  for (const OcioDisplay& item : built_in()) {
    SCOPED_TRACE(item.name);
    const OcioTransform proof = folder.view(item.name, "Proof");
    const Rgb black = proof({0, 0, 0});
    const Rgb white = proof({1, 1, 1});
    EXPECT_NEAR(white.g, 1, 1e-3);
    EXPECT_GE(black.g, 0);
    EXPECT_LE(black.g, 0.6);
    for (const double grey : {0.0, 0.2, 0.5, 1.0}) {
      const Rgb out = proof({grey, grey, grey});
      EXPECT_GE(out.g, black.g);
      if (item.display.palette.empty() && item.display.frame.packing.samples == 3) {
        EXPECT_NEAR(out.r, out.b, 0.03) << "greys stay grey";
      }
    }
  }
  const Rgb half = folder.view("srgb", "Proof")({0.5, 0.25, 0.75});
  EXPECT_NEAR(half.r, srgb_encode(0.5), 1e-5);
  EXPECT_NEAR(half.g, srgb_encode(0.25), 1e-5);
}

TEST(OcioConfig, IsValidForOciocheck) {
  const ConfigFolder folder(built_in());
  const CommandResult check = run_command({"ociocheck", "--iconfig", folder.path()});
  if (check.exit_code == 127) GTEST_SKIP() << "no ociocheck";
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_NE(check.out.find("Tests complete."), std::string::npos);
  EXPECT_EQ(check.out.find("ERROR"), std::string::npos) << check.out;
}

TEST(OcioConfig, RefusesNamesTwice) {
  const OcioDisplay one{"a", {}};
  EXPECT_EQ(error_text([&] {
              ocio_config(std::vector{one, one});
            }),
            "invalid: ocio_config: two displays are called a");
  EXPECT_EQ(error_text([&] { ocio_config({}); }), "invalid: ocio_config: no displays");
}

TEST(OpenOcioTransform, SaysWhatTheConfigHas) {
  const std::vector<OcioDisplay> displays{{"srgb", load_display("srgb")},
                                          {"crt-p22", load_display("crt-p22")}};
  const ConfigFolder folder(displays);
  const auto refusal = [&](OcioRequest request) {
    request.config = folder.path();
    std::string text = error_text([&] { open_ocio_transform(request); });
    const std::size_t at = text.find(folder.path());
    return at == std::string::npos ? text : text.replace(at, folder.path().size(), "CONFIG");
  };
  EXPECT_EQ(refusal({.display = "crt-p2"}),
            "2 --display: CONFIG has no 'crt-p2'; did you mean crt-p22? It has srgb, crt-p22");
  EXPECT_EQ(refusal({.display = "srgb", .view = "Code"}),
            "2 --view: display srgb has no 'Code'; did you mean Codes? It has Codes, Proof");
  EXPECT_EQ(refusal({.from = "x", .to = "Raw"}).substr(0, 50),
            "2 --from: CONFIG has no 'x'; use one of: Linear sR");
  EXPECT_EQ(refusal({.to = "srgb code"}).substr(0, 62),
            "2 --to: CONFIG has no 'srgb code'; did you mean srgb Codes? It");
  EXPECT_EQ(error_text([] { open_ocio_transform({.config = "/no/such.ocio"}); }),
            "1 /no/such.ocio: there is no such file; check the name");
  const TemporaryDirectory scratch;
  write_bytes(scratch.file("bad.ocio"), "ocio_profile_version: 99\n");
  EXPECT_EQ(error_text([&] {
              open_ocio_transform({.config = scratch.file("bad.ocio")});
            }).substr(0, scratch.file("bad.ocio").size() + 28),
            "3 " + scratch.file("bad.ocio") + ": OpenColorIO refuses it: ");
}

TEST(OpenOcioTransform, GoesFromSpaceToSpace) {
  const std::vector<OcioDisplay> displays{{"srgb", load_display("srgb")}};
  const ConfigFolder folder(displays);
  const OcioTransform transform =
      open_ocio_transform({.config = folder.path(), .from = "linear bt2020", .to = "scene_linear"});
  const Eigen::Vector3d expected =
      rgb_from_rgb(Primaries{}, find_by_name(primaries_list(), "bt2020")->primaries,
                   Adaptation::kBradford) *
      Eigen::Vector3d(0.1, 0.9, 0.3);
  const Rgb out = transform({0.1, 0.9, 0.3});
  EXPECT_NEAR(out.r, expected(0), 1e-6);
  EXPECT_NEAR(out.g, expected(1), 1e-6);
  EXPECT_NEAR(out.b, expected(2), 1e-6);
}

}  // namespace
}  // namespace tristim
