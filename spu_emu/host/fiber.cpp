#include "host/fiber.h"

#include <cxxabi.h>

#include <algorithm>
#include <cstdint>

#include "host/sanitizers.h"
#include "mfc/watch.h"

namespace spu_emu {

Fiber::Fiber(std::byte* stack, std::size_t size, Entry entry, void* argument)
    : stack_(stack), size_(size), entry_(entry), argument_(argument) {
  SPU_EMU_TSAN(inside_thread_ = __tsan_create_fiber(0));
  getcontext(&inside_);
  inside_.uc_stack.ss_sp = stack;
  inside_.uc_stack.ss_size = size;
  inside_.uc_link = nullptr;
  const auto self = reinterpret_cast<std::uintptr_t>(this);
  makecontext(&inside_, reinterpret_cast<void (*)()>(&Fiber::start), 2, static_cast<unsigned>(self >> 32U),
              static_cast<unsigned>(self));
}

Fiber::~Fiber() {
  allow_access(stack_, size_);
  SPU_EMU_TSAN(__tsan_destroy_fiber(inside_thread_));
}

void Fiber::swap_exception_state() {
  auto* state = reinterpret_cast<std::byte*>(abi::__cxa_get_globals());
  std::swap_ranges(exceptions_.begin(), exceptions_.end(), state);
}

void Fiber::start(unsigned high, unsigned low) {
  auto* self = reinterpret_cast<Fiber*>((std::uintptr_t{high} << 32U) | low);
  SPU_EMU_ASAN(__sanitizer_finish_switch_fiber(nullptr, &self->outside_stack_, &self->outside_size_));
  self->entry_(self->argument_);
}

void Fiber::resume() {
  swap_exception_state();
  SPU_EMU_ASAN(__sanitizer_start_switch_fiber(&outside_fake_stack_, stack_, size_));
  SPU_EMU_TSAN(outside_thread_ = __tsan_get_current_fiber());
  SPU_EMU_TSAN(__tsan_switch_to_fiber(inside_thread_, 0));
  swapcontext(&outside_, &inside_);
  SPU_EMU_ASAN(__sanitizer_finish_switch_fiber(outside_fake_stack_, nullptr, nullptr));
  swap_exception_state();
}

void Fiber::suspend() {
  SPU_EMU_ASAN(__sanitizer_start_switch_fiber(&inside_fake_stack_, outside_stack_, outside_size_));
  SPU_EMU_TSAN(__tsan_switch_to_fiber(outside_thread_, 0));
  swapcontext(&inside_, &outside_);
  SPU_EMU_ASAN(__sanitizer_finish_switch_fiber(inside_fake_stack_, &outside_stack_, &outside_size_));
}

}  // namespace spu_emu
