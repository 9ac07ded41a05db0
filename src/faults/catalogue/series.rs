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
            "The first flight has a wrong factor",
            SHARE,
            0.5,
            Series(|s| Lost { first: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 2 Phi(2) T_;1",
            "The bending term of the velocity is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { bend: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 3 Phi(3) T_;1^2",
            "The jerk term of the velocity is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { jerk: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 4 Phi(4) T_;1^3",
            "The snap term of the velocity is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { snap: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks Phi(1)_n-1;3",
            "The velocity before is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { speed: s, ..none() }),
        ),
        amount(
            "Eq. 57 lacks 2 Phi(2) T_;3",
            "The pull of the odd flights is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { pull: s, ..none() }),
        ),
        amount(
            "Eq. 57: eta is missing",
            "Restitution is left out of the recursion",
            "share missing of its exponent",
            0.999,
            Series(|s| Lost { restitution: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(2)_;0 lacks the forcing",
            "The pull at the base is that of gravity alone",
            SHARE,
            1.0,
            Series(|s| Lost { pull_forcing: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(2)_;2 lacks the square",
            "The square of omega sigma in d_n;2 is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { bend_square: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(3)_;1 lacks the phase",
            "omega sigma in c_n;1 is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { jerk_phase: s, ..none() }),
        ),
        amount(
            "Eq. 60: Phi(4)_;0 lacks i",
            "The sign of the rotation is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { snap_side: s, ..none() }),
        ),
        amount(
            "Eq. 62 lacks its cube",
            "The even flights follow from a quadratic",
            SHARE,
            1.0,
            Series(|s| Lost { cubic: s, ..none() }),
        ),
        amount(
            "Eq. 65 lacks the odd flights",
            "The second sum is dropped",
            SHARE,
            1.0,
            Series(|s| Lost { odd: s, ..none() }),
        ),
    ];
    all.into_iter().map(|fault| within(SERIES, fault)).collect()
}
