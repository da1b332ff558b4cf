#include "host/spe.h"

#include <xmmintrin.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "host/elf_image.h"
#include "mfc/format.h"
#include "mfc/watch.h"

namespace spu_emu {

namespace {
/// Round toward zero, denormals are zero, flush to zero, all exceptions masked: the SPU's single precision.
constexpr unsigned kSpuMxcsr = 0xffc0;

unsigned next_number() {
  static std::atomic<unsigned> next{0};
  return next.fetch_add(1);
}

SignalMode signal_mode(unsigned flags, unsigned flag) {
  return (flags & flag) != 0 ? SignalMode::logical_or : SignalMode::overwrite;
}

ChannelSetup channel_setup(const EmulationSettings& settings, unsigned flags, SpeTrace& trace,
                           WaitPoint* point) {
  ChannelSetup setup;
  setup.mode = settings.dma_mode;
  setup.seed = settings.seed;
  setup.signal1 = signal_mode(flags, SPE_CFG_SIGNOTIFY1_OR);
  setup.signal2 = signal_mode(flags, SPE_CFG_SIGNOTIFY2_OR);
  setup.log = settings.trace ? &trace : nullptr;
  setup.also_notified = point;
  return setup;
}
}  // namespace

Spe::Spe(const EmulationSettings& settings, unsigned int flags, WaitPoint* event_point)
    : settings_(settings),
      number_(next_number()),
      trace_(number_),
      store_(settings.local_store_limit, settings.code_reserve, settings.stack_reserve),
      timebase_(settings.timebase_hertz),
      channels_(store_, timebase_, channel_setup(settings, flags, trace_, event_point)),
      proxy_(store_, {Issuer::proxy, settings.dma_mode, settings.seed + 2, nullptr, nullptr}),
      services_(make_services(*this)) {
  SpeDirectory::instance().add({reinterpret_cast<std::uintptr_t>(store_.arena().base()),
                                store_.arena().local_store_size(), &store_, &channels_});
  note_high_water();
}

Spe::~Spe() {
  SpeDirectory::instance().remove(reinterpret_cast<std::uintptr_t>(store_.arena().base()));
  channels_.abandon();
  fiber_.reset();
}

int Spe::load(const spe_program_handle_t& program) {
  channels_.abandon();
  {
    const std::lock_guard lock(proxy_mutex_);
    proxy_.clear();
  }
  fiber_.reset();
  suspended_ = false;
  module_.reset();
  store_.clear();
  const ImageKind kind = program.elf_image == nullptr ? ImageKind::none : image_kind(program.elf_image);
  if (kind == ImageKind::spu_elf) {
    set_last_fault("the image is an SPU ELF file: the host engine runs modules made by add_spu_program");
    return ENOTSUP;
  }
  if (kind == ImageKind::none) {
    set_last_fault("the image is no ELF file of an SPU program");
    return EINVAL;
  }
  std::string error;
  module_ = Module::load(program, error);
  if (!module_) {
    set_last_fault(error);
    return EINVAL;
  }
  if (!store_.place(module_->segments())) {
    set_last_fault(
        "the program's data does not fit between code and stack reserve; raise the local store limit\n" +
        store_.map());
    module_.reset();
    return ENOMEM;
  }
  note_high_water();
  return 0;
}

void Spe::enter(void* self) {
  auto& spe = *static_cast<Spe*>(self);
  _mm_setcsr(kSpuMxcsr);
  const Arguments& arguments = spe.arguments_;
  const int code = spe.module_->run(spe.services_, arguments.speid, arguments.argp, arguments.envp);
  constexpr unsigned kExit = 0x2000;
  spe.services_.stop(self, kExit | (static_cast<unsigned>(code) & 0xffU), {});
}

Stop Spe::start(const Arguments& arguments) {
  arguments_ = arguments;
  channels_.abandon();
  fiber_.reset();
  fiber_.emplace(store_.arena().stack(), Arena::kStackSize, &Spe::enter, this);
  return run_fiber();
}

Stop Spe::resume() {
  return run_fiber();
}

Stop Spe::run_fiber() {
  const TraceTime begin = std::chrono::steady_clock::now();
  suspended_ = true;
  const unsigned outside = _mm_getcsr();
  fiber_->resume();
  _mm_setcsr(outside);
  if (settings_.trace) trace_.run(begin);
  return stop_;
}

void Spe::stop_here(const Stop& stop) {
  stop_ = stop;
  fiber_->suspend();
  _mm_setcsr(kSpuMxcsr);
}

void Spe::stop_for_good(const Stop& stop) {
  suspended_ = false;
  for (;;) stop_here(stop);
}

void Spe::set_last_fault(std::string text) {
  const std::lock_guard lock(fault_mutex_);
  last_fault_ = std::move(text);
}

std::string Spe::last_fault() {
  const std::lock_guard lock(fault_mutex_);
  return last_fault_;
}

void Spe::note_fault(const Fault& fault) {
  channels_.abandon();
  set_last_fault(fault.text());
  fault_report_ = stop_report(fault.rule());
}

void Spe::stop_for_fault() {
  stop_for_good({Stop::Kind::fault, 0, 0, fault_report_});
}

std::uint32_t Spe::ls_outside_arena(const volatile void* pointer, const Command& command) {
  if (const auto ls = store_.address_of(pointer)) return *ls;
  const auto address = reinterpret_cast<std::uintptr_t>(pointer);
  if (store_.below_stack_reserve(pointer)) {
    throw Fault(
        Rule::stack_reserve,
        format(
            "the buffer at %#lx lies deeper on the stack than the reserve of %u bytes; raise stack_reserve",
            address, settings_.stack_reserve),
        command);
  }
  throw Fault(
      Rule::local_store_range,
      format("the pointer %#lx is no local store address; buffers for DMA come from _malloc_align, are "
             "globals of the SPU program, or lie on its stack (constants: raise code_reserve)",
             address),
      command);
}

void* Spe::allocate(std::size_t size, std::size_t alignment) {
  if (const auto ls = store_.heap().allocate(size, alignment)) {
    note_high_water();
    return store_.arena().base() + *ls;
  }
  throw Fault(
      Rule::local_store_full,
      format(
          "%zu bytes at a multiple of %zu do not fit any more; raise the local store limit or use less\n%s",
          size, alignment, store_.map().c_str()));
}

void* Spe::reallocate(void* block, std::size_t size) {
  if (block == nullptr) return allocate(size, 16);
  if (!store_.in_arena(block)) return std::realloc(block, size);
  const std::uint32_t old_size = store_.heap().size_of(store_.ls_of_arena(block));
  void* moved = allocate(size, 16);
  std::memcpy(moved, block, std::min<std::size_t>(old_size, size));
  release(block);
  return moved;
}

/// A block that the host's C library allocated on behalf of the program goes back there.
void Spe::release(void* block) {
  if (block == nullptr) return;
  if (!store_.in_arena(block)) return std::free(block);
  if (!store_.heap().release(store_.ls_of_arena(block))) {
    throw Fault(Rule::local_store_range,
                format("free of LS 0x%x, where no block begins", store_.ls_of_arena(block)));
  }
}

std::uint32_t Spe::make_call_word(unsigned int opcode, void* data) {
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

void Spe::free_call_word(std::uint32_t ls) {
  store_.heap().release(ls);
}

void Spe::note_high_water() {
  high_water_.store(std::max(high_water_.load(std::memory_order_relaxed), store_.high_water()),
                    std::memory_order_relaxed);
}

SpeStatistics Spe::statistics() {
  const QueueCounters& queue = channels_.queue_counters();
  const ChannelCounters& channel = channels_.counters();
  SpeStatistics result;
  result.gets = queue.gets.value();
  result.puts = queue.puts.value();
  result.bytes_in = queue.bytes_in.value();
  result.bytes_out = queue.bytes_out.value();
  result.list_elements = queue.list_elements.value();
  result.queue_stalls = queue.queue_stalls.value();
  result.proxy_gets = proxy_.counters().gets.value();
  result.proxy_puts = proxy_.counters().puts.value();
  result.tag_waits = channel.tag_waits.value();
  result.mailbox_waits = channel.mailbox_waits.value();
  result.signal_waits = channel.signal_waits.value();
  result.event_waits = channel.event_waits.value();
  result.atomics = channel.atomics.value();
  result.failed_atomics = channel.lost_reservations.value();
  result.local_store_high_water = high_water_.load(std::memory_order_relaxed);
  return result;
}

}  // namespace spu_emu
