#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tristim/core/error.h"
#include "tristim/device/fit.h"
#include "tristim/device/measured.h"

// Tables of measured luminances: any bytes are a table or an Error of their content, and what is a
// table of few rows can be levelled out and fitted.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tristim;  // NOLINT(google-build-using-namespace): nothing else is here
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    MeasuredTable table = parse_measured(text, "input");
    for (std::size_t c = 0; c < table.luminance.size() && table.code.size() < 32; ++c) {
      table.luminance[c] = monotone_luminance(table.luminance[c]);
      const TableResponse response = measured_response(table, c);
      (void)fit_response(response, response.code.back());
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kContent) throw;
  }
  return 0;
}
