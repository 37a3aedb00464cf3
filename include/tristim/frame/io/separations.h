#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tristim/frame/io/write.h"

namespace tristim {

/// Whether the files of a format are separations, one for each ink: those that printers take, TIFF
/// and PNM. `path` tells the format where `options` do not.
bool is_separated(const std::string& path, const FrameWriteOptions& options = {});

/// The file of each ink: "page.tif" gives "page.cyan.tif".
std::vector<std::string> separation_paths(const std::string& path,
                                          std::span<const std::string> inks);

/// Opens a file of one bit a pixel for each ink, black where the ink is printed; codes have bit i
/// for ink i. finish() makes all files appear, or none. Throws as open_code_sink, and Error
/// (kMisuse) for standard output.
std::unique_ptr<CodeSink> open_separations(const std::string& path, const FrameInfo& info,
                                           std::span<const std::string> inks,
                                           const FrameWriteOptions& options = {});

}  // namespace tristim
