#include <string>
#include <vector>

#include "lib/lut/io/ocio/library.h"
#include "lib/lut/io/ocio_module.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

class CpuProcessor final : public OcioProcessor {
 public:
  explicit CpuProcessor(ocio::ConstCPUProcessorRcPtr processor)
      : processor_(std::move(processor)) {}

  void apply(std::span<float> rgb) const override {
    const auto pixels = static_cast<long>(rgb.size() / 3);
    ocio::PackedImageDesc picture(rgb.data(), pixels, 1, 3);
    processor_->apply(picture);
  }

 private:
  ocio::ConstCPUProcessorRcPtr processor_;
};

struct Name {
  std::string name;
};
using Names = std::vector<Name>;

// The name as the config has it, or the refusal of one that it has not.
const std::string& known(const Names& names, const std::string& name, const char* option,
                         const std::string& what) {
  if (const Name* found = find_by_name(names, name)) return found->name;
  std::string remedy = name_hint(names, name);
  if (!remedy.starts_with("use one of")) remedy += " It has " + list_names(names);
  throw Error(ErrorKind::kMisuse, option, what + " has no '" + name + "'", remedy);
}

Names colour_spaces(const ocio::ConstConfigRcPtr& config) {
  Names names;
  for (int i = 0; i < config->getNumColorSpaces(); ++i) {
    names.push_back({config->getColorSpaceNameByIndex(i)});
  }
  return names;
}

// A colour space, or one by its role; the role scene_linear where none is named.
std::string colour_space(const ocio::ConstConfigRcPtr& config, const OcioRequest& request,
                         const std::string& name, const char* option) {
  const std::string wanted = name.empty() ? ocio::ROLE_SCENE_LINEAR : name;
  if (config->getColorSpace(wanted.c_str()) != nullptr) return wanted;
  return known(colour_spaces(config), wanted, option, request.config);
}

ocio::ConstTransformRcPtr view_transform(const ocio::ConstConfigRcPtr& config,
                                         const OcioRequest& request) {
  Names displays;
  for (int i = 0; i < config->getNumDisplays(); ++i) displays.push_back({config->getDisplay(i)});
  const std::string display =
      known(displays, request.display.empty() ? config->getDefaultDisplay() : request.display,
            "--display", request.config);
  Names views;
  for (int i = 0; i < config->getNumViews(display.c_str()); ++i) {
    views.push_back({config->getView(display.c_str(), i)});
  }
  const std::string view =
      known(views, request.view.empty() ? config->getDefaultView(display.c_str()) : request.view,
            "--view", "display " + display);
  const auto transform = ocio::DisplayViewTransform::Create();
  transform->setSrc(colour_space(config, request, request.from, "--from").c_str());
  transform->setDisplay(display.c_str());
  transform->setView(view.c_str());
  return transform;
}

ocio::ConstTransformRcPtr space_transform(const ocio::ConstConfigRcPtr& config,
                                          const OcioRequest& request) {
  const auto transform = ocio::ColorSpaceTransform::Create();
  transform->setSrc(colour_space(config, request, request.from, "--from").c_str());
  transform->setDst(colour_space(config, request, request.to, "--to").c_str());
  return transform;
}

}  // namespace
}  // namespace tristim::detail

extern "C" __attribute__((visibility("default"))) void tristim_open_ocio_processor(
    const tristim::OcioRequest& request,
    std::unique_ptr<tristim::detail::OcioProcessor>& processor) {
  namespace ocio = OCIO_NAMESPACE;
  using namespace tristim;  // NOLINT(google-build-using-namespace): this function is C's
  detail::set_up_library();
  try {
    const auto config = ocio::Config::CreateFromFile(request.config.c_str());
    const auto transform = request.to.empty() ? detail::view_transform(config, request)
                                              : detail::space_transform(config, request);
    processor = std::make_unique<detail::CpuProcessor>(
        config->getProcessor(transform)->getDefaultCPUProcessor());
  } catch (const ocio::Exception& exception) {
    throw Error(ErrorKind::kContent, request.config,
                "OpenColorIO refuses it: " + detail::reason(exception));
  }
}
