#include <filesystem>
#include <nlohmann/json.hpp>

#include "tools/halftone.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/dither/matrix_text.h"
#include "tristim/frame/io/write.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim halftone matrix d3\n"
    "  tristim halftone matrix magic6 -o magic6.csv\n"
    "  tristim halftone matrix blue-noise -o mask.png\n"
    "  tristim halftone matrix blue-noise --mask-size 64 --frame 3 -o slice.h\n";

std::string matrix_json(const ThresholdMatrix& matrix) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (int y = 0; y < matrix.height; ++y) {
    rows.push_back(std::vector<int>(matrix.row(y), matrix.row(y) + matrix.width));
  }
  return json_line({{"name", matrix.name},
                    {"source", matrix.source},
                    {"width", matrix.width},
                    {"height", matrix.height},
                    {"ranks", matrix.ranks},
                    {"rank", rows}});
}

// Greys that ascend with the ranks: 8 bits where they hold all of them, else 16.
void write_picture(const ThresholdMatrix& matrix, const std::string& path, bool force) {
  const bool deep = matrix.ranks > 256;
  FrameInfo info{.width = matrix.width, .height = matrix.height};
  info.layout.packing = *find_by_name(kPackings, deep ? "gray16" : "gray8");
  const auto sink = open_code_sink(path, info, {.replace = force});
  const int most = deep ? 65535 : 255;
  Raster<std::uint16_t> row(matrix.width, 1, 1);
  for (int y = 0; y < matrix.height; ++y) {
    std::uint16_t* grey = row.view().data;
    for (int x = 0; x < matrix.width; ++x) {
      const std::int64_t rank = matrix.row(y)[x];
      grey[x] = static_cast<std::uint16_t>(
          matrix.ranks == 1 ? 0 : (rank * most + (matrix.ranks - 1) / 2) / (matrix.ranks - 1));
    }
    sink->write(row.view());
  }
  sink->finish();
}

// Columns of one width.
std::string matrix_text(const ThresholdMatrix& matrix) {
  const std::size_t width = std::to_string(matrix.ranks - 1).size();
  std::string text = matrix.name + ", " + std::to_string(matrix.width) + " x " +
                     std::to_string(matrix.height) + ", ranks 0 to " +
                     std::to_string(matrix.ranks - 1) + ", " + matrix.source + "\n";
  for (int y = 0; y < matrix.height; ++y) {
    for (int x = 0; x < matrix.width; ++x) {
      std::string rank = std::to_string(matrix.row(y)[x]);
      rank.insert(0, width - rank.size() + (x > 0 ? 1 : 0), ' ');
      text += rank;
    }
    text += "\n";
  }
  return text;
}

void write_text(const std::string& text, const std::string& path, bool force) {
  OutputFile file(path, force);
  file.write(text);
  file.commit();
}

}  // namespace

void run_halftone_matrix(Arguments arguments) {
  std::vector<std::string> names;
  MatrixOptions options;
  std::string output;
  bool json = false;
  bool force = false;
  CommandLine line(*halftone_job("matrix"), kExamples);
  line.positional("NAME", "a matrix, or a file with your own: CSV, or a grey picture", names, 1, 1);
  declare_matrix_options(line, options);
  line.option("-o,--output", "OUT", "a file: .csv, .json, .h, or a picture (.png, .pgm)", output);
  line.flag("--json", "print it as JSON", json);
  line.flag("-f,--force", "replace an existing file", force);
  if (!line.parse(arguments)) return;
  refuse_inputs_as_outputs({names[0]}, {output});
  const ThresholdMatrix matrix = halftone_matrix(names[0], options);
  if (output.empty()) return print(json ? matrix_json(matrix) : matrix_text(matrix));
  const std::string extension = std::filesystem::path(output).extension().string();
  if (output == "-" || extension == ".csv" || extension == ".txt") {
    return write_text(matrix_csv(matrix), output, force);
  }
  if (extension == ".json") return write_text(matrix_json(matrix), output, force);
  if (extension == ".h" || extension == ".c") {
    return write_text(matrix_c_header(matrix), output, force);
  }
  write_picture(matrix, output, force);
}

}  // namespace tristim::tools
