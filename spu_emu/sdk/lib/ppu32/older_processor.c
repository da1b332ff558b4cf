/* Linked into every program of the PPU in 32 bits: what a Cell executes and qemu's 32-bit processors do not.
 *
 * ISA 3.0 put mffscrni, mffscrn, mffsl and their kin into bits of mffs that older processors ignore, so that
 * they take all of these for mffs; the C library counts on that, in sin, cos, tan, atan and atan2 of doubles.
 * qemu takes them for illegal. Before anything else runs, each is therefore made the mffs that it is on a
 * Cell. Only the sections of code are looked at, which lie from _init to _fini: elsewhere the same bits are a
 * number. */
#define _GNU_SOURCE
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

extern void _init(void);
extern void _fini(void);

static int is_newer_mffs(unsigned int word) {
  const unsigned int form = word >> 16 & 31u;
  return (word & 0xfc0007feu) == 0xfc00048eu && (form == 1 || (form >= 0x14 && form <= 0x18));
}

static void make_mffs(unsigned int* word) {
  const unsigned long size = (unsigned long)sysconf(_SC_PAGESIZE);
  void* page = (void*)((unsigned long)word & ~(size - 1));
  if (mprotect(page, size, PROT_READ | PROT_WRITE | PROT_EXEC) != 0) return;
  *word &= 0xffe007ffu;
  __builtin___clear_cache((char*)word, (char*)(word + 1));
  mprotect(page, size, PROT_READ | PROT_EXEC);
}

static void mend(unsigned int* word, const unsigned int* end) {
  for (; word < end; ++word) {
    if (is_newer_mffs(*word)) make_mffs(word);
  }
}

/* Of a shared library the dynamic section says where both are, less the address that it was loaded to. */
static int mend_library(struct dl_phdr_info* info, size_t size, void* unused) {
  ElfW(Addr) begin = 0, end = 0;
  int i;
  (void)size;
  (void)unused;
  for (i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Dyn)* entry = (const ElfW(Dyn)*)(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
    if (info->dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
    for (; entry->d_tag != DT_NULL; ++entry) {
      if (entry->d_tag == DT_INIT) begin = info->dlpi_addr + entry->d_un.d_ptr;
      if (entry->d_tag == DT_FINI) end = info->dlpi_addr + entry->d_un.d_ptr;
    }
  }
  if (begin != 0 && end != 0) mend((unsigned int*)begin, (const unsigned int*)end);
  return 0;
}

__attribute__((constructor(101))) static void be_an_older_processor(void) {
  mend((unsigned int*)&_init, (const unsigned int*)&_fini);
  dl_iterate_phdr(mend_library, 0);
}
