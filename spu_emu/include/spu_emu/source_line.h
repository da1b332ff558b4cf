// The place in SPU source that a channel access came from.
#ifndef SPU_EMU_SOURCE_LINE_H
#define SPU_EMU_SOURCE_LINE_H

namespace spu_emu {

/// A line of SPU source, kept so that a fault can name it; `file` lives as long as the module, or is null.
struct SourceLine {
  const char* file = nullptr;
  int line = 0;
};

}  // namespace spu_emu

#endif
