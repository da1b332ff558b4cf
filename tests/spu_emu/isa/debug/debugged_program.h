// A program under the debugger with commands of the test, and what the debugger says.
#ifndef SPU_EMU_TESTS_ISA_DEBUG_DEBUGGED_PROGRAM_H
#define SPU_EMU_TESTS_ISA_DEBUG_DEBUGGED_PROGRAM_H

#include <unistd.h>

#include <fstream>

#include "../isa_context.h"

namespace spu_emu::isa {

/// A file with these lines, removed at the end.
class CommandFile {
 public:
  explicit CommandFile(const std::string& lines) : name(new_name()) { std::ofstream(name) << lines; }
  ~CommandFile() { unlink(name.c_str()); }
  CommandFile(const CommandFile&) = delete;
  CommandFile& operator=(const CommandFile&) = delete;

  const std::string name;

 private:
  static std::string new_name() {
    static int count = 0;
    return testing::TempDir() + "spu_emu_commands." + std::to_string(getpid()) + "." +
           std::to_string(++count);
  }
};

class DebuggedProgram {
 public:
  DebuggedProgram(const File& elf, const std::string& commands, EmulationSettings settings = {})
      : commands_(commands), context(elf, with_debugger(std::move(settings))) {}

  /// Runs it; what was written to standard error. The numbers of SPEs are left out: each test process counts
  /// its own.
  std::string run(const void* argp = nullptr) {
    testing::internal::CaptureStderr();
    result = context.run(argp);
    return without_numbers(testing::internal::GetCapturedStderr());
  }
  std::string resume() {
    testing::internal::CaptureStderr();
    result = context.resume();
    return without_numbers(testing::internal::GetCapturedStderr());
  }

 private:
  EmulationSettings with_debugger(EmulationSettings settings) const {
    settings.debugger = {commands_.name};
    return settings;
  }
  static std::string without_numbers(std::string text) {
    for (const std::string before : {"(spu ", "SPE "}) {
      for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        const std::size_t first = at + before.size();
        std::size_t end = first;
        while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
        if (end != first) text.replace(first, end - first, "N");
      }
    }
    return text;
  }

  CommandFile commands_;

 public:
  IsaContext context;
  int result = -2;
};

inline void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}
inline void expect_not_in(const std::string& text, const std::string& part) {
  EXPECT_EQ(text.find(part), std::string::npos) << "\"" << part << "\" is in:\n" << text;
}

}  // namespace spu_emu::isa

#endif
