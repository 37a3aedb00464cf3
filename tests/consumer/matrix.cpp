#include <tristim/color/primaries.h>
#include <tristim/core/version.h>

#include <cmath>
#include <cstdio>

int main() {
  const Eigen::Vector3d white = tristim::xyz_from_rgb(tristim::Primaries{}).rowwise().sum();
  std::printf("%s %.4f\n", tristim::kVersion.data(), white.y());
  return std::abs(white.y() - 1) < 1e-12 ? 0 : 1;
}
