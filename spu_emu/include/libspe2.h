/* The SPE runtime management library, version 2, for emulated SPEs.
 *
 * Unless a function says otherwise it returns 0 (or what it names) and -1 with errno on error, or a null
 * pointer with errno; a null context, gang or handler is ESRCH, any other bad argument EINVAL. All functions
 * may be called from any thread; one context runs on one thread at a time. Sizes are in bytes, `ls` is an LS
 * address. A context or handler is of the process that made it: in a child that fork() made it is ESRCH for
 * all functions, and to destroy it is to forget it. */
#ifndef SPU_EMU_LIBSPE2_H
#define SPU_EMU_LIBSPE2_H

#include <errno.h>
#include <stdio.h>

#include "libspe2-types.h"

#pragma GCC visibility push(default)
#ifdef __cplusplus
extern "C" {
#endif

/* A new SPE with the settings of <spu_emu/emulation.h>. Owned by the caller until spe_context_destroy.
 * SPE_ISOLATE and SPE_ISOLATE_EMULATE are refused (ENODEV, EINVAL); other flags that only place an SPE are
 * accepted and do nothing. */
spe_context_ptr_t spe_context_create(unsigned int flags, spe_gang_context_ptr_t gang);
spe_context_ptr_t spe_context_create_affinity(unsigned int flags, spe_context_ptr_t affinity_neighbor,
                                              spe_gang_context_ptr_t gang);
/* EBUSY while the context runs. A program that is stopped in the middle never goes on. */
int spe_context_destroy(spe_context_ptr_t spe);
spe_gang_context_ptr_t spe_gang_context_create(unsigned int flags);
/* EBUSY while contexts of the gang exist. */
int spe_gang_context_destroy(spe_gang_context_ptr_t gang);

/* A program image from a file, a copy of it until spe_image_close. EACCES if not executable, EINVAL if no SPU
 * program, EFBIG beyond 256 MB. */
spe_program_handle_t* spe_image_open(const char* filename);
int spe_image_close(spe_program_handle_t* program);
/* Loads a program of its own copy of all writable data into the context. EINVAL for an image that is no SPU
 * program or whose headers lead to where no memory can be read, ENOTSUP for one that no engine here
 * executes, ENOMEM when code, data and stack reserve exceed the limit; spu_emu::last_fault says more. */
int spe_program_load(spe_context_ptr_t spe, spe_program_handle_t* program);

/* Runs the loaded program on the calling thread until it stops. entry: SPE_DEFAULT_ENTRY starts it, the value
 * found there after a stop-and-signal resumes it. Returns 0 after exit, the code after stop-and-signal, -1
 * after a fault: EIO for a broken DMA rule (with SPE_EVENTS_ENABLE; without, SIGBUS is raised), EFAULT for
 * other faults. */
int spe_context_run(spe_context_ptr_t spe, unsigned int* entry, unsigned int runflags, void* argp, void* envp,
                    spe_stop_info_t* stopinfo);
/* The next stop info not read yet; needs SPE_EVENTS_ENABLE (else ENOTSUP); EAGAIN when there is none. */
int spe_stop_info_read(spe_context_ptr_t spe, spe_stop_info_t* stopinfo);

/* Event handlers: contexts need SPE_EVENTS_ENABLE (else ENOTSUP). EEXIST / ENOENT for an event registered
 * twice / not. */
spe_event_handler_ptr_t spe_event_handler_create(void);
int spe_event_handler_destroy(spe_event_handler_ptr_t evhandler);
int spe_event_handler_register(spe_event_handler_ptr_t evhandler, spe_event_unit_t* event);
int spe_event_handler_deregister(spe_event_handler_ptr_t evhandler, spe_event_unit_t* event);
/* Number of events, 0 after `timeout` milliseconds; -1 waits for ever. One entry for each event of a context.
 */
int spe_event_wait(spe_event_handler_ptr_t evhandler, spe_event_unit_t* events, int max_events, int timeout);

/* Proxy DMA: tags 0-15 (else EINVAL), a broken DMA rule is EIO. */
int spe_mfcio_put(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                  unsigned int tid, unsigned int rid);
int spe_mfcio_putb(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid);
int spe_mfcio_putf(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid);
int spe_mfcio_get(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                  unsigned int tid, unsigned int rid);
int spe_mfcio_getb(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid);
int spe_mfcio_getf(spe_context_ptr_t spe, unsigned int ls, void* ea, unsigned int size, unsigned int tag,
                   unsigned int tid, unsigned int rid);
/* mask 0 means every tag in use. */
int spe_mfcio_tag_status_read(spe_context_ptr_t spe, unsigned int mask, unsigned int behavior,
                              unsigned int* tag_status);

/* Mailboxes: reads and writes return the number of messages moved, status the number that can be moved now.
 */
int spe_out_mbox_read(spe_context_ptr_t spe, unsigned int* mbox_data, int count);
int spe_out_mbox_status(spe_context_ptr_t spe);
int spe_in_mbox_write(spe_context_ptr_t spe, unsigned int* mbox_data, int count, unsigned int behavior);
int spe_in_mbox_status(spe_context_ptr_t spe);
int spe_out_intr_mbox_read(spe_context_ptr_t spe, unsigned int* mbox_data, int count, unsigned int behavior);
int spe_out_intr_mbox_status(spe_context_ptr_t spe);

/* Multisource synchronisation: transfers of one context are visible in order here, so the status is always
 * done. */
int spe_mssync_start(spe_context_ptr_t spe);
int spe_mssync_status(spe_context_ptr_t spe);

int spe_signal_write(spe_context_ptr_t spe, unsigned int signal_reg, unsigned int data);

/* Addresses by which SPEs' DMA (and, for the local store, plain loads and stores) reach this SPE. */
void* spe_ls_area_get(spe_context_ptr_t spe);
int spe_ls_size_get(spe_context_ptr_t spe);
/* EACCES unless the context was created with SPE_MAP_PS. */
void* spe_ps_area_get(spe_context_ptr_t spe, enum ps_area area);

/* Library calls 0x2100-0x21ff: int handler(void* ls_base, unsigned int word_address). Numbers 0-3 are
 * reserved. */
int spe_callback_handler_register(void* handler, unsigned int callnum, unsigned int mode);
int spe_callback_handler_deregister(unsigned int callnum);
void* spe_callback_handler_query(unsigned int callnum);

/* One node of 8 SPEs for every 8 processors or part of it. */
int spe_cpu_info_get(int info_requested, int cpu_node);

#ifdef __cplusplus
}
#endif
#pragma GCC visibility pop

#endif
