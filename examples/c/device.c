/* A device that radcomp judges, in nothing but C: replace `compensated` by your control.
 *
 *   cc -shared -fPIC -Iimpl/c/include device.c -o device.so      (-I: the folder of radcomp.h)
 *   radcomp ping lib:device.so
 *   radcomp certify lib:device.so --profile NAME
 *
 * As it stands it knows programs without compensation, and says of every other one that it is not supported.
 */

#include "radcomp.h"

/* Your control. `profile` has a line "name = value" for each parameter; an alarm is its name of the specification, copied
 * into alarm->name, and the block in alarm->block. */
static int32_t compensated(const char *profile, const radcomp_block *blocks, size_t block_count, radcomp_step *steps,
                           size_t capacity, size_t *count, radcomp_alarm *alarm) {
    (void)profile, (void)blocks, (void)block_count, (void)steps, (void)capacity, (void)count, (void)alarm;
    return RADCOMP_UNSUPPORTED;
}

/* Without compensation the tool's centre follows the program. */
static int32_t uncompensated(const radcomp_block *blocks, size_t block_count, radcomp_step *steps, size_t capacity,
                             size_t *count) {
    double at[2] = {0, 0};
    if (capacity < block_count) {
        return RADCOMP_SHORT;
    }
    for (size_t index = 0; index < block_count; ++index) {
        const radcomp_block *block = &blocks[index];
        radcomp_step step = {.block = index, .shape = RADCOMP_NONE, .rapid = block->rapid};
        switch (block->movement) {
        case RADCOMP_ARC:
            step.shape = RADCOMP_ARC;
            step.direction = block->direction;
            step.centre[0] = at[0] + block->centre[0];
            step.centre[1] = at[1] + block->centre[1];
            step.full = block->end[0] == at[0] && block->end[1] == at[1];
            break;
        case RADCOMP_LINE:
            step.shape = RADCOMP_LINE;
            break;
        case RADCOMP_NONE:
        case RADCOMP_DUMMY:
            break;
        default:
            return RADCOMP_UNSUPPORTED;
        }
        if (step.shape != RADCOMP_NONE) {
            step.end[0] = at[0] = block->end[0];
            step.end[1] = at[1] = block->end[1];
        }
        steps[(*count)++] = step;
    }
    return RADCOMP_OK;
}

int32_t radcomp_device(const char *profile, const radcomp_block *blocks, size_t block_count, radcomp_step *steps,
                       size_t capacity, size_t *count, radcomp_alarm *alarm) {
    *count = 0;
    *alarm = (radcomp_alarm){0};
    for (size_t index = 0; index < block_count; ++index) {
        uint32_t code = blocks[index].compensation;
        if (code == RADCOMP_LEFT || code == RADCOMP_RIGHT) {
            return compensated(profile, blocks, block_count, steps, capacity, count, alarm);
        }
    }
    return uncompensated(blocks, block_count, steps, capacity, count);
}
