#include "tools/outputs.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>

#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim::tools {
namespace {

namespace fs = std::filesystem;

std::string padded(std::size_t number, std::size_t width, char fill) {
  std::string text = std::to_string(number);
  if (text.size() < width) text.insert(0, width - text.size(), fill);
  return text;
}

// What stands at a '%': "%%", or %d with an optional width; moves `at` behind it.
std::string expand_percent(const std::string& pattern, std::size_t& at, std::size_t place,
                           const std::string& option) {
  std::size_t end = at + 1;
  const bool zeros = end < pattern.size() && pattern[end] == '0';
  std::size_t width = 0;
  while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9' && width < 100) {
    width = width * 10 + static_cast<std::size_t>(pattern[end++] - '0');
  }
  const char kind = end < pattern.size() ? pattern[end] : '\0';
  const bool percent = kind == '%' && end == at + 1;
  if (!percent && kind != 'd') {
    throw Error(ErrorKind::kMisuse, option, "'" + pattern + "' has a '%' without a number",
                "write %04d for the number of the frame, %% for a percent sign");
  }
  at = end + 1;
  return percent ? "%" : padded(place, width, zeros ? '0' : ' ');
}

std::string expand(const std::string& pattern, const std::string& input, std::size_t place,
                   const std::string& option) {
  constexpr std::string_view kStem = "{stem}";
  std::string name;
  for (std::size_t at = 0; at < pattern.size();) {
    if (pattern.compare(at, kStem.size(), kStem) == 0) {
      name += input == "-" ? "stdin" : fs::path(input).stem().string();
      at += kStem.size();
    } else if (pattern[at] == '%') {
      name += expand_percent(pattern, at, place, option);
    } else {
      name += pattern[at++];
    }
  }
  return name;
}

bool is_link(const std::string& path) {
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(path, ignored));
}

std::string canonical(const std::string& path) {
  std::error_code failed;
  const fs::path name = fs::weakly_canonical(fs::absolute(path), failed);
  return failed ? path : name.lexically_normal().string();
}

}  // namespace

std::vector<std::string> output_names(const std::string& pattern,
                                      const std::vector<std::string>& inputs,
                                      const std::string& option) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    names.push_back(expand(pattern, inputs[i], i + 1, option));
    const bool device = names.back() == "/dev/null";
    if (device || taken.insert(canonical(names.back())).second) continue;
    throw Error(ErrorKind::kMisuse, option, "two inputs would be written to " + names.back(),
                pattern.find("{stem}") == std::string::npos
                    ? "put {stem} or %04d into the name"
                    : "put %04d into the name, the number of the picture");
  }
  return names;
}

bool same_output(const std::string& a, const std::string& b) {
  return a != "/dev/null" && canonical(a) == canonical(b);
}

void refuse_inputs_as_outputs(const std::vector<std::string>& inputs,
                              const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code ignored;
      const bool regular = fs::is_regular_file(output, ignored);
      if (output == "-" || input == "-" || !regular) continue;
      if (!fs::equivalent(input, output, ignored)) continue;
      throw Error(ErrorKind::kMisuse, output, "is an input too",
                  "choose another name for the output");
    }
  }
}

void refuse_taken_outputs(const std::vector<std::string>& outputs, bool replace) {
  for (const std::string& output : outputs) {
    std::error_code ignored;
    const fs::file_status status = fs::status(output, ignored);
    if (fs::is_directory(status) || output.ends_with('/')) {
      throw Error(ErrorKind::kSystem, output, "is a directory",
                  "give a name in it: " + (fs::path(output) / "{stem}.png").string());
    }
    const bool taken = fs::is_regular_file(status) || (!fs::exists(status) && is_link(output));
    if (taken && !replace) {
      throw Error(ErrorKind::kSystem, output, "exists already", "give --force to replace it");
    }
  }
}

void refuse_missing_inputs(const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code ignored;
    if (input == "-" || fs::status(input, ignored).type() != fs::file_type::not_found) continue;
    throw Error(ErrorKind::kSystem, input, "cannot be opened: " + system_message(ENOENT),
                "check the path");
  }
}

void refuse_other_drawings(const std::string& output) {
  const std::string extension = fs::path(output).extension().string();
  if (extension.empty() || output.starts_with("/dev/") || same_name(extension, ".svg")) return;
  throw Error(ErrorKind::kMisuse, output, "does not end in .svg", "drawings are SVG");
}

void refuse_terminal(const std::string& output) {
  if (output != "-" || isatty(STDOUT_FILENO) != 1) return;
  throw Error(ErrorKind::kMisuse, "-", "a picture is not written to a terminal",
              "give -o a file, or pipe it on");
}

}  // namespace tristim::tools
