#include "bench/measured/page_marks.h"

namespace cellsweep::bench {

Result<std::string> replace_between_marks(std::string text, const std::string& name,
                                          const std::string& content) {
  const std::string begin = "<!-- " + name + ": begin -->\n";
  const std::size_t start = text.find(begin);
  const std::size_t end = text.find("<!-- " + name + ": end -->");
  if (start == std::string::npos || end == std::string::npos || end < start) {
    return Status::bad_input("There is no place for '" + name + "'.");
  }
  const std::size_t from = start + begin.size();
  return text.replace(from, end - from, content);
}

}  // namespace cellsweep::bench
