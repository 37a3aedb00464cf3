#include "tristim/plot/chromaticity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/plot/svg_reader.h"
#include "tristim/color/wavelength.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

DiagramGamut named(std::string_view name) {
  return {std::string(name), find_by_name(primaries_list(), name)->primaries};
}

// With members set one by one: g++ 12 sees uninitialised strings in braces within braces.
ChromaticityDiagram with_colors(std::vector<DiagramColor> colors) {
  ChromaticityDiagram diagram;
  diagram.colors = std::move(colors);
  return diagram;
}

ChromaticityDiagram with_gamuts(std::vector<DiagramGamut> gamuts) {
  ChromaticityDiagram diagram;
  diagram.gamuts = std::move(gamuts);
  return diagram;
}

TEST(ChromaticityDiagram, HasAxesLocusAndTemperatures) {
  for (const ChromaticityPlane& plane : kChromaticityPlanes) {
    SCOPED_TRACE(plane.name);
    ChromaticityDiagram diagram;
    diagram.plane = &plane;
    const std::string svg = chromaticity_diagram(diagram);
    EXPECT_EQ(xml_complaint(svg), "");
    const std::string title = ">CIE " + std::string(plane.name) + " chromaticity diagram<";
    EXPECT_EQ(count_of(svg, title), 2U);  // <title> and the text
    for (const std::string_view text :
         {plane.x_name, plane.y_name, std::string_view("0.3"), std::string_view("460"),
          std::string_view("520"), std::string_view("580"), std::string_view("620"),
          std::string_view("10000 K"), std::string_view("∞"), std::string_view("Planckian locus"),
          std::string_view("white, D65")}) {
      EXPECT_GE(count_of(svg, ">" + std::string(text) + "<"), 1U) << text;
    }
    EXPECT_EQ(count_of(svg, "nan"), 0U);
    EXPECT_EQ(svg, chromaticity_diagram(diagram));
  }
}

TEST(ChromaticityDiagram, NamesGamutsAndColors) {
  ChromaticityDiagram diagram = with_gamuts({named("srgb"), named("bt2020")});
  diagram.colors = {{"<b>", {0.5, 0.41}}, {"purple", {0.33, 0.22}}};
  const std::string svg = chromaticity_diagram(diagram);
  EXPECT_EQ(xml_complaint(svg), "");
  for (const char* text :
       {">srgb<", ">bt2020<", ">&lt;b&gt;<", ">&lt;b&gt;: 587.8 nm, purity 0.750<",
        ">purple: 542.5 nm c, purity 0.451<", ">to the complementary wavelength<"}) {
    EXPECT_EQ(count_of(svg, text), 1U) << text;
  }
}

TEST(ChromaticityDiagram, DrawsRaysToTheLocus) {
  const Chromaticity end = spectral_locus(600);
  const Chromaticity red{(kD65.x + end.x) / 2, (kD65.y + end.y) / 2};
  const std::string with = chromaticity_diagram(with_colors({{"red", red}}));
  const std::string without = chromaticity_diagram({});
  EXPECT_EQ(count_of(with, "stroke-dasharray=\"4 3\""), 2U);  // the opposite ray, and its key
  EXPECT_EQ(count_of(without, "stroke-dasharray=\"4 3\""), 0U);
  EXPECT_EQ(count_of(with, "red: 600.0 nm, purity 0.500"), 1U);
}

TEST(ChromaticityDiagram, ShowsLimitsAndEllipses) {
  const std::string plain = chromaticity_diagram({});
  ChromaticityDiagram diagram;
  diagram.ellipses = true;
  const std::string ellipses = chromaticity_diagram(diagram);
  EXPECT_EQ(count_of(ellipses, "<polygon") - count_of(plain, "<polygon"), 25U);
  diagram.ellipses = false;
  diagram.limits = {0.2, 0.5, 1.5};
  const std::string limits = chromaticity_diagram(diagram);
  EXPECT_EQ(xml_complaint(limits), "");
  EXPECT_EQ(count_of(limits, ">Y = 50<"), 1U);
  EXPECT_EQ(count_of(limits, "<polygon") - count_of(plain, "<polygon"), 2U);  // none reaches 1.5
}

TEST(ChromaticityDiagram, ReachesWhatLiesOutside) {
  const std::string svg = chromaticity_diagram(with_gamuts({named("aces-ap0")}));
  EXPECT_EQ(xml_complaint(svg), "");
  EXPECT_EQ(count_of(svg, ">1.0<"), 1U);  // its green is at y = 1
  EXPECT_EQ(count_of(chromaticity_diagram({}), ">1.0<"), 0U);
  // A colour too far away stretches nothing.
  EXPECT_EQ(count_of(chromaticity_diagram(with_colors({{"far", {1e6, -3}}})), ">1.0<"), 0U);
}

TEST(ChromaticityDiagram, LeavesOutWhatHasNoChromaticity) {
  const double nan = std::nan("");
  const std::string svg = chromaticity_diagram(with_colors({{"black", {nan, nan}}}));
  EXPECT_EQ(svg, chromaticity_diagram({}));
}

TEST(ChromaticityDiagram, ShowsManyColorsAsDots) {
  std::vector<DiagramColor> colors;
  for (int i = 0; i < 100; ++i) {
    colors.push_back({"c" + std::to_string(i), {0.2 + i * 0.003, 0.4 - i * 0.001}});
  }
  const std::string svg = chromaticity_diagram(with_colors(colors));
  EXPECT_EQ(count_of(svg, ">100 colours<"), 1U);
  EXPECT_EQ(count_of(svg, ">c7<"), 0U);
  EXPECT_GE(count_of(svg, "<circle"), 200U);  // each on a white one
}

TEST(ChromaticityDiagram, PutsALongLegendBesideTheFrame) {
  ChromaticityDiagram diagram;
  for (const NamedPrimaries& set : primaries_list()) {
    diagram.gamuts.push_back({std::string(set.name), set.primaries});
  }
  const std::string svg = chromaticity_diagram(diagram);
  EXPECT_EQ(xml_complaint(svg), "");
  for (const NamedPrimaries& set : primaries_list()) {
    EXPECT_EQ(count_of(svg, ">" + std::string(set.name) + "<"), 1U);
  }
}

}  // namespace
}  // namespace tristim
