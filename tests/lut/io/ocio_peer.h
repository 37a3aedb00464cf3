#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <array>
#include <cstdint>
#include <string>

#include "tristim/lut/lut.h"

namespace tristim {

/// A table file as OpenColorIO reads it, by itself.
class OcioPeer {
 public:
  explicit OcioPeer(const std::string& path) {
    namespace ocio = OCIO_NAMESPACE;
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    const auto file = ocio::FileTransform::Create();
    file->setSrc(path.c_str());
    file->setInterpolation(ocio::INTERP_BEST);
    processor_ = ocio::Config::CreateRaw()->getProcessor(file)->getOptimizedCPUProcessor(
        ocio::OPTIMIZATION_LOSSLESS);
  }

  Rgb operator()(Rgb in) const {
    float rgb[] = {static_cast<float>(in.r), static_cast<float>(in.g), static_cast<float>(in.b)};
    processor_->applyRGB(rgb);
    return {rgb[0], rgb[1], rgb[2]};
  }

 private:
  OCIO_NAMESPACE::ConstCPUProcessorRcPtr processor_;
};

}  // namespace tristim
