#include "tools/help.h"

#include <string_view>

#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

constexpr std::size_t kTextColumn = 26;
constexpr std::size_t kWidth = 80;

// `text` word by word behind what `line` holds, in lines that begin at kTextColumn.
std::string wrapped(std::string line, std::string_view text) {
  std::string all;
  for (const std::string_view word : split(text, ' ')) {
    if (line.size() > kTextColumn && line.size() + 1 + word.size() > kWidth) {
      all += line + "\n";
      line.assign(kTextColumn, ' ');
    }
    if (line.size() > kTextColumn) line += ' ';
    line += word;
  }
  return all + line + "\n";
}

std::string entry_text(const HelpEntry& entry) {
  std::string line = "  " + entry.names;
  std::string above;
  if (line.size() + 2 > kTextColumn) {
    above = line + "\n";
    line.clear();
  }
  line.resize(kTextColumn, ' ');
  return above + wrapped(std::move(line), entry.text);
}

}  // namespace

std::string help_text(const std::vector<HelpSection>& sections) {
  std::string text;
  for (const HelpSection& section : sections) {
    if (section.entries.empty()) continue;
    if (!section.title.empty()) text += (text.empty() ? "" : "\n") + section.title + ":\n";
    for (const HelpEntry& entry : section.entries) text += entry_text(entry);
  }
  return text;
}

}  // namespace tristim::tools
