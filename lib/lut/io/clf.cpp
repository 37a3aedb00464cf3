#include <optional>

#include "lib/lut/io/clf.h"
#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

void open_node(std::string& text, const char* name, const char* more, const std::string& size) {
  text += std::string("  <") + name + " inBitDepth=\"32f\" outBitDepth=\"32f\"" + more +
          ">\n    <Array dim=\"" + size + "\">\n";
}

void close_node(std::string& text, const char* name) {
  text += std::string("    </Array>\n  </") + name + ">\n";
}

void append(std::string& text, const LutMatrix& step, bool ctf) {
  open_node(text, "Matrix", "", ctf ? "3 4 3" : "3 4");
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) text += shortest(step.matrix(row, column)) + " ";
    text += shortest(step.offset(row)) + "\n";
  }
  close_node(text, "Matrix");
}

// Tables of this format begin at 0 and end at 1: a range becomes a matrix in front.
void append(std::string& text, const LutRange& range, bool ctf) {
  if (range == LutRange{}) return;
  LutMatrix to_unit;
  for (int c = 0; c < 3; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    const double width = range.high[channel] - range.low[channel];
    to_unit.matrix(c, c) = 1 / width;
    to_unit.offset(c) = -range.low[channel] / width;
  }
  append(text, to_unit, ctf);
}

void append(std::string& text, const Lut1D& step, bool ctf) {
  append(text, step.range, ctf);
  open_node(text, "LUT1D", "", std::to_string(step.size) + " 3");
  for (std::size_t i = 0; i < step.rgb.size(); i += 3) append_row(text, step.rgb.data() + i);
  close_node(text, "LUT1D");
}

void append(std::string& text, const Lut3D& step, bool ctf) {
  append(text, step.range, ctf);
  const std::string edge = std::to_string(step.size);
  open_node(text, "LUT3D", " interpolation=\"tetrahedral\"", edge + " " + edge + " " + edge + " 3");
  const auto size = static_cast<std::size_t>(step.size);
  for (std::size_t i = 0; i < size * size * size; ++i) {
    append_row(text, step.rgb.data() + 3 * blue_fastest(i, size));
  }
  close_node(text, "LUT3D");
}

void append(std::string& /*text*/, const LutPoints& /*step*/, bool /*ctf*/) {}  // not held

std::string write(const Lut& lut, bool ctf) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ProcessList id=\"tristim\" ";
  text += ctf ? "version=\"2.0\">\n" : "compCLFversion=\"3.0\">\n";
  if (!lut.title.empty()) text += "  <Description>" + xml_text(lut.title) + "</Description>\n";
  return text + clf_nodes(lut, ctf) + "</ProcessList>\n";
}

}  // namespace

// A file has one node at least: the identity is a matrix.
std::string clf_nodes(const Lut& lut, bool ctf) {
  std::string text;
  if (lut.steps.empty()) append(text, LutMatrix{}, ctf);
  for (const LutStep& step : lut.steps) {
    std::visit([&](const auto& one) { append(text, one, ctf); }, step);
  }
  return text;
}

// The Common LUT Format [CLF] and Autodesk's dialect of it, which OpenColorIO reads.
std::string write_clf(const Lut& lut, const LutFileOptions& /*options*/) {
  return write(lut, false);
}

std::string write_ctf(const Lut& lut, const LutFileOptions& /*options*/) {
  return write(lut, true);
}

}  // namespace tristim::detail
