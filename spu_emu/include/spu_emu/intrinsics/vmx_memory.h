// vmx2spu.h: loads and stores with a byte offset, aligned and unaligned, and the alignment patterns.
//
// Addresses are pointer plus offset. vec_ld and vec_st ignore the low four address bits. vec_lvlx and its kin
// move the bytes as they lie in memory, so that the left and right parts of an unaligned vector fit together;
// on elements that are aligned to their own size this is what the PPU does.
#ifndef SPU_EMU_INTRINSICS_VMX_MEMORY_H
#define SPU_EMU_INTRINSICS_VMX_MEMORY_H

#include <cstring>

#include "spu_emu/intrinsics/vmx_types.h"

namespace spu_emu::detail {

SPU_EMU_INLINE std::uintptr_t offset_address(const volatile void* pointer, int offset) {
  return reinterpret_cast<std::uintptr_t>(pointer) +
         static_cast<std::uintptr_t>(static_cast<std::intptr_t>(offset));
}

// Result type R where a V may be stored through a T*.
template <typename V, typename T>
using IfStores = std::enable_if_t<lane_bytes<V> == lane_bytes<PointeeT<T>>>;

}  // namespace spu_emu::detail

template <typename T>
SPU_EMU_INLINE spu_emu::detail::PointeeT<T> vec_ld(int offset, T* pointer) {
  const std::uintptr_t address = spu_emu::detail::offset_address(pointer, offset) & ~std::uintptr_t{15};
  return (spu_emu::detail::PointeeT<T>)_mm_load_si128(reinterpret_cast<const __m128i*>(address));
}

template <typename V, typename T, typename = spu_emu::detail::IfStores<V, T>>
SPU_EMU_INLINE void vec_st(V value, int offset, T* pointer) {
  const std::uintptr_t address = spu_emu::detail::offset_address(pointer, offset) & ~std::uintptr_t{15};
  _mm_store_si128(reinterpret_cast<__m128i*>(address), (__m128i)value);
}

// The whole quadword around the addressed element, as an SPU has no narrower load.
template <typename T>
SPU_EMU_INLINE spu_emu::detail::PointeeT<T> vec_lde(int offset, T* pointer) {
  return vec_ld(offset, pointer);
}

template <typename V, typename T, typename = spu_emu::detail::IfStores<V, T>>
SPU_EMU_INLINE void vec_ste(V value, int offset, T* pointer) {
  const std::uintptr_t address =
      spu_emu::detail::offset_address(pointer, offset) & ~std::uintptr_t{sizeof(T) - 1};
  std::memcpy(reinterpret_cast<void*>(address), reinterpret_cast<const char*>(&value) + (address & 15),
              sizeof(T));
}

// The bytes from the address to the end of its quadword, moved to the vector's start; zeros behind them.
template <typename T>
SPU_EMU_INLINE spu_emu::detail::PointeeT<T> vec_lvlx(int offset, T* pointer) {
  const std::uintptr_t address = spu_emu::detail::offset_address(pointer, offset);
  spu_emu::detail::PointeeT<T> result = {};
  std::memcpy(&result, reinterpret_cast<const void*>(address), 16 - (address & 15));
  return result;
}

// The bytes from the start of the address's quadword up to the address, moved to the vector's end; none when
// aligned.
template <typename T>
SPU_EMU_INLINE spu_emu::detail::PointeeT<T> vec_lvrx(int offset, T* pointer) {
  const std::uintptr_t address = spu_emu::detail::offset_address(pointer, offset);
  const std::size_t count = address & 15;
  spu_emu::detail::PointeeT<T> result = {};
  if (count != 0)
    std::memcpy(reinterpret_cast<char*>(&result) + 16 - count, reinterpret_cast<const void*>(address - count),
                count);
  return result;
}

// The inverse of vec_lvlx: the vector's first bytes go from the address to the end of its quadword.
template <typename V, typename T, typename = spu_emu::detail::IfStores<V, T>>
SPU_EMU_INLINE void vec_stvlx(V value, int offset, T* pointer) {
  const std::uintptr_t address = spu_emu::detail::offset_address(pointer, offset);
  std::memcpy(reinterpret_cast<void*>(address), &value, 16 - (address & 15));
}

template <typename V, typename T, typename = spu_emu::detail::IfStores<V, T>>
SPU_EMU_INLINE void vec_stvrx(V value, int offset, T* pointer) {
  const std::uintptr_t address = spu_emu::detail::offset_address(pointer, offset);
  const std::size_t count = address & 15;
  if (count != 0)
    std::memcpy(reinterpret_cast<void*>(address - count), reinterpret_cast<const char*>(&value) + 16 - count,
                count);
}

// The patterns by which vec_perm aligns two quadwords: bytes from the address's offset on, or from 16 less
// it.
template <typename T>
SPU_EMU_INLINE vec_uchar16 vec_lvsl(int offset, T* pointer) {
  const auto first = static_cast<unsigned char>(spu_emu::detail::offset_address(pointer, offset) & 15);
  const vec_uchar16 numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  return numbers + spu_emu::detail::splat<vec_uchar16>(first);
}

template <typename T>
SPU_EMU_INLINE vec_uchar16 vec_lvsr(int offset, T* pointer) {
  const auto first = static_cast<unsigned char>(16 - (spu_emu::detail::offset_address(pointer, offset) & 15));
  const vec_uchar16 numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  return numbers + spu_emu::detail::splat<vec_uchar16>(first);
}

// "Least recently used" forms: a cache hint on the PPU.
template <typename T>
SPU_EMU_INLINE auto vec_ldl(int offset, T* pointer) {
  return vec_ld(offset, pointer);
}

template <typename V, typename T>
SPU_EMU_INLINE void vec_stl(V value, int offset, T* pointer) {
  vec_st(value, offset, pointer);
}

template <typename T>
SPU_EMU_INLINE auto vec_lvlxl(int offset, T* pointer) {
  return vec_lvlx(offset, pointer);
}

template <typename T>
SPU_EMU_INLINE auto vec_lvrxl(int offset, T* pointer) {
  return vec_lvrx(offset, pointer);
}

template <typename V, typename T>
SPU_EMU_INLINE void vec_stvlxl(V value, int offset, T* pointer) {
  vec_stvlx(value, offset, pointer);
}

template <typename V, typename T>
SPU_EMU_INLINE void vec_stvrxl(V value, int offset, T* pointer) {
  vec_stvrx(value, offset, pointer);
}

// Data stream touches are prefetch hints of the PPU; an SPU has no cache to touch.
SPU_EMU_INLINE void vec_dss(int) {}
SPU_EMU_INLINE void vec_dssall() {}
SPU_EMU_INLINE void vec_dst(const void*, int, int) {}
SPU_EMU_INLINE void vec_dstst(const void*, int, int) {}
SPU_EMU_INLINE void vec_dststt(const void*, int, int) {}
SPU_EMU_INLINE void vec_dstt(const void*, int, int) {}

// The vector status register reads as zero: saturation is not recorded.
SPU_EMU_INLINE vec_ushort8 vec_mfvscr() {
  return vec_ushort8{};
}

template <typename V>
SPU_EMU_INLINE void vec_mtvscr(V) {}

#endif
