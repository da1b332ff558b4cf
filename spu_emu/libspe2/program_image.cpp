#include "libspe2/program_image.h"

#include <elf.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "host/elf_image.h"
#include "isa/elf/elf_loader.h"
#include "mfc/format.h"
#include "mfc/mapped.h"

namespace spu_emu {

namespace {
/// An opened program: its handle, and a copy of its file, which may change or be cut while programs run.
struct OpenImage {
  spe_program_handle_t program{};
  std::vector<std::byte> file;
};

struct OpenImages {
  std::mutex mutex;
  std::map<const spe_program_handle_t*, std::unique_ptr<OpenImage>> images;
};

OpenImages& open_images() {
  static OpenImages instance;
  return instance;
}

/// The open file's content, or an errno value.
int read_file(int file, std::vector<std::byte>& bytes) {
  struct stat status {};
  if (fstat(file, &status) != 0) return errno;
  if (!S_ISREG(status.st_mode) || status.st_size < static_cast<off_t>(sizeof(Elf32_Ehdr))) return EINVAL;
  if ((status.st_mode & (S_IXUSR | S_IXGRP | S_IXOTH)) == 0) return EACCES;
  if (static_cast<std::uint64_t>(status.st_size) > kLargestImage) return EFBIG;
  bytes.resize(static_cast<std::size_t>(status.st_size));
  std::size_t got = 0;
  while (got < bytes.size()) {
    const ssize_t step = read(file, bytes.data() + got, bytes.size() - got);
    if (step < 0 && errno == EINTR) continue;
    if (step < 0) return errno;
    if (step == 0) break;
    got += static_cast<std::size_t>(step);
  }
  bytes.resize(got);
  return 0;
}

/// Whether a shared object of this machine may be a program module: others have no such symbol.
bool names_entry(std::span<const std::byte> file) {
  const std::span<const char> name("spu_emu_entry");  // with its NUL
  const auto wanted = std::as_bytes(name);
  return std::search(file.begin(), file.end(), wanted.begin(), wanted.end()) != file.end();
}

int check_program(std::span<const std::byte> file) {
  switch (image_kind(file)) {
    case ImageKind::host_module:
      return claimed_module_size(file) <= file.size() && names_entry(file) ? 0 : EINVAL;
    case ImageKind::spu_elf:
      return isa::read_elf(file).program ? 0 : EINVAL;
    case ImageKind::none:
      break;
  }
  return EINVAL;
}

int read_program(const char* filename, std::vector<std::byte>& bytes) {
  const int file = open(filename, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return errno;
  const int error = read_file(file, bytes);
  close(file);
  return error != 0 ? error : check_program(bytes);
}

bool can_read(const std::byte* image, std::uint64_t size) {
  return is_mapped(reinterpret_cast<std::uintptr_t>(image), size, Access::read);
}

std::uint64_t claimed_size(std::span<const std::byte> known) {
  return image_kind(known) == ImageKind::spu_elf ? isa::claimed_elf_size(known) : claimed_module_size(known);
}

/// The header says where the tables end, and these say where the segments do.
ImageBytes bytes_by_headers(std::span<const std::byte> known) {
  for (;;) {
    const std::uint64_t size = claimed_size(known);
    if (size <= known.size()) return {known.first(size), {}};
    if (size > kLargestImage || !can_read(known.data(), size)) {
      return {{},
              format("broken program: its headers say that it has %llu bytes, which is more than can be read "
                     "at its address or than the %zu of the largest image",
                     static_cast<unsigned long long>(size), kLargestImage)};
    }
    known = {known.data(), static_cast<std::size_t>(size)};
  }
}

/// The file of the opened image at this address; empty if there is none.
std::span<const std::byte> opened_at(const void* address) {
  const std::lock_guard lock(open_images().mutex);
  for (const auto& [handle, image] : open_images().images) {
    if (image->file.data() == address) return image->file;
  }
  return {};
}
}  // namespace

ImageKind image_kind(std::span<const std::byte> image) {
  if (isa::is_spu_elf(image)) return ImageKind::spu_elf;
  return is_module(image) ? ImageKind::host_module : ImageKind::none;
}

spe_program_handle_t* open_image(const char* filename) {
  try {
    auto image = std::make_unique<OpenImage>();
    errno = read_program(filename, image->file);
    if (errno != 0) return nullptr;
    image->program = {sizeof(spe_program_handle_t), image->file.data(), nullptr};
    spe_program_handle_t* const handle = &image->program;
    const std::lock_guard lock(open_images().mutex);
    open_images().images.emplace(handle, std::move(image));
    return handle;
  } catch (const std::bad_alloc&) {
    errno = ENOMEM;
    return nullptr;
  }
}

int close_image(spe_program_handle_t* program) {
  const std::lock_guard lock(open_images().mutex);
  return open_images().images.erase(program) == 1 ? 0 : EINVAL;
}

ImageBytes image_bytes(const spe_program_handle_t& program) {
  const auto* image = static_cast<const std::byte*>(program.elf_image);
  if (const auto file = opened_at(image); !file.empty()) return {file, {}};
  for (const std::size_t size : {sizeof(Elf64_Ehdr), sizeof(Elf32_Ehdr)}) {
    const std::span<const std::byte> known(image, size);
    if (image == nullptr || !can_read(image, size)) continue;
    if (image_kind(known) != ImageKind::none) return bytes_by_headers(known);
  }
  return {{}, "the image is no ELF file of an SPU program"};
}

}  // namespace spu_emu
