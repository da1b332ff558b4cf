#include "isa/timing/code_ranges.h"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "mfc/command.h"

namespace spu_emu::isa {

namespace {

struct Release {
  void operator()(char* text) const { std::free(text); }
};

std::string demangled(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, Release> text(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status));
  return status == 0 ? text.get() : name;
}

}  // namespace

std::vector<CodeRange> code_ranges(const std::vector<ElfSymbol>& symbols, std::uint32_t image_end) {
  std::vector<CodeRange> ranges;
  std::uint32_t covered =
      0;  // by symbols with a size: a name without one in there, as of a loop, is no function
  for (const ElfSymbol& symbol : symbols) {
    if (!ranges.empty() && ranges.back().first == symbol.address) continue;
    if (symbol.size == 0 && symbol.address < covered) continue;
    if (!ranges.empty()) ranges.back().end = std::min(ranges.back().end, symbol.address);
    const std::uint32_t size = std::min(symbol.size, kLocalStoreSize);
    covered = std::max(covered, symbol.address + size);
    const std::uint32_t end = size == 0 ? image_end : symbol.address + size;
    ranges.push_back({symbol.address, end, demangled(symbol.name)});
  }
  return ranges;
}

}  // namespace spu_emu::isa
