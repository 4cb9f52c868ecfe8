/* A control's firmware compensates a program with radcomp-impl: block by block, in fixed memory, without a heap.
 *
 *   cargo build -p radcomp-c --profile firmware --features firmware
 *   cc -Iimpl/c/include examples/c/firmware.c target/firmware/libradcomp_c.a -o firmware
 */

#include <stdio.h>

#include "radcomp.h"

/* The control: every parameter of its profile, by the names of spec/PARAMETERS.md. */
static const char PROFILE[] =
    "start-up = type-a\n"
    "start-up-lost = normal\n"
    "cancel = type-a\n"
    "outer-corner = intersection\n"
    "reversal = outer\n"
    "side-change = intersection-within\n"
    "side-change-after-start-up = alarm\n"
    "non-moving-allowed = 2\n"
    "corner-owner = next\n"
    "reversed-path = advisory\n"
    "arc-end-tolerance = 0.01\n"
    "far-intersection = 5\n"
    "start-up-b = via-normal\n"
    "start-up-without-movement = none\n"
    "start-up-arc = alarm\n"
    "cancel-without-movement = none\n"
    "corner-limit-cosine = 0\n"
    "arc-extension = tangent\n"
    "smallest-corner-cosine = 0\n"
    "straight-band-cosine = 0\n"
    "arc-on-rapid = arc\n"
    "small-vector-limit = 0\n"
    "same-code = ordinary\n"
    "negative-radius = alarm\n"
    "equal-radius = alarm\n"
    "zero-length-move = no-movement\n"
    "pending-at-alarm = ended\n"
    "side-code-vector = refused\n"
    "cancel-vector = refused\n"
    "offset-change = alarm\n"
    "chord-tolerance = 0\n"
    "centre-tolerance = 0\n"
    "interference = off\n"
    "interference-blocks = 3\n"
    "interference-boundary = strict\n";

/* A tool of radius 5 mm runs left of a contour with an inner and an outer corner and an arc. */
static const radcomp_block PROGRAM[] = {
    {.movement = RADCOMP_LINE, .compensation = RADCOMP_LEFT, .has_radius = 1, .radius = 5, .end = {20, 0}},
    {.movement = RADCOMP_LINE, .end = {60, 0}},
    {.movement = RADCOMP_LINE, .end = {60, 30}},
    {.movement = RADCOMP_NONE},
    {.movement = RADCOMP_LINE, .end = {90, 30}},
    {.movement = RADCOMP_ARC, .direction = RADCOMP_CLOCKWISE, .end = {100, 20}, .centre = {0, -10}},
    {.movement = RADCOMP_LINE, .end = {100, 0}},
    {.movement = RADCOMP_LINE, .compensation = RADCOMP_OFF, .end = {120, 0}},
};
enum { BLOCKS = sizeof PROGRAM / sizeof PROGRAM[0] };

/* All the memory that compensation takes. */
static uint8_t memory[RADCOMP_STATE_SIZE];
static radcomp_step steps[RADCOMP_MOST_STEPS];

/* Where a firmware hands the path to its interpolator. */
static void move(const radcomp_step *step) {
    unsigned long block = (unsigned long)step->block;
    switch (step->shape) {
    case RADCOMP_LINE:
        printf("%lu line %.6f %.6f\n", block, step->end[0], step->end[1]);
        break;
    case RADCOMP_ARC:
        printf("%lu %s %.6f %.6f about %.6f %.6f\n", block,
               step->direction == RADCOMP_CLOCKWISE ? "cw" : "ccw", step->end[0], step->end[1], step->centre[0],
               step->centre[1]);
        break;
    default:
        printf("%lu hold\n", block);
    }
}

int main(void) {
    radcomp_state *state;
    int32_t status = radcomp_new(memory, sizeof memory, PROFILE, &state);
    if (status != RADCOMP_OK) {
        fprintf(stderr, "radcomp_new: %d\n", (int)status);
        return 2;
    }
    /* One call more than there are blocks: the last one ends the program. */
    for (size_t index = 0; index <= BLOCKS; ++index) {
        size_t count = 0;
        radcomp_alarm alarm;
        status = index < BLOCKS
                     ? radcomp_push(state, &PROGRAM[index], steps, RADCOMP_MOST_STEPS, &count, &alarm)
                     : radcomp_finish(state, steps, RADCOMP_MOST_STEPS, &count, &alarm);
        for (size_t step = 0; step < count; ++step) {
            move(&steps[step]);
        }
        if (status == RADCOMP_ALARM) {
            printf("alarm %s at block %lu\n", alarm.name, (unsigned long)alarm.block);
            return 1;
        }
        if (status != RADCOMP_OK) {
            fprintf(stderr, "block %zu: %d\n", index, (int)status);
            return 2;
        }
    }
    return 0;
}
