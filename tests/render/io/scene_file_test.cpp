#include "tristim/render/io/scene_file.h"

#include <gtest/gtest.h>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/core/find.h"
#include "tristim/render/shapes.h"

namespace tristim {
namespace {

SceneFile scene_of(const std::string& text) { return parse_scene(text, "s.toml", "/nowhere"); }
std::string scene_error(const std::string& text) {
  return error_text([&] { (void)scene_of(text); });
}

TEST(SceneFile, EverySection) {
  const SceneFile file = scene_of(R"(
name = "all"
source = "made up"
ambient = [0.1, 0.2, 0.3]
[picture]
size = [320, 200]
samples = 16
filter = "gaussian"
shading = "gouraud"
affine = true
[camera]
eye = [1, 2, 3]
target = [0, 1, 0]
up = [0, 0, 1]
fov_deg = 30
near = 0.5
far = 100
[edges]
silhouettes = true
creases = false
crease_deg = 50
width = 2
color = "navy"
[[light]]
name = "sun"
kind = "directional"
to_light = [1, 1, 0]
intensity = 3
[[light]]
kind = "spot"
position = [0, 5, 0]
target = [0, 0, 0]
cutoff_deg = 20
exponent = 4
attenuation = "inverse-square"
intensity = { color = "white", scale = 50 }
fixed_to = "camera"
[[light]]
kind = "area"
polygon = [[0, 3, 0], [1, 3, 0], [0, 3, 1]]
samples = 4
[[light]]
kind = "point"
position = [1, 1, 1]
attenuation = "opengl"
c1 = 2
c2 = 3
c3 = 4
[[material]]
name = "gold"
model = "cook-torrance"
metal = "gold"
m = 0.2
[[material]]
name = "glass"
kt = 0.8
ot = [0.9, 1, 1]
transparency = "filtered"
two_sided = true
[[object]]
name = "ball"
shape = "sphere"
radius = 2
columns = 12
rows = 6
material = "gold"
translate = [1, 0, 0]
rotate_deg = [0, 90, 0]
scale = [1, 2, 3]
[[object]]
shape = "box"
)");
  const Scene& scene = file.scene;
  EXPECT_EQ(file.name, "all");
  EXPECT_EQ(scene.ambient, (Rgb{0.1, 0.2, 0.3}));
  EXPECT_EQ(scene.picture.width, 320);
  EXPECT_EQ(scene.picture.samples, 16);
  EXPECT_EQ(scene.picture.filter.name, "gaussian");
  EXPECT_EQ(scene.picture.shading.name, "gouraud");
  EXPECT_TRUE(scene.picture.affine);
  EXPECT_EQ(scene.camera.eye, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scene.camera.far, 100);
  EXPECT_FALSE(scene.edges.creases);
  EXPECT_NEAR(scene.edges.color.b, 0.2158605, 1e-6);
  ASSERT_EQ(scene.lights.size(), 4U);
  EXPECT_EQ(scene.lights[0].name, "sun");
  const auto& spot = std::get<SpotLight>(scene.lights[1].source);
  EXPECT_EQ(spot.direction, Eigen::Vector3d(0, -5, 0));
  EXPECT_EQ(spot.intensity, (Rgb{50, 50, 50}));
  EXPECT_EQ(spot.attenuation.kind.name, "inverse_square");
  EXPECT_TRUE(scene.lights[1].with_camera);
  EXPECT_EQ(scene.lights[1].name, "light2");
  EXPECT_EQ(std::get<PolygonLight>(scene.lights[2].source).polygon.size(), 3U);
  EXPECT_EQ(std::get<PointLight>(scene.lights[3].source).attenuation.c3, 4);
  EXPECT_TRUE(scene.materials[0].rough.spectral.has_value());
  EXPECT_EQ(scene.materials[1].transparent.tint, (Rgb{0.9, 1, 1}));
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].material, 0U);
  // (0, 0, 1) is scaled by 3, turned to x, moved by 1.
  const Eigen::Vector4d moved = scene.objects[0].world_from_object * Eigen::Vector4d(0, 0, 1, 1);
  EXPECT_EQ(moved, Eigen::Vector4d(4, 0, 0, 1));
  const SceneCounts counts = count_scene(scene);
  EXPECT_EQ(counts.triangles, 120 + 12U);
  EXPECT_EQ(counts.lights, 4U);
  EXPECT_EQ(counts.degenerate, 0U);
  EXPECT_TRUE(file.notes.empty());
}

TEST(SceneFile, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(scene_error("[camera]\neyes = [1, 2, 3]\n"),
            "3 s.toml:2:1: unknown key 'eyes'; did you mean eye?");
  EXPECT_EQ(scene_error("[[object]]\nshape = \"spere\"\n"),
            "3 s.toml:2:9: unknown shape 'spere'; did you mean sphere?");
  EXPECT_EQ(scene_error("[[object]]\nshape = \"sphere\"\ntube = 3\n"),
            "3 s.toml:3:1: unknown key 'tube'; use one of: file, shape, rotate_deg, scale, "
            "translate, name, material, radius, columns, rows, normals, smoothing_deg");
  EXPECT_EQ(scene_error("[[object]]\nshape = \"box\"\nmaterial = \"x\"\n"),
            "3 s.toml:3:12: unknown material 'x'; add a [[material]] of that name");
  EXPECT_EQ(scene_error("[[light]]\n"),
            "3 s.toml:1:1: the kind of the light is missing; give one of: directional, "
            "point, spot, area");
  EXPECT_EQ(scene_error("lihgt = 1\n"),
            "3 s.toml:1:1: unknown key 'lihgt'; did you mean "
            "light?");
}

TEST(SceneFile, RefusesValuesOutOfRange) {
  EXPECT_EQ(scene_error("[camera]\nnear = 0\n"),
            "3 s.toml:2:8: near = 0 is out of range; give a number above 0");
  EXPECT_EQ(scene_error("[camera]\neye = [0, 0, 0]\ntarget = [0, 0, 0]\n"),
            "3 s.toml:3:10: the camera looks at its own place; move eye or target");
  EXPECT_EQ(scene_error("[camera]\neye = [0, 9, 0]\n"),
            "3 s.toml:1:1: up is the direction of the view; give another direction, such as "
            "[0, 0, -1]");
  EXPECT_EQ(scene_error("[picture]\nsamples = 3\n"),
            "3 s.toml:2:11: samples = 3 is not possible; give 1, 4, 16 or 64");
  EXPECT_EQ(scene_error("[picture]\nsize = [0, 5]\n"),
            "3 s.toml:2:8: size is no size; give [width, height], 1 to 65536 pixels each");
  EXPECT_EQ(scene_error("ambient = \"gren\"\n"),
            "3 s.toml:1:11: 'gren' is no colour; did you mean green?");
  EXPECT_EQ(scene_error("[[object]]\nshape = \"box\"\nfile = \"x.obj\"\n"),
            "3 s.toml:3:8: an object must say once what it is; give one of file and shape, a "
            "shape being one of: " +
                list_names(shapes()));
  EXPECT_EQ(scene_error("[[object]]\nfile = \"x.obj\"\n"),
            "3 s.toml:2:8: /nowhere/x.obj: there is no such file; check the name");
  EXPECT_EQ(scene_error("[[object]]\nshape = \"plane\"\nnormals = \"plane\"\n"),
            "3 s.toml:3:11: only the pyramid has planes; use uniform, area or angle");
}

TEST(SceneFile, NotesWhatIsOdd) {
  EXPECT_EQ(scene_of("").notes,
            (std::vector<std::string>{
                "there is nothing to see: add an [[object]]",
                "there is no light: the picture is black; add a [[light]] or ambient"}));
}

TEST(SceneFile, SpectraAreColoursToo) {
  const SceneFile file = scene_of(R"(
ambient = { illuminant = "a", scale = 0.5 }
[[light]]
kind = "directional"
intensity = "planckian:3000"
[[material]]
name = "m"
od = { reflectance = "gauss", mu = 600, sd = 30, lo = 0.1, hi = 0.9 }
)");
  const Scene& scene = file.scene;
  ASSERT_TRUE(scene.ambient_spectrum.has_value());
  const Rgb& warm = scene.ambient;  // of luminance .5
  EXPECT_NEAR(0.2126 * warm.r + 0.7152 * warm.g + 0.0722 * warm.b, 0.5, 1e-3);
  EXPECT_GT(warm.r, 2 * warm.b);
  EXPECT_TRUE(scene.lights[0].spectrum.has_value());
  ASSERT_TRUE(scene.materials[0].spectral.has_value());
  EXPECT_EQ(scene.materials[0].spectral->od.at[44], 0.9);  // 600 nm
  EXPECT_GT(scene.materials[0].surface.od.r, scene.materials[0].surface.od.b);
}

TEST(SceneFile, BuiltInOnesAreGood) {
  for (const BuiltInScene& scene : built_in_scenes()) {
    SCOPED_TRACE(scene.name);
    const SceneFile file = load_scene(std::string(scene.name));
    EXPECT_TRUE(file.notes.empty());
    EXPECT_GT(count_scene(file.scene).triangles, 0U);
    EXPECT_GT(file.scene.lights.size(), 0U);
  }
  EXPECT_EQ(error_text([] { (void)load_scene("teapt"); }),
            "2 teapt: unknown scene; did you mean teapot? (a file of your own: "
            "./scene.toml)");
}

TEST(SceneFile, ReadsMeshesBesideIt) {
  const TemporaryDirectory folder;
  write_bytes(folder.file("t.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 1\n");
  write_bytes(folder.file("s.toml"),
              "ambient = 1\n[[object]]\nfile = \"t.obj\"\nsmoothing_deg = 30\n");
  const SceneFile file = load_scene(folder.file("s.toml"));
  EXPECT_EQ(count_scene(file.scene).degenerate, 1U);
  EXPECT_EQ(file.notes,
            std::vector<std::string>{"1 of 2 triangles have no area and are not drawn"});
  // Of a mesh alone: all of it is seen, by a light that goes with the camera.
  const SceneFile alone = load_scene(folder.file("t.obj"));
  EXPECT_EQ(alone.scene.camera.target, Eigen::Vector3d(0.5, 0.5, 0));
  EXPECT_TRUE(alone.scene.lights.at(0).with_camera);
}

}  // namespace
}  // namespace tristim
