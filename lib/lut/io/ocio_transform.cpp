#include "lib/lut/io/ocio_module.h"
#include "tristim/core/file.h"

namespace tristim {

void OcioTransform::apply(std::span<float> rgb) const { processor_->apply(rgb); }

Rgb OcioTransform::operator()(Rgb rgb) const {
  float values[] = {static_cast<float>(rgb.r), static_cast<float>(rgb.g),
                    static_cast<float>(rgb.b)};
  processor_->apply(values);
  return {values[0], values[1], values[2]};
}

OcioTransform open_ocio_transform(const OcioRequest& request) {
  (void)read_text_file(request.config);  // its errors say more than the library's
  std::unique_ptr<detail::OcioProcessor> processor;
  auto* open = reinterpret_cast<detail::OpenOcioProcessor*>(
      detail::load_function(detail::kOcioTransformModule));
  open(request, processor);
  OcioTransform transform;
  transform.processor_ = std::move(processor);
  return transform;
}

}  // namespace tristim
