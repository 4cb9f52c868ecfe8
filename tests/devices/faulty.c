/* Libraries with planted faults: radcomp's own compensation, spoilt. Built once for each fault:
 *
 *   cc -shared -fPIC -DFAULT=WRONG_SIDE ... faulty.c libradcomp_c.a
 */

#define _GNU_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The library's own function, which radcomp's static library exports too, goes by another name. */
#define radcomp_device radcomp_device_of_the_header
#include "radcomp.h"
#undef radcomp_device

enum {
    SOUND, WRONG_SIDE, MITRE_WITHOUT_LIMIT, NEGATIVE_RADIUS, LOST_ON_Z_ONLY, SHORT_LOOK_AHEAD, DRIFT, NOT_A_NUMBER,
    HANG, CRASH, OTHER_BLOCK, LYING_COUNT, NO_COUNT, CHATTER
};

enum { MOST = 4096 };

/* Whether a program is one of those that the fault shows in, by the ends of its moves: not by the bytes between the
   fields of a block, which may be any. */
static int one_in(const radcomp_block *blocks, size_t count, unsigned long many) {
    unsigned long long hash = 14695981039346656037u;
    for (size_t index = 0; index < count; ++index) {
        const unsigned char *bytes = (const unsigned char *)blocks[index].end;
        for (size_t byte = 0; byte < sizeof blocks[index].end; ++byte) {
            hash = (hash ^ bytes[byte]) * 1099511628211u;
        }
    }
    return (hash >> 32) % many == 0;
}

/* Where the line through p and q meets the line through r and s; 0 if it does not. */
static int meet(const double *p, const double *q, const double *r, const double *s, double *point) {
    double u[2] = {q[0] - p[0], q[1] - p[1]}, v[2] = {s[0] - r[0], s[1] - r[1]};
    double cross = u[0] * v[1] - u[1] * v[0];
    if (fabs(cross) < 1e-9) {
        return 0;
    }
    double t = ((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0]) / cross;
    point[0] = p[0] + t * u[0], point[1] = p[1] + t * u[1];
    return 1;
}

/* An acute outer corner, four lines of which the third is the flat, comes to a point. */
static size_t mitre(radcomp_step *steps, size_t count) {
    for (size_t index = 2; index + 1 < count; ++index) {
        int lines = 1;
        for (size_t near = index - 2; near <= index + 1; ++near) {
            lines &= steps[near].shape == RADCOMP_LINE;
        }
        double tip[2];
        const double *before = steps[index - 2].end, *a = steps[index - 1].end, *b = steps[index].end;
        const double *after = steps[index + 1].end;
        double along = (a[0] - before[0]) * (after[0] - b[0]) + (a[1] - before[1]) * (after[1] - b[1]);
        if (lines && along < 0 && steps[index].block == steps[index + 1].block && meet(before, a, b, after, tip)) {
            memcpy(steps[index - 1].end, tip, sizeof tip);
            memcpy(steps[index].end, tip, sizeof tip);
        }
    }
    return count;
}

static void shorten(char *profile) {
    char *allowed = strstr(profile, "non-moving-allowed = ");
    if (allowed) {
        allowed[strlen("non-moving-allowed = ")] -= 1;
    }
}

/* The compensation of radcomp, over the whole program. */
static int32_t sound(const char *profile, const radcomp_block *blocks, size_t block_count, radcomp_step *steps,
                     size_t capacity, size_t *count, radcomp_alarm *alarm) {
    static unsigned char memory[RADCOMP_STATE_SIZE];
    radcomp_state *state;
    int32_t status = radcomp_new(memory, sizeof memory, profile, &state);
    *count = 0;
    for (size_t index = 0; status == RADCOMP_OK && index <= block_count; ++index) {
        static radcomp_step room[RADCOMP_MOST_STEPS];
        size_t more = 0;
        status = index < block_count ? radcomp_push(state, &blocks[index], room, RADCOMP_MOST_STEPS, &more, alarm)
                                     : radcomp_finish(state, room, RADCOMP_MOST_STEPS, &more, alarm);
        if (more > capacity - *count)
            return RADCOMP_SHORT;
        memcpy(steps + *count, room, more * sizeof *room);
        *count += more;
    }
    return status == RADCOMP_ALARM ? RADCOMP_OK : status;
}

int32_t device(const char *given, const radcomp_block *told, size_t block_count, radcomp_step *steps, size_t capacity,
               size_t *count, radcomp_alarm *alarm) {
    static radcomp_block blocks[MOST * 2];
    static char profile[4096];
    if (block_count > MOST * 2 || strlen(given) >= sizeof profile) {
        return RADCOMP_UNSUPPORTED;
    }
    memcpy(blocks, told, block_count * sizeof *blocks);
    strcpy(profile, given);
    int on = 0;
    for (size_t index = 0; index < block_count; ++index) {
        radcomp_block *block = &blocks[index];
        uint32_t code = block->compensation;
        on = code == RADCOMP_UNCHANGED ? on : code != RADCOMP_OFF;
        if (FAULT == WRONG_SIDE && (code == RADCOMP_LEFT || code == RADCOMP_RIGHT)) {
            block->compensation = code == RADCOMP_LEFT ? RADCOMP_RIGHT : RADCOMP_LEFT;
        }
        if (FAULT == LOST_ON_Z_ONLY && on && block->movement == RADCOMP_NONE) {
            block->compensation = RADCOMP_OFF;
        }
    }
    if (FAULT == SHORT_LOOK_AHEAD) {
        shorten(profile);
    }
    int32_t status = sound(profile, blocks, block_count, steps, capacity, count, alarm);
    if (status != RADCOMP_OK) {
        return status;
    }
    if (FAULT == MITRE_WITHOUT_LIMIT) {
        *count = mitre(steps, *count);
    }
    if (FAULT == NEGATIVE_RADIUS && strcmp(alarm->name, "radius-too-small") == 0) {
        const radcomp_block *arc = &blocks[alarm->block];
        radcomp_step step = {.block = alarm->block, .shape = RADCOMP_ARC, .direction = !arc->direction};
        memcpy(step.end, arc->end, sizeof step.end);
        memcpy(step.centre, arc->end, sizeof step.centre);
        steps[(*count)++] = step;
        memset(alarm, 0, sizeof *alarm);
    }
    if (FAULT == DRIFT) {
        for (size_t index = 0; index < *count; ++index) {
            steps[index].end[0] += 1e-6 * (double)index;
        }
    }
    if (FAULT == NOT_A_NUMBER && *count > 0 && one_in(told, block_count, 30)) {
        steps[*count - 1].shape = RADCOMP_LINE;
        steps[*count - 1].end[1] = NAN;
    }
    if (FAULT == HANG && one_in(told, block_count, 150)) {
        sleep(3600);
    }
    if (FAULT == CRASH && one_in(told, block_count, 60)) {
        abort();
    }
    if (FAULT == OTHER_BLOCK && *count > 1) {
        steps[*count - 1].block = steps[0].block;
    }
    if (FAULT == LYING_COUNT && one_in(told, block_count, 30)) {
        *count = capacity + 1;
    }
    if (FAULT == NO_COUNT && one_in(told, block_count, 30)) {
        *count = (size_t)-1;
    }
    if (FAULT == CHATTER && one_in(told, block_count, 60)) {
        puts("compensated");
        fflush(stdout);
    }
    return RADCOMP_OK;
}
