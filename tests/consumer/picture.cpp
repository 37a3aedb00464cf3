#include <tristim/image/io/read.h>

#include <cmath>
#include <cstdio>
#include <fstream>

// A PNM goes through the OpenImageIO module, so this also shows that the installed module is found.
int main() {
  std::ofstream("white.ppm", std::ios::binary) << "P6 2 1 255\n\xff\xff\xff\xff\xff\xff";
  const auto picture = tristim::open_picture("white.ppm");
  tristim::Image row(picture->info().width, 1, picture->info().channels);
  picture->read(row.view());
  std::printf("%d pixels of %.4f\n", picture->info().width, double{row.view().row(0)[0]});
  return std::abs(row.view().row(0)[0] - 1) < 1e-6F ? 0 : 1;
}
