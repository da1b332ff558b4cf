#include "host/host_program.h"

#include <xmmintrin.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "mfc/format.h"

namespace spu_emu {

namespace {
/// Round toward zero, denormals are zero, flush to zero, all exceptions masked: the SPU's single precision.
constexpr unsigned kSpuMxcsr = 0xffc0;
}  // namespace

HostProgram::HostProgram(Spe& spe)
    : spe_(spe),
      store_(spe.arena(), spe.settings().code_reserve, spe.settings().stack_reserve),
      services_(make_services(*this)),
      guard_(spe.arena().stack_top(), &HostProgram::interrupted, this),
      lowest_frame_(lowest_frame()) {
  guard_.contains_errors = spe.settings().contain_faults;
}

LoadResult HostProgram::load(Spe& spe, std::span<const std::byte> image) {
  auto program = std::make_unique<HostProgram>(spe);
  std::string error;
  program->module_ = Module::load(image, error);
  if (!program->module_) return {nullptr, EINVAL, error};
  if (!program->store_.place(program->module_->segments())) {
    return {nullptr, ENOMEM,
            "the program's data does not fit between code and stack reserve; raise the local store limit\n" +
                program->store_.map()};
  }
  program->guard_.code = program->module_->code();
  program->note_high_water();
  return {std::move(program), 0, {}};
}

void HostProgram::enter(void* self) {
  auto& program = *static_cast<HostProgram*>(self);
  _mm_setcsr(kSpuMxcsr);
  int code = 0;
  if (!program.run_main(code)) program.stop_for_end();
  constexpr unsigned kExit = 0x2000;
  program.services_.stop(self, kExit | (static_cast<unsigned>(code) & 0xffU), {});
}

/// Holds nothing while main runs: a program that exits or faults never comes back here.
bool HostProgram::run_main(int& code) {
  try {
    guard_.in_program.store(true);
    code = module_->run(services_, arguments_.speid, arguments_.argp, arguments_.envp);
    guard_.in_program.store(false);
    return true;
  } catch (...) {
    guard_.in_program.store(false);
    note_end({End::left_main, std::current_exception()});
  }
  return false;
}

Stop HostProgram::start(const Arguments& arguments) {
  arguments_ = arguments;
  // Blocks that a run before has left, which may have ended by a fault.
  store_.heap_guards().mark_all();
  // Before the fiber, which begins with the signals that are let through here.
  const GuardScope scope(guard_, spe_.deadline());
  fiber_.reset();
  fiber_.emplace(spe_.arena().stack(), Arena::kStackSize, &HostProgram::enter, this);
  return run_fiber();
}

Stop HostProgram::resume(unsigned int) {
  const GuardScope scope(guard_, spe_.deadline());
  return run_fiber();
}

Stop HostProgram::run_fiber() {
  suspended_ = true;
  entry_ += 4;
  const unsigned outside = _mm_getcsr();
  fiber_->resume();
  _mm_setcsr(outside);
  if (end_.kind != End::none) report_end();
  return stop_;
}

/// The C library's own calls: host programs call their C library directly, so nobody serves them here.
int HostProgram::serve_library_call(const Stop&) {
  return 1;
}

void HostProgram::stop_here(const Stop& stop) {
  stop_ = stop;
  fiber_->suspend();
  _mm_setcsr(kSpuMxcsr);
}

void HostProgram::stop_for_good(const Stop& stop) {
  suspended_ = false;
  for (;;) stop_here(stop);
}

void HostProgram::stop_for_exit(unsigned int code) {
  if (const auto overrun = store_.heap_guards().any_overrun()) throw fault_of(*overrun);
  for (;;) stop_here({Stop::Kind::exit, code, 0, {}});
}

void HostProgram::note_end(End end) {
  end_ = std::move(end);
}

void HostProgram::stop_for_end() {
  stop_for_good({Stop::Kind::fault, 0, 0, {}});
}

/// On the program's stack, of which nothing is left.
void HostProgram::interrupted(void* self) {
  auto& program = *static_cast<HostProgram*>(self);
  _mm_setcsr(kSpuMxcsr);
  program.note_end({End::interrupted, nullptr});
  program.stop_for_end();
}

void HostProgram::report_end() {
  const End end = std::exchange(end_, {});
  channels().abandon();
  const Fault fault = fault_of(end);
  spe_.set_last_fault(fault.text());
  stop_.report = stop_report(fault.rule());
}

Fault HostProgram::fault_of(const End& end) const {
  if (end.kind == End::interrupted) return fault_of(guard_.what);
  std::string what = "of a type that is no std::exception";
  try {
    std::rethrow_exception(end.error);
  } catch (const Fault& fault) {
    return fault;
  } catch (const std::bad_alloc&) {
    if (end.kind == End::in_service) throw;
    what = "there was no memory";
  } catch (const std::exception& error) {
    what = error.what();
  } catch (...) {
  }
  return Fault(Rule::exception,
               format("an exception left main of SPE %u's program: %s", spe_.number(), what.c_str()));
}

std::string HostProgram::place_of(std::uintptr_t instruction) const {
  if (!guard_.code.holds(instruction)) return "in a library function";
  return format("at 0x%lx of its module", instruction - module_->base());
}

Fault HostProgram::fault_of(const Interruption& what) const {
  const std::string place = place_of(what.instruction);
  const unsigned spe = spe_.number();
  switch (what.signal) {
    case 0:
      return Fault(Rule::time_limit,
                   format("SPE %u's program has run for %lld ms and has not ended, %s", spe,
                          static_cast<long long>(spe_.settings().time_limit.count()), place.c_str()));
    case SIGFPE:
      return Fault(
          Rule::arithmetic,
          format("SPE %u's program divided an integer by zero, or the lowest by -1, %s", spe, place.c_str()));
    case SIGILL:
      return Fault(Rule::illegal_instruction,
                   format("SPE %u's program came to what is no instruction, %s", spe, place.c_str()));
    case SIGABRT:
      return Fault(Rule::abort, format("SPE %u's program called abort(), or something that does", spe));
    default:
      return memory_fault(what);
  }
}

Fault HostProgram::fault_of(const HeapOverrun& overrun) const {
  return Fault(
      Rule::heap_overrun,
      format("SPE %u's program wrote to LS 0x%05x, behind the %u bytes that it asked for at LS 0x%05x",
             spe_.number(), overrun.at, overrun.asked, overrun.block));
}

/// A stack that is full meets the pages below it, a buffer's end those behind the local store.
Fault HostProgram::memory_fault(const Interruption& what) const {
  constexpr std::uintptr_t kNear = 1U << 24U;
  const std::string place = place_of(what.instruction);
  const unsigned spe = spe_.number();
  const std::uintptr_t below_stack = reinterpret_cast<std::uintptr_t>(spe_.arena().stack()) - what.address;
  const std::uintptr_t ls = what.address - reinterpret_cast<std::uintptr_t>(spe_.arena().base());
  const std::uint32_t size = spe_.arena().local_store_size();
  if (below_stack - 1 < kNear) {
    return Fault(
        Rule::stack_overflow,
        format("SPE %u's program has used up the %u bytes of its stack, %s; does it call itself without end?",
               spe, Arena::kStackSize, place.c_str()));
  }
  if (ls >= size && ls - size < kNear) {
    return Fault(Rule::memory_access,
                 format("SPE %u's program used LS 0x%lx, beyond the %u bytes of its local store, %s", spe, ls,
                        size, place.c_str()));
  }
  return Fault(Rule::memory_access, format("SPE %u's program used address 0x%lx, where it has no memory, %s",
                                           spe, what.address, place.c_str()));
}

/// What the program calls needs room, too, and must not meet the stack's end: it may hold locks.
std::uintptr_t HostProgram::lowest_frame() const {
  constexpr std::uint32_t kRoom = 64 * 1024;
  std::uint32_t most = Arena::kStackSize - kRoom;
  const EmulationSettings& settings = spe_.settings();
  if (kGuardsPrograms && settings.dma_mode == DmaMode::late && settings.local_store_limit != 0) {
    most = std::min(most, settings.stack_reserve);
  }
  return reinterpret_cast<std::uintptr_t>(spe_.arena().stack_top()) - most;
}

void HostProgram::stack_too_deep(const void* frame) const {
  const std::uintptr_t depth =
      reinterpret_cast<std::uintptr_t>(spe_.arena().stack_top()) - reinterpret_cast<std::uintptr_t>(frame);
  const std::uintptr_t most = reinterpret_cast<std::uintptr_t>(spe_.arena().stack_top()) - lowest_frame_;
  throw Fault(
      Rule::stack_reserve,
      format("SPE %u's program has %lu bytes on its stack and may have %lu; raise stack_reserve, up to "
             "the %u bytes of the stack, or use less",
             spe_.number(), depth, most, Arena::kStackSize));
}

std::uint32_t HostProgram::ls_outside_arena(const volatile void* pointer, const Command& command) {
  if (const auto ls = store_.address_of(pointer)) return *ls;
  const auto address = reinterpret_cast<std::uintptr_t>(pointer);
  if (store_.below_stack_reserve(pointer)) {
    throw Fault(
        Rule::stack_reserve,
        format(
            "the buffer at %#lx lies deeper on the stack than the reserve of %u bytes; raise stack_reserve",
            address, spe_.settings().stack_reserve),
        command);
  }
  throw Fault(
      Rule::local_store_range,
      format("the pointer %#lx is no local store address; buffers for DMA come from _malloc_align, are "
             "globals of the SPU program, or lie on its stack (constants: raise code_reserve)",
             address),
      command);
}

void* HostProgram::allocate(std::size_t size, std::size_t alignment) {
  if (const auto ls = store_.heap().allocate(size, alignment)) {
    store_.heap_guards().mark(*ls);
    note_high_water();
    return store_.arena().base() + *ls;
  }
  throw Fault(
      Rule::local_store_full,
      format(
          "%zu bytes at a multiple of %zu do not fit any more; raise the local store limit or use less\n%s",
          size, alignment, store_.map().c_str()));
}

void* HostProgram::reallocate(void* block, std::size_t size) {
  if (block == nullptr) return allocate(size, 16);
  if (!store_.in_arena(block)) return std::realloc(block, size);
  const std::uint32_t old_size = store_.heap().size_of(store_.ls_of_arena(block));
  void* moved = allocate(size, 16);
  std::memcpy(moved, block, std::min<std::size_t>(old_size, size));
  release(block);
  return moved;
}

/// A block that the host's C library allocated on behalf of the program goes back there.
void HostProgram::release(void* block) {
  if (block == nullptr) return;
  if (!store_.in_arena(block)) return std::free(block);
  if (const auto overrun = store_.heap_guards().overrun_of(store_.ls_of_arena(block)))
    throw fault_of(*overrun);
  if (!store_.heap().release(store_.ls_of_arena(block))) {
    throw Fault(Rule::local_store_range,
                format("free of LS 0x%x, where no block begins", store_.ls_of_arena(block)));
  }
}

std::uint32_t HostProgram::make_call_word(unsigned int opcode, void* data) {
  const std::uint32_t address = data == nullptr ? 0 : ls_of(data, Command{});
  if (data != nullptr && !store_.in_arena(data)) {
    throw Fault(
        Rule::local_store_range,
        "the argument block of a library call must come from the heap: the handler reads it through the "
        "local store area");
  }
  auto* word = static_cast<std::byte*>(allocate(16, 16));
  const std::uint32_t value = (opcode << 24U) | address;
  std::memcpy(word, &value, sizeof value);
  return store_.ls_of_arena(word);
}

void HostProgram::free_call_word(std::uint32_t ls) {
  store_.heap().release(ls);
}

void HostProgram::note_high_water() {
  high_water_.store(std::max(high_water_.load(std::memory_order_relaxed), store_.high_water()),
                    std::memory_order_relaxed);
}

}  // namespace spu_emu
