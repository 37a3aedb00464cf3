#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kMostCode = 65535;
constexpr int kCubeBits = 12;    // what Flame and Lustre take
constexpr int kShaperBits = 10;  // of the curve in front

struct Codes {
  std::vector<std::uint16_t> shaper;
  std::vector<std::uint16_t> cube;  // three a row, blue fastest
  int shaper_row = 0;
  int bits = 0;  // that the file says; 0: it does not
};

bool is_row(std::string_view line) {
  return line.find_first_of("0123456789+-") == 0 && !line.starts_with("3DMESH");
}

// "Mesh 5 12": 2^5 + 1 points an edge, 12 bits. Others have nothing that is needed.
void take_words(TextLines& lines, Codes& codes) {
  const std::string word(lines.take_word().substr(0, 40));
  if (word == "Mesh") {
    lines.take_integer(1, 8, "power of two");
    codes.bits = lines.take_integer(8, 16, "number of bits");
  } else if (word != "3DMESH" && word != "LUT8" && word != "gamma") {
    lines.fail("'" + word + "' is no keyword of a 3dl file", "it has 3DMESH, Mesh, LUT8 and gamma");
  }
}

void take_row(TextLines& lines, Codes& codes) {
  std::vector<std::uint16_t> row;
  while (!lines.rest().empty()) {
    row.push_back(static_cast<std::uint16_t>(lines.take_integer(0, kMostCode, "code")));
  }
  if (row.size() == 3) {
    codes.cube.insert(codes.cube.end(), row.begin(), row.end());
  } else if (row.size() > 3 && codes.shaper.empty() && codes.cube.empty()) {
    codes.shaper = row;
  } else {
    lines.fail("has " + std::to_string(row.size()) + " codes", "a colour has three");
  }
}

// The highest code of a table that does not say its bits: of the even numbers of them the least
// that has room for a half of the codes, as OpenColorIO guesses.
int guessed_most(const std::vector<std::uint16_t>& codes) {
  const int highest = *std::max_element(codes.begin(), codes.end());
  int bits = 8;
  while (bits < 16 && highest > 2 * (1 << bits) - 1) bits += 2;
  return most_of_bits(bits);
}

std::vector<float> values(const std::vector<std::uint16_t>& codes, int most) {
  std::vector<float> floats;
  floats.reserve(codes.size());
  for (const int code : codes) {
    floats.push_back(static_cast<float>(code) / static_cast<float>(most));
  }
  return floats;
}

// Codes at equal steps, rounded down or up, say only where the points lie.
bool is_identity(const std::vector<std::uint16_t>& codes, int most) {
  const auto steps = static_cast<double>(codes.size() - 1);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (std::fabs(static_cast<double>(i) * most / steps - codes[i]) > 1.5) return false;
  }
  return true;
}

Lut1D shaper_of(const std::vector<std::uint16_t>& codes, int most) {
  Lut1D curves{{}, static_cast<int>(codes.size()), {}};
  for (const float value : values(codes, most)) curves.rgb.insert(curves.rgb.end(), 3, value);
  return curves;
}

int edge_of(const TextLines& lines, std::size_t colors) {
  const auto size = static_cast<int>(std::lround(std::cbrt(static_cast<double>(colors))));
  if (size < 2 || size > kMostCubeSize || cube_samples(size) != 3 * colors) {
    lines.fail("the file has " + std::to_string(colors) + " colours",
               "a cube has 8, 27, 64, ... of them, 2 to 256 an edge");
  }
  return size;
}

}  // namespace

// The integer cube of Autodesk's Lustre and Flame [OCIO]: a curve in front, then colours.
Lut read_3dl(std::string_view bytes, const std::string& file, const LutFileOptions& options) {
  TextLines lines(bytes, file);
  Codes codes;
  while (lines.next()) {
    if (is_row(lines.rest())) {
      take_row(lines, codes);
    } else {
      take_words(lines, codes);
    }
  }
  Lut3D cube{{}, edge_of(lines, codes.cube.size() / 3), {}};
  const int bits = options.bits != 0 ? options.bits : codes.bits;
  const std::vector<float> table =
      values(codes.cube, bits != 0 ? most_of_bits(bits) : guessed_most(codes.cube));
  cube.rgb.resize(table.size());
  const auto size = static_cast<std::size_t>(cube.size);
  for (std::size_t i = 0; i < table.size() / 3; ++i) {
    std::copy_n(table.data() + 3 * blue_fastest(i, size), 3, cube.rgb.data() + 3 * i);
  }
  Lut lut;
  if (!codes.shaper.empty()) {
    const int most = guessed_most(codes.shaper);
    if (!is_identity(codes.shaper, most)) lut.steps.emplace_back(shaper_of(codes.shaper, most));
  }
  lut.steps.emplace_back(std::move(cube));
  return lut;
}

std::string write_3dl(const Lut& lut, const LutFileOptions& options) {
  const auto [points, curves, cube] = parts_of(lut);
  const int bits = options.bits != 0 ? options.bits : kCubeBits;
  const int most = most_of_bits(bits);
  std::string text = lut.title.empty() ? "" : "# " + one_line(lut.title) + "\n";
  const int intervals = cube->size - 1;
  const bool mesh =
      intervals > 1 && (intervals & (intervals - 1)) == 0;  // Lustre knows powers of two alone
  if (mesh) {
    int power = 0;
    while (1 << power < intervals) ++power;
    text += "3DMESH\nMesh " + std::to_string(power) + " " + std::to_string(bits) + "\n";
  }
  const int shaper_size = std::max(curves != nullptr ? curves->size : cube->size, 4);
  const int shaper_most = most_of_bits(curves != nullptr ? bits : kShaperBits);
  for (int i = 0; i < shaper_size; ++i) {
    const float value = curves != nullptr
                            ? curves->rgb[3 * static_cast<std::size_t>(i)]
                            : static_cast<float>(i) / static_cast<float>(shaper_size - 1);
    text += (i > 0 ? " " : "") + std::to_string(table_code(value, shaper_most));
  }
  text += '\n';
  const auto size = static_cast<std::size_t>(cube->size);
  for (std::size_t i = 0; i < size * size * size; ++i) {
    const float* rgb = cube->rgb.data() + 3 * blue_fastest(i, size);  // its own inverse
    for (int c = 0; c < 3; ++c) {
      text += std::to_string(table_code(rgb[c], most)) + (c < 2 ? " " : "\n");
    }
  }
  if (mesh) text += "LUT8\ngamma 1.0\n";
  return text;
}

}  // namespace tristim::detail
