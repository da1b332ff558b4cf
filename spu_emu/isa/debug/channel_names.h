/// @file
/// The SDK's names of channels.
#ifndef SPU_EMU_ISA_DEBUG_CHANNEL_NAMES_H
#define SPU_EMU_ISA_DEBUG_CHANNEL_NAMES_H

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace spu_emu::isa {

struct ChannelName {
  const char* name;
  std::uint32_t number;
};

/// By rising number.
std::span<const ChannelName> channel_names();
/// The SDK's name; of a number that has none, words that say so.
const char* channel_name(std::uint32_t number);
/// The number of the channel with this name, upper and lower case alike.
std::optional<std::uint32_t> channel_named(std::string_view name);

}  // namespace spu_emu::isa

#endif
