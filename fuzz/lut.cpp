#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/lut/io/file.h"

using namespace tristim;  // NOLINT(google-build-using-namespace): nothing else is here

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

// Larger tables would only be slow to write.
constexpr std::size_t kMostSamples = 6000;

bool is_small(const LutStep& step) {
  const auto* curves = std::get_if<Lut1D>(&step);
  const auto* cube = std::get_if<Lut3D>(&step);
  return (curves == nullptr || curves->rgb.size() < kMostSamples) &&
         (cube == nullptr || cube->rgb.size() < kMostSamples);
}

// A table that the format holds.
Lut seed(const LutFormat& format, std::size_t kind) {
  const LutCapacity& holds = format.holds;
  const int size = holds.sizes.empty() ? 2 : holds.sizes[0];
  Lut lut{"seed", {}};
  if (holds.cube > 0 && (kind % 2 == 0 || holds.curves == 0)) {
    if (holds.shaper > 0 && kind % 4 == 0) {
      lut.steps.emplace_back(Lut1D{{}, 4, {0, 0, 0, .5F, .5F, .5F, .6F, .6F, .6F, 1, 1, 1}});
    }
    lut.steps.emplace_back(Lut3D{{}, size, std::vector<float>(cube_samples(size), 0.5F)});
  } else {
    lut.steps.emplace_back(Lut1D{{}, size, std::vector<float>(curve_samples(size), 0.25F)});
  }
  return lut;
}

}  // namespace

// Begins with files that are good: nothing else has the words of a format by chance.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned chance) {
  if (size > 1 && chance % 64 != 0) return LLVMFuzzerMutate(data, size, most);
  const LutFormat& format = *find_by_name(lut_formats(), TRISTIM_FORMAT);
  const std::string bytes = lut_bytes(seed(format, chance / 64), format, "seed");
  const std::size_t count = std::min(bytes.size(), most);
  std::memcpy(data, bytes.data(), count);
  return count;
}

// The reader of one table format, whose name the build gives: any bytes are a table or an Error of
// their content, and what was read can be written in every format that holds it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const LutFileOptions options{.cube = size % 2 == 0};
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Lut lut = parse_lut(bytes, "input", TRISTIM_FORMAT, options);
    if (!std::all_of(lut.steps.begin(), lut.steps.end(), is_small)) return 0;
    for (const LutFormat& format : lut_formats()) {
      if (format.name == "clf" || format.name == "ctf" || !holds(format, lut)) continue;
      LutFileOptions again;
      again.cube = !lut.steps.empty() && std::holds_alternative<Lut3D>(lut.steps[0]);
      (void)parse_lut(lut_bytes(lut, format, "output", again), "output", format.name, again);
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kContent) throw;
  }
  return 0;
}
