/* Wide characters in the formats of printf and scanf. */
#include <stdio.h>
#include <stdlib.h>
#include <wchar.h>

int main(void) {
  wchar_t word[20];
  wchar_t letter = 0;
  char bytes[20];
  int number = 0;
  printf("[%ls|%5lc|%-6ls|%.2ls]\n", L"wide", (wint_t)L'x', L"ab", L"abcdef");
  if (sscanf("hello w9", "%ls %lc%d", word, &letter, &number) != 3) return 1;
  printf("%ls %lc %d\n", word, (wint_t)letter, number);
  if (sprintf(bytes, "%lc", (wint_t)0x20ac) != 3 || sprintf(bytes, "%lc", (wint_t)0xd800) != -1) return 2;
  return (int)wcslen(word);
}
