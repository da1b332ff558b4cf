#include "host/module.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

#include "host/elf_image.h"
#include "mfc/format.h"

namespace spu_emu {

namespace {
bool write_all(int file, const std::byte* bytes, std::size_t size) {
  while (size != 0) {
    const ssize_t written = write(file, bytes, size);
    if (written <= 0) return false;
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

/// The image with zeros where the module says, written to an empty file.
bool write_module(int file, std::span<const std::byte> image, const PreparedModule& prepared) {
  if (!write_all(file, image.data(), image.size())) return false;
  const std::uint64_t zero = 0;
  return std::all_of(prepared.zero_words.begin(), prepared.zero_words.end(), [&](std::uint64_t at) {
    return pwrite(file, &zero, sizeof zero, static_cast<off_t>(at)) == sizeof zero;
  });
}

/// The module's segments that hold data; the part that is read-only after relocation counts as constant.
void add_segments(const dl_phdr_info& info, std::vector<ModuleSegment>& segments) {
  std::uint64_t relro_begin = 0;
  std::uint64_t relro_end = 0;
  for (int i = 0; i < info.dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info.dlpi_phdr[i];
    if (header.p_type != PT_GNU_RELRO) continue;
    relro_begin = header.p_vaddr;
    relro_end = header.p_vaddr + header.p_memsz;
  }
  for (int i = 0; i < info.dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info.dlpi_phdr[i];
    if (header.p_type != PT_LOAD || (header.p_flags & PF_X) != 0) continue;
    std::uint64_t first = header.p_vaddr;
    const std::uint64_t last = header.p_vaddr + header.p_memsz;
    const auto add = [&](std::uint64_t begin, std::uint64_t end, bool writable) {
      if (end <= begin) return;
      segments.push_back({reinterpret_cast<std::byte*>(info.dlpi_addr + begin),
                          static_cast<std::uint32_t>(end - begin), writable});
    };
    if (first <= relro_begin && relro_begin < last) {
      add(first, relro_end, false);
      first = relro_end;
    }
    add(first, last, (header.p_flags & PF_W) != 0);
  }
}

CodeRange code_of(const dl_phdr_info& info) {
  for (int i = 0; i < info.dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = info.dlpi_phdr[i];
    if (header.p_type != PT_LOAD || (header.p_flags & PF_X) == 0) continue;
    const std::uintptr_t begin = info.dlpi_addr + header.p_vaddr;
    return {begin, begin + header.p_memsz};
  }
  return {};
}

struct ModuleSearch {
  std::uintptr_t base;
  dl_phdr_info found{};
};

/// Nothing may be thrown through the C library.
int find_module(dl_phdr_info* info, std::size_t, void* data) {
  auto* search = static_cast<ModuleSearch*>(data);
  if (info->dlpi_addr != search->base) return 0;
  search->found = *info;
  return 1;
}

/// Of the module that was loaded there.
dl_phdr_info headers_at(std::uintptr_t base) {
  ModuleSearch search{base};
  dl_iterate_phdr(&find_module, &search);
  return search.found;
}
}  // namespace

std::unique_ptr<Module> Module::load(std::span<const std::byte> image, std::string& error) {
  const auto prepared = prepare_module(image, error);
  if (!prepared) return nullptr;
  std::unique_ptr<Module> module(new Module);
  module->init_array_ = prepared->init_array;
  module->init_count_ = prepared->init_count;
  if (!module->open(image, *prepared, error)) return nullptr;
  return module;
}

/// The file stays open while the module is loaded: its name must stay its own, or the dynamic linker would
/// hand out this module for the next one of the same name.
bool Module::open(std::span<const std::byte> image, const PreparedModule& prepared, std::string& error) {
  file_ = memfd_create("spu_program", MFD_CLOEXEC);
  if (file_ < 0 || !write_module(file_, image, prepared)) {
    error = "no memory for a copy of the program";
    return false;
  }
  const std::string name = format("/proc/%d/fd/%d", static_cast<int>(getpid()), file_);
  handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    error = format("the program cannot be loaded: %s", dlerror());
    return false;
  }
  bind_ = reinterpret_cast<Bind>(dlsym(handle_, "spu_emu_bind"));
  entry_ = reinterpret_cast<Entry>(dlsym(handle_, "spu_emu_entry"));
  link_map* map = nullptr;
  if (bind_ == nullptr || entry_ == nullptr ||
      dlinfo(handle_, RTLD_DI_LINKMAP, static_cast<void*>(&map)) != 0) {
    error = "the module has no SPU program in it: build it with add_spu_program";
    return false;
  }
  base_ = reinterpret_cast<std::byte*>(map->l_addr);
  return true;
}

Module::~Module() {
  if (handle_ != nullptr) dlclose(handle_);
  if (file_ >= 0) close(file_);
}

int Module::run(const HostServices& services, unsigned long long speid, unsigned long long argp,
                unsigned long long envp) {
  if (!constructed_) {
    constructed_ = true;
    bind_(&services);
    using Constructor = void (*)(int, char**, char**);
    auto* constructors = reinterpret_cast<Constructor*>(base_ + init_array_);
    for (std::uint64_t i = 0; i < init_count_; ++i) constructors[i](0, nullptr, nullptr);
  }
  return entry_(speid, argp, envp);
}

std::vector<ModuleSegment> Module::segments() const {
  std::vector<ModuleSegment> segments;
  add_segments(headers_at(base()), segments);
  return segments;
}

CodeRange Module::code() const {
  return code_of(headers_at(base()));
}

}  // namespace spu_emu
