/// @file
/// A loaded SPU program of the host engine: a private copy of its module.
#ifndef SPU_EMU_HOST_MODULE_H
#define SPU_EMU_HOST_MODULE_H

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/host_local_store.h"
#include "host/program_guard.h"
#include "spu_emu/services.h"

namespace spu_emu {

struct PreparedModule;

/// Every object has a copy of all writable data of the program, however often the same image is loaded.
class Module {
 public:
  using Bind = void (*)(const HostServices*);
  using Entry = int (*)(unsigned long long speid, unsigned long long argp, unsigned long long envp);

  /// Loads the image; null, with the reason in `error`, if it is no module made by add_spu_program.
  static std::unique_ptr<Module> load(std::span<const std::byte> image, std::string& error);
  ~Module();
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  /// Runs the constructors (before the first start only) and main; to be called on the program's own stack.
  int run(const HostServices& services, unsigned long long speid, unsigned long long argp,
          unsigned long long envp);
  /// Constants and data of the program, in the order of their addresses.
  std::vector<ModuleSegment> segments() const;
  /// Addresses of its code.
  CodeRange code() const;
  /// Where the dynamic linker put the module's address 0.
  std::uintptr_t base() const { return reinterpret_cast<std::uintptr_t>(base_); }

 private:
  Module() = default;
  bool open(std::span<const std::byte> image, const PreparedModule& prepared, std::string& error);

  int file_ = -1;
  void* handle_ = nullptr;
  std::byte* base_ = nullptr;
  Bind bind_ = nullptr;
  Entry entry_ = nullptr;
  std::uint64_t init_array_ = 0;
  std::uint64_t init_count_ = 0;
  bool constructed_ = false;
};

}  // namespace spu_emu

#endif
