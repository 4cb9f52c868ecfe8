//! What C hands over wrong is an error, and changes nothing.
#![expect(unsafe_code, reason = "the C boundary")]

use std::ffi::CString;
use std::ptr::{null, null_mut};

use radcomp_c::*;

const PROFILE: &str = "start-up = type-a\nstart-up-lost = normal\ncancel = type-a\nouter-corner = intersection\n\
    reversal = outer\nside-change = intersection-within\nside-change-after-start-up = alarm\nnon-moving-allowed = 2\n\
    corner-owner = next\nreversed-path = advisory\narc-end-tolerance = 0.01\nfar-intersection = 5\n\
    start-up-b = via-normal\nstart-up-without-movement = none\nstart-up-arc = alarm\ncancel-without-movement = none\n\
    corner-limit-cosine = 0\narc-extension = tangent\nsmallest-corner-cosine = 0\nstraight-band-cosine = 0\n\
    arc-on-rapid = arc\nsmall-vector-limit = 0\nsame-code = ordinary\nnegative-radius = alarm\nequal-radius = alarm\n\
    zero-length-move = no-movement\npending-at-alarm = ended\n\
    side-code-vector = refused\ncancel-vector = refused\noffset-change = alarm\n\
    chord-tolerance = 0\ncentre-tolerance = 0\ninterference = off\ninterference-blocks = 3\ninterference-boundary = strict\n";

fn new(memory: &mut [u8], profile: &str) -> (i32, *mut radcomp_state) {
    let text = CString::new(profile).unwrap();
    let mut state = null_mut();
    // SAFETY: the memory and the text are valid for this call; the state is only used while the memory lives.
    let status = unsafe { radcomp_new(memory.as_mut_ptr(), memory.len(), text.as_ptr(), &mut state) };
    (status, state)
}

#[test]
fn memory_may_lie_anywhere_but_has_to_be_long_enough() {
    let mut memory = [0; RADCOMP_STATE_SIZE + 16];
    for offset in 0..16 {
        assert_eq!(new(&mut memory[offset..offset + RADCOMP_STATE_SIZE], PROFILE).0, RADCOMP_OK);
    }
    assert_eq!(new(&mut memory[..64], PROFILE).0, RADCOMP_SHORT);
    assert_eq!(new(&mut memory[..0], PROFILE).0, RADCOMP_SHORT);
}

#[test]
fn a_profile_names_every_parameter_once() {
    let mut memory = [0; RADCOMP_STATE_SIZE];
    for wrong in [
        String::new(),
        PROFILE.replace("cancel = type-a\n", ""),
        PROFILE.replace("cancel = type-a\n", "cancel = type-z\n"),
        PROFILE.replace("cancel = type-a\n", "cancel\n"),
        PROFILE.replace("cancel = type-a\n", "reversal = outer\n"),
        PROFILE.replace("= 2\n", "= 200\n"),
        PROFILE.replace("= 0.01\n", "= -0.01\n"),
        format!("{PROFILE}colour = red\n"),
        format!("{PROFILE}cancel = type-a\n"),
    ] {
        assert_eq!(new(&mut memory, &wrong), (RADCOMP_PROFILE, null_mut()), "{wrong}");
    }
}

#[test]
fn null_pointers_short_buffers_and_values_that_are_none() {
    let mut memory = [0; RADCOMP_STATE_SIZE];
    let text = CString::new(PROFILE).unwrap();
    let mut state = null_mut();
    let line = radcomp_block { movement: RADCOMP_LINE, end: [1.0, 2.0], ..radcomp_block::default() };
    let mut steps = [radcomp_step::default(); RADCOMP_MOST_STEPS];
    let (mut count, mut alarm) = (7, radcomp_alarm::default());
    let (room, short) = (steps.len(), steps.len() - 1);
    // SAFETY: every pointer that is not null is valid for its length.
    unsafe {
        assert_eq!(radcomp_new(null_mut(), 0, text.as_ptr(), &mut state), RADCOMP_NULL);
        assert_eq!(radcomp_new(memory.as_mut_ptr(), memory.len(), null(), &mut state), RADCOMP_NULL);
        assert_eq!(radcomp_new(memory.as_mut_ptr(), memory.len(), text.as_ptr(), null_mut()), RADCOMP_NULL);
        assert_eq!(radcomp_new(memory.as_mut_ptr(), memory.len(), text.as_ptr(), &mut state), RADCOMP_OK);
        let to = steps.as_mut_ptr();
        assert_eq!(radcomp_push(null_mut(), &line, to, room, &mut count, &mut alarm), RADCOMP_NULL);
        assert_eq!(radcomp_push(state, null(), to, room, &mut count, &mut alarm), RADCOMP_NULL);
        assert_eq!(radcomp_push(state, &line, null_mut(), room, &mut count, &mut alarm), RADCOMP_NULL);
        assert_eq!(radcomp_push(state, &line, to, room, null_mut(), &mut alarm), RADCOMP_NULL);
        assert_eq!(radcomp_push(state, &line, to, room, &mut count, null_mut()), RADCOMP_NULL);
        assert_eq!(radcomp_push(state, &line, to, short, &mut count, &mut alarm), RADCOMP_SHORT);
        for wrong in [
            radcomp_block { movement: 9, ..line },
            radcomp_block { direction: 2, ..line },
            radcomp_block { compensation: 4, ..line },
            radcomp_block { corner: 4, ..line },
            radcomp_block { approach: 3, ..line },
        ] {
            assert_eq!(radcomp_push(state, &wrong, to, room, &mut count, &mut alarm), RADCOMP_BLOCK);
        }
        // None of these calls has read a block.
        assert_eq!((count, radcomp_push(state, &line, to, room, &mut count, &mut alarm)), (7, RADCOMP_OK));
        assert_eq!(radcomp_finish(state, to, room, &mut count, &mut alarm), RADCOMP_OK);
        let mut zeros = [0_u64; RADCOMP_STATE_SIZE / 8];
        let none = zeros.as_mut_ptr().cast::<radcomp_state>();
        assert_eq!(radcomp_push(none, &line, to, room, &mut count, &mut alarm), RADCOMP_STATE);
        assert_eq!(radcomp_device(text.as_ptr(), &line, 1, to, 0, &mut count, &mut alarm), RADCOMP_SHORT);
        assert_eq!(radcomp_device(null(), &line, 1, to, room, &mut count, &mut alarm), RADCOMP_NULL);
    }
}

#[test]
fn an_alarm_has_its_name_and_stays() {
    let mut memory = [0; RADCOMP_STATE_SIZE];
    let (_, state) = new(&mut memory, PROFILE);
    let far = radcomp_block { movement: RADCOMP_LINE, end: [f64::NAN, 0.0], ..radcomp_block::default() };
    let mut steps = [radcomp_step::default(); RADCOMP_MOST_STEPS];
    let (mut count, mut alarm) = (7, radcomp_alarm::default());
    for _ in 0..2 {
        // SAFETY: the state's memory lives, and every pointer is valid for its length.
        let status = unsafe { radcomp_push(state, &far, steps.as_mut_ptr(), steps.len(), &mut count, &mut alarm) };
        assert_eq!((status, count), (RADCOMP_ALARM, 0));
        let alarm = alarm.alarm().unwrap().unwrap();
        assert_eq!((alarm.block, alarm.kind.id()), (0, "out-of-range"));
    }
}

#[test]
fn every_alarm_of_the_specification_has_room_for_its_name() {
    for kind in radcomp_spec::AlarmKind::ALL {
        let alarm = radcomp_spec::Alarm { block: 3, kind: *kind };
        assert_eq!(radcomp_alarm::from(alarm).alarm(), Ok(Some(alarm)));
    }
}
