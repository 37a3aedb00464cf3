#include "tristim/plot/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/plot/svg_reader.h"

namespace tristim {
namespace {

TEST(SvgDrawing, IsADocumentWithItsSize) {
  const SvgDrawing svg(320, 240.5, "a title", "a description");
  const std::string text = svg.document();
  EXPECT_EQ(xml_complaint(text), "");
  EXPECT_TRUE(
      text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
                       "width=\"320\" height=\"240.5\" viewBox=\"0 0 320 240.5\""));
  EXPECT_NE(text.find("<title>a title</title>\n<desc>a description</desc>"), text.npos);
  EXPECT_TRUE(text.ends_with("</svg>\n"));
}

TEST(SvgDrawing, WritesEachShape) {
  SvgDrawing svg(100, 100, "");
  const SvgPoint triangle[] = {{0, 0}, {10, 0}, {0, 10.126}};
  const SvgStop stops[] = {{0, "#000"}, {0.25, "#ff0000"}, {1, "#fff"}};
  svg.line({1, 2}, {3, 4}, {"#123456", 1.5, "4 3"});
  svg.polygon(triangle, {.fill = "red", .stroke = {"#000", 2}, .opacity = 0.5});
  svg.rectangle({-0.001, 5}, 10, 20, {.fill = "#fff"});
  svg.circle({50, 50}, 3, {.fill = "blue"});
  svg.gradient({0, 0}, 10, 2, stops);
  svg.begin_clip(triangle);
  svg.text({5, 6}, "x", {.size = 9, .anchor = SvgAnchor::kEnd, .bold = true, .italic = true});
  svg.end_clip();
  const std::string text = svg.document();
  EXPECT_EQ(xml_complaint(text), "");
  for (const char* part :
       {"<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\" stroke=\"#123456\" stroke-width=\"1.5\" "
        "stroke-dasharray=\"4 3\"/>",
        "<polygon points=\"0,0 10,0 0,10.13\" fill=\"red\" fill-opacity=\"0.5\" stroke=\"#000\" "
        "stroke-width=\"2\"/>",
        "<rect x=\"0\" y=\"5\" width=\"10\" height=\"20\" fill=\"#fff\"/>",
        "<circle cx=\"50\" cy=\"50\" r=\"3\" fill=\"blue\"/>",
        "<stop offset=\"0.2500\" stop-color=\"#ff0000\"/>", "fill=\"url(#g1)\"",
        "<g clip-path=\"url(#c2)\">\n<text x=\"5\" y=\"6\" font-size=\"9\" fill=\"#222\" "
        "text-anchor=\"end\" font-weight=\"bold\" font-style=\"italic\">x</text>\n</g>"}) {
    EXPECT_EQ(count_of(text, part), 1U) << part << "\n" << text;
  }
}

TEST(SvgDrawing, BreaksLinesWhereThereIsNoPoint) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  SvgDrawing svg(100, 100, "");
  const SvgPoint line[] = {{nan, 0}, {1, 1}, {2, 2}, {3, inf}, {4, 4}, {nan, nan}, {5, 5}, {6, 6}};
  const SvgPoint bad[] = {{0, 0}, {1, nan}, {1, 1}};
  svg.polyline(line, {"#000", 1});
  svg.polygon(bad, {.fill = "red"});
  svg.line({0, 0}, {inf, 0}, {"#000", 1});
  svg.circle({nan, 0}, 1, {});
  svg.text({nan, 0}, "x", {});
  svg.line({0, 0}, {1, 1}, {"#000", 0});
  const std::string text = svg.document();
  EXPECT_EQ(xml_complaint(text), "");
  EXPECT_EQ(count_of(text, "<polyline"), 2U) << text;
  EXPECT_NE(text.find("points=\"1,1 2,2\""), text.npos);
  EXPECT_NE(text.find("points=\"5,5 6,6\""), text.npos);
  for (const char* shape : {"<polygon", "<line", "<circle", "<text", "nan", "inf"}) {
    EXPECT_EQ(count_of(text, shape), 0U) << shape;
  }
}

TEST(XmlEscaped, EscapesWhatXmlCannotHold) {
  EXPECT_EQ(xml_escaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(xml_escaped("tab\t, null\x01, delete\x7f"), "tab?, null?, delete?");
  EXPECT_EQ(xml_escaped("u′ é 🙂"), "u′ é 🙂");
  const std::string replacement = "\xEF\xBF\xBD";
  EXPECT_EQ(xml_escaped("\xFF"), replacement);
  EXPECT_EQ(xml_escaped("\xC3"), replacement);                            // cut short
  EXPECT_EQ(xml_escaped("\xC0\x80"), replacement + replacement);          // overlong
  EXPECT_EQ(count_of(xml_escaped("\xED\xA0\x80"), replacement), 3U);      // a surrogate
  EXPECT_EQ(count_of(xml_escaped("\xF4\x90\x80\x80"), replacement), 4U);  // beyond U+10FFFF
}

TEST(FixedText, HasItsDecimals) {
  EXPECT_EQ(fixed_text(0.125, 1), "0.1");
  EXPECT_EQ(fixed_text(-0.04, 1), "0.0");
  EXPECT_EQ(fixed_text(-0.06, 1), "-0.1");
  EXPECT_EQ(fixed_text(3, 0), "3");
  EXPECT_EQ(fixed_text(-1e300, 2).size(), 305U);
}

// [AFM]: "Ag" is 667 + 556.
TEST(TextWidth, IsThatOfHelvetica) {
  EXPECT_DOUBLE_EQ(text_width("Ag"), 1.223);
  EXPECT_DOUBLE_EQ(text_width(" ~"), 0.862);
  EXPECT_DOUBLE_EQ(text_width("′"), 0.556);  // one letter of three bytes
  EXPECT_EQ(text_width(""), 0);
}

}  // namespace
}  // namespace tristim
