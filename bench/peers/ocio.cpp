#include <OpenColorIO/OpenColorIO.h>

#include <Eigen/Core>

#include "bench/peers/peers.h"

namespace tristim::bench {
namespace {

namespace ocio = OCIO_NAMESPACE;

ocio::MatrixTransformRcPtr matrix_to_srgb(const Primaries& from) {
  const Eigen::Matrix3d m = rgb_from_rgb(Primaries{}, from, Adaptation::kBradford);
  const double rows[] = {m(0, 0), m(0, 1), m(0, 2), 0, m(1, 0), m(1, 1), m(1, 2), 0,
                         m(2, 0), m(2, 1), m(2, 2), 0, 0,       0,       0,       1};
  const auto matrix = ocio::MatrixTransform::Create();
  matrix->setMatrix(rows);
  return matrix;
}

ocio::RangeTransformRcPtr clip() {
  const auto range = ocio::RangeTransform::Create();
  range->setMinInValue(0);
  range->setMinOutValue(0);
  range->setMaxInValue(1);
  range->setMaxOutValue(1);
  return range;
}

ocio::ExponentWithLinearTransformRcPtr srgb_curve() {
  const auto curve = ocio::ExponentWithLinearTransform::Create();
  curve->setGamma({2.4, 2.4, 2.4, 1});
  curve->setOffset({0.055, 0.055, 0.055, 0});
  curve->setDirection(ocio::TRANSFORM_DIR_INVERSE);
  return curve;
}

}  // namespace

ToBytes ocio_to_bytes(const DisplayJob& job) {
  const auto chain = ocio::GroupTransform::Create();
  chain->appendTransform(matrix_to_srgb(job.from));
  chain->appendTransform(clip());
  chain->appendTransform(srgb_curve());
  const auto processor = ocio::Config::CreateRaw()->getProcessor(chain)->getOptimizedCPUProcessor(
      ocio::BIT_DEPTH_F32, ocio::BIT_DEPTH_UINT8, ocio::OPTIMIZATION_DEFAULT);
  return [processor, job](const float* in, std::uint8_t* out) {
    const ocio::PackedImageDesc from(const_cast<float*>(in), job.width, job.height, 3);
    ocio::PackedImageDesc to(out, job.width, job.height, 3, ocio::BIT_DEPTH_UINT8, ocio::AutoStride,
                             ocio::AutoStride, ocio::AutoStride);
    processor->apply(from, to);
  };
}

FloatPixels ocio_cube(const Lut3D& cube, bool is_trilinear) {
  const auto size = static_cast<unsigned long>(cube.size);  // NOLINT(google-runtime-int)
  const auto lut = ocio::Lut3DTransform::Create(size);
  lut->setInterpolation(is_trilinear ? ocio::INTERP_LINEAR : ocio::INTERP_TETRAHEDRAL);
  for (unsigned long i = 0; i < size * size * size; ++i) {  // NOLINT(google-runtime-int)
    const float* p = &cube.rgb[3 * i];
    lut->setValue(i % size, i / size % size, i / (size * size), p[0], p[1], p[2]);
  }
  const auto processor = ocio::Config::CreateRaw()->getProcessor(lut)->getDefaultCPUProcessor();
  return [processor](const float* in, float* out, int pixels) {
    const ocio::PackedImageDesc from(const_cast<float*>(in), pixels, 1, 3);
    ocio::PackedImageDesc to(out, pixels, 1, 3);
    processor->apply(from, to);
  };
}

}  // namespace tristim::bench
