#define TINYOBJLOADER_USE_DOUBLE  // as libtinyobjloader_double is built
#include <tiny_obj_loader.h>
#include <algorithm>
#include <cmath>
#include <istream>
#include <map>
#include <set>
#include <span>
#include <sstream>

#include "lib/render/io/obj_lines.h"
#include "lib/render/io/read_scene.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"
#include "tristim/render/io/model_file.h"

namespace tristim {
namespace {

constexpr int kMostCorners = 1024;

// The words of a line behind the first.
std::vector<std::string_view> values_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  if (!words.empty()) words.erase(words.begin());
  return words;
}

SceneMaterial grey_material() { return {.name = "default", .surface = detail::kDefaultSurface}; }

// Colours of MTL files are taken as light; its coefficients are in the colours.
SceneMaterial scene_material(const tinyobj::material_t& from) {
  SceneMaterial material{.name = from.name};
  const auto rgb = [](const tinyobj::real_t(&c)[3]) { return Rgb{c[0], c[1], c[2]}; };
  const auto sum = [](const Rgb& c) { return c.r + c.g + c.b; };
  material.surface.od = rgb(from.diffuse);
  material.surface.os = rgb(from.specular);
  material.surface.kd = 1;
  const double diffuse = sum(material.surface.od);
  material.surface.ka = diffuse > 0 ? std::min(sum(rgb(from.ambient)) / diffuse, 1.0) : 0;
  material.surface.ks = from.illum == 1 ? 0 : 1;
  material.surface.n = from.shininess;
  if (from.illum == 0) material.model = kFlatColor;
  if (from.dissolve < 1) {
    material.transparency = Transparency::kInterpolated;
    material.transparent.kt = 1 - std::max<double>(from.dissolve, 0);
  }
  return material;
}

bool all_finite(const SceneMaterial& material) {
  const Material& s = material.surface;
  for (const double value : {s.od.r, s.od.g, s.od.b, s.os.r, s.os.g, s.os.b, s.ka, s.n}) {
    if (!std::isfinite(value) || value < 0) return false;
  }
  return true;
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& file, const std::string& directory)
      : lines_(text), file_(file), directory_(directory) {
    result_.materials.push_back(grey_material());
    result_.models.emplace_back();
    result_.placed.push_back({});
  }

  ModelFile parse() {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, double, double, double, double) {
      static_cast<ObjParser*>(self)->add_position();
    };
    callbacks.normal_cb = [](void* self, double, double, double) {
      static_cast<ObjParser*>(self)->add_normal();
    };
    callbacks.texcoord_cb = [](void* self, double, double, double) {
      static_cast<ObjParser*>(self)->add_uv();
    };
    callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
      static_cast<ObjParser*>(self)->add_polygon({indices, static_cast<std::size_t>(count)});
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int) {
      static_cast<ObjParser*>(self)->use_material(name);
    };
    MaterialFiles files(*this);
    std::istream stream(&lines_);
    std::string warning;
    std::string error;
    const bool good =
        tinyobj::LoadObjWithCallback(stream, callbacks, this, &files, &warning, &error);
    if (!good) fail("is no OBJ file", error);
    if (few_corners_ > 0) {
      note(std::to_string(few_corners_) + " faces have less than 3 corners and were left out");
    }
    return std::move(result_);
  }

 private:
  // Where the materials come from that the file names.
  class MaterialFiles : public tinyobj::MaterialReader {
   public:
    explicit MaterialFiles(ObjParser& parser) : parser_(parser) {}
    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* numbers, std::string*, std::string*) override {
      return parser_.read_materials(name, materials, numbers);
    }

   private:
    ObjParser& parser_;
  };

  [[noreturn]] void fail(const std::string& wrong, const std::string& remedy) const {
    throw Error(ErrorKind::kContent, file_ + ":" + std::to_string(lines_.number()), wrong, remedy);
  }

  void note(const std::string& text) { result_.notes.push_back(file_ + ": " + text); }

  PolygonModel& model() { return result_.models[0]; }

  // The first numbers of the line; the parser's own depend on the C library's pow.
  std::vector<double> numbers(std::size_t least, std::size_t most) const {
    const std::vector<std::string_view> words = values_of(lines_.line());
    if (words.size() < least) {
      fail("has " + std::to_string(words.size()) + " numbers", "give " + std::to_string(least));
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < std::min(words.size(), most); ++i) {
      const auto value = parse_number(words[i]);
      if (!value || !std::isfinite(*value)) {
        fail("'" + std::string(words[i]) + "' is no finite number", "write digits");
      }
      values.push_back(*value);
    }
    return values;
  }

  void add_position() {
    const std::vector<double> p = numbers(3, 3);
    model().positions.emplace_back(p[0], p[1], p[2]);
  }

  void add_normal() {
    const std::vector<double> n = numbers(3, 3);
    model().normals.emplace_back(n[0], n[1], n[2]);
  }

  void add_uv() {
    std::vector<double> uv = numbers(1, 2);
    uv.resize(2);
    model().uvs.push_back({static_cast<float>(uv[0]), static_cast<float>(uv[1])});
  }

  // OBJ counts from 1, and from the last one backwards below 0.
  std::uint32_t resolved(int index, std::size_t count, const char* what) const {
    const long long number = index > 0 ? index - 1LL : static_cast<long long>(count) + index;
    if (index == 0 || number < 0 || number >= static_cast<long long>(count)) {
      fail("the face names " + std::string(what) + " " + std::to_string(index) + " of " +
               std::to_string(count),
           index == 0 ? "numbers begin at 1" : "define it before the face");
    }
    return static_cast<std::uint32_t>(number);
  }

  void add_polygon(std::span<const tinyobj::index_t> indices) {
    if (indices.size() > kMostCorners) {
      fail("the face has " + std::to_string(indices.size()) + " corners",
           "split it: 1024 are the most");
    }
    check_numbers(indices.size());
    std::vector<MeshCorner> corners;
    for (const tinyobj::index_t& index : indices) {
      MeshCorner corner;
      corner.position = resolved(index.vertex_index, model().positions.size(), "vertex");
      if (index.normal_index != 0) {
        corner.normal = resolved(index.normal_index, model().normals.size(), "normal");
        if (model().normals[corner.normal] == Eigen::Vector3d(0, 0, 0)) corner.normal = kNoIndex;
      }
      if (index.texcoord_index != 0) {
        corner.uv = resolved(index.texcoord_index, model().uvs.size(), "texture coordinate");
      }
      corners.push_back(corner);
    }
    if (corners.size() < 3) {
      ++few_corners_;
    } else {
      add_face(model(), corners, material_);
    }
  }

  // The parser takes 1x for 1, words for 0 and what overflows for anything.
  void check_numbers(std::size_t count) const {
    const std::vector<std::string_view> words = values_of(lines_.line());
    if (words.size() != count) fail("the face is not understood", "write f 1 2 3 or f 1/2/3 ...");
    for (const std::string_view word : words) {
      for (const std::string_view number : split(word, '/')) {
        if (number.empty()) continue;
        const auto value = parse_integer(number);
        if (!value) {
          fail("'" + std::string(number) + "' is no number of a vertex", "write f 1 2 3");
        }
        if (*value > kMostIndex || *value < -kMostIndex) {
          fail("the face names vertex " + std::string(number) + " of " +
                   std::to_string(result_.models[0].positions.size()),
               "define it before the face");
        }
      }
    }
  }

  void use_material(std::string_view name) {
    while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
    const auto& materials = result_.materials;
    for (std::size_t i = 0; i < materials.size(); ++i) {
      if (materials[i].name == name) {
        material_ = static_cast<std::uint32_t>(i);
        return;
      }
    }
    material_ = 0;
    if (unknown_.insert(std::string(name)).second) {
      note("there is no material '" + std::string(name) + "': grey is used");
    }
  }

  bool read_materials(const std::string& name, std::vector<tinyobj::material_t>* materials,
                      std::map<std::string, int>* numbers) {
    const std::string path = detail::path_beside(directory_, name);
    std::string text;
    try {
      text = read_text_file(path);
    } catch (const Error& error) {
      note("line " + std::to_string(lines_.number()) +
           ": the materials are missing: " + error.what() + "; grey is used");
      return true;
    }
    std::erase(text, '\0');
    std::istringstream stream(text);
    std::string warning;
    std::string error;
    const std::size_t before = materials->size();
    tinyobj::LoadMtl(numbers, materials, &stream, &warning, &error);
    for (std::size_t i = before; i < materials->size(); ++i) {
      const SceneMaterial material = scene_material((*materials)[i]);
      if (!all_finite(material)) {
        throw Error(ErrorKind::kContent, path,
                    "material '" + material.name + "' has numbers that are negative or not finite");
      }
      if (!material.name.empty()) result_.materials.push_back(material);
      if (!(*materials)[i].diffuse_texname.empty()) textured_ = true;
    }
    if (textured_ && !textures_noted_) {
      note("textures are not drawn: the colours of the materials count");
      textures_noted_ = true;
    }
    return true;
  }

  static constexpr long long kMostIndex = 2'000'000'000;

  detail::ObjLines lines_;
  const std::string& file_;
  const std::string& directory_;
  ModelFile result_;
  std::uint32_t material_ = 0;
  std::size_t few_corners_ = 0;
  std::set<std::string> unknown_;
  bool textured_ = false, textures_noted_ = false;
};

}  // namespace

ModelFile parse_obj(std::string_view bytes, const std::string& file, const std::string& directory) {
  return ObjParser(bytes, file, directory).parse();
}

}  // namespace tristim
