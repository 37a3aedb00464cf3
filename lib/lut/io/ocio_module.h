#pragma once

#include <memory>
#include <span>
#include <string>

#include "lib/image/io/module.h"
#include "tristim/lut/io/ocio.h"
#include "tristim/lut/lut.h"

namespace tristim::detail {

/// A chain of OpenColorIO, opened; several threads may apply it at once.
class OcioProcessor {
 public:
  virtual ~OcioProcessor() = default;
  virtual void apply(std::span<float> rgb) const = 0;
};

// OpenColorIO takes 5 ms to load: it lies in a module of its own.
inline constexpr const char* kOcioRemedy = "install tristim completely";

/// A function that opens what a request names. Throws Error as open_ocio_transform does.
using OpenOcioProcessor = void(const OcioRequest& request,
                               std::unique_ptr<OcioProcessor>& processor);
inline constexpr Module kOcioTransformModule{"tristim_ocio.so", "tristim_open_ocio_processor",
                                             kOcioRemedy};

/// A function that reads a file of a format that OpenColorIO knows; `name` is for messages. Throws
/// Error (kContent).
using ReadWithOcio = void(const std::string& path, const std::string& name, Lut& lut);
inline constexpr Module kOcioReadModule{"tristim_ocio.so", "tristim_read_with_ocio", kOcioRemedy};

}  // namespace tristim::detail
