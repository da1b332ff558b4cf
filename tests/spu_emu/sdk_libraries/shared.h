// What SPU programs and host of the tests of the SDK's libraries share in main memory; 32-bit words only, each word of
// libsync in a line of its own.
#pragma once

struct SharedWord {
  int value;
  int padding[31];
};

struct SharedState {
  SharedWord counter;
  SharedWord mutex;
  SharedWord condition;
  SharedWord completion;
  SharedWord lock;
  SharedWord guarded;  // by the mutex
  SharedWord go;       // by the mutex, told by the condition
};

struct SharedJob {
  unsigned int state_hi;
  unsigned int state_lo;
  unsigned int padding[2];
};

constexpr int kRounds = 200;
