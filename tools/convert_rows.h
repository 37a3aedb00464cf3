#pragma once

#include <string>
#include <vector>

#include "tristim/color/models.h"

namespace tristim::tools {

/// A colour to convert, and whether it was given as "nan" or without end: then what comes out
/// undefined is "nan" too, not "none".
struct ColorRow {
  Components values{};
  bool odd = false;
  std::string place = {};  // "rows.txt, row 2" of colours of a text, for messages
};

/// The colours of the arguments: numbers, as many for each colour as the model has components,
/// #rrggbb and CSS names, and whatever else the model reads. An argument may hold several,
/// separated by white space or commas. Throws Error (kContent) that names the argument.
std::vector<ColorRow> read_color_arguments(const std::vector<std::string>& arguments,
                                           const ModelReference& model);

/// The colours of a text, one a line; comments begin with '#' where it does not begin a colour.
/// `name` is what messages call the text. Throws Error (kContent) that names row and column.
std::vector<ColorRow> read_color_rows(std::string_view text, const std::string& name,
                                      const ModelReference& model);

/// Whether the text is a number, a colour, or one that the model reads.
bool is_color_text(const std::string& text, const ModelReference& model);

}  // namespace tristim::tools
