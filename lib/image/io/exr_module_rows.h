#pragma once

#include <memory>

#include "lib/image/io/exr_colour.h"

namespace tristim::detail {

/// Whether OpenEXR's core library cannot decode these channels: luminance and chroma, and DWA
/// compression in version 3.1.
bool needs_exr_module(const ExrPart& part, const ExrSelection& selection);

/// Rows of such channels, by OpenEXR's C++ library in its module. `info` is of the picture.
/// Throws Error: kContent where the file is damaged, or has luminance and chroma in a layer or in
/// another part than the first; kSystem where the module is missing.
std::unique_ptr<RowSource> open_exr_module_rows(InputFilePtr file, const ExrPart& part,
                                                const ExrSelection& selection,
                                                const ExrColour& colour, const PictureInfo& info);

}  // namespace tristim::detail
