/// @file
/// What the sanitizers must be told when a thread changes its stack; nothing in an ordinary build.
#ifndef SPU_EMU_HOST_SANITIZERS_H
#define SPU_EMU_HOST_SANITIZERS_H

#include <cstddef>

#if defined(__has_feature)
#define SPU_EMU_HAS_FEATURE(name) __has_feature(name)
#else
#define SPU_EMU_HAS_FEATURE(name) 0
#endif

#if defined(__SANITIZE_ADDRESS__) || SPU_EMU_HAS_FEATURE(address_sanitizer)
#include <sanitizer/common_interface_defs.h>
#define SPU_EMU_SANITIZED
#define SPU_EMU_ASAN(call) call
#else
#define SPU_EMU_ASAN(call) static_cast<void>(0)
#endif

#if defined(__SANITIZE_THREAD__) || SPU_EMU_HAS_FEATURE(thread_sanitizer)
#include <sanitizer/tsan_interface.h>
#define SPU_EMU_SANITIZED
#define SPU_EMU_TSAN(call) call
#else
#define SPU_EMU_TSAN(call) static_cast<void>(0)
#endif

#endif
