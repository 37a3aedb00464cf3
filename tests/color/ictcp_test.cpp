#include "tristim/color/ictcp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/conversion.h"

namespace tristim {
namespace {

TEST(Ictcp, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/ictcp.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Rgb rgb{row.number("R"), row.number("G"), row.number("B")};
    const Ictcp c = row.text("method") == "pq" ? bt2020_to_ictcp_pq(rgb) : bt2020_to_ictcp_hlg(rgb);
    EXPECT_NEAR(c.i, row.number("I"), 2e-16);
    EXPECT_NEAR(c.ct, row.number("Ct"), 1e-15);
    EXPECT_NEAR(c.cp, row.number("Cp"), 1e-15);
  }
}

TEST(Ictcp, GreysAreExactlyNeutralAndColoursComeBack) {
  for (double v = 0; v <= 1; v += 1.0 / 64) {
    const Ictcp pq = bt2020_to_ictcp_pq({10000 * v, 10000 * v, 10000 * v});
    const Ictcp hlg = bt2020_to_ictcp_hlg({v, v, v});
    EXPECT_TRUE(pq.ct == 0 && pq.cp == 0 && hlg.ct == 0 && hlg.cp == 0);
  }
  EXPECT_EQ(bt2020_to_ictcp_pq({10000, 10000, 10000}).i, 1);
  for (const Rgb rgb : {Rgb{0.9, 0.1, 0.4}, Rgb{0.01, 0.9, 0.2}, Rgb{1, 1, 1}, Rgb{0, 0, 0.5}}) {
    const Rgb hlg = ictcp_hlg_to_bt2020(bt2020_to_ictcp_hlg(rgb));
    const Rgb pq = ictcp_pq_to_bt2020(bt2020_to_ictcp_pq({1e4 * rgb.r, 1e4 * rgb.g, 1e4 * rgb.b}));
    for (const Rgb back : {hlg, Rgb{pq.r / 1e4, pq.g / 1e4, pq.b / 1e4}}) {
      EXPECT_NEAR(back.r, rgb.r, 4e-14);  // the slope of the decoding curves, up to 40 of PQ's
      EXPECT_NEAR(back.g, rgb.g, 4e-14);
      EXPECT_NEAR(back.b, rgb.b, 4e-14);
    }
  }
  EXPECT_TRUE(std::isnan(bt2020_to_ictcp_pq({1, std::nan(""), 1}).i));
}

TEST(Ictcp, CountsCdM2UnlessAWhiteIsGiven) {
  const ColorConversion absolute(parse_model("linear:bt2020", ""), parse_model("ictcp", ""),
                                 Adaptation::kBradford);
  const ColorConversion relative(parse_model("linear:bt2020", ""),
                                 parse_model("ictcp:pq:white=203", ""), Adaptation::kBradford);
  EXPECT_EQ(absolute({203, 203, 203}), relative({1, 1, 1}));
  EXPECT_NEAR(relative({1, 1, 1})[0], 0.58, 1e-3);  // BT.2408: 203 cd/m2 is 58 % of PQ
}

}  // namespace
}  // namespace tristim
