/* Preloaded into LinuxCNC's rs274, which prints canonical calls with four decimals: every "%.4f" of a format becomes
 * "%.17g", so that each double is told apart from its neighbours. The interpreter itself stays as it is installed. */

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Long enough for every format of canonical calls; a longer one is printed as it is. */
#define ROOM 512

static const char *widened(const char *format, char *room) {
    size_t used = 0;
    const char *from = format;
    while (*from != '\0') {
        if (used + 6 > ROOM) {
            return format;
        }
        if (strncmp(from, "%.4f", 4) == 0) {
            memcpy(room + used, "%.17g", 5);
            used += 5;
            from += 4;
        } else {
            room[used++] = *from++;
        }
    }
    room[used] = '\0';
    return room;
}

/* The names under which fortified programs call printf and its relatives. */

int __vfprintf_chk(FILE *file, int flag, const char *format, va_list arguments) {
    char room[ROOM];
    (void)flag;
    return vfprintf(file, widened(format, room), arguments);
}

int __fprintf_chk(FILE *file, int flag, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int written = __vfprintf_chk(file, flag, format, arguments);
    va_end(arguments);
    return written;
}

int __printf_chk(int flag, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int written = __vfprintf_chk(stdout, flag, format, arguments);
    va_end(arguments);
    return written;
}
