#include "compile/edits.h"

#include <algorithm>
#include <utility>

namespace spu_emu::compile {

void Edits::replace(std::size_t begin, std::size_t end, std::string text) {
  edits_.push_back({begin, end, std::move(text)});
}

std::string Edits::apply(std::string_view source) const {
  std::vector<Edit> sorted = edits_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t done = 0;
  for (const Edit& edit : sorted) {
    if (edit.begin < done) continue;
    result += source.substr(done, edit.begin - done);
    result += edit.text;
    const std::string_view gone = source.substr(edit.begin, edit.end - edit.begin);
    result.append(static_cast<std::size_t>(std::count(gone.begin(), gone.end(), '\n')), '\n');
    done = edit.end;
  }
  result += source.substr(done);
  return result;
}

}  // namespace spu_emu::compile
