#include "tristim/render/io/model_file.h"

#include <algorithm>
#include <array>

#include "lib/render/io/read_scene.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::array kFormats{ModelFormat{"obj", "obj", "[OBJ]", parse_obj},
                              ModelFormat{"gltf", "gltf glb", "[GLTF2]", parse_gltf}};
constexpr std::size_t kMostBytes = std::size_t{2} << 30;

}  // namespace

std::span<const ModelFormat> model_formats() noexcept { return kFormats; }

const ModelFormat* model_format_of(std::string_view path) noexcept {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return nullptr;
  const std::string_view extension = path.substr(dot + 1);
  for (const ModelFormat& format : kFormats) {
    for (const std::string_view own : split(format.extensions, ' ')) {
      if (same_name(own, extension)) return &format;
    }
  }
  return nullptr;
}

ModelFile read_model_file(const std::string& path) {
  const ModelFormat* format = model_format_of(path);
  if (format == nullptr) {
    throw Error(ErrorKind::kMisuse, path, "is no file of meshes by its name",
                "give one that ends in .obj, .gltf or .glb");
  }
  return format->parse(read_text_file(path, kMostBytes), path, detail::directory_of(path));
}

}  // namespace tristim
