#include "tristim/measure/pixels.h"

#include <algorithm>
#include <cmath>

#include "lib/core/parallel.h"
#include "lib/measure/pair.h"
#include "lib/measure/statistics.h"
#include "tristim/color/difference.h"
#include "tristim/color/lab.h"
#include "tristim/color/rows.h"

namespace tristim {
namespace {

using Row = std::span<const float>;

// What a row adds to the sums; rows are added up in their order.
struct RowSums {
  double encoded_square = 0, light_square = 0, largest = 0;
};

RowConversion from_light_to(const char* model) {
  return {parse_model("linear:srgb", "measure"), parse_model(model, "measure"), Adaptation::kNone};
}

std::vector<float> within_range(Row light) {
  std::vector<float> values(light.begin(), light.end());
  for (float& v : values) v = std::clamp(v, 0.0F, 1.0F);
  return values;
}

std::vector<float> lab_of(Row light) {
  static const RowConversion to_lab = from_light_to("lab");
  std::vector<float> values = within_range(light);
  to_lab(values, 3, values, 3);
  return values;
}

std::vector<float> encoded(Row light) {
  static const RowConversion to_code = from_light_to("rgb:srgb");
  std::vector<float> values = within_range(light);
  to_code(values, 3, values, 3);
  return values;
}

RowSums sums_of(Row reference, Row result) {
  const std::vector<float> reference_codes = encoded(reference);
  const std::vector<float> result_codes = encoded(result);
  RowSums sums;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double light = double{result[i]} - double{reference[i]};
    const double code = double{result_codes[i]} - double{reference_codes[i]};
    sums.light_square += light * light;
    sums.encoded_square += code * code;
    sums.largest = std::max(sums.largest, std::fabs(light));
  }
  return sums;
}

void differences(Row reference, Row result, float* difference) {
  const std::vector<float> a = lab_of(reference);
  const std::vector<float> b = lab_of(result);
  for (std::size_t i = 0; i < a.size(); i += 3) {
    *difference++ =
        static_cast<float>(ciede2000({a[i], a[i + 1], a[i + 2]}, {b[i], b[i + 1], b[i + 2]}));
  }
}

}  // namespace

PixelFigures pixel_figures(const PicturePair& pictures) {
  detail::check_pair(pictures);
  const int width = pictures.reference.width;
  const int height = pictures.reference.height;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<float> difference(pixels);
  std::vector<RowSums> rows(static_cast<std::size_t>(height));
  detail::parallel_for_rows(height, 0, [&](int y) {
    const Row reference = pictures.reference.row(y);
    const Row result = pictures.result.row(y);
    rows[static_cast<std::size_t>(y)] = sums_of(reference, result);
    differences(reference, result, difference.data() + static_cast<std::ptrdiff_t>(y) * width);
  });

  PixelFigures figures;
  double encoded_square = 0;
  double light_square = 0;
  for (const RowSums& row : rows) {
    encoded_square += row.encoded_square;
    light_square += row.light_square;
    figures.max_abs = std::max(figures.max_abs, row.largest);
  }
  const double samples = 3 * static_cast<double>(pixels);
  figures.rms = std::sqrt(light_square / samples);
  figures.psnr_db = -detail::decibels(encoded_square / samples);
  double sum = 0;
  for (const float d : difference) sum += double{d};
  figures.ciede2000_mean = sum / static_cast<double>(pixels);
  figures.ciede2000_max = double{*std::max_element(difference.begin(), difference.end())};
  figures.ciede2000_p95 = detail::percentile(difference, 0.95);
  return figures;
}

}  // namespace tristim
