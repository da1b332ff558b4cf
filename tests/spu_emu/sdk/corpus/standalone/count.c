#include <ctype.h>
#include <stdio.h>

int count_words(FILE *file, int *letters) {
  int c, words = 0, inside = 0;
  while ((c = fgetc(file)) != EOF) {
    if (isalpha(c)) ++*letters;
    if (!isspace(c) && !inside) words++;
    inside = !isspace(c);
  }
  return words;
}
