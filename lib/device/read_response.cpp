#include <cmath>

#include "lib/device/read_display.h"
#include "tristim/core/text.h"
#include "tristim/device/channels.h"
#include "tristim/device/measured.h"

namespace tristim::detail {
namespace {

struct ResponseKind {
  std::string_view name;
};
constexpr ResponseKind kResponseKinds[] = {{"srgb"},   {"linear"}, {"gamma"},
                                           {"bt1886"}, {"gog"},    {"table"}};

// What every response is read with.
struct Reader {
  double code_max;
  const std::string& directory;
};

TableResponse inline_table(const TomlTable& table, const std::vector<std::vector<double>>& rows) {
  TableResponse response;
  for (const auto& row : rows) {
    if (row.size() != 2) table.fail("table", "a row is no pair", "give [code, luminance] pairs");
    response.code.push_back(row[0]);
    response.luminance.push_back(row[1]);
  }
  if (rows.size() < 2) table.fail("table", "a measured table needs at least 2 rows");
  if (const auto fault = measured_fault(response.code, response.luminance)) {
    table.fail("table", "row " + std::to_string(fault->rows[0] + 1) + ": " + fault->wrong);
  }
  return response;
}

MeasuredTable beside(const TomlTable& table, const std::string& file, const Reader& reader) {
  if (reader.directory.empty()) {
    table.fail("file", "no file can be named here", "give the table itself");
  }
  return load_measured(file.starts_with('/') ? file : reader.directory + "/" + file);
}

// One table, or of a file with a column for each channel, three.
std::vector<Response> read_tables(const TomlTable& table, const Reader& reader) {
  std::vector<Response> responses;
  const double code_max = number_in(table, "code_max", 0, table.has("code_max") ? 1 : 0, 65535,
                                    "from 1 to 65535, the highest code of the table's kind");
  const auto add = [&](std::string_view key, TableResponse response) {
    const double most = code_max > 0 ? code_max : reader.code_max;
    if (response.code.back() > most) {
      table.fail(key, "the measured table leaves the codes 0.." + shortest(most),
                 "give code_max where its codes are others than the frame buffer's");
    }
    response.code_max = most;
    responses.emplace_back(std::move(response));
  };
  const auto rows = table.rows("table");
  const auto file = table.string("file");
  if (rows && file) table.fail("file", "both table and file are given", "give one of them");
  if (rows) {
    add("table", inline_table(table, *rows));
  } else if (file) {
    const MeasuredTable measured = beside(table, *file, reader);
    for (std::size_t c = 0; c < measured.luminance.size(); ++c) {
      add("file", measured_response(measured, c));
    }
  } else {
    table.fail("kind", "a measured response has no figures",
               "give table = [[code, luminance], ...] or file = \"measured.csv\"");
  }
  return responses;
}

constexpr std::string_view kBelowOne = "from 0 up to, not including, 1";

double read_gamma(const TomlTable& table) {
  return number_in(table, "gamma", 2.2, 0.01, 100, "from 0.01 to 100");
}

// One response for all channels, or three.
std::vector<Response> read_kind(const TomlTable& table, const Reader& reader) {
  const std::string_view kind = choice(table, "kind", kResponseKinds, kResponseKinds[0]).name;
  if (kind == "table") return read_tables(table, reader);
  if (kind == "linear") return {LinearResponse{}};
  if (kind == "gamma") {
    return {GammaResponse{
        .gamma = read_gamma(table),
        .i0 = number_in(table, "i0", 0, 0, 1 - kTiny, kBelowOne),
        .k = number_in(table, "k", 0, table.has("k") ? 1e-300 : 0, 1e300, "above 0")}};
  }
  if (kind == "bt1886") {
    return {Bt1886Response{number_in(table, "black", 0, 0, 1 - kTiny, kBelowOne)}};
  }
  if (kind == "gog") {
    return {GogResponse{
        .gamma = read_gamma(table),
        .offset = number_in(table, "offset", 0, kTiny - 1, 1 - kTiny, "between -1 and 1"),
        .black = number_in(table, "black", 0, 0, 1 - kTiny, kBelowOne)}};
  }
  return {SrgbResponse{}};
}

void take(const TomlTable& table, const std::vector<Response>& read, Display& display) {
  if (read.size() == 1) {
    display.response = read[0];
    return;
  }
  if (display.frame.packing.samples != 3) {
    table.fail("file", "it measures red, green and blue, but the codes have one channel",
               "give a file with the columns code,luminance");
  }
  for (std::size_t c = 0; c < 3; ++c) display.channel_response[c] = read[c];
}

}  // namespace

void read_response(const TomlTable& root, Display& display, const std::string& directory) {
  const auto table = root.table("response");
  if (!table) return;
  const auto code_max = [&](std::size_t c) {
    return static_cast<double>((1 << display.frame.packing.bits[c]) - 1);
  };
  take(*table, read_kind(*table, {code_max(0), directory}), display);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto channel = table->table(kChannelNames[c]);
    if (!channel) continue;
    if (display.frame.packing.samples != 3) {
      table->fail(kChannelNames[c], "the codes have one channel", "give one [response]");
    }
    const std::vector<Response> read = read_kind(*channel, {code_max(c), directory});
    if (read.size() != 1) {
      channel->fail("file", "a file of three channels stands in [response] itself");
    }
    display.channel_response[c] = read[0];
    channel->finish();
  }
  table->finish();
}

}  // namespace tristim::detail
