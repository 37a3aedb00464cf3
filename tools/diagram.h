#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli.h"
#include "tools/convert_rows.h"
#include "tristim/plot/chromaticity.h"

namespace tristim::tools {

/// What commands that draw a chromaticity diagram are told of it.
struct DiagramOptions {
  std::string output;  // empty: none is drawn
  const ChromaticityPlane* plane = &kCie1931Plane;
  std::vector<double> limits;        // of MacAdam, luminance factors
  std::vector<DiagramGamut> gamuts;  // besides those that the command itself is about
  bool ellipses = false;
};

/// Declares --diagram and what it takes, as a section of the help page.
void declare_diagram(CommandLine& line, DiagramOptions& options);

/// The set of primaries of a name or of chromaticities, as models take them. Throws Error
/// (kMisuse).
DiagramGamut named_gamut(std::string_view text, std::string_view option);

/// The set that a model is of: "rgb:bt2020/pq"; nothing where its name has none. Throws as above.
std::optional<DiagramGamut> gamut_of(std::string_view model, std::string_view option);

/// Names of colours: the words that gave them where there is one for each, else their numbers.
std::vector<std::string> color_labels(const std::vector<std::string>& words, std::size_t count);

/// A diagram of colours of `model`, not adapted, seen from their white.
ChromaticityDiagram diagram_of(const std::vector<ColorRow>& rows,
                               const std::vector<std::string>& labels, const ModelReference& model);

/// Adds the gamut of a model that has one, unless it is there.
void add_gamut(ChromaticityDiagram& diagram, std::string_view model, std::string_view option);

/// Draws `diagram`, with the options set in it, to the file that the options name. Throws Error.
void write_diagram(ChromaticityDiagram diagram, const DiagramOptions& options, bool force);

}  // namespace tristim::tools
