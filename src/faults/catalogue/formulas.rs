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
            "The coefficient A_n loses its forcing",
            SHARE,
            1.0,
            Stepper(|s| of_a(Terms { forcing: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: A_n lacks Xi'",
            "The coefficient A_n loses the rate of its forcing",
            SHARE,
            1.0,
            Stepper(|s| of_a(Terms { rate: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: A_n lacks i",
            "The coefficient A_n loses the sign of the rotation",
            SHARE,
            1.0,
            Stepper(|s| of_a(Terms { side: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: B_n lacks Xi",
            "The coefficient B_n loses its forcing",
            SHARE,
            1.0,
            Stepper(|s| of_b(Terms { forcing: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: B_n lacks Xi'",
            "The coefficient B_n loses the rate of its forcing",
            SHARE,
            1.0,
            Stepper(|s| of_b(Terms { rate: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: B_n lacks i",
            "The coefficient B_n loses the sign of the rotation",
            SHARE,
            1.0,
            Stepper(|s| of_b(Terms { side: s, ..Terms::default() })),
        ),
        amount(
            "Eq. 10: Xi' with the wrong sign",
            "Both coefficients take the rate of the forcing with the other sign",
            "twice this is the share lost",
            1.0,
            Stepper(|s| {
                let terms = Terms { rate: 2.0 * s, ..Terms::default() };
                Wrong { a: terms, b: terms, ..honest() }
            }),
        ),
        amount(
            "Eq. 4: phi is left out",
            "The block falls as if gravity did not change with its rotation",
            SHARE,
            1.0,
            Stepper(|s| Wrong { stiffness: s, ..honest() }),
        ),
        amount(
            "Eq. 4: gravity as a spring",
            "phi comes with the sign of an oscillator",
            SHARE,
            2.0,
            Stepper(|s| Wrong { stiffness: s, ..honest() }),
        ),
        amount(
            "Eq. 4: gravity is off",
            "g, R or the inertia in p is a part in a thousand off",
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
            "The forcing is left out of the motion",
            SHARE,
            1.0,
            Stepper(|s| Wrong { forcing: s, ..honest() }),
        ),
        amount(
            "Eq. 8: forcing with the wrong sign",
            "The ground moves the other way",
            SHARE,
            2.0,
            Stepper(|s| Wrong { forcing: s, ..honest() }),
        ),
        amount(
            "Eq. 8: omega^2 - 1",
            "The denominator omega^2 + 1 is that of an oscillator",
            "half of what is subtracted",
            1.0,
            Stepper(|s| Wrong { denominator: s, ..honest() }),
        ),
        amount(
            "Eq. 67: constant forcing",
            "The forcing is kept constant during a flight",
            "share of its change that is lost",
            1.0,
            Stepper(|s| Wrong { change: s, ..honest() }),
        ),
        amount(
            "Eq. 12: phase to first order",
            "a cos psi is taken as sqrt(2 epsilon)",
            "share of epsilon^2 that is lost",
            1.0,
            Stepper(|s| Wrong { square: s, ..honest() }),
        ),
        amount(
            "Eq. 12: other quadrant",
            "psi is taken where the shaking falls",
            "half the share of a cos psi that is lost",
            1.0,
            Stepper(|s| Wrong { quadrant: s, ..honest() }),
        ),
        amount(
            "time origin",
            "The shaking starts a step of its record later than the clock",
            "delay in tau",
            1e-3,
            Stepper(|s| Wrong { origin: -s, ..honest() }),
        ),
        amount(
            "stale phase",
            "A flight takes the forcing at the previous impact",
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
            "Restitution is applied to the speed of departure, not of landing",
            "share of the difference",
            1.0,
            Stepper(|s| Wrong { bounce: s, ..honest() }),
        ),
        amount(
            "Eq. 13 at every second impact",
            "Restitution is applied once a cycle",
            "share missing of the exponent",
            0.999,
            Stepper(|s| Wrong { spared: s, ..honest() }),
        ),
        amount(
            "loose root tolerance, absolute",
            "Impacts are noticed late by a fixed tolerance",
            "delay in tau",
            1e-6,
            Stepper(|s| Wrong { late: s, ..honest() }),
        ),
        amount(
            "loose root tolerance, relative",
            "Impacts are noticed late by a share of the flight",
            "share of the flight",
            1e-6,
            Stepper(|s| Wrong { slack: s, ..honest() }),
        ),
        amount(
            "lifted restart",
            "Each flight starts a little above the base, to get away from the event",
            "rotation phi",
            1e-8,
            Stepper(|s| Wrong { lift: s, ..honest() }),
        ),
        amount(
            "sunken restart",
            "Each flight starts a little below the base, where its predecessor ended",
            "rotation -phi",
            1e-8,
            Stepper(|s| Wrong { lift: -s, ..honest() }),
        ),
        whole(
            "overturned at phi = 1",
            "The block is given up where its weight passes over the corner",
            Stepper(|_| Wrong { brittle: true, ..honest() }),
        ),
    ]
}
