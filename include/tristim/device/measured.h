#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/device/response.h"

namespace tristim {

/// Luminances that were measured at codes: of one channel, or of red, green and blue each alone.
struct MeasuredTable {
  std::string file;  // for messages
  std::vector<double> code;
  std::vector<std::vector<double>> luminance;  // a column a channel: 1 or 3
  std::vector<int> line;                       // where each row stands in the file
};

/// Rows "code,luminance" or "code,red,green,blue" between commas, semicolons or tabs, with decimal
/// points. Comments begin with '#'; a first row without numbers is a heading.
///
/// Throws Error (kContent) "<file>:<line>: <what is wrong>" for other rows, numbers that are not
/// finite, and less than 2 rows.
MeasuredTable parse_measured(std::string_view text, const std::string& file);

/// parse_measured of a file; "-" is standard input. Throws Error (kSystem) too.
MeasuredTable load_measured(const std::string& path);

/// What keeps figures from being a measured response, and the rows where that shows; the words are
/// of the first.
struct MeasuredFault {
  std::vector<std::size_t> rows;
  std::string wrong, remedy;
};

/// The first fault: codes that do not ascend or are negative, luminances that are negative, fall,
/// or do not rise at all.
std::optional<MeasuredFault> measured_fault(std::span<const double> code,
                                            std::span<const double> luminance);

/// A channel of a table as a response. Throws Error (kContent), naming the line, where
/// measured_fault finds one.
TableResponse measured_response(const MeasuredTable& table, std::size_t channel);

/// The nowhere falling luminances that are nearest to the measured in least squares: neighbours
/// that fall become their mean, until none do [Ayer55].
std::vector<double> monotone_luminance(std::span<const double> luminance);

}  // namespace tristim
