//! Terms of Eqs 4, 8, 10, 12 and 13 that are lost or wrong, and mistakes in following a flight.

use super::{Fault, amount, whole};
use crate::faults::{
    plant::Plant::Stepper,
    stepper::{Terms, Wrong},
};

const SHARE: &str = "share of the term that is lost";

/// Nothing wrong.
fn honest() -> Wrong {
    Wrong::default()
}

fn of_a(a: Terms) -> Wrong {
    Wrong { a, ..honest() }
}

fn of_b(b: Terms) -> Wrong {
    Wrong { b, ..honest() }
}

pub(super) fn all() -> Vec<Fault> {
    [terms(), forcing(), flights()].concat()
}

fn terms() -> Vec<Fault> {
    vec![
        amount(
            "Eq. 10: A_n lacks Xi",
            "A_n, which multiplies exp(-tau), lacked the forcing at the impact, Xi (Eq. 10)",
            SHARE,
            1.0,
            Stepper(|s| of_a(Terms { forcing: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: A_n lacks Xi'",
            "A_n, which multiplies exp(-tau), lacked the rate of the forcing at the impact, Xi' (Eq. 10)",
            SHARE,
            1.0,
            Stepper(|s| of_a(Terms { rate: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: A_n lacks i",
            "A_n, which multiplies exp(-tau), lacked the side that the block rocks on, i_n (Eq. 10)",
            SHARE,
            1.0,
            Stepper(|s| of_a(Terms { side: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: B_n lacks Xi",
            "B_n, which multiplies exp(tau), lacked the forcing at the impact, Xi (Eq. 10)",
            SHARE,
            1.0,
            Stepper(|s| of_b(Terms { forcing: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: B_n lacks Xi'",
            "B_n, which multiplies exp(tau), lacked the rate of the forcing at the impact, Xi' (Eq. 10)",
            SHARE,
            1.0,
            Stepper(|s| of_b(Terms { rate: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: B_n lacks i",
            "B_n, which multiplies exp(tau), lacked the side that the block rocks on, i_n (Eq. 10)",
            SHARE,
            1.0,
            Stepper(|s| of_b(Terms { side: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: Xi' with the wrong sign",
            "A_n and B_n both took the rate of the forcing, Xi', with the wrong sign (Eq. 10)",
            "twice this is the share lost",
            1.0,
            Stepper(|s| {
                let terms = Terms { rate: 2.0 * s, ..Terms::default() };
                Wrong { a: terms, b: terms, ..honest() }
            }),
        ),
        amount(
            "Eq. 4: phi is left out",
            "gravity did not change with the rotation, phi being left out of Eq. 4",
            SHARE,
            1.0,
            Stepper(|s| Wrong { stiffness: s, ..honest() }),
        ),
        amount(
            "Eq. 4: gravity as a spring",
            "gravity pulled the block back like a spring, phi having the wrong sign in Eq. 4",
            SHARE,
            2.0,
            Stepper(|s| Wrong { stiffness: s, ..honest() }),
        ),
        amount(
            "Eq. 4: gravity is off",
            "gravity changed with the rotation a little too much or too little, g, R or the moment of inertia behind p being off",
            SHARE,
            1e-3,
            Stepper(|s| Wrong { stiffness: s, ..honest() }),
        ),
    ]
}

fn forcing() -> Vec<Fault> {
    vec![
        amount(
            "Eq. 8: no particular solution",
            "the shaking were left out of the flights, with no particular solution (Eq. 8)",
            SHARE,
            1.0,
            Stepper(|s| Wrong { forcing: s, ..honest() }),
        ),
        amount(
            "Eq. 8: forcing with the wrong sign",
            "the ground moved the other way",
            SHARE,
            2.0,
            Stepper(|s| Wrong { forcing: s, ..honest() }),
        ),
        amount(
            "Eq. 8: omega^2 - 1",
            "the particular solution were divided by omega^2 - 1, as for an oscillator, in place of omega^2 + 1 (Eq. 8)",
            "half of what is subtracted",
            1.0,
            Stepper(|s| Wrong { denominator: s, ..honest() }),
        ),
        amount(
            "Eq. 67: constant forcing",
            "the acceleration of the ground stayed constant during each flight (Eq. 67)",
            "share of its change that is lost",
            1.0,
            Stepper(|s| Wrong { change: s, ..honest() }),
        ),
        amount(
            "Eq. 12: phase to first order",
            "the phase at which rocking starts were known to first order only, a cos(psi) = sqrt(2 epsilon) (Eq. 12)",
            "share of epsilon^2 that is lost",
            1.0,
            Stepper(|s| Wrong { square: s, ..honest() }),
        ),
        amount(
            "Eq. 12: other quadrant",
            "rocking started where the shaking falls through the threshold, in the other quadrant of psi (Eq. 12)",
            "half the share of a cos psi that is lost",
            1.0,
            Stepper(|s| Wrong { quadrant: s, ..honest() }),
        ),
        amount(
            "time origin",
            "the shaking started a step of its record later than the clock",
            "delay in tau",
            1e-3,
            Stepper(|s| Wrong { origin: -s, ..honest() }),
        ),
        amount(
            "stale phase",
            "each flight took the shaking of one impact earlier",
            "share of the last interval",
            1.0,
            Stepper(|s| Wrong { stale: s, ..honest() }),
        ),
    ]
}

fn flights() -> Vec<Fault> {
    vec![
        amount(
            "Eq. 68 taken for exact",
            "restitution were applied to the speed with which a flight begins, and not to that of its landing (Eq. 68 taken for exact)",
            "share of the difference",
            1.0,
            Stepper(|s| Wrong { bounce: s, ..honest() }),
        ),
        amount(
            "Eq. 13 at every second impact",
            "restitution were applied at every second impact only",
            "share missing of the exponent",
            0.999,
            Stepper(|s| Wrong { spared: s, ..honest() }),
        ),
        amount(
            "loose root tolerance, absolute",
            "impacts were noticed too late by a fixed time, as by a root finder with an absolute tolerance or at the end of a time step",
            "delay in tau",
            1e-6,
            Stepper(|s| Wrong { late: s, ..honest() }),
        ),
        amount(
            "loose root tolerance, relative",
            "impacts were noticed too late by a share of the flight, as by a root finder with a relative tolerance",
            "share of the flight",
            1e-6,
            Stepper(|s| Wrong { slack: s, ..honest() }),
        ),
        amount(
            "lifted restart",
            "each flight were started a little above the base, to get away from the last event",
            "rotation phi",
            1e-8,
            Stepper(|s| Wrong { lift: s, ..honest() }),
        ),
        amount(
            "sunken restart",
            "each flight were started a little below the base, where the last one was stopped",
            "rotation -phi",
            1e-8,
            Stepper(|s| Wrong { lift: -s, ..honest() }),
        ),
        whole(
            "overturned at phi = 1",
            "the block were given up as overturned at phi = 1, where its weight passes over the corner",
            Stepper(|_| Wrong { brittle: true, ..honest() }),
        ),
    ]
}
