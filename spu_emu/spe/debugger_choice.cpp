#include "spe/debugger_choice.h"

#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace spu_emu {

namespace {
unsigned number_in(std::string_view text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  throw std::invalid_argument("SPU_EMU_DEBUG=\"" + std::string(text) +
                              "\" is no number of an SPE; the first that a program makes is 0");
}
}  // namespace

std::optional<DebuggerSettings> debugger_of(const EmulationSettings& settings, unsigned number) {
  if (settings.debugger) return settings.debugger;
  const char* chosen = std::getenv("SPU_EMU_DEBUG");
  if (chosen == nullptr || *chosen == '\0' || number_in(chosen) != number) return std::nullopt;
  const char* commands = std::getenv("SPU_EMU_DEBUG_COMMANDS");
  return DebuggerSettings{commands != nullptr ? commands : ""};
}

}  // namespace spu_emu
