#include <gtest/gtest.h>

#include "tests/support.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/light/metals.h"
#include "tristim/light/spectral.h"
#include "tristim/render/io/scene_file.h"
#include "tristim/render/shapes.h"

namespace tristim {
namespace {

std::string document() { return read_bytes(source_file("docs/scenes.md")); }

TEST(SceneDocs, TheExampleIsAScene) {
  const std::string text = document();
  const std::string fence = "```toml\n";
  const std::size_t begin = text.find(fence) + fence.size();
  const SceneFile file = parse_scene(
      std::string_view(text).substr(begin, text.find("```", begin) - begin), "docs", "");
  EXPECT_EQ(file.scene.objects.size(), 2U);
  EXPECT_EQ(file.scene.lights.size(), 2U);
  EXPECT_TRUE(file.notes.empty());
}

TEST(SceneDocs, HaveEveryShapeWithItsDefaults) {
  const std::string text = document();
  for (const Shape& shape : shapes()) {
    std::string row = "| `" + std::string(shape.name) + "` |";
    for (const ShapeParameter& parameter : shape.parameters) {
      row += (&parameter == shape.parameters.data() ? " `" : ", `") + std::string(parameter.name) +
             "` " + shortest(parameter.preset);
    }
    EXPECT_NE(text.find(row), std::string::npos) << row;
  }
}

TEST(SceneDocs, HaveEveryMemberOfTheLists) {
  const std::string text = document();
  const auto expect_all = [&](const auto& list) {
    for (const auto& item : list) {
      EXPECT_NE(text.find("`" + std::string(item.name) + "`"), std::string::npos) << item.name;
    }
  };
  const auto in_quotes = [&](std::string_view name) {
    return text.find("\"" + std::string(name) + "\"") != std::string::npos ||
           text.find("`" + std::string(name) + "`") != std::string::npos;
  };
  expect_all(kReflectanceShapes);
  expect_all(metals());
  for (const auto& item : kReflectionModels) EXPECT_TRUE(in_quotes(item.name)) << item.name;
  for (const auto& item : kShadings) EXPECT_TRUE(in_quotes(item.name)) << item.name;
  for (const auto& item : kPixelFilters) EXPECT_TRUE(in_quotes(item.name)) << item.name;
  for (const auto& item : kAttenuations) EXPECT_TRUE(in_quotes(item.name)) << item.name;
  for (const auto& item : kNormalWeightings) EXPECT_TRUE(in_quotes(item.name)) << item.name;
  for (const auto& item : kMicrofacetDistributions) EXPECT_TRUE(in_quotes(item.name)) << item.name;
}

// A key that is like none brings the list of those that the reader asks for.
TEST(SceneDocs, KeysAreThoseOfTheReader) {
  const std::string text = document();
  for (const std::string& section :
       {std::string("[camera]\n"), std::string("[picture]\n"), std::string("[edges]\n"),
        std::string("[[light]]\nkind = \"spot\"\n"), std::string("[[light]]\nkind = \"point\"\n"),
        std::string("[[material]]\nname = \"m\"\n"),
        std::string("[[object]]\nshape = \"box\"\n")}) {
    try {
      (void)parse_scene(section + "zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz = 1\n", "s", "");
      ADD_FAILURE() << section;
    } catch (const Error& error) {
      const std::string all = error.what();
      const std::string before = "use one of: ";
      ASSERT_NE(all.find(before), std::string::npos) << all;
      for (const std::string_view key :
           split(std::string_view(all).substr(all.find(before) + before.size()), ',')) {
        const std::string name(key.substr(key.find_first_not_of(' ')));
        EXPECT_NE(text.find("`" + name + "`"), std::string::npos) << section << name;
      }
    }
  }
}

}  // namespace
}  // namespace tristim
