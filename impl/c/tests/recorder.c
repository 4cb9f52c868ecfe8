/* A device that answers with another library, and writes down what it is asked and a digest of what it answers, for
 * tests/certified.rs: its file is $RADCOMP_RECORDING and the number of the process. `scripts/mutants` builds it.
 *
 * The file, for each program: the length of the profile's text and the text, or 0 if it is the one before; the number of
 * blocks, and the blocks; the digest. Lengths, numbers and the digest are 64 bits, as the machine has them. */

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "radcomp.h"

typedef int32_t device(const char *, const radcomp_block *, size_t, radcomp_step *, size_t, size_t *, radcomp_alarm *);

static void check(int well, const char *what)
{
    if (!well) {
        fprintf(stderr, "recorder: %s\n", what);
        exit(2);
    }
}

static uint64_t digest(uint64_t digest, const void *bytes, size_t size)
{
    for (size_t at = 0; at < size; at += sizeof(uint64_t)) {
        uint64_t word;
        memcpy(&word, (const char *)bytes + at, sizeof word);
        digest = (digest ^ word) * 0x9e3779b97f4a7c15u;
        digest ^= digest >> 32;
    }
    return digest;
}

static void put(FILE *file, uint64_t number)
{
    check(fwrite(&number, sizeof number, 1, file) == 1, "the record cannot be written");
}

int32_t radcomp_device(const char *profile, const radcomp_block *blocks, size_t block_count, radcomp_step *steps,
                       size_t capacity, size_t *count, radcomp_alarm *alarm)
{
    static device *answer;
    static FILE *file;
    static char *before;
    if (!answer) {
        const char *library = getenv("RADCOMP_RECORDED"), *place = getenv("RADCOMP_RECORDING");
        check(library && place, "RADCOMP_RECORDED and RADCOMP_RECORDING name library and file");
        void *loaded = dlopen(library, RTLD_NOW | RTLD_LOCAL);
        check(loaded != NULL, "the library cannot be loaded");
        answer = (device *)dlsym(loaded, "radcomp_device");
        check(answer != NULL, "the library has no radcomp_device");
        char name[4096];
        snprintf(name, sizeof name, "%s.%ld", place, (long)getpid());
        file = fopen(name, "wb");
        check(file != NULL, "the record cannot be opened");
    }
    if (before && strcmp(before, profile) == 0) {
        put(file, 0);
    } else {
        free(before);
        before = strdup(profile);
        check(before != NULL, "no memory");
        put(file, strlen(profile));
        fputs(profile, file);
    }
    int32_t status = answer(profile, blocks, block_count, steps, capacity, count, alarm);
    check(status == RADCOMP_OK, "the library does not answer");
    put(file, block_count);
    check(fwrite(blocks, sizeof *blocks, block_count, file) == block_count, "the record cannot be written");
    put(file, digest(digest(0, steps, *count * sizeof *steps), alarm, sizeof *alarm));
    check(fflush(file) == 0, "the record cannot be written");
    return status;
}
