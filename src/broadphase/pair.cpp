#include "cellsweep/pair.h"

#include <array>
#include <cstdio>

namespace cellsweep {

std::string hash_text(std::uint64_t hash) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

}  // namespace cellsweep
