/* What both sides agree on: 16-byte multiples, addresses as 64-bit numbers. */
#ifndef JOB_H
#define JOB_H

#define BLOCK 4096 /* bytes of a transfer */

typedef struct {
  unsigned long long in;
  unsigned long long out;
  unsigned int bytes;
  float offset;
  unsigned int pad[2];
} job_t;

#endif
