#pragma once

#include <array>
#include <memory>
#include <string>

#include "lib/image/io/native_picture.h"
#include "lib/image/io/pixel_window.h"

namespace tristim::detail {

/// Libraries that take long to load lie in modules of their own, in the folder "tristim" beside
/// this library, and are loaded when a file needs them: OpenImageIO takes 250 ms, OpenEXR's C++
/// library 2 ms.
struct Module {
  const char* file;
  const char* function;  // the one that it exports, extern "C"
  const char* remedy = "install tristim completely, or convert the picture to a plain EXR or PNG";
};

/// A function that opens `path`, of a format that OpenImageIO calls `format`. `name` is for
/// messages. Throws Error (kContent).
using OpenWithOiio = void(const std::string& path, const std::string& name,
                          const std::string& format, NativePicture& picture);
inline constexpr Module kOiioModule{"tristim_oiio.so", "tristim_open_with_oiio"};

/// Which channels of an EXR file to read as R G B A; of those without a name the values are 0, of
/// A 1.
struct ExrRowsRequest {
  std::string path;
  std::string name;  // for messages
  int part = 0;
  PixelWindow data;     // that the header must have
  bool chroma = false;  // Y RY BY made RGB, of the first part; `channels` are not asked for
  std::array<std::string, 4> channels = {};
};

/// A function that gives the data window's rows as four floats a pixel. Throws Error (kContent).
using OpenExrRows = void(const ExrRowsRequest& request, std::unique_ptr<NativeRows>& rows);
inline constexpr Module kOpenExrModule{"tristim_openexr.so", "tristim_open_exr_rows"};

/// The function of a module, loaded at first use and kept. Throws Error (kSystem) where it is
/// missing.
void* load_function(const Module& module);

}  // namespace tristim::detail
