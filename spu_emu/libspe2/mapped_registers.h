/// @file
/// The problem state of one SPE as a host program's loads and stores reach it.
#ifndef SPU_EMU_LIBSPE2_MAPPED_REGISTERS_H
#define SPU_EMU_LIBSPE2_MAPPED_REGISTERS_H

#include <libspe2-types.h>

#include <cstdint>
#include <mutex>

namespace spu_emu {

/// Mailboxes, signals, their status, multisource synchronisation and the proxy's command queue. Any thread.
/// Neither throws: a command that breaks a rule is told on stderr and by SIGBUS.
class MappedRegisters {
 public:
  explicit MappedRegisters(spe_context_ptr_t spe) : spe_(spe) {}

  /// False where no such register can be written / read. `offset` is from the begin of the problem state.
  bool write(std::uint32_t offset, std::uint32_t value);
  bool read(std::uint32_t offset, std::uint32_t& value);

 private:
  void issue(std::uint32_t command);
  std::uint32_t tag_status();

  spe_context_ptr_t spe_;
  std::mutex mutex_;
  std::uint32_t lsa_ = 0;
  std::uint32_t eah_ = 0;
  std::uint32_t eal_ = 0;
  std::uint32_t size_and_tag_ = 0;
  std::uint32_t query_mask_ = 0;
};

/// Of the register at the offset its name, and the function of libspe2 that does what it is for.
struct RegisterName {
  const char* name;
  const char* function;
};
RegisterName register_name(std::uint32_t offset);

}  // namespace spu_emu

#endif
