#include <cstddef>
#include <cstdint>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/render/io/model_file.h"
#include "tristim/render/mesh_normals.h"

// The parser of one format of meshes, whose name the build gives: any bytes are models or an Error,
// and the models become triangles with normals. Files beside it are not there.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tristim;  // NOLINT(google-build-using-namespace): nothing else is here
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const ModelFormat& format = *find_by_name(model_formats(), TRISTIM_FORMAT);
    ModelFile file = format.parse(bytes, "input", "/nowhere");
    for (PolygonModel& model : file.models) {
      average_normals(model, kAngleNormals, 40);
      (void)degenerate_count(triangulated(model));
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kMisuse) throw;
  }
  return 0;
}
