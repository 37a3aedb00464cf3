#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"

namespace tristim::detail {

// The cube of Sony Pictures Imageworks [OCIO]: each row names its place.
Lut read_spi3d(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  TextLines lines(bytes, file);
  lines.need();
  if (!lines.rest().starts_with("SPILUT")) lines.fail("does not begin with SPILUT");
  lines.need();
  lines.take_integer(3, 3, "number of inputs that is read");
  lines.take_integer(3, 3, "number of outputs that is read");
  lines.need();
  const int size = lines.take_integer(2, kMostCubeSize, "number of points an edge");
  for (int i = 0; i < 2; ++i) lines.take_integer(size, size, "size like that of red");
  const std::size_t samples = cube_samples(size);
  lines.promise(2 * samples);
  Lut3D cube{{}, size, std::vector<float>(samples)};
  std::vector<bool> seen(samples / 3);
  for (std::size_t i = 0; i < samples; i += 3) {
    lines.need();
    std::size_t place = 0;
    std::size_t step = 1;
    for (int c = 0; c < 3; ++c, step *= static_cast<std::size_t>(size)) {
      place += static_cast<std::size_t>(lines.take_integer(0, size - 1, "place")) * step;
    }
    if (seen[place]) lines.fail("the same place comes for the second time");
    seen[place] = true;
    for (std::size_t c = 0; c < 3; ++c) cube.rgb[3 * place + c] = lines.take_float();
    lines.end_line();
  }
  if (lines.next()) lines.fail("there are more rows than the size says");
  return {"", {std::move(cube)}};
}

std::string write_spi3d(const Lut& lut, const LutFileOptions& /*options*/) {
  const Lut3D& cube = *parts_of(lut).cube;
  const std::string edge = std::to_string(cube.size);
  std::string text = "SPILUT 1.0\n3 3\n" + edge + " " + edge + " " + edge + "\n";
  const auto size = static_cast<std::size_t>(cube.size);
  for (std::size_t r = 0; r < size; ++r) {
    for (std::size_t g = 0; g < size; ++g) {
      for (std::size_t b = 0; b < size; ++b) {  // blue fastest, as the others write it
        text += std::to_string(r) + " " + std::to_string(g) + " " + std::to_string(b) + " ";
        append_row(text, cube.rgb.data() + 3 * ((b * size + g) * size + r));
      }
    }
  }
  return text;
}

}  // namespace tristim::detail
