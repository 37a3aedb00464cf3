#include <limits>
#include <string>

#include "lib/lut/io/clf.h"
#include "lib/lut/io/ocio/library.h"
#include "lib/lut/io/ocio_module.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

class StepReader {
 public:
  StepReader(const std::string& name, Lut& lut) : name_(name), lut_(lut) {}

  void read(const ocio::ConstTransformRcPtr& transform) {
    if (transform->getDirection() == ocio::TRANSFORM_DIR_INVERSE) refuse("a table to be inverted");
    if (const auto group = std::dynamic_pointer_cast<const ocio::GroupTransform>(transform)) {
      for (int i = 0; i < group->getNumTransforms(); ++i) read(group->getTransform(i));
    } else if (const auto curves =
                   std::dynamic_pointer_cast<const ocio::Lut1DTransform>(transform)) {
      read_curves(*curves);
    } else if (const auto cube = std::dynamic_pointer_cast<const ocio::Lut3DTransform>(transform)) {
      read_cube(*cube);
    } else if (const auto matrix =
                   std::dynamic_pointer_cast<const ocio::MatrixTransform>(transform)) {
      read_matrix(*matrix);
    } else if (const auto range =
                   std::dynamic_pointer_cast<const ocio::RangeTransform>(transform)) {
      read_range(*range);
    } else {
      refuse("a step that is no table, matrix or range");
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::kContent, name_, "has " + what,
                "bake it: make it a view of a config, and tristim lut bake --ocio");
  }

  void read_curves(const ocio::Lut1DTransform& transform) {
    if (transform.getHueAdjust() != ocio::HUE_NONE) refuse("curves that keep the hue");
    if (transform.getInputHalfDomain()) return read_half_curves(transform);
    Lut1D curves{{}, static_cast<int>(transform.getLength()), {}};
    curves.rgb.resize(curve_samples(curves.size));
    for (std::size_t i = 0; i < transform.getLength(); ++i) {
      float* rgb = curves.rgb.data() + 3 * i;
      transform.getValue(i, rgb[0], rgb[1], rgb[2]);
    }
    lut_.steps.emplace_back(std::move(curves));
  }

  // The entries of finite half floats, ascending: those of negative ones lie behind the positive
  // ones and turned about.
  void read_half_curves(const ocio::Lut1DTransform& transform) {
    LutPoints points;
    for (int half = -kLastHalf; half <= kLastHalf; ++half) {
      const unsigned bits =
          half < 0 ? 0x8000U - static_cast<unsigned>(half) : static_cast<unsigned>(half);
      float rgb[3];
      transform.getValue(bits, rgb[0], rgb[1], rgb[2]);
      for (std::size_t c = 0; c < 3; ++c) {
        points.curves[c].in.push_back(half_value(bits));
        points.curves[c].out.push_back(rgb[c]);
      }
    }
    lut_.steps.emplace_back(std::move(points));
  }

  static constexpr int kLastHalf = 0x7bff;  // 65504

  void read_cube(const ocio::Lut3DTransform& transform) {
    Lut3D cube{{}, static_cast<int>(transform.getGridSize()), {}};
    cube.rgb.resize(cube_samples(cube.size));
    const auto size = static_cast<std::size_t>(cube.size);
    for (std::size_t i = 0; i < size * size * size; ++i) {
      float* rgb = cube.rgb.data() + 3 * i;
      transform.getValue(i % size, i / size % size, i / (size * size), rgb[0], rgb[1], rgb[2]);
    }
    lut_.steps.emplace_back(std::move(cube));
  }

  void read_matrix(const ocio::MatrixTransform& transform) {
    double matrix[16];
    double offset[4];
    transform.getMatrix(matrix);
    transform.getOffset(offset);
    LutMatrix step;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        step.matrix(row, column) = matrix[4 * row + column];
      step.offset(row) = offset[row];
    }
    lut_.steps.emplace_back(step);
  }

  // A straight line that clamps where it says so, which points do at their ends.
  void read_range(const ocio::RangeTransform& range) {
    const bool low = range.hasMinInValue();
    const bool high = range.hasMaxInValue();
    const double scale = low && high ? (range.getMaxOutValue() - range.getMinOutValue()) /
                                           (range.getMaxInValue() - range.getMinInValue())
                                     : 1;
    const double offset = low    ? range.getMinOutValue() - scale * range.getMinInValue()
                          : high ? range.getMaxOutValue() - range.getMaxInValue()
                                 : 0;
    if (range.getStyle() == ocio::RANGE_NO_CLAMP || (!low && !high)) {
      LutMatrix step;
      step.matrix *= scale;
      step.offset.fill(offset);
      lut_.steps.emplace_back(step);
      return;
    }
    constexpr float kFar = std::numeric_limits<float>::max() / 4;
    const float from = low ? static_cast<float>(range.getMinInValue()) : -kFar;
    const float to = high ? static_cast<float>(range.getMaxInValue()) : kFar;
    const LutCurve curve{
        {from, to},
        {static_cast<float>(scale * from + offset), static_cast<float>(scale * to + offset)}};
    lut_.steps.emplace_back(LutPoints{{curve, curve, curve}});
  }

  const std::string& name_;
  Lut& lut_;
};

std::string title_of(const ocio::FormatMetadata& metadata) {
  for (int i = 0; i < metadata.getNumChildrenElements(); ++i) {
    const ocio::FormatMetadata& child = metadata.getChildElement(i);
    if (std::string_view(child.getElementName()) == "Description") return child.getElementValue();
  }
  return "";
}

}  // namespace
}  // namespace tristim::detail

extern "C" __attribute__((visibility("default"))) void tristim_read_with_ocio(
    const std::string& path, const std::string& name, tristim::Lut& lut) {
  namespace ocio = OCIO_NAMESPACE;
  using namespace tristim;  // NOLINT(google-build-using-namespace): this function is C's
  detail::set_up_library();
  try {
    const auto file = ocio::FileTransform::Create();
    file->setSrc(path.c_str());
    const auto processor = ocio::Config::CreateRaw()->getProcessor(file);
    const auto group = processor->createGroupTransform();
    ocio::ClearAllCaches();  // the next file may have the same name
    lut.title = detail::title_of(processor->getFormatMetadata());
    if (lut.title.empty()) lut.title = detail::title_of(group->getFormatMetadata());
    detail::StepReader(name, lut).read(group);
  } catch (const ocio::Exception& exception) {
    std::string text = detail::reason(exception);
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at)) {
      text.replace(at, path.size(), "the file");
    }
    throw Error(ErrorKind::kContent, name, "OpenColorIO cannot read it: " + text);
  }
}
