#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/process_job.h"
#include "tools/process_palette.h"
#include "tristim/frame/code.h"
#include "tristim/image/picture.h"

namespace tristim::tools {

/// Refuses an output whose format, by --format or its extension, is none, and a proof that is not
/// called .png. Throws Error (kMisuse).
void check_format(const ProcessOptions& options, const std::string& output);
void check_proof_format(const std::string& proof);

/// The files that an output becomes: itself, or one for each ink of a press.
std::vector<std::string> output_files(const ProcessOptions& options, const Display& device,
                                      const std::string& output);

/// Whether the format of an output has a palette, and whether it has nothing else: GIF.
bool is_indexed_format(const ProcessOptions& options, const std::string& output);
bool is_indexed_only(const ProcessOptions& options, const std::string& output);

/// Opens an output for `frames` pictures of the size of `picture`, or a proof. Throw Error as
/// open_code_sink does.
std::unique_ptr<CodeSink> open_sink(const ProcessOptions& options, const std::string& output,
                                    const PaletteDisplay& palette, const PictureInfo& picture,
                                    int frames = 1);
std::unique_ptr<CodeSink> open_proof(const ProcessOptions& options, const std::string& path,
                                     const PictureInfo& picture);

}  // namespace tristim::tools
