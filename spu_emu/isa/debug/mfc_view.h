/// @file
/// What is outside of an SPU's registers and local store, as text: the MFC's queue and tags, mailboxes,
/// signals, events, and what all SPEs of the process are doing.
#ifndef SPU_EMU_ISA_DEBUG_MFC_VIEW_H
#define SPU_EMU_ISA_DEBUG_MFC_VIEW_H

#include <string>

#include "spe/spe.h"

namespace spu_emu::isa {

// Each gives lines that end in newlines. On the thread of the SPU, which stands still.

std::string queue_text(Spe& spe);
std::string mailboxes_text(Spe& spe);
std::string signals_text(Spe& spe);
std::string events_text(Spe& spe);
/// `here` is the SPE that the debugger keeps standing.
std::string spes_text(Spe& here);

}  // namespace spu_emu::isa

#endif
