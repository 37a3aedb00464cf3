#include "tristim/device/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/error_text.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

// A display's luminances at `rows` codes from 0 to 255.
TableResponse measured(const GogResponse& display, double white, int rows) {
  TableResponse table;
  for (int i = 0; i < rows; ++i) {
    const double code = std::round(255.0 * i / (rows - 1));
    table.code.push_back(code);
    table.luminance.push_back(white * light_of_code(display, code, 255));
  }
  return table;
}

struct Case {
  const char* model;
  GogResponse display;
};
const Case kCases[] = {
    {"gamma", {2.2, 0, 0}},  {"gamma", {1.0, 0, 0}},   {"gamma-black", {2.35, 0, 0.01}},
    {"gog", {2.4, 0.08, 0}}, {"gog", {1.9, -0.06, 0}}, {"gog-black", {2.2, -0.05, 0.004}},
};

TEST(FitResponse, FindsTheFiguresThatTheDisplayHas) {
  for (const Case& c : kCases) {
    for (const int rows : {9, 18, 52}) {
      SCOPED_TRACE(std::string(c.model) + " " + std::to_string(rows));
      const ResponseFit fit = fit_response(measured(c.display, 180, rows), 255);
      EXPECT_EQ(fit.model->name, c.model);
      EXPECT_NEAR(fit.response.gamma, c.display.gamma, 1e-5);
      EXPECT_NEAR(fit.response.offset, c.display.offset, 1e-5);
      EXPECT_NEAR(fit.response.black, c.display.black, 1e-6);
      EXPECT_NEAR(fit.white, 180, 1e-4);
      EXPECT_NEAR(fit.black, 180 * c.display.black, 1e-4);
      EXPECT_LT(fit.largest_lstar, 1e-4);
      ASSERT_EQ(fit.residuals.size(), static_cast<std::size_t>(rows));
    }
  }
}

// The document's K of I = K V^gamma is Lw Vmax^-gamma.
TEST(FitResponse, GivesTheDocumentsK) {
  const ResponseFit fit = fit_response(measured({2.2, 0, 0}, 80, 18), 255);
  EXPECT_NEAR(fit.k, 80 * std::pow(255, -2.2), 1e-10);
  const ResponseFit lifted = fit_response(measured({2.0, 0.1, 0.01}, 80, 18), 255);
  const double gain = 0.9;
  const double v = 128 + 0.1 / gain * 255;
  EXPECT_NEAR(lifted.black + lifted.k * std::pow(v, 2.0),
              80 * light_of_code(GogResponse{2.0, 0.1, 0.01}, 128, 255), 1e-4);
}

TEST(FitResponse, TellsWhatItLeavesOver) {
  // 1 % of noise, as a meter has.
  std::mt19937 random(7);
  TableResponse noisy = measured({2.2, 0.05, 0}, 100, 18);
  for (double& y : noisy.luminance) y *= 1 + 0.01 * (double(random() % 2001) / 1000 - 1);
  const ResponseFit fit = fit_response(noisy, 255, find_by_name(kFitModels, "gog"));
  EXPECT_NEAR(fit.response.gamma, 2.2, 0.1);
  EXPECT_GT(fit.rms_lstar, 0.01);
  EXPECT_LT(fit.largest_lstar, 1);
  double squares = 0;
  double largest = 0;
  for (const FitResidual& r : fit.residuals) {
    squares += r.lstar * r.lstar;
    largest = std::max(largest, r.ciede2000);
  }
  EXPECT_DOUBLE_EQ(fit.rms_lstar, std::sqrt(squares / 18));
  EXPECT_EQ(fit.largest_ciede2000, largest);
}

TEST(FitResponse, IsBadWhereTheDisplayIsNoPower) {
  TableResponse knee{{}, {}};
  for (int i = 0; i <= 16; ++i) {
    knee.code.push_back(16 * i > 255 ? 255 : 16 * i);
    knee.luminance.push_back(i < 8 ? 1 + 0.2 * i : 2.4 + 12 * (i - 7));
  }
  EXPECT_GT(fit_response(knee, 255).largest_ciede2000, kGoodFit);
}

TEST(FitResponse, TakesTheSimplestWhereRowsAreFew) {
  const ResponseFit fit = fit_response({{0, 128, 255}, {0, 20, 90}}, 255);
  EXPECT_EQ(fit.model->name, "gamma");
}

TEST(FitResponse, RefusesWhatCannotBeFitted) {
  const TableResponse two{{0, 255}, {0, 1}};
  EXPECT_EQ(error_text([&] { fit_response(two, 255, find_by_name(kFitModels, "gog")); }),
            "invalid: rows: 2 are too few for the 3 figures of gog");
  EXPECT_EQ(error_text([&] { fit_response(two, 127); }),
            "invalid: Vmax: 127 is below the code 255");
  EXPECT_EQ(error_text([] {
              fit_response({{0, 1}, {3, 2}}, 255);
            }),
            "invalid: table: luminance falls from 3 at code 0 to 2 at code 1");
}

}  // namespace
}  // namespace tristim
