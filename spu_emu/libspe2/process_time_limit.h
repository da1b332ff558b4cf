/// @file
/// The time limit of a whole process, for programs that are run by somebody else's script.
#ifndef SPU_EMU_LIBSPE2_PROCESS_TIME_LIMIT_H
#define SPU_EMU_LIBSPE2_PROCESS_TIME_LIMIT_H

namespace spu_emu {

/// Once in a process, when it makes its first SPE: with SPU_EMU_PROCESS_TIME_LIMIT=SECONDS in the environment
/// the process ends with exit code 124 so many seconds from now, and says on standard error who waits for
/// what. A value that is no number above 0 ends it at once, with the reason.
void start_process_time_limit();

}  // namespace spu_emu

#endif
