#pragma once

#include <string>

#include "tristim/color/primaries.h"

namespace tristim::tools {

/// A picture to convert, pixel by pixel.
struct PictureJob {
  std::string input, output;
  std::string from;  // "": light of the file's primaries
  std::string to;
  Adaptation adaptation = Adaptation::kBradford;
  bool keep_undefined = false;  // NaN where a component has no value; else 0
  bool replace = false;
  bool explain = false;  // print the way between the models
};

/// The numbers of a picture from one model to another, as EXR of floats. Throws Error.
void convert_picture(const PictureJob& job);

}  // namespace tristim::tools
