#include "isa/debug/breakpoints.h"

#include <algorithm>
#include <span>

#include "isa/debug/channel_names.h"
#include "isa/debug/store_reader.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {

bool has_address(const Breakpoint& breakpoint, std::uint32_t pc) {
  const auto& addresses = breakpoint.addresses;
  return std::find(addresses.begin(), addresses.end(), pc) != addresses.end();
}

bool meets_channel(const Breakpoint& breakpoint, const ChannelEffect& effect) {
  if (!breakpoint.is_channel || breakpoint.channel != effect.channel) return false;
  return effect.write ? breakpoint.on_write : breakpoint.on_read;
}

std::string channel_words(const ChannelEffect& effect) {
  const char* name = channel_name(effect.channel);
  if (effect.write)
    return format("0x%08x is about to be written to channel %u, %s", effect.value, effect.channel, name);
  return format("channel %u, %s, is about to be read", effect.channel, name);
}

/// Bytes as words of four; a long range is cut.
std::string bytes_text(std::span<const std::byte> bytes) {
  constexpr std::size_t kMost = 16;
  std::string text;
  for (std::size_t i = 0; i < std::min(bytes.size(), kMost); ++i) {
    if (i != 0 && i % 4 == 0) text += ' ';
    text += format("%02x", std::to_integer<unsigned>(bytes[i]));
  }
  return bytes.size() > kMost ? text + " ..." : text;
}

/// The part of `bytes`, which begin at LS `first`, that is different in `now`.
std::string change_text(std::uint32_t first, std::span<const std::byte> bytes,
                        std::span<const std::byte> now) {
  std::size_t begin = 0;
  std::size_t end = bytes.size();
  while (begin < end && bytes[begin] == now[begin]) ++begin;
  while (end > begin && bytes[end - 1] == now[end - 1]) --end;
  begin = begin / 4 * 4;
  end = std::min((end + 3) / 4 * 4, bytes.size());
  return format("LS 0x%05x: %s -> %s", first + static_cast<std::uint32_t>(begin),
                bytes_text(bytes.subspan(begin, end - begin)).c_str(),
                bytes_text(now.subspan(begin, end - begin)).c_str());
}

std::string meeting(const Breakpoint& breakpoint, const std::string& what) {
  const char* kind = breakpoint.addresses.empty() ? "watchpoint" : "breakpoint";
  return format("%s %u", kind, breakpoint.number) + (what.empty() ? "" : ": " + what);
}

}  // namespace

const Breakpoint& Breakpoints::add(Breakpoint breakpoint) {
  breakpoint.number = next_number_++;
  breakpoint.known = read_store(store_, breakpoint.first, breakpoint.size);
  all_.push_back(std::move(breakpoint));
  return all_.back();
}

bool Breakpoints::remove(unsigned number) {
  return std::erase_if(all_, [number](const Breakpoint& each) { return each.number == number; }) != 0;
}

bool Breakpoints::watches_bytes() const {
  return std::any_of(all_.begin(), all_.end(), [](const Breakpoint& each) { return each.size != 0; });
}

bool Breakpoints::wants(std::uint32_t pc, std::uint32_t word) const {
  const bool store = is_store_instruction(word);
  const auto channel = channel_effect(word);
  return std::any_of(all_.begin(), all_.end(), [&](const Breakpoint& each) {
    return has_address(each, pc) || (store && each.size != 0) || (channel && meets_channel(each, *channel));
  });
}

/// True if the store is to be stopped at; then what it will leave is what is known.
bool Breakpoints::meets_store(Breakpoint& breakpoint, const StoreEffect& store, std::string& what) {
  const std::uint32_t first = std::max(breakpoint.first, store.address);
  const std::uint32_t end = std::min(breakpoint.first + breakpoint.size, store.address + 16);
  if (first >= end) return false;
  const std::vector<std::byte> old = read_store(store_, first, end - first);
  const auto now = std::span(store.bytes).subspan(first - store.address, end - first);
  const bool changes = !std::equal(old.begin(), old.end(), now.begin());
  std::copy(now.begin(), now.end(), breakpoint.known.begin() + (first - breakpoint.first));
  if (changes) {
    what = "a store is about to change " + change_text(first, old, now);
  } else if (breakpoint.any_store) {
    what = format("a store is about to write LS 0x%05x: %s again", first, bytes_text(now).c_str());
  }
  return changes || breakpoint.any_store;
}

std::vector<std::string> Breakpoints::meet(std::uint32_t pc, std::uint32_t word, const Machine& machine) {
  std::vector<std::string> met;
  const auto store = store_effect(word, pc, machine);
  const auto channel = channel_effect(word, machine);
  for (Breakpoint& each : all_) {
    std::string what;
    if (each.size != 0 && !(store && meets_store(each, *store, what))) continue;
    if (each.is_channel && !(channel && meets_channel(each, *channel))) continue;
    if (!each.addresses.empty() && !has_address(each, pc)) continue;
    if (each.is_channel) what = channel_words(*channel);
    ++each.hits;
    met.push_back(meeting(each, what));
  }
  if (!met.empty())
    std::erase_if(all_, [pc](const Breakpoint& b) { return b.temporary && has_address(b, pc); });
  return met;
}

void Breakpoints::expect(std::uint32_t pc, std::uint32_t word, const Machine& machine) {
  const auto store = store_effect(word, pc, machine);
  if (!store) return;
  std::string unsaid;
  for (Breakpoint& each : all_) meets_store(each, *store, unsaid);
}

void Breakpoints::accept_changes() {
  for (Breakpoint& each : all_) each.known = read_store(store_, each.first, each.size);
}

std::vector<std::string> Breakpoints::changed_by(const char* who) {
  std::vector<std::string> met;
  for (Breakpoint& each : all_) {
    const std::vector<std::byte> now = read_store(store_, each.first, each.size);
    if (std::equal(now.begin(), now.end(), each.known.begin())) continue;
    ++each.hits;
    met.push_back(meeting(each, who + (" changed " + change_text(each.first, each.known, now))));
    each.known = now;
  }
  return met;
}

}  // namespace spu_emu::isa
