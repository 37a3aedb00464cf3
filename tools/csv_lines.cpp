#include "tools/csv_lines.h"

#include <cerrno>

#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 16;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

int keep_open(std::FILE*) { return 0; }

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

// A cell that begins with a quote at `at`; moves `at` to what follows its end.
std::string quoted_cell(std::string_view line, std::size_t& at) {
  std::string cell;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      cell += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      cell += line[at++];
    } else {
      break;
    }
  }
  at = std::min(line.find(',', at), line.size());
  return cell;
}

}  // namespace

TextLines::TextLines(const std::string& path)
    : path_(path == "-" ? "standard input" : path),
      file_(path == "-" ? stdin : std::fopen(path.c_str(), "rb"),
            path == "-" ? keep_open : std::fclose),
      buffer_(kBufferSize) {
  if (file_ != nullptr) return;
  const int error = errno;
  throw Error(ErrorKind::kSystem, path_, "cannot be opened: " + system_message(error),
              "check the path");
}

int TextLines::character() {
  if (at_ == end_) {
    end_ = std::fread(buffer_.data(), 1, buffer_.size(), file_.get());
    at_ = 0;
    if (end_ == 0) {
      const int error = errno;
      if (std::ferror(file_.get()) == 0) return EOF;
      throw Error(ErrorKind::kSystem, path_, "cannot be read: " + system_message(error));
    }
  }
  return static_cast<unsigned char>(buffer_[at_++]);
}

bool TextLines::next(std::string& line) {
  line.clear();
  int c = character();
  if (c == EOF) return false;
  ++number_;
  for (; c != EOF && c != '\n'; c = character()) {
    if (line.size() == kLongestLine) {
      throw Error(ErrorKind::kContent, path_ + ", line " + std::to_string(number_),
                  "is longer than 1 MB", "give lines of text");
    }
    line += static_cast<char>(c);
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (number_ == 1) line = std::string(without_utf8_mark(line));
  return true;
}

std::vector<std::string> csv_cells(std::string_view line) {
  std::vector<std::string> cells;
  std::size_t at = 0;
  while (true) {
    std::size_t start = at;
    while (start < line.size() && is_blank(line[start])) ++start;
    if (start < line.size() && line[start] == '"') {
      at = start;
      cells.push_back(quoted_cell(line, at));
    } else {
      at = std::min(line.find(',', start), line.size());
      cells.push_back(trimmed(line.substr(start, at - start)));
    }
    if (at == line.size()) return cells;
    ++at;
  }
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace tristim::tools
