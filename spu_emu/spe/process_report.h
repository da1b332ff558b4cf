/// @file
/// Who waits for what in this process, for people.
#ifndef SPU_EMU_SPE_PROCESS_REPORT_H
#define SPU_EMU_SPE_PROCESS_REPORT_H

#include <string>

namespace spu_emu {

/// Lines for each SPE, what it does or waits for and at which instruction, and what is in its mailboxes; then
/// a line for each thread of the host that waits in libspe2. Any thread, while programs run.
std::string process_report();

}  // namespace spu_emu

#endif
