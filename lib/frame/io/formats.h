#pragma once

#include <memory>
#include <string>

#include "tristim/frame/code.h"
#include "tristim/frame/io/write.h"

namespace tristim::detail {

/// One for each of kFrameFormats; all as open_code_sink.
std::unique_ptr<CodeSink> open_png(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options);
std::unique_ptr<CodeSink> open_gif(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options);
std::unique_ptr<CodeSink> open_bmp(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options);
std::unique_ptr<CodeSink> open_tiff(const std::string& path, const FrameInfo& info,
                                    const FrameWriteOptions& options);
std::unique_ptr<CodeSink> open_pnm(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options);
std::unique_ptr<CodeSink> open_raw(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options);
std::unique_ptr<CodeSink> open_c_header(const std::string& path, const FrameInfo& info,
                                        const FrameWriteOptions& options);

}  // namespace tristim::detail
