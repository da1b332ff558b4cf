// The part of every SPU program module that is not the program: its entry, and its own malloc and exit.
//
// The C library's allocation and exit functions are routed here by the linker's --wrap, for the module only.
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>

#include "spu_emu/services.h"

const spu_emu::HostServices* spu_emu_services = nullptr;

extern "C" {
/// The program's main, whatever parameters it has: they are passed alike.
__attribute__((visibility("hidden"))) int spu_emu_program_main(unsigned long long speid,
                                                               unsigned long long argp,
                                                               unsigned long long envp);
/// There where main returns nothing.
extern const char spu_emu_program_main_is_void __attribute__((weak, visibility("hidden")));
}

namespace {

constexpr std::size_t kAlignment = 16;

void* allocate(std::size_t size, std::size_t alignment) {
  return spu_emu_services->allocate(spu_emu_services->spe, size, alignment);
}

/// A function that runs at exit, last registered first; as on the SPU these are the program's own, kept in
/// its heap.
struct ExitCall {
  void (*function)(void*);
  void* argument;
  ExitCall* next;
};
ExitCall* exit_calls = nullptr;

void run_exit_calls() {
  while (exit_calls != nullptr) {
    ExitCall* call = exit_calls;
    exit_calls = call->next;
    call->function(call->argument);
    spu_emu_services->release(spu_emu_services->spe, call);
  }
}

[[noreturn]] void stop_for_good(int code) {
  constexpr unsigned kExit = 0x2000;
  for (;;) spu_emu_services->stop(spu_emu_services->spe, kExit | (static_cast<unsigned>(code) & 0xffU), {});
}

void call_without_argument(void* function) {
  reinterpret_cast<void (*)()>(function)();
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) void spu_emu_bind(const spu_emu::HostServices* services) {
  spu_emu_services = services;
}

__attribute__((visibility("default"))) int spu_emu_entry(unsigned long long speid, unsigned long long argp,
                                                         unsigned long long envp) {
  const int code = spu_emu_program_main(speid, argp, envp);
  run_exit_calls();
  return &spu_emu_program_main_is_void == nullptr ? code : 0;
}

void* __wrap_malloc(std::size_t size) {
  return allocate(size, kAlignment);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
  std::size_t bytes = 0;
  if (__builtin_mul_overflow(count, size, &bytes)) return nullptr;
  void* block = allocate(bytes, kAlignment);
  return block == nullptr ? nullptr : std::memset(block, 0, bytes);
}

void* __wrap_realloc(void* block, std::size_t size) {
  return spu_emu_services->reallocate(spu_emu_services->spe, block, size);
}

void __wrap_free(void* block) {
  spu_emu_services->release(spu_emu_services->spe, block);
}

void* __wrap_memalign(std::size_t alignment, std::size_t size) {
  return allocate(size, alignment);
}

void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  return allocate(size, alignment);
}

int __wrap_posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = allocate(size, alignment);
  return *block == nullptr ? ENOMEM : 0;
}

int __wrap___cxa_atexit(void (*function)(void*), void* argument, void*) {
  auto* call = static_cast<ExitCall*>(allocate(sizeof(ExitCall), kAlignment));
  *call = {function, argument, exit_calls};
  exit_calls = call;
  return 0;
}

int __wrap_atexit(void (*function)()) {
  return __wrap___cxa_atexit(&call_without_argument, reinterpret_cast<void*>(function), nullptr);
}

[[noreturn]] void __wrap_exit(int code) {
  run_exit_calls();
  stop_for_good(code);
}

[[noreturn]] void __wrap__exit(int code) {
  stop_for_good(code);
}

/// The library call of the SPU's C library: `data` in the local store is the argument block.
int __send_to_ppe(unsigned int code, unsigned int opcode, void* data) {
  return spu_emu_services->call_host(spu_emu_services->spe, code, opcode, data, {});
}

}  // extern "C"

// The sized and array forms of the standard library end in these.
void* operator new(std::size_t size) {
  return allocate(size, kAlignment);
}
void* operator new[](std::size_t size) {
  return allocate(size, kAlignment);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block) noexcept {
  __wrap_free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  __wrap_free(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  __wrap_free(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  __wrap_free(block);
}
