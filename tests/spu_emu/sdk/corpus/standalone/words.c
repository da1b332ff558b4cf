#include <stdio.h>

int count_words(FILE *file, int *letters);

int main(int argc, char *argv[]) {
  int i;
  for (i = 1; i < argc; i++) {
    int letters = 0;
    FILE *file = fopen(argv[i], "r");
    if (!file) {
      printf("%s: not there\n", argv[i]);
      return 3;
    }
    printf("%s: %d words", argv[i], count_words(file, &letters));
    printf(", %d letters\n", letters);
    fclose(file);
  }
  return 0;
}
