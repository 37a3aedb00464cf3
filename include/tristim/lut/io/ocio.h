#pragma once

#include <memory>
#include <span>
#include <string>

#include "tristim/color/rgb.h"

namespace tristim {

namespace detail {
class OcioProcessor;
}  // namespace detail

/// Which way through an OpenColorIO config: from a colour space to another, or to a view of a
/// display.
struct OcioRequest {
  std::string config;   // the path of a config file
  std::string from;     // a colour space or a role; "": the role scene_linear
  std::string to;       // likewise, or
  std::string display;  // a display; "" with a view: the config's default
  std::string view;     // "": the display's default
};

/// A way through an OpenColorIO config, for any number of threads.
class OcioTransform {
 public:
  /// Interleaved R G B in place, as OpenColorIO computes it in floats.
  void apply(std::span<float> rgb) const;

  /// One colour, in floats too.
  Rgb operator()(Rgb rgb) const;

 private:
  friend OcioTransform open_ocio_transform(const OcioRequest& request);
  std::shared_ptr<const detail::OcioProcessor> processor_;
};

/// Opens a way through a config. Loads OpenColorIO at first use.
///
/// Throws Error: kSystem for a missing config or where OpenColorIO cannot be loaded; kContent for a
/// config that OpenColorIO refuses or a file of it that is missing; kMisuse for a display, view or
/// colour space that it has not, with the nearest name and what there is.
OcioTransform open_ocio_transform(const OcioRequest& request);

}  // namespace tristim
