#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tristim::tools {

/// The lines of a text file, one at a time; "-" is standard input. Ends of lines are LF or CR LF;
/// the mark of UTF-8 files is skipped.
class TextLines {
 public:
  /// Throws Error (kSystem) where the file is missing, a directory or unreadable.
  explicit TextLines(const std::string& path);

  /// False at the end. Throws Error: kSystem where reading fails, kContent for a line beyond 1 MB.
  bool next(std::string& line);

  /// The number of the line that next() gave, from 1.
  std::size_t number() const { return number_; }

 private:
  int character();

  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<char> buffer_;
  std::size_t at_ = 0, end_ = 0;
  std::size_t number_ = 0;
};

/// The cells of a line of CSV, without the quotes of those that have them; blanks about a
/// cell do not count.
std::vector<std::string> csv_cells(std::string_view line);

/// A cell as CSV holds it: in quotes where it needs them.
std::string csv_cell(const std::string& text);

}  // namespace tristim::tools
