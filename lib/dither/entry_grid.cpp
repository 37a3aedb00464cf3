#include "lib/dither/entry_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lib/palette/oklab_toe-inl.h"

namespace tristim::detail {
namespace {

using Color = MixPalette::Color;

constexpr float kAmong = 0.25F;     // of the palette's extent, that narrow cells reach beyond it
constexpr float kRounding = 1e-5F;  // of squared distances, beside their sizes
constexpr int kCoarse = 4;          // cells of the fine grid in one of the coarse, a side

const HWY_NAMESPACE::OklabToe<float>& toe_places() {
  static const HWY_NAMESPACE::OklabToe<float> places([](float x) { return x; }, root_of_toe());
  return places;
}

// NaN counts as the lowest.
float held_inside(const EntryGrid::Axis& axis, float place) noexcept {
  const float held = place > axis.knot.front() ? place : axis.knot.front();
  return held < axis.knot.back() ? held : axis.knot.back();
}

int cell_of(const EntryGrid::Axis& axis, float held) noexcept {
  float cells = 0;
  for (std::size_t i = 0; i < EntryGrid::kZones; ++i) {
    const float inside = (held - axis.knot[i]) * axis.cells_per_unit[i];
    cells += std::min(std::max(inside, 0.0F), static_cast<float>(EntryGrid::kCells[i]));
  }
  return std::min(static_cast<int>(cells), EntryGrid::kSide - 1);
}

// Where a cell begins.
float knot_of(const EntryGrid::Axis& axis, int cell) noexcept {
  std::size_t zone = 0;
  while (zone + 1 < EntryGrid::kZones && cell >= EntryGrid::kCells[zone]) {
    cell -= EntryGrid::kCells[zone++];
  }
  const float part = static_cast<float>(cell) / static_cast<float>(EntryGrid::kCells[zone]);
  return axis.knot[zone] + part * (axis.knot[zone + 1] - axis.knot[zone]);
}

}  // namespace

EntryGrid::EntryGrid(const MixPalette& palette)
    : palette_(&palette), toe_(palette.places_light_by(oklab_toe_place)) {
  for (int i = 0; i < palette.size(); ++i) {
    const Color at = place(palette.entry(i));
    for (std::size_t a = 0; a < 3; ++a) axes_[a].place.push_back(at[a]);
  }
  set_knots();
  Entries all(static_cast<std::size_t>(palette.size()));
  std::iota(all.begin(), all.end(), 0);
  constexpr int kBlocks = kSide / kCoarse;
  std::vector<Entries> coarse;
  for (int i = 0; i < kBlocks * kBlocks * kBlocks; ++i) {
    coarse.push_back(
        possible(box({i / (kBlocks * kBlocks), i / kBlocks % kBlocks, i % kBlocks}, kBlocks), all));
  }
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int z = 0; z < kSide; ++z) {
        const int block = (x / kCoarse * kBlocks + y / kCoarse) * kBlocks + z / kCoarse;
        const Entries entries =
            possible(box({x, y, z}, kSide), coarse[static_cast<std::size_t>(block)]);
        first_.push_back(static_cast<std::int32_t>(list_.size()));
        count_.push_back(static_cast<std::int32_t>(entries.size()));
        list_.insert(list_.end(), entries.begin(), entries.end());
      }
    }
  }
}

void EntryGrid::set_knots() {
  for (Axis& axis : axes_) {
    const auto [low, high] = std::minmax_element(axis.place.begin(), axis.place.end());
    const float beyond = kAmong * (*high - *low);
    axis.knot = {*low - beyond, *low - beyond, *high + beyond, *high + beyond};
  }
  for (int corner = 0; corner < 8; ++corner) {
    Color far{};
    for (std::size_t c = 0; c < 3; ++c) {
      far[c] = (corner >> c & 1) != 0 ? palette_->highest()[c] : palette_->lowest()[c];
    }
    const Color at = place(far);
    for (std::size_t a = 0; a < 3; ++a) {
      axes_[a].knot.front() = std::min(axes_[a].knot.front(), at[a]);
      axes_[a].knot.back() = std::max(axes_[a].knot.back(), at[a]);
    }
  }
  for (Axis& axis : axes_) {
    for (std::size_t i = 0; i < kZones; ++i) {
      const float extent = axis.knot[i + 1] - axis.knot[i];
      if (extent > 0) axis.cells_per_unit[i] = static_cast<float>(kCells[i]) / extent;
    }
  }
}

EntryGrid::Box EntryGrid::box(const std::array<int, 3>& cell, int cells) const noexcept {
  Box box{};
  const int size = kSide / cells;
  for (std::size_t a = 0; a < 3; ++a) {
    const float low = knot_of(axes_[a], cell[a] * size);
    const float high = knot_of(axes_[a], (cell[a] + 1) * size);
    box.middle[a] = (low + high) / 2;
    box.reach[a] = (high - low) / 2;
  }
  return box;
}

// Of two entries a and b, |p - a|^2 - |p - b|^2 is linear in p, so that it is largest in a corner
// of the box: an entry is left out where the one nearest to the middle is nearer in every corner.
EntryGrid::Entries EntryGrid::possible(const Box& box, const Entries& among) const {
  const auto offset = [&](std::int32_t entry, std::size_t a) {
    return axes_[a].place[static_cast<std::size_t>(entry)] - box.middle[a];
  };
  const auto distance2 = [&](std::int32_t entry) {
    const float x = offset(entry, 0);
    const float y = offset(entry, 1);
    const float z = offset(entry, 2);
    return x * x + y * y + z * z;
  };
  std::int32_t nearest = 0;
  float least = std::numeric_limits<float>::infinity();
  for (const std::int32_t entry : among) {
    const float d = distance2(entry);
    if (d < least) {
      least = d;
      nearest = entry;
    }
  }
  Entries left;
  for (const std::int32_t entry : among) {
    const float d = distance2(entry);
    float gain = kRounding * (d + least);
    for (std::size_t a = 0; a < 3; ++a) {
      gain += 2 * std::abs(offset(entry, a) - offset(nearest, a)) * box.reach[a];
    }
    if (d - least <= gain) left.push_back(entry);
  }
  return left;
}

// Most metrics know nothing beyond [0, 1], where errors push colours: there they go on as they
// came, turned about the point where the colour leaves.
Color EntryGrid::place(const Color& color) const noexcept {
  if (toe_) return toe_places()(color[0], color[1], color[2]);
  Color rim{};
  Color turned{};
  for (std::size_t c = 0; c < 3; ++c) {
    rim[c] = std::clamp(color[c], 0.0F, 1.0F);
    turned[c] = std::clamp(2 * rim[c] - color[c], 0.0F, 1.0F);
  }
  Color place = palette_->place(rim);
  if (rim == color) return place;
  const Color back = palette_->place(turned);
  for (std::size_t a = 0; a < 3; ++a) place[a] = 2 * place[a] - back[a];
  return place;
}

int EntryGrid::nearest(const Color& color) const noexcept {
  Color at = place(color);
  int cell = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = held_inside(axes_[a], at[a]);
    cell = cell * kSide + cell_of(axes_[a], at[a]);
  }
  const auto first = static_cast<std::size_t>(first_[static_cast<std::size_t>(cell)]);
  const auto count = static_cast<std::size_t>(count_[static_cast<std::size_t>(cell)]);
  std::int32_t best = list_[first];
  if (count == 1) return best;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = first; i < first + count; ++i) {
    const auto entry = static_cast<std::size_t>(list_[i]);
    const float x = axes_[0].place[entry] - at[0];
    const float y = axes_[1].place[entry] - at[1];
    const float z = axes_[2].place[entry] - at[2];
    const float distance2 = (x * x + y * y) + z * z;
    if (distance2 < least) {
      least = distance2;
      best = list_[i];
    }
  }
  return best;
}

}  // namespace tristim::detail
