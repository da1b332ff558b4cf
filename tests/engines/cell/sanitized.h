/// @file
/// Whether a sanitizer is at work: it makes the data of SPU programs larger than on a Cell.
#pragma once

namespace cellsweep::cell {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace cellsweep::cell
