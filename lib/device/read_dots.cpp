#include <algorithm>

#include "lib/device/read_display.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr const char* kGains[] = {"gain", "yule_nielsen", "gain_table"};

MeasuredGain measured_gain(const TomlTable& table, const std::vector<std::vector<double>>& rows) {
  MeasuredGain gain;
  for (const std::vector<double>& row : rows) {
    if (row.size() != 2) {
      table.fail("gain_table", "a row is no pair", "give [area asked for, area covered] pairs");
    }
    gain.asked.push_back(row[0]);
    gain.covered.push_back(row[1]);
  }
  const bool whole = rows.size() >= 2 && gain.asked.front() == 0 && gain.covered.front() == 0 &&
                     gain.asked.back() == 1 && gain.covered.back() == 1;
  if (!whole || !strictly_ascending(gain.asked) || !strictly_ascending(gain.covered)) {
    table.fail("gain_table", "the table of dot gain does not rise from [0, 0] to [1, 1]",
               "give areas from 0 to 1 in ascending order, [0, 0] first and [1, 1] last");
  }
  return gain;
}

DotGain read_gain(const TomlTable& table) {
  int given = 0;
  for (const char* key : kGains) given += table.has(key) ? 1 : 0;
  if (given > 1) {
    table.fail("", "dot gain is given more than once",
               "give one of gain, yule_nielsen, gain_table");
  }
  if (table.has("solid") && !table.has("yule_nielsen")) {
    table.fail("solid", "solid is of yule_nielsen", "add yule_nielsen = 1.7, or remove it");
  }
  if (const auto rows = table.rows("gain_table")) return measured_gain(table, *rows);
  if (table.has("yule_nielsen")) {
    return YuleNielsenGain{
        number_in(table, "yule_nielsen", 1, 1, 10, "from 1 to 10"),
        number_in(table, "solid", YuleNielsenGain{}.solid, kTiny, 1 - kTiny,
                  "between 0 and 1: light of the solid ink, relative to the paper")};
  }
  const double at_half =
      number_in(table, "gain", 0, 0, 0.25, "from 0 to 0.25: coverage gained at 50 %");
  if (at_half == 0) return NoGain{};
  return MurrayDaviesGain{at_half};
}

}  // namespace

std::optional<Dots> read_dots(const TomlTable& root, std::optional<Press>& press) {
  const auto table = root.table("dots");
  if (!table) return std::nullopt;
  Dots dots;
  dots.dpi = number_in(*table, "dpi", 0, 0, 1e6, "from 0 to 1000000");
  dots.lpi = number_in(*table, "lpi", 0, 0, 1e6, "from 0 to 1000000");
  dots.isolated = table->boolean("isolated").value_or(true);
  dots.gain = read_gain(*table);
  press = read_press(*table);
  table->finish();
  return dots;
}

}  // namespace tristim::detail
