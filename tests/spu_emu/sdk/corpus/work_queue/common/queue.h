#ifndef QUEUE_H
#define QUEUE_H

#define ITEMS 60

/* The head of the queue, alone in a line, and items that are taken in order. Addresses are those of a 32-bit host. */
typedef struct {
  unsigned int next;
  unsigned int items;
  unsigned int item_ea;
  unsigned int pad[29];
} queue_t;

typedef struct {
  unsigned int number;
  unsigned int steps; /* to 1, by the rule of Collatz */
  unsigned int by;
  unsigned int pad;
} item_t;

int collatz_steps(unsigned int number);

#endif
