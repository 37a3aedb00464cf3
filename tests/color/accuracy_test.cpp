// The largest errors of the conversions, measured against 113-bit arithmetic, beside their bounds:
// docs/accuracy.md. TRISTIM_WRITE_ACCURACY=1 writes the page anew; TRISTIM_FULL_SWEEP=1 (or a
// stride) lets the last tests take every float and every 8-bit colour.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/color/accuracy_models.h"
#include "tests/support.h"
#include "tristim/color/rows.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using reference::Colour;
using reference::Quad;
using reference::Three;

using Sampler = Components (*)(std::mt19937_64& random);

enum class Unit { kLastPlace, kAbsolute, kDegrees };

// A conversion, what it should give, and how far from that it may be in double and in float rows.
struct Measured {
  std::string title, from, to;
  std::function<Colour(const Three&)> exact;
  Sampler sample;
  Unit unit;
  double double_bound, float_bound;
};

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

// In the cube; an eighth of the components is tiny.
Components in_cube(std::mt19937_64& random) {
  Components c{};
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = uniform(random, 0, 1);
    if (random() % 8 == 0) c[k] = std::exp2(uniform(random, -20, 0));
  }
  return c;
}

// About the cube, with small and large numbers that a curve takes.
Components on_curve(std::mt19937_64& random) {
  Components c{};
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = random() % 2 == 0 ? uniform(random, 0, 1.9) : std::exp2(uniform(random, -30, 0.9));
  }
  return c;
}

Components in_lab(std::mt19937_64& random) {
  return {uniform(random, 0, 100), uniform(random, -80, 80), uniform(random, -80, 80), 0};
}

Components in_hsv(std::mt19937_64& random) {
  return {uniform(random, 0, 360), uniform(random, 0, 1), uniform(random, 0, 1), 0};
}

std::vector<Measured> measured_curves() {
  std::vector<Measured> all;
  for (const TransferFunction& curve : kTransferFunctions) {
    if (curve.name == "linear") continue;
    for (const bool encodes : {true, false}) {
      const std::string model = "rgb:srgb/" + std::string(curve.name);
      const auto exact = [name = curve.name, encodes](const Three& c) {
        const auto term = [&](Quad x) { return reference::curve<Quad>(name, encodes, x); };
        return reference::colour(term(c[0]), term(c[1]), term(c[2]));
      };
      all.push_back({std::string(curve.name) + (encodes ? " encode" : " decode"),
                     encodes ? "linear:srgb" : model, encodes ? model : "linear:srgb", exact,
                     on_curve, Unit::kLastPlace, 2, 2});
    }
  }
  return all;
}

std::vector<Measured> measured_models() {
  const auto matrix = reference::xyz_from_rgb(Primaries{});
  const auto to_xyz = [matrix](const Three& c) { return reference::times(matrix, c); };
  const auto from_xyz = [inverse = reference::inverse(matrix)](const Three& c) {
    return reference::times(inverse, c);
  };
  const auto through = [to_xyz](Colour (*next)(const Three&)) {
    return [to_xyz, next](const Three& c) { return next(to_xyz(c).value); };
  };
  std::vector<Measured> all{
      {"RGB to XYZ", "linear", "xyz", to_xyz, in_cube, Unit::kLastPlace, 12, 1.5},
      {"XYZ to RGB", "xyz", "linear", from_xyz, in_cube, Unit::kLastPlace, 12, 1.5},
      {"XYZ to Lab", "xyz", "lab", reference::lab, in_cube, Unit::kAbsolute, 1e-13 * 5, 4e-5},
      {"XYZ to Luv", "xyz", "luv", reference::luv, in_cube, Unit::kAbsolute, 1e-12, 4e-5},
      {"linear RGB to Lab", "linear", "lab", through(reference::lab), in_cube, Unit::kAbsolute,
       2e-13, 4e-5},
      {"linear RGB to Luv", "linear", "luv", through(reference::luv), in_cube, Unit::kAbsolute,
       2e-13, 4e-5},
      {"Lab to XYZ", "lab", "xyz", reference::xyz_of_lab, in_lab, Unit::kLastPlace, 8, 2},
      {"linear RGB to Oklab", "linear", "oklab", reference::oklab, in_cube, Unit::kLastPlace, 4, 2},
      {"RGB to HSV, hue", "rgb", "hsv", reference::hsv, in_cube, Unit::kDegrees, 1e-13, 2.3e-5},
      {"RGB to HSV, S and V", "rgb", "hsv", reference::hsv, in_cube, Unit::kLastPlace, 2, 1.5},
      {"HSV to RGB", "hsv", "rgb", reference::rgb_of_hsv, in_hsv, Unit::kLastPlace, 4, 1.5},
      {"RGB to HLS, hue", "rgb", "hls", reference::hls, in_cube, Unit::kDegrees, 1e-13, 2.3e-5},
      {"RGB to HLS, L and S", "rgb", "hls", reference::hls, in_cube, Unit::kLastPlace, 4, 1.5},
  };
  for (const YiqSystem& system : kYiqSystems) {
    all.push_back({"RGB to YIQ, " + std::string(system.name), "rgb",
                   "yiq:" + std::string(system.name),
                   [&system](const Three& c) { return reference::yiq(c, system); }, in_cube,
                   Unit::kLastPlace, 2.5, 1.5});
  }
  return all;
}

// An error, and the pixel where it is.
struct Largest {
  double error = 0;
  Components at{};

  void add(double e, const Components& c) {
    if (e <= error) return;
    error = e;
    at = c;
  }
};

// Which components count for a unit: hues in degrees, and all others.
bool counts(const Measured& m, const ColorModel& to, std::size_t k) {
  const bool hue = to.hue == static_cast<int>(k);
  return m.unit == Unit::kDegrees ? hue : !hue;
}

double error_of(const Measured& m, double ours, Quad exact, Quad largest, int digits) {
  const auto difference =
      static_cast<double>(reference::magnitude(static_cast<Quad>(ours) - exact));
  if (m.unit != Unit::kLastPlace) return difference;
  return difference / std::ldexp(1.0, std::ilogb(static_cast<double>(largest)) - (digits - 1));
}

constexpr int kPixels = 3000;

ModelReference model(const std::string& name) { return parse_model(name, "accuracy"); }

Largest double_error(const Measured& m) {
  const ColorConversion conversion(model(m.from), model(m.to), Adaptation::kNone);
  std::mt19937_64 random(1);
  Largest largest;
  for (int i = 0; i < kPixels; ++i) {
    const Components c = m.sample(random);
    const Components ours = conversion(c);
    const Colour exact = m.exact({c[0], c[1], c[2]});
    for (std::size_t k = 0; k < 3; ++k) {
      if (!counts(m, conversion.to(), k)) continue;
      largest.add(error_of(m, ours[k], exact.value[k], exact.largest[k], 53), c);
    }
  }
  return largest;
}

Largest float_error(const Measured& m) {
  const RowConversion rows(model(m.from), model(m.to), Adaptation::kNone);
  std::mt19937_64 random(2);
  Largest largest;
  for (int i = 0; i < kPixels; ++i) {
    const Components c = m.sample(random);
    const float in[] = {float(c[0]), float(c[1]), float(c[2])};
    float out[3];
    rows(in, 3, out, 3);
    const Colour exact = m.exact({in[0], in[1], in[2]});
    for (std::size_t k = 0; k < 3; ++k) {
      if (!counts(m, rows.conversion().to(), k)) continue;
      largest.add(error_of(m, out[k], exact.value[k], exact.largest[k], 24), {in[0], in[1], in[2]});
    }
  }
  return largest;
}

std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

std::string cell(const Largest& largest, double bound, Unit unit) {
  constexpr const char* kUnits[] = {" ulp", "", "°"};
  const std::string name = kUnits[static_cast<int>(unit)];
  std::string at;
  for (std::size_t k = 0; k < 3; ++k) {
    char text[32];
    std::snprintf(text, sizeof text, "%s%.6g", k > 0 ? " " : "", largest.at[k]);
    at += text;
  }
  return " " + short_text(largest.error) + name + " | " + short_text(bound) + name + " | " + at +
         " |";
}

// A row of the page; says where a bound is broken.
std::string measure(const Measured& m) {
  const Largest in_double = double_error(m);
  const Largest in_float = float_error(m);
  EXPECT_LE(in_double.error, m.double_bound) << m.title;
  EXPECT_LE(in_float.error, m.float_bound) << m.title;
  return "| " + m.title + " |" + cell(in_double, m.double_bound, m.unit) +
         cell(in_float, m.float_bound, m.unit) + "\n";
}

std::string page() {
  std::string text =
      "# Accuracy\n\n"
      "Largest errors measured against 113-bit arithmetic, beside the bound that a test holds them "
      "to. `ulp` is a unit in the last\nplace of the largest term of the formula; Lab and Luv are "
      "in their own units, hues in degrees. *at* is the colour with the\nlargest error.\n\n"
      "`tests/color/accuracy_test.cpp` measures, compares this page and, with "
      "`TRISTIM_WRITE_ACCURACY=1`, writes it: " +
      std::to_string(kPixels) +
      " colours\na row, in and about the cube. With `TRISTIM_FULL_SWEEP=1` it runs every curve "
      "over "
      "all floats and takes all 16.7 million\n8-bit colours to every model and back.\n\n"
      "| conversion | double | bound | at | float rows | bound | at "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const Measured& m : measured_curves()) text += measure(m);
  for (const Measured& m : measured_models()) text += measure(m);
  return text;
}

TEST(Accuracy, IsWithinItsBoundsAndAsThePageSays) {
  const std::string measured = page();
  const std::filesystem::path path = source_file("docs/accuracy.md");
  if (std::getenv("TRISTIM_WRITE_ACCURACY") != nullptr) write_bytes(path, measured);
  EXPECT_EQ(read_bytes(path), measured) << "write it anew: TRISTIM_WRITE_ACCURACY=1";
}

// How many floats or codes a sweep leaves out between two; the environment's 1 takes all.
std::uint32_t stride(std::uint32_t usual) {
  const char* text = std::getenv("TRISTIM_FULL_SWEEP");
  const auto wanted = text == nullptr ? std::nullopt : parse_integer(text);
  return wanted && *wanted > 0 ? static_cast<std::uint32_t>(*wanted) : usual;
}

// Errors of a curve in floats against the formula in double, which is 10^8 times as fine.
double largest_curve_error(const TransferFunction& curve, bool encodes, std::uint32_t step) {
  constexpr std::uint64_t kEnd = 0x7f800000;  // of the finite floats from 0 on
  const std::string name = "rgb:srgb/" + std::string(curve.name);
  const RowConversion rows(model(encodes ? "linear:srgb" : name),
                           model(encodes ? name : "linear:srgb"), Adaptation::kNone);
  double largest = 0;
  std::vector<float> in(3 * 1024), out(in.size());
  for (std::uint64_t bits = 0; bits < kEnd;) {
    for (float& x : in) {
      x = std::bit_cast<float>(static_cast<std::uint32_t>(std::min(bits, kEnd - 1)));
      bits += step;
    }
    rows(in, 3, out, 3);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const bool coarse = curve.name == "pq" && !encodes && (in[i] < 1e-3F || in[i] > 1.9F);
      const auto exact = coarse ? reference::just(pq_decode(in[i]))
                                : reference::curve<double>(curve.name, encodes, in[i]);
      if (!(std::fabs(exact.value) < 3.4e38)) {
        if (!(out[i] >= 3.4e38F)) return 1e9;
        continue;
      }
      const int exponent = std::max(std::ilogb(exact.largest), -126);
      largest = std::max(largest, std::fabs(out[i] - exact.value) / std::ldexp(1.0, exponent - 23));
    }
  }
  return largest;
}

TEST(Accuracy, OfCurvesHoldsOverAllFloats) {
  for (const TransferFunction& curve : kTransferFunctions) {
    for (const bool encodes : {true, false}) {
      SCOPED_TRACE(std::string(curve.name) + (encodes ? " encode" : " decode"));
      const double error = largest_curve_error(curve, encodes, stride(200003));
      EXPECT_LE(error, 0.501);  // half an ulp is the rounding to float
      if (std::getenv("TRISTIM_FULL_SWEEP") != nullptr) {
        std::printf("%s %s %.4f\n", std::string(curve.name).c_str(), encodes ? "encode" : "decode",
                    error);
      }
    }
  }
}

TEST(Accuracy, OfRowsKeepsEightBitColors) {
  const std::uint32_t step = stride(20011);
  std::vector<float> in(3 * 4096), out(in.size()), back(in.size());
  for (const std::string name : {"hsv", "hls", "yiq", "xyz", "lab", "luv", "lch", "oklab"}) {
    SCOPED_TRACE(name);
    const RowConversion there(model("rgb:srgb"), model(name), Adaptation::kNone);
    const RowConversion home(model(name), model("rgb:srgb"), Adaptation::kNone);
    for (std::uint32_t color = 0; color < 1U << 24;) {
      for (std::size_t i = 0; i < in.size(); i += 3, color += step) {
        const std::uint32_t c = std::min(color, (1U << 24) - 1);
        in[i] = static_cast<float>((c >> 16) / 255.0);
        in[i + 1] = static_cast<float>((c >> 8 & 255) / 255.0);
        in[i + 2] = static_cast<float>((c & 255) / 255.0);
      }
      there(in, 3, out, 3);
      home(out, 3, back, 3);
      for (std::size_t i = 0; i < in.size(); ++i) {
        ASSERT_EQ(std::floor(255 * back[i] + 0.5F), std::floor(255 * in[i] + 0.5F));
      }
    }
  }
}

}  // namespace
}  // namespace tristim
