/// @file
/// A program of the host engine: a module of this machine's code on a stack of its own.
#ifndef SPU_EMU_HOST_HOST_PROGRAM_H
#define SPU_EMU_HOST_HOST_PROGRAM_H

#include <atomic>
#include <exception>
#include <memory>
#include <optional>

#include "host/fiber.h"
#include "host/host_local_store.h"
#include "host/module.h"
#include "host/program_guard.h"
#include "spe/program_loader.h"
#include "spe/spe.h"
#include "spu_emu/services.h"

namespace spu_emu {

class HostProgram final : public Program {
 public:
  static LoadResult load(Spe& spe, std::span<const std::byte> image);
  explicit HostProgram(Spe& spe);

  HostLocalStore& store() override { return store_; }
  std::uint32_t store_size() const override { return spe_.arena().local_store_size(); }
  Stop start(const Arguments& arguments) override;
  Stop resume(unsigned int entry) override;
  bool can_resume(unsigned int entry) const override { return suspended_ && entry == entry_; }
  unsigned int resume_entry() const override { return entry_; }
  std::uint32_t ls_address(std::uint32_t number) const override { return store_.address_of_number(number); }
  unsigned int entry_after_call() const override { return entry_; }
  int serve_library_call(const Stop& call) override;
  std::uint32_t high_water() const override { return high_water_.load(std::memory_order_relaxed); }
  std::string map() const override { return store_.map(); }

  // The program's side, called on its stack.
  SpuChannels& channels() { return spe_.channels(); }
  ProgramGuard& guard() { return guard_; }
  /// Throws Fault when the stack at `frame` is deeper than the program may go: in late mode than its reserve,
  /// else than leaves room for what it calls.
  void check_stack(const void* frame) const {
    if (reinterpret_cast<std::uintptr_t>(frame) < lowest_frame_) stack_too_deep(frame);
  }
  void stop_here(const Stop& stop);
  [[noreturn]] void stop_for_good(const Stop& stop);
  /// The program's exit, which comes again when it is resumed, as that of a real one does. Throws Fault when
  /// it wrote beyond a block of its heap.
  [[noreturn]] void stop_for_exit(unsigned int code);
  /// Why a program ends before its time. What is to be said of it is put into words off its stack, where
  /// memory may run out once more.
  struct End {
    enum Kind { none, in_service, left_main, interrupted } kind = none;
    std::exception_ptr error{};
  };
  /// Remembers the reason of the stop to come; whatever is in flight never lands.
  void note_end(End end);
  /// Ends the program for the reason noted.
  [[noreturn]] void stop_for_end();
  /// The LS address of a program's pointer. Throws Fault if it is none.
  std::uint32_t ls_of(const volatile void* pointer, const Command& command) {
    if (store_.in_arena(pointer)) return store_.ls_of_arena(pointer);
    return ls_outside_arena(pointer, command);
  }
  /// The three allocation functions throw Fault when the local store is full or a block unknown.
  void* allocate(std::size_t size, std::size_t alignment);
  void* reallocate(void* block, std::size_t size);
  void release(void* block);
  /// Writes the argument word of a library call into the local store; its LS address.
  std::uint32_t make_call_word(unsigned int opcode, void* data);
  void free_call_word(std::uint32_t ls);

 private:
  static void enter(void* self);
  static void interrupted(void* self);
  std::uintptr_t lowest_frame() const;
  [[noreturn]] void stack_too_deep(const void* frame) const;
  /// Runs main to its end; false when an exception left it, which is then noted.
  bool run_main(int& code);
  /// Throws std::bad_alloc, too, when that is the reason.
  void report_end();
  Fault fault_of(const End& end) const;
  Fault fault_of(const Interruption& what) const;
  Fault fault_of(const HeapOverrun& overrun) const;
  Fault memory_fault(const Interruption& what) const;
  std::string place_of(std::uintptr_t instruction) const;
  std::uint32_t ls_outside_arena(const volatile void* pointer, const Command& command);
  Stop run_fiber();
  void note_high_water();

  Spe& spe_;
  HostLocalStore store_;
  HostServices services_;
  ProgramGuard guard_;
  const std::uintptr_t lowest_frame_;
  std::unique_ptr<Module> module_;
  std::optional<Fiber> fiber_;
  Arguments arguments_;
  Stop stop_;
  bool suspended_ = false;
  unsigned int entry_ = 0;
  End end_;
  std::atomic<std::uint32_t> high_water_{0};
};

/// The table of functions by which a program module reaches `program`.
HostServices make_services(HostProgram& program);

}  // namespace spu_emu

#endif
