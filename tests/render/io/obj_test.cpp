#include <gtest/gtest.h>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/render/io/model_file.h"

namespace tristim {
namespace {

ModelFile obj(const std::string& text, const std::string& directory = "/nowhere") {
  return parse_obj(text, "m.obj", directory);
}

std::string obj_error(const std::string& text) {
  return error_text([&] { (void)obj(text); });
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, FacesOfAnyNumberOfCorners) {
  const ModelFile file = obj("# a comment\n" + kSquare +
                             "vn 0 0 2\nvt .5 .25\nf 1/1/1 2//1 3/1 4\n"
                             "f 1 2 3 # another\r\nl 1 2\np 1\n");
  const PolygonModel& model = file.models.at(0);
  ASSERT_EQ(model.faces.size(), 2U);
  EXPECT_EQ(model.faces[0].count, 4U);
  EXPECT_EQ(model.corners[0], (MeshCorner{0, 0, 0}));
  EXPECT_EQ(model.corners[1], (MeshCorner{1, 0, kNoIndex}));
  EXPECT_EQ(model.corners[2], (MeshCorner{2, kNoIndex, 0}));
  EXPECT_EQ(model.corners[3], (MeshCorner{3, kNoIndex, kNoIndex}));
  EXPECT_EQ(model.uvs[0], (Uv{0.5F, 0.25F}));
  EXPECT_TRUE(file.notes.empty());
  EXPECT_EQ(triangulated(model).triangles.size(), 3U);
}

TEST(Obj, RelativeNumbersAndLongLines) {
  const PolygonModel model = obj(kSquare + "f -4 -3 -2\nv 9 9 9\nf -1 -5 \\\n 2\n").models[0];
  EXPECT_EQ(model.corners[0].position, 0U);
  EXPECT_EQ(model.corners[2].position, 2U);
  EXPECT_EQ(model.corners[3].position, 4U);
  EXPECT_EQ(model.corners[4].position, 0U);
  EXPECT_EQ(model.corners[5].position, 1U);
}

TEST(Obj, NumbersAreReadExactly) {
  const PolygonModel model = obj("v 0.1 1e-7 -123456.789012345678\n").models[0];
  EXPECT_EQ(model.positions[0], Eigen::Vector3d(0.1, 1e-7, -123456.789012345678));
}

TEST(Obj, TellsTheLineOfAMistake) {
  EXPECT_EQ(obj_error(kSquare + "f 1 2 5\n"),
            "3 m.obj:5: the face names vertex 5 of 4; define it before the face");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 -5\n"),
            "3 m.obj:5: the face names vertex -5 of 4; define it before the face");
  EXPECT_EQ(obj_error(kSquare + "f 0 1 2\n"),
            "3 m.obj:5: the face names vertex 0 of 4; numbers begin at 1");
  EXPECT_EQ(obj_error(kSquare + "f 1 2 4294967297\n"),
            "3 m.obj:5: the face names vertex 4294967297 of 4; define it before the face");
  EXPECT_EQ(obj_error(kSquare + "f 1/1 2 3\n"),
            "3 m.obj:5: the face names texture coordinate 1 of 0; define it before the "
            "face");
  EXPECT_EQ(obj_error(kSquare + "f 1//9 2 3\n"),
            "3 m.obj:5: the face names normal 9 of 0; define it before the face");
  EXPECT_EQ(obj_error("\n\nv 1 nan 2\n"), "3 m.obj:3: 'nan' is no finite number; write digits");
  EXPECT_EQ(obj_error("v 1 1e999 2\n"), "3 m.obj:1: '1e999' is no finite number; write digits");
  EXPECT_EQ(obj_error("v 1 2\n"), "3 m.obj:1: has 2 numbers; give 3");
  EXPECT_EQ(obj_error(kSquare + "f a b c\n"),
            "3 m.obj:5: 'a' is no number of a vertex; write f 1 2 3");
  std::string many = kSquare + "f";
  for (int i = 0; i < 1025; ++i) many += " 1";
  EXPECT_EQ(obj_error(many + "\n"),
            "3 m.obj:5: the face has 1025 corners; split it: 1024 are the most");
}

TEST(Obj, CountsWhatIsNoFace) {
  const ModelFile file = obj(kSquare + "f 1 2\nf 1\nf 1 1 2\nf 1 2 3\n");
  EXPECT_EQ(file.models[0].faces.size(), 2U);
  EXPECT_EQ(degenerate_count(triangulated(file.models[0])), 1U);
  EXPECT_EQ(file.notes,
            std::vector<std::string>{"m.obj: 2 faces have less than 3 corners and were left out"});
}

TEST(Obj, MaterialsOfMtlFiles) {
  const TemporaryDirectory folder;
  write_bytes(folder.file("a.mtl"),
              "newmtl red\nKa 0.1 0 0\nKd 0.5 0 0\nKs 1 1 1\nNs 30\nillum 2\n"
              "newmtl glass\nKd 1 1 1\nd 0.25\nmap_Kd x.png\nnewmtl lamp\nKd 1 1 0\nillum 0\n");
  const ModelFile file = obj("mtllib a.mtl\n" + kSquare +
                                 "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl glass\nf 1 2 3\nusemtl no\n"
                                 "f 1 2 3\nusemtl lamp\nf 1 2 3\n",
                             folder.path());
  std::vector<std::uint32_t> used;
  for (const PolygonFace& face : file.models[0].faces) used.push_back(face.material);
  EXPECT_EQ(used, (std::vector<std::uint32_t>{0, 1, 2, 0, 3}));
  const SceneMaterial& red = file.materials.at(1);
  EXPECT_EQ(red.surface.od, (Rgb{0.5, 0, 0}));
  EXPECT_NEAR(red.surface.ka, 0.2, 1e-15);
  EXPECT_EQ(red.surface.n, 30);
  EXPECT_EQ(file.materials.at(2).transparency, Transparency::kInterpolated);
  EXPECT_EQ(file.materials.at(2).transparent.kt, 0.75);
  EXPECT_EQ(file.materials.at(3).model.name, kFlatColor.name);
  EXPECT_EQ(file.notes, (std::vector<std::string>{
                            "m.obj: textures are not drawn: the colours of the materials count",
                            "m.obj: there is no material 'no': grey is used"}));
}

TEST(Obj, MissingMaterialsAreANote) {
  const ModelFile file = obj("mtllib gone.mtl\nusemtl red\n" + kSquare + "f 1 2 3\n");
  EXPECT_EQ(file.materials.size(), 1U);
  ASSERT_EQ(file.notes.size(), 2U);
  EXPECT_EQ(file.notes[0],
            "m.obj: line 1: the materials are missing: /nowhere/gone.mtl: there is no such "
            "file; check the name; grey is used");
}

TEST(Obj, AnyBytesAreAFileOrAnError) {
  for (const std::string& text :
       {std::string("f"), std::string("f \n"), std::string("\0\0v 1 2 3", 9),
        std::string("g\ng \n"), std::string("mtllib\nmtllib \nusemtl \n"),
        std::string("v 1 2 3\nf 1/ 1// 1/\n"), std::string("f /\n"), std::string("f 1/2/3/4 1 1\n"),
        std::string("\\\n\\\n\\")}) {
    (void)error_text([&] { (void)obj(text); });
  }
}

TEST(ModelFormats, ByTheEndOfTheName) {
  EXPECT_EQ(model_format_of("a.b/c.OBJ")->name, "obj");
  EXPECT_EQ(model_format_of("x.glb")->name, "gltf");
  EXPECT_EQ(model_format_of("x.toml"), nullptr);
  EXPECT_EQ(model_format_of("obj"), nullptr);
  EXPECT_EQ(error_text([] { (void)read_model_file("x.ply"); }),
            "2 x.ply: is no file of meshes by its name; give one that ends in .obj, .gltf or "
            ".glb");
}

}  // namespace
}  // namespace tristim
