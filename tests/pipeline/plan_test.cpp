#include "tristim/pipeline/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lib/pipeline/stage_rows.h"
#include "tests/pipeline/pictures.h"
#include "tristim/core/find.h"
#include "tristim/core/instruction_sets.h"
#include "tristim/core/text.h"
#include "tristim/dither/method.h"
#include "tristim/pipeline/run.h"

namespace tristim {
namespace {

using Codes = std::vector<std::uint16_t>;

const ConvertPrimaries kToD50{.matrix = rgb_from_rgb({}, {.white = kD50}, Adaptation::kBradford)};

TEST(Plan, MultipliesNeighboursIntoOneMatrix) {
  const std::vector<Stage> stages{Exposure{1}, kToD50, Exposure{-2}, GamutMap{}};
  const Plan plan = plan_chain(stages, false);
  ASSERT_EQ(plan.passes.size(), 2U);
  EXPECT_EQ(plan.passes[0].stages, "exposure, primaries, exposure");
  const Eigen::Matrix3d product = kToD50.matrix / 2;
  EXPECT_EQ(std::get<Multiply>(plan.passes[0].work).matrix, product.cast<float>());
  EXPECT_TRUE(std::holds_alternative<GamutMap>(plan.passes[1].work));
}

TEST(Plan, DoesNotMultiplyAcrossACurve) {
  const std::vector<Stage> stages{Exposure{1}, ToneMap{}, kToD50, GamutMap{}};
  const Plan plan = plan_chain(stages, true);
  ASSERT_EQ(plan.passes.size(), 2U);
  EXPECT_EQ(plan.passes[0].stages, "exposure");
  EXPECT_EQ(plan.passes[1].stages, "tone map reinhard");
  EXPECT_EQ(plan.lead.stages, "primaries, gamut map clip");
  EXPECT_TRUE(plan.lead.clip);
  ASSERT_TRUE(plan.lead.multiply);
  EXPECT_EQ(plan.lead.multiply->matrix, kToD50.matrix.cast<float>());
}

TEST(Plan, LeavesOutWhatChangesNothing) {
  EXPECT_TRUE(plan_chain(std::vector<Stage>{Exposure{0}, ConvertPrimaries{}}, true).passes.empty());
  EXPECT_TRUE(plan_chain(std::vector<Stage>{Exposure{3}, Exposure{-3}}, false).passes.empty());
  const Plan plan = plan_chain(std::vector<Stage>{GamutMap{kDesaturate}}, true);
  EXPECT_EQ(plan.passes.size(), 1U);  // not by itself a clip
  EXPECT_FALSE(plan.lead.clip);
}

// The passes in plain numbers: one product, rounded to floats once, then the sums from the left.
TEST(Plan, GivesTheLightOfItsProduct) {
  const std::vector<Stage> stages{Exposure{0.3}, kToD50};
  const Eigen::Matrix3f m = (kToD50.matrix * std::pow(2.0, 0.3)).cast<float>();
  Image light = test_picture(37, 5);
  Image expected = test_picture(37, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 37; ++x) {
      float* p = expected.view().pixel(x, y);
      const float in[3] = {p[0], p[1], p[2]};
      for (int k = 0; k < 3; ++k) p[k] = m(k, 0) * in[0] + m(k, 1) * in[1] + m(k, 2) * in[2];
    }
  }
  StageCounts counts;
  apply(plan_chain(stages, false), {light.view(), 0, {}}, counts);
  for (int y = 0; y < 5; ++y) {
    const auto row = light.view().row(y);
    EXPECT_TRUE(std::ranges::equal(row, expected.view().row(y)));
  }
}

// A lead gives the codes and the counts that the passes by themselves do.
TEST(Plan, LeadIsWhatThePassesAre) {
  const std::vector<Stage> stages{Exposure{0.5}, kToD50, GamutMap{}};
  for (const char* packing : {"rgb888", "rgb565", "rgb332"}) {
    Display display;
    display.frame.packing = *find_by_name(kPackings, packing);
    for (const char* dither : {"none", "bayer8", "blue-noise", "floyd-steinberg"}) {
      SCOPED_TRACE(std::string(packing) + " " + dither);
      const ReduceOptions options{.dither = find_by_name(dither_methods(), dither)->method};
      for (const int width : {1, 7, 511, 513, 1200}) {
        Image one = test_picture(width, 3);
        Image other = test_picture(width, 3);
        Raster<std::uint16_t> led(width, 3, 3);
        Raster<std::uint16_t> apart(width, 3, 3);
        Reducer reducer(display, options, width);
        ASSERT_TRUE(reducer.leads());
        const Plan plan = plan_chain(stages, true);
        EXPECT_TRUE(plan.passes.empty());
        StageCounts led_counts = reducer.prepare({one.view(), 0, {}}, led.view(), plan.lead);
        for (int c = 0; c < reducer.chains(); ++c) {
          reducer.advance(c, {one.view(), 0, {}}, led.view());
        }
        reducer.finish(led.view());
        StageCounts counts;
        apply(plan_chain(stages, false), {other.view(), 0, {}}, counts);
        Reducer(display, options, width).reduce({other.view(), 0, {}}, apart.view());
        EXPECT_EQ(led_counts, counts);
        for (int y = 0; y < 3; ++y) {
          ASSERT_TRUE(std::ranges::equal(led.view().row(y), apart.view().row(y))) << width;
        }
      }
    }
  }
}

// Looks at the light between exposure and primaries, which are one matrix.
class Watcher : public BandObserver {
 public:
  int light_after() const noexcept override { return 1; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t>) override {
    first = light.row(0)[0];
  }
  float first = 0;
};

TEST(Run, CodesDoNotDependOnObservers) {
  const std::vector<Stage> stages{Exposure{1}, kToD50, GamutMap{}};
  Codes codes[2];
  Watcher watcher;
  for (const bool watched : {false, true}) {
    ImageSource source(test_picture(64, 1));
    Reducer reducer(Display{}, {}, 64);
    CodeCollector sink;
    BandObserver* const observers[] = {&watcher};
    run(source, stages, reducer, sink, std::span(observers).first(watched ? 1 : 0));
    codes[watched ? 1 : 0] = sink.codes;
  }
  EXPECT_EQ(codes[0], codes[1]);
  const Image picture = test_picture(64, 1);
  EXPECT_EQ(watcher.first, 2 * picture.view().row(0)[0]);
}

TEST(Plan, ExplainsItsPasses) {
  const std::vector<Stage> stages{Exposure{1}, ToneMap{}, GamutMap{}};
  const StepReport step = explain(plan_chain(stages, true), "response, dither none");
  const std::vector<std::pair<std::string, std::string>> expected{
      {"pass 1", "exposure"},
      {"matrix of 1", "2 0 0; 0 2 0; 0 0 2"},
      {"pass 2", "tone map reinhard"},
      {"pass 3", "gamut map clip, response, dither none"},
      {"instruction set", chosen_instruction_set().name}};
  EXPECT_EQ(step.numbers, expected);
}

TEST(StageKernels, SplitAlikeInEveryInstructionSet) {
  const float odd[] = {-INFINITY,  -1e-9F, -0.0F, 0,   1e-40F, 0.5F,     1,
                       1.0000001F, 65504,  0.25F, NAN, 0.75F,  INFINITY, 0.125F};
  Eigen::Matrix3f full;
  full << 1.2F, -0.3F, 0.1F, 0.01F, 0.9F, 0.09F, -0.5F, 0.2F, 1.3F;
  const detail::RowMatrix matrices[] = {
      detail::RowMatrix({full}),
      detail::RowMatrix({Eigen::Vector3f(2, 0.5F, 1).asDiagonal().toDenseMatrix()})};
  EXPECT_FALSE(matrices[0].diagonal);
  EXPECT_TRUE(matrices[1].diagonal);
  for (const detail::RowMatrix* matrix : {&matrices[0], &matrices[1]}) {
    for (const std::size_t pixels : {1U, 7U, 16U, 33U, 512U}) {
      std::vector<float> row(3 * pixels);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = odd[(i * i + i / 3) % std::size(odd)];
      const auto split = [&](const detail::StageKernels& kernels, StageCounts& counts) {
        std::vector<float> planes(3 * pixels);
        counts = kernels.split(matrix, true, row.data(), pixels,
                               {&planes[0], &planes[pixels], &planes[2 * pixels]});
        return planes;
      };
      StageCounts expected_counts;
      const auto expected = split(detail::scalar_stage_kernels(), expected_counts);
      for (const detail::StageKernels& simd : detail::simd_stage_kernels()) {
        StageCounts counts;
        EXPECT_EQ(split(simd, counts), expected) << simd.name;
        EXPECT_EQ(counts, expected_counts) << simd.name;
      }
    }
  }
}

}  // namespace
}  // namespace tristim
