#include "services.h"

namespace reference {

Request& last_request() {
  static Request request;
  return request;
}

unsigned int& channel_answer() {
  static unsigned int answer = 0;
  return answer;
}

namespace {

void record(const char* kind, unsigned int channel, unsigned int value, spu_emu::SourceLine where) {
  last_request() = {kind, channel, value, where.line, where.file};
}

spu_emu::HostServices make_services() {
  spu_emu::HostServices s{};
  s.read_channel = [](void*, unsigned int channel, spu_emu::SourceLine where) {
    record("read", channel, 0, where);
    return channel_answer();
  };
  s.write_channel = [](void*, unsigned int channel, unsigned int value, spu_emu::SourceLine where) {
    record("write", channel, value, where);
  };
  s.channel_count = [](void*, unsigned int channel, spu_emu::SourceLine where) {
    record("count", channel, 0, where);
    return channel_answer();
  };
  s.stop = [](void*, unsigned int code, spu_emu::SourceLine where) { record("stop", 0, code, where); };
  s.halt = [](void*, spu_emu::SourceLine where) { record("halt", 0, 0, where); };
  return s;
}

const spu_emu::HostServices services = make_services();

}  // namespace

}  // namespace reference

const spu_emu::HostServices* spu_emu_services = &reference::services;
