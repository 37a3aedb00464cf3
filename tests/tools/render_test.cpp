#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class Render : public CommandTest {};

TEST_F(Render, IsTheSameForAnyNumberOfThreads) {
  for (const std::string threads : {"1", "2", "7"}) {
    good("render spheres --size 61x35 --samples 4 --threads " + threads + " -o " + threads +
         ".exr");
  }
  EXPECT_EQ(read("1.exr"), read("2.exr"));
  EXPECT_EQ(read("1.exr"), read("7.exr"));
}

TEST_F(Render, WritesToAPipe) {
  good("render Spheres --size 16x9 --samples 1 -o o.exr");
  EXPECT_EQ(good("render spheres --size 16X9 --samples 1 -o -"), read("o.exr"));
  good("render spheres --size 1x1 --samples 1 -o one.exr");
  EXPECT_EQ(parsed(good("info one.exr --json"))["width"], 1);
}

TEST_F(Render, RefusesWhatItCannotDo) {
  refuses("render", 2,
          "render: SCENE is missing; use: tristim render SCENE -o OUT.exr, or --gallery");
  refuses("render teapod -o o.exr", 2,
          "teapod: unknown scene; did you mean teapot? (a file of your own: ./scene.toml)");
  refuses(
      "render spheres -o o.png", 2,
      "o.png: does not end in .exr; render writes EXR, tristim process makes other formats of it");
  refuses("render spheres -o s.exr", 1, "s.exr: exists already; give --force to replace it");
  refuses("render spheres -o no/o.exr", 1, "no/o.exr: there is no directory no; create it first");
  for (const std::string size : {"0x0", "16", "16x", "ax9", "70000x1", "4x4x4", "-1x5"}) {
    refuses("render spheres -o o.exr --size " + size, 2,
            "--size: '" + size +
                "' is no size; give WIDTHxHEIGHT in pixels, at most 65536 a side: 1280x720");
  }
  refuses("render spheres -o o.exr --samples 0", 2,
          "--samples: '0' is out of range; give a whole number from 1 to 1024");
}

constexpr const char* kScene = R"(
ambient = 0.2
[picture]
size = [40, 30]
[camera]
eye = [0, 0, 5]
[[light]]
name = "key"
kind = "directional"
to_light = [1, 1, 1]
[[material]]
name = "paint"
kd = 0.7
[[object]]
shape = "sphere"
material = "paint"
)";

TEST_F(Render, DrawsAScene) {
  write("s.toml", kScene);
  good("render s.toml -o o.exr --layers beauty,diffuse,N,Z,id");
  const auto facts = parsed(good("info o.exr --json"));
  EXPECT_EQ(facts["width"], 40);
  EXPECT_EQ(facts["height"], 30);
  EXPECT_NE(facts.dump().find("diffuse.key.R"), std::string::npos);
  EXPECT_EQ(good("render s.toml --layers beauty,diffuse,N,Z,id --threads 3"), read("o.exr"));
  good("render s.toml -o small.exr --size 8x6 --samples 16 --filter tent --shading flat");
  EXPECT_EQ(parsed(good("info small.exr --json"))["width"], 8);
}

TEST_F(Render, TurnsRoundTheTarget) {
  write("s.toml", kScene);
  good("render s.toml --frames 2-3/4 -o turn-%02d.exr");
  EXPECT_TRUE(exists("turn-02.exr"));
  EXPECT_TRUE(exists("turn-03.exr"));
  EXPECT_FALSE(exists("turn-01.exr"));
  refuses("render s.toml --frames 1-2 -o o.exr", 2,
          "--frames: 'o.exr' names one file; write %04d for the number of the frame: "
          "turn-%04d.exr");
  refuses("render s.toml --frames 2-1 -o %d.exr", 2,
          "--frames: '2-1' is no range of frames; give the first and the last: 1-24; and those of "
          "a whole turn where they are more: 1-12/24");
}

TEST_F(Render, RefusesWhatIsNoPicture) {
  write("s.toml", kScene);
  refuses("render s.toml -o o.exr --samples 5", 2, "--samples: 5 is none of 1, 4, 16, 64");
  refuses("render s.toml -o o.exr --layers N,n", 2, "--layers: n stands there twice");
  refuses("render spheres -o o.exr --frames 1-2", 2,
          "--frames: spheres has one picture only; give a scene file");
}

TEST_F(Render, DrawsTheGallery) {
  good("render --gallery -o new/folder");
  for (const char* name : {"lights", "shading", "phong-grid", "phong-terms", "transparency",
                           "gooch", "silhouettes", "normals", "smoothing", "corrugation",
                           "mach-bands", "perspective", "orientation", "t-junction"}) {
    SCOPED_TRACE(name);
    const std::string file = std::string("new/folder/") + name;
    EXPECT_GT(parsed(good("info " + file + ".png --json"))["width"], 300);
    EXPECT_GT(parsed(good("info " + file + ".exr --json"))["width"], 300);
  }
  refuses("render --gallery -o new/folder", 1,
          "new/folder/lights.exr: exists already; give --force to replace it");
  refuses("render --gallery", 2, "--output: is missing; give a directory: -o gallery");
  refuses("render teapot --gallery -o g", 2, "--gallery: draws scenes of its own; leave out SCENE");
}

TEST_F(Render, InfoTellsWhatASceneHas) {
  write("s.toml", kScene);
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
  const auto facts = parsed(good("info s.toml --json"));
  EXPECT_EQ(facts["triangles"], 2 * 64 * 31);
  EXPECT_EQ(facts["lights"], 1);
  EXPECT_EQ(facts["camera"]["eye"], nlohmann::json({0, 0, 5}));
  EXPECT_EQ(facts["notes"].size(), 0U);
  const std::string text = good("info m.obj");
  EXPECT_NE(text.find("triangles     2, 1 of them without area: not drawn"), std::string::npos);
  EXPECT_NE(text.find("materials     1: default"), std::string::npos);
}

TEST_F(Render, TellsWhatIsOddAboutAScene) {
  write("empty.toml", "");
  EXPECT_EQ(run("render empty.toml -o empty.exr").err,
            "tristim: empty.toml: there is nothing to see: add an [[object]]\n"
            "tristim: empty.toml: there is no light: the picture is black; add a [[light]] or "
            "ambient\n");
  write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  refuses("render bad.obj -o bad.exr", 3,
          "bad.obj:4: the face names vertex 9 of 3; define it before the face");
  refuses("render gone.glb -o gone.exr", 1, "gone.glb: there is no such file; check the name");
}

}  // namespace
}  // namespace tristim
