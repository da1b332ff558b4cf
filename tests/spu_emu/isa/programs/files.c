/* main(argc, argv): writes its arguments to a file, by streams and by descriptors, and reads them back. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

int main(int argc, char** argv) {
  char line[64];
  struct stat status;
  struct timeval now;
  if (argc != 4) return 1;
  const char* name = argv[1];
  FILE* file = fopen(name, "w");
  if (file == NULL) return errno == EACCES ? 77 : 2;
  fprintf(file, "%s\n%s\n", argv[2], argv[3]);
  if (fclose(file) != 0 || stat(name, &status) != 0) return 3;
  if (status.st_size != (int)(strlen(argv[2]) + strlen(argv[3]) + 2)) return 4;
  int descriptor = open(name, O_RDONLY);
  if (descriptor < 0 || lseek(descriptor, (int)strlen(argv[2]) + 1, SEEK_SET) < 0) return 5;
  ssize_t got = read(descriptor, line, sizeof line);
  if (got < 1 || close(descriptor) != 0) return 6;
  line[got - 1] = '\0';
  if (strcmp(line, argv[3]) != 0) return 7;
  if (unlink(name) != 0 || stat(name, &status) == 0 || errno != ENOENT) return 8;
  if (gettimeofday(&now, NULL) != 0 || now.tv_sec < 1000000000) return 9;
  write(1, "done\n", 5);
  return 0;
}
