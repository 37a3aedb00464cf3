#pragma once

#include <string>
#include <vector>

#include "tristim/device/response.h"

namespace tristim::tools {

/// The responses of measured tables: one file of one channel or of three, or three files of one
/// each. `monotone`: luminances that fall are levelled out, and a note says by how much; else they
/// are refused. Throws Error.
std::vector<TableResponse> read_measured(const std::vector<std::string>& files, bool monotone);

}  // namespace tristim::tools
