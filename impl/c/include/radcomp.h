#ifndef RADCOMP_H
#define RADCOMP_H

#include <stddef.h>
#include <stdint.h>

/* The C interface of radcomp: tool-radius compensation in f64, and devices that radcomp judges.
 *
 * Written by cbindgen from impl/c; `BLESS=1 cargo test -p radcomp-c --test header` writes it anew.
 *
 * Lengths are in millimetres, coordinates in the compensation plane: (X, Y) in G17, (Z, X) in G18, (Y, Z) in G19.
 * Blocks are counted from 0, and the tool starts at (0, 0) in cancel mode with radius 0. No function allocates,
 * and none keeps a pointer that it was given but the memory of a state. A null pointer, a short buffer and a value
 * that is none are errors that change nothing.
 */

// All is well.
#define RADCOMP_OK 0

// The program has raised an alarm, which ends it.
#define RADCOMP_ALARM 1

// The device does not take such a program.
#define RADCOMP_UNSUPPORTED 2

// A pointer is null.
#define RADCOMP_NULL -1

// A buffer is too short.
#define RADCOMP_SHORT -2

// The profile names a parameter or a value that there is not, or leaves a parameter out.
#define RADCOMP_PROFILE -3

// A block holds a value that is none.
#define RADCOMP_BLOCK -4

// The memory does not hold a state.
#define RADCOMP_STATE -5

// No movement in the plane.
#define RADCOMP_NONE 0

// A straight move to `end`.
#define RADCOMP_LINE 1

// A circular move to `end`; `centre` is the vector from the start to the centre.
#define RADCOMP_ARC 2

// A circular move to `end`; `centre[0]` is the R word, negative for the arc of more than a half turn.
#define RADCOMP_ARC_RADIUS 3

// A dummy block: `end` is its vector.
#define RADCOMP_DUMMY 4

// G38 with a straight move to `end`: the vector is held.
#define RADCOMP_HELD_VECTOR 5

// G38 with I, J, K: a new vector, at right angles to `end`, which is incremental.
#define RADCOMP_NEW_VECTOR 6

// G39 with a direction: a corner arc to the vector at right angles to `end`, which is incremental.
#define RADCOMP_CORNER_TO_VECTOR 7

// G39 alone: a corner arc to the next element.
#define RADCOMP_CORNER_TO_NEXT 8

// G02.
#define RADCOMP_CLOCKWISE 0

// G03.
#define RADCOMP_COUNTERCLOCKWISE 1

// The block has no such code.
#define RADCOMP_UNCHANGED 0

// Compensation off.
#define RADCOMP_OFF 1

// Compensation on, the tool left of the path.
#define RADCOMP_LEFT 2

// Compensation on, the tool right of the path.
#define RADCOMP_RIGHT 3

// Outer corners by intersection.
#define RADCOMP_INTERSECTION 1

// Outer corners by an arc.
#define RADCOMP_CORNER_ARC 2

// Outer corners by intersection down to the limit angle of the profile, by an arc below it.
#define RADCOMP_LIMIT_ANGLE 3

// NORM: start-up and cancel of type A.
#define RADCOMP_NORM 1

// KONT: start-up and cancel of type B.
#define RADCOMP_KONT 2

// How long a name may be, with the zero at its end.
#define RADCOMP_NAME 48

// As many bytes as the memory of a state has to have, at any address.
#define RADCOMP_STATE_SIZE 4096

// The most elements that one call of `radcomp_push` or `radcomp_finish` gives.
#define RADCOMP_MOST_STEPS 128

// The compensation of one program. It lies in the memory that `radcomp_new` was given, and needs no end.
typedef struct radcomp_state radcomp_state;

// One block of a program, modal codes, units and diameters resolved.
typedef struct {
  // RADCOMP_NONE, RADCOMP_LINE, RADCOMP_ARC, RADCOMP_ARC_RADIUS, RADCOMP_DUMMY, RADCOMP_HELD_VECTOR,
  // RADCOMP_NEW_VECTOR, RADCOMP_CORNER_TO_VECTOR or RADCOMP_CORNER_TO_NEXT.
  uint32_t movement;
  // RADCOMP_CLOCKWISE or RADCOMP_COUNTERCLOCKWISE, of an arc.
  uint32_t direction;
  // Not 0: at rapid traverse.
  uint32_t rapid;
  // RADCOMP_UNCHANGED, RADCOMP_OFF, RADCOMP_LEFT or RADCOMP_RIGHT.
  uint32_t compensation;
  // RADCOMP_UNCHANGED, RADCOMP_INTERSECTION, RADCOMP_CORNER_ARC or RADCOMP_LIMIT_ANGLE.
  uint32_t corner;
  // RADCOMP_UNCHANGED, RADCOMP_NORM or RADCOMP_KONT.
  uint32_t approach;
  // Not 0: a code that loses the look-ahead.
  uint32_t stops_look_ahead;
  // Not 0: the block puts `radius` in force.
  uint32_t has_radius;
  // The tool radius.
  double radius;
  // The end point, absolute.
  double end[2];
  // The centre of an arc.
  double centre[2];
  // Not 0: I, J, K stand beside the compensation code, and `vector` is theirs.
  uint32_t has_vector;
  // The incremental vector beside the compensation code.
  double vector[2];
  // The alarm of a code that is not for offset mode, such as "tool-change-in-mode", with a zero at its end; empty for
  // none.
  char not_in_mode[RADCOMP_NAME];
} radcomp_block;

// One element of the path of the tool's centre, from where the one before ended.
typedef struct {
  // The block that the element belongs to.
  uint64_t block;
  // RADCOMP_LINE, RADCOMP_ARC, or RADCOMP_NONE: a block without movement is executed here.
  uint32_t shape;
  // RADCOMP_CLOCKWISE or RADCOMP_COUNTERCLOCKWISE, of an arc.
  uint32_t direction;
  // Not 0: the arc is a whole turn.
  uint32_t full;
  // Not 0: at rapid traverse.
  uint32_t rapid;
  // The end point.
  double end[2];
  // The centre of an arc, absolute.
  double centre[2];
} radcomp_step;

// An alarm, or none.
typedef struct {
  // The block that it is raised at.
  uint64_t block;
  // Its name in the specification, such as "radius-too-small", with a zero at its end; empty for no alarm.
  char name[RADCOMP_NAME];
} radcomp_alarm;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Begins a program in `memory` of at least RADCOMP_STATE_SIZE bytes. `profile` is text with a zero at its end: a line
// `name = value` for each parameter of the compensation, by the names of spec/PARAMETERS.md. The state, which is to be
// given to the other functions, is stored in `state`; the memory is to stay where it is until the program has ended.
//
// Returns RADCOMP_OK, RADCOMP_NULL, RADCOMP_SHORT or RADCOMP_PROFILE.
//
// # Safety
//
// `memory` is valid for `size` bytes, `profile` ends with a zero, and `state` can be written to.
int32_t radcomp_new(uint8_t *memory,
                    size_t size,
                    const char *profile,
                    radcomp_state **state);

// Reads the next block. The elements of the path that this settles are written to `steps`, which has room for at least
// RADCOMP_MOST_STEPS of them, and their number to `count`. After an alarm, which is written to `alarm`, every call
// returns the same alarm and gives no elements.
//
// Returns RADCOMP_OK, RADCOMP_ALARM, RADCOMP_NULL, RADCOMP_SHORT, RADCOMP_BLOCK or RADCOMP_STATE.
//
// # Safety
//
// `state` is of `radcomp_new` and used by no other thread, `block` can be read, `steps` is valid for `capacity`
// elements, `count` and `alarm` can be written to.
int32_t radcomp_push(radcomp_state *state,
                     const radcomp_block *block,
                     radcomp_step *steps,
                     size_t capacity,
                     size_t *count,
                     radcomp_alarm *alarm);

// Ends the program. As `radcomp_push`, without a block.
//
// # Safety
//
// As of `radcomp_push`.
int32_t radcomp_finish(radcomp_state *state,
                       radcomp_step *steps,
                       size_t capacity,
                       size_t *count,
                       radcomp_alarm *alarm);

// The path of the tool's centre for a whole program. A device that radcomp judges as `lib:FILE` is a shared library that
// exports this function: it writes at most `capacity` elements to `steps` and their number to `count`, and to `alarm`
// the alarm that has ended the program, or an empty name. `profile` is as in `radcomp_new`.
//
// Returns RADCOMP_OK (with or without an alarm), RADCOMP_UNSUPPORTED, RADCOMP_SHORT if there are more elements, or another
// error.
//
// # Safety
//
// `profile` ends with a zero, `blocks` is valid for `block_count` blocks, `steps` for `capacity` elements, `count` and
// `alarm` can be written to.
int32_t radcomp_device(const char *profile,
                       const radcomp_block *blocks,
                       size_t block_count,
                       radcomp_step *steps,
                       size_t capacity,
                       size_t *count,
                       radcomp_alarm *alarm);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* RADCOMP_H */
