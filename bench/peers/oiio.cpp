#include <Imath/ImathMatrix.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <Eigen/Core>
#include <stdexcept>

#include "bench/peers/peers.h"

namespace tristim::bench {
namespace {

void check(bool done, const OIIO::ImageBuf& buffer) {
  if (!done) throw std::runtime_error("OpenImageIO: " + buffer.geterror());
}

// As OpenImageIO multiplies: rows from the left.
Imath::M44f matrix_to_srgb(const Primaries& from) {
  const Eigen::Matrix3d m = rgb_from_rgb(Primaries{}, from, Adaptation::kBradford);
  Imath::M44f turned;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      turned[column][row] = static_cast<float>(m(row, column));
    }
  }
  return turned;
}

}  // namespace

ToBytes oiio_to_bytes(const DisplayJob& job) {
  const OIIO::ImageSpec floats(job.width, job.height, 3, OIIO::TypeDesc::FLOAT);
  const OIIO::ImageSpec bytes(job.width, job.height, 3, OIIO::TypeDesc::UINT8);
  return [=, matrix = matrix_to_srgb(job.from)](const float* in, std::uint8_t* out) {
    constexpr int kThreads = 1;
    const OIIO::ImageBuf from(floats, const_cast<float*>(in));
    OIIO::ImageBuf light(floats);
    OIIO::ImageBuf to(bytes, out);  // which clips
    check(OIIO::ImageBufAlgo::colormatrixtransform(light, from, matrix, false, {}, kThreads),
          light);
    check(OIIO::ImageBufAlgo::colorconvert(to, light, "linear", "sRGB", false, "", "", nullptr, {},
                                           kThreads),
          to);
  };
}

}  // namespace tristim::bench
