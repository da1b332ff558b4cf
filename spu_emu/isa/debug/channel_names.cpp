#include "isa/debug/channel_names.h"

#include <algorithm>
#include <cctype>

#include "spu_emu/channel_numbers.h"

namespace spu_emu::isa {

namespace {

#define SPU_EMU_CHANNEL(name) \
  { #name, name }
constexpr ChannelName kNames[] = {
    SPU_EMU_CHANNEL(SPU_RdEventStat),
    SPU_EMU_CHANNEL(SPU_WrEventMask),
    SPU_EMU_CHANNEL(SPU_WrEventAck),
    SPU_EMU_CHANNEL(SPU_RdSigNotify1),
    SPU_EMU_CHANNEL(SPU_RdSigNotify2),
    SPU_EMU_CHANNEL(SPU_WrDec),
    SPU_EMU_CHANNEL(SPU_RdDec),
    SPU_EMU_CHANNEL(MFC_WrMSSyncReq),
    SPU_EMU_CHANNEL(SPU_RdEventMask),
    SPU_EMU_CHANNEL(MFC_RdTagMask),
    SPU_EMU_CHANNEL(SPU_RdMachStat),
    SPU_EMU_CHANNEL(SPU_WrSRR0),
    SPU_EMU_CHANNEL(SPU_RdSRR0),
    SPU_EMU_CHANNEL(MFC_LSA),
    SPU_EMU_CHANNEL(MFC_EAH),
    SPU_EMU_CHANNEL(MFC_EAL),
    SPU_EMU_CHANNEL(MFC_Size),
    SPU_EMU_CHANNEL(MFC_TagID),
    SPU_EMU_CHANNEL(MFC_Cmd),
    SPU_EMU_CHANNEL(MFC_WrTagMask),
    SPU_EMU_CHANNEL(MFC_WrTagUpdate),
    SPU_EMU_CHANNEL(MFC_RdTagStat),
    SPU_EMU_CHANNEL(MFC_RdListStallStat),
    SPU_EMU_CHANNEL(MFC_WrListStallAck),
    SPU_EMU_CHANNEL(MFC_RdAtomicStat),
    SPU_EMU_CHANNEL(SPU_WrOutMbox),
    SPU_EMU_CHANNEL(SPU_RdInMbox),
    SPU_EMU_CHANNEL(SPU_WrOutIntrMbox),
};
#undef SPU_EMU_CHANNEL

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

}  // namespace

std::span<const ChannelName> channel_names() {
  return kNames;
}

const char* channel_name(std::uint32_t number) {
  for (const ChannelName& each : kNames) {
    if (each.number == number) return each.name;
  }
  return "a channel without a name";
}

std::optional<std::uint32_t> channel_named(std::string_view name) {
  for (const ChannelName& each : kNames) {
    const std::string_view known = each.name;
    if (std::equal(known.begin(), known.end(), name.begin(), name.end(),
                   [](char a, char b) { return lower(a) == lower(b); })) {
      return each.number;
    }
  }
  return std::nullopt;
}

}  // namespace spu_emu::isa
