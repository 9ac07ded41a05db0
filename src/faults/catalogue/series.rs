//! Terms of the perturbation series that are lost (Eqs 31, 57, 60, 62 and 65).

use super::{Fault, SERIES, amount, within};
use crate::faults::{plant::Plant::Series, recursion::Lost};

const SHARE: &str = "share of the term that is lost";

fn none() -> Lost {
    Lost::default()
}

pub(super) fn all() -> Vec<Fault> {
    let all = vec![
        amount(
            "Eq. 31: T_0;1 is off",
            "the first flight of the series, T_0;1, had a wrong factor (Eq. 31)",
            SHARE,
            0.5,
            Series(|s| Lost { first: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 2 Phi(2) T_;1",
            "the velocities of the series lacked the term 2 Phi(2) T_;1 (Eq. 57)",
            SHARE,
            1.0,
            Series(|s| Lost { bend: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 3 Phi(3) T_;1^2",
            "the velocities of the series lacked the term 3 Phi(3) T_;1^2 (Eq. 57)",
            SHARE,
            1.0,
            Series(|s| Lost { jerk: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 4 Phi(4) T_;1^3",
            "the velocities of the series lacked the term 4 Phi(4) T_;1^3 (Eq. 57)",
            SHARE,
            1.0,
            Series(|s| Lost { snap: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks Phi(1)_n-1;3",
            "the velocities of the series lacked the velocity before, Phi(1)_n-1;3 (Eq. 57)",
            SHARE,
            1.0,
            Series(|s| Lost { speed: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 2 Phi(2) T_;3",
            "the velocities of the series lacked the term of the odd flights, 2 Phi(2) T_;3 (Eq. 57)",
            SHARE,
            1.0,
            Series(|s| Lost { pull: s, ..none() }),
        ),
        amount(
            "Eq. 57: eta is missing",
            "the recursion of the series lacked eta (Eq. 57)",
            "share missing of its exponent",
            0.999,
            Series(|s| Lost { restitution: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(2)_;0 lacks the forcing",
            "the pull at the base, Phi(2)_;0, were that of gravity alone in the series (Eq. 60)",
            SHARE,
            1.0,
            Series(|s| Lost { pull_forcing: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(2)_;2 lacks the square",
            "Phi(2)_;2 of the series lacked the square of omega sigma (Eq. 60)",
            SHARE,
            1.0,
            Series(|s| Lost { bend_square: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(3)_;1 lacks the phase",
            "Phi(3)_;1 of the series lacked omega sigma (Eq. 60)",
            SHARE,
            1.0,
            Series(|s| Lost { jerk_phase: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(4)_;0 lacks i",
            "Phi(4)_;0 of the series lacked the side that the block rocks on, i_n (Eq. 60)",
            SHARE,
            1.0,
            Series(|s| Lost { snap_side: s, ..none() }),
        ),
        amount(
            "Eq. 62 lacks its cube",
            "the even flights of the series followed from a quadratic, the cube of Eq. 62 being left out",
            SHARE,
            1.0,
            Series(|s| Lost { cubic: s, ..none() }),
        ),
        amount(
            "Eq. 65 lacks the odd flights",
            "the chattering time of the series lacked the odd flights (Eq. 65)",
            SHARE,
            1.0,
            Series(|s| Lost { odd: s, ..none() }),
        ),
    ];
    all.into_iter().map(|fault| within(SERIES, fault)).collect()
}
