#include "tristim/dither/matrix_text.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "lib/dither/cells.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

constexpr int kMostSide = 4096;
constexpr std::string_view kSeparators = ",; \t\r";

std::string_view without_comment(std::string_view line) {
  return line.substr(0, std::min({line.size(), line.find('#'), line.find("//")}));
}

// The words of a row.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(kSeparators, at)) < line.size();) {
    const std::size_t end = std::min(line.size(), line.find_first_of(kSeparators, at));
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string place(std::size_t row, std::size_t column) {
  return "row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1);
}

[[noreturn]] void fail(const std::string& name, const std::string& wrong,
                       const std::string& remedy) {
  throw Error(ErrorKind::kContent, name, wrong, remedy);
}

// Two commas with nothing between them are a hole in the table.
void refuse_empty_cells(std::string_view line, std::size_t row, const std::string& name) {
  std::size_t column = 0;
  bool filled = false;
  const std::size_t last = line.find_last_not_of(kSeparators);
  for (std::size_t i = 0; last != std::string_view::npos && i < last; ++i) {
    const char c = line[i];
    if (c == ',' || c == ';') {
      if (!filled) {
        fail(name, place(row, column) + " is empty", "write a whole number between the commas");
      }
      filled = false;
      ++column;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      filled = true;
    }
  }
}

struct Table {
  std::size_t width = 0, height = 0;
  std::vector<long long> number;  // rows from y
  std::string where(std::size_t cell) const { return place(cell / width, cell % width); }
};

Table parse_table(std::string_view text, const std::string& name) {
  Table table;
  for (const std::string_view whole_line : split(without_utf8_mark(text), '\n')) {
    const std::string_view line = without_comment(whole_line);
    refuse_empty_cells(line, table.height, name);
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) continue;
    if (table.height == 0) table.width = words.size();
    for (std::size_t column = 0; column < words.size(); ++column) {
      const auto number = parse_integer(words[column]);
      if (!number) {
        fail(name,
             place(table.height, column) + ": '" + std::string(words[column]) +
                 "' is no whole number",
             "write the ranks 0, 1, 2, ... in rows");
      }
      table.number.push_back(*number);
    }
    ++table.height;
    if (words.size() != table.width) {
      fail(name,
           "row " + std::to_string(table.height) + " has " + std::to_string(words.size()) +
               " numbers, the first row " + std::to_string(table.width),
           "make all rows of one length");
    }
  }
  if (table.height == 0) fail(name, "holds no numbers", "write a matrix of one cell at least");
  if (table.width > kMostSide || table.height > kMostSide) {
    fail(name,
         "is " + std::to_string(table.width) + " x " + std::to_string(table.height) + " cells",
         "use " + std::to_string(kMostSide) + " a side at most");
  }
  return table;
}

using Cells = std::vector<std::size_t>;

// Where each rank is; takes off a start at 1, and tells what is no rank.
std::vector<Cells> cells_by_rank(Table& table, int ranks, long long start,
                                 const std::string& name) {
  std::vector<Cells> cells_of(static_cast<std::size_t>(ranks));
  for (std::size_t cell = 0; cell < table.number.size(); ++cell) {
    const long long rank = table.number[cell] -= start;
    if (rank < 0 || rank >= ranks) {
      fail(name,
           table.where(cell) + ": " + std::to_string(rank + start) + " is no rank of " +
               std::to_string(table.number.size()) + " cells",
           "use " + std::to_string(start) + " to " + std::to_string(ranks - 1 + start));
    }
    cells_of[static_cast<std::size_t>(rank)].push_back(cell);
  }
  return cells_of;
}

// Tells what repeats and what is missing.
void check_ranks(Table& table, int ranks, const std::string& name) {
  const long long start = std::ranges::min(table.number) == 1 ? 1 : 0;
  const std::vector<Cells> cells_of = cells_by_rank(table, ranks, start, name);
  const std::size_t most = (table.number.size() + cells_of.size() - 1) / cells_of.size();
  const std::size_t least = table.number.size() / cells_of.size();
  std::string repeated;
  std::string missing;
  for (std::size_t rank = cells_of.size(); rank-- > 0;) {  // so that the first one is told
    const Cells& cells = cells_of[rank];
    const std::string number = std::to_string(static_cast<long long>(rank) + start);
    if (cells.size() < least) missing = number + " is missing";
    if (cells.size() > most) {
      repeated =
          table.where(cells[most]) + " repeats the " + number + " of " + table.where(cells[0]);
    }
  }
  if (missing.empty() && repeated.empty()) return;
  const bool both = !missing.empty() && !repeated.empty();
  fail(name, repeated + (both ? ", and " : "") + missing,
       "use each of " + std::to_string(start) + " to " + std::to_string(ranks - 1 + start) +
           " once");
}

// The rows of a pattern: 0 and 1, with separators or without.
std::optional<std::vector<std::uint8_t> > pattern_row(std::string_view line) {
  std::vector<std::uint8_t> row;
  for (const char c : line) {
    if (kSeparators.find(c) != std::string_view::npos) continue;
    if (c != '0' && c != '1') return std::nullopt;
    row.push_back(c == '1' ? 1 : 0);
  }
  return row;
}

// Comma-separated rows, each with `end` behind it.
std::string rows_text(const ThresholdMatrix& matrix, std::string_view begin, std::string_view end) {
  std::string text;
  for (int y = 0; y < matrix.height; ++y) {
    text += begin;
    for (int x = 0; x < matrix.width; ++x) {
      if (x > 0) text += ", ";
      text += std::to_string(matrix.row(y)[x]);
    }
    text += end;
  }
  return text;
}

// A matrix's name as C has names.
std::string c_name(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9';
    if (digit && result.empty()) result += '_';
    result += letter || digit ? c : '_';
  }
  return result.empty() ? "matrix" : result;
}

}  // namespace

ThresholdMatrix parse_matrix(std::string_view text, const std::string& name) {
  Table table = parse_table(text, name);
  const auto ranks =
      static_cast<int>(std::min<std::size_t>(table.number.size(), detail::kMostRanks));
  check_ranks(table, ranks, name);
  ThresholdMatrix matrix{.name = name,
                         .source = "of " + name,
                         .width = static_cast<int>(table.width),
                         .height = static_cast<int>(table.height),
                         .ranks = ranks};
  for (const long long rank : table.number) {
    matrix.rank.push_back(static_cast<std::uint16_t>(rank));
  }
  return matrix;
}

std::optional<PatternSequence> parse_patterns(std::string_view text, const std::string& name) {
  std::vector<std::vector<std::uint8_t> > patterns(1);
  std::size_t width = 0;
  for (const std::string_view line : split(without_utf8_mark(text), '\n')) {
    const std::string_view content = without_comment(line);
    const bool is_comment = content.size() < line.size();
    const auto row = pattern_row(content);
    if (!row) return std::nullopt;
    if (row->empty()) {
      if (!is_comment && !patterns.back().empty()) patterns.emplace_back();
      continue;
    }
    if (width == 0) width = row->size();
    if (row->size() != width) {
      fail(name,
           "pattern " + std::to_string(patterns.size()) + " has a row of " +
               std::to_string(row->size()) + " cells, the first row " + std::to_string(width),
           "make all patterns of one size");
    }
    patterns.back().insert(patterns.back().end(), row->begin(), row->end());
  }
  if (patterns.back().empty()) patterns.pop_back();
  if (patterns.size() < 2) return std::nullopt;
  for (const auto& pattern : patterns) {
    if (pattern.size() == patterns.front().size()) continue;
    fail(name,
         "pattern " + std::to_string(&pattern - patterns.data() + 1) + " has " +
             std::to_string(pattern.size() / width) + " rows, the first pattern " +
             std::to_string(patterns.front().size() / width),
         "make all patterns of one size");
  }
  return pattern_sequence(name, static_cast<int>(width),
                          static_cast<int>(patterns.front().size() / width), patterns);
}

ThresholdMatrix matrix_from_picture(ImageView<const float> picture, const std::string& name) {
  if (picture.width < 1 || picture.height < 1) {
    throw std::invalid_argument("picture of a matrix: no pixels");
  }
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<std::size_t> order(width * static_cast<std::size_t>(picture.height));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto grey = [&](std::size_t cell) {
    const float value =
        *picture.pixel(static_cast<int>(cell % width), static_cast<int>(cell / width));
    return value == value ? value : 0.0F;
  };
  const ThresholdMatrix dispersed =
      bayer_matrix({.size = detail::kMostCellSize});  // tells equal greys apart
  const auto tie = [&](std::size_t cell) {
    return dispersed.row(static_cast<int>(cell / width))[cell % width % detail::kMostCellSize];
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const float ga = grey(a);
    const float gb = grey(b);
    return ga != gb ? ga < gb : tie(a) < tie(b);
  });
  ThresholdMatrix matrix{.name = name,
                         .source = "of " + name,
                         .width = picture.width,
                         .height = picture.height,
                         .rank = std::vector<std::uint16_t>(order.size())};
  detail::assign_ranks(order, matrix);
  return matrix;
}

std::string matrix_csv(const ThresholdMatrix& matrix) {
  return "# " + matrix.name + ", " + std::to_string(matrix.width) + " x " +
         std::to_string(matrix.height) + ", ranks 0 to " + std::to_string(matrix.ranks - 1) + "\n" +
         rows_text(matrix, "", "\n");
}

std::string matrix_c_header(const ThresholdMatrix& matrix) {
  const std::string name = c_name(matrix.name);
  return "/* " + matrix.name + ": ranks 0 to " + std::to_string(matrix.ranks - 1) +
         ", rows from the top; lit where floor(I * " + std::to_string(matrix.ranks) +
         " + .5) > rank. */\n#include <stdint.h>\n\nstatic const uint16_t " + name + "[" +
         std::to_string(matrix.height) + "][" + std::to_string(matrix.width) + "] = {\n" +
         rows_text(matrix, "    {", "},\n") + "};\n";
}

}  // namespace tristim
