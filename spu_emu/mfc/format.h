/// @file
/// printf-style text into a std::string, for fault messages and the trace.
#ifndef SPU_EMU_MFC_FORMAT_H
#define SPU_EMU_MFC_FORMAT_H

#include <string>

namespace spu_emu {

/// The text that printf would write; checked by the compiler like printf.
__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...);

}  // namespace spu_emu

#endif
