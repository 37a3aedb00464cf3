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
  refuses("render", 2, "render: SCENE is missing; use: tristim render SCENE -o OUT.exr [options]");
  refuses("render sphere -o o.exr", 2, "sphere: unknown scene; did you mean spheres?");
  refuses("render spheres", 2, "--output: is missing; give -o spheres.exr");
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

}  // namespace
}  // namespace tristim
