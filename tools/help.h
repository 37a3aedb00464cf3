#pragma once

#include <string>
#include <vector>

namespace tristim::tools {

/// One entry of a help page: "-o, --output OUT", and what it is for.
struct HelpEntry {
  std::string names;
  std::string text;
};

/// Entries under a title; an empty title joins them to what comes before.
struct HelpSection {
  std::string title;
  std::vector<HelpEntry> entries;
};

/// Sections in two columns, 80 characters wide at most where words allow it.
std::string help_text(const std::vector<HelpSection>& sections);

}  // namespace tristim::tools
