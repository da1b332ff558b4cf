// A stand-in for the emulation: the services that channel and control intrinsics call, recorded for the
// tests.
#pragma once

#include <spu_intrinsics.h>

#include <string>

namespace reference {

// What an intrinsic asked for last.
struct Request {
  std::string kind;
  unsigned int channel = 0;
  unsigned int value = 0;
  int line = 0;
  std::string file;
};

Request& last_request();

// What the next channel read or count gives.
unsigned int& channel_answer();

}  // namespace reference
