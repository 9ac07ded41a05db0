//! Batches: the same bits on every instruction set with or without a fused multiply-add, in any order and on any number of threads, and the numbers of the
//! oracle that steps through one case with its claims.

use closed_form::{
    ClosedForm,
    batch::{Batch, InstructionSet, Operations, Refusal, Rows, Sequence, Tally},
};
use contract::{Case, Ending, History, Limit, Oracle};
use proptest::prelude::*;

/// `ε`, `ω`, `η`.
type Parameters = [f64; 3];

#[derive(Debug, Clone)]
struct Answer {
    time: Vec<f64>,
    interval: Vec<f64>,
    velocity: Vec<f64>,
    sequences: Vec<Sequence>,
    tally: Tally,
}

impl Answer {
    /// Everything about one case, to the bit.
    fn bits(&self, case: usize) -> (Vec<u64>, Sequence) {
        let impacts = self.time.len() / self.sequences.len();
        let row = case * impacts..(case + 1) * impacts;
        let quantities = [&self.time[row.clone()], &self.interval[row.clone()], &self.velocity[row]];
        (quantities.concat().iter().map(|number| number.to_bits()).collect(), self.sequences[case])
    }
}

fn run(cases: &[Parameters], impacts: usize, set: InstructionSet) -> Answer {
    let column = |of: usize| cases.iter().map(|case| case[of]).collect::<Vec<_>>();
    let (epsilon, omega, eta) = (column(0), column(1), column(2));
    let batch = Batch::new(&epsilon, &omega, &eta, impacts).unwrap().with_instruction_set(set);
    // What was in the rows before must not matter.
    let row = vec![7.0; cases.len() * impacts];
    let mut answer = Answer {
        time: row.clone(),
        interval: row.clone(),
        velocity: row,
        sequences: vec![Sequence::default(); cases.len()],
        tally: Tally::default(),
    };
    let Answer { time, interval, velocity, sequences, .. } = &mut answer;
    answer.tally = batch.run(Rows { time, interval, velocity, sequences }).unwrap();
    answer
}

fn oracle([epsilon, omega, eta]: Parameters, impacts: usize) -> History {
    let case = Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(impacts).unwrap();
    ClosedForm.history(&case).unwrap()
}

/// The largest difference to the oracle, as a multiple of what that claims; an error if the sequence is another one.
fn difference(answer: &Answer, cases: &[Parameters]) -> Result<f64, String> {
    let impacts = answer.time.len() / cases.len();
    let mut worst: f64 = 0.0;
    for (index, case) in cases.iter().enumerate() {
        let history = oracle(*case, impacts);
        let Sequence { impacts: count, ending } = answer.sequences[index];
        if (count, ending) != (history.impacts.len(), history.ending) {
            return Err(format!(
                "{case:?}: {count} impacts, {ending}; {} and {}",
                history.impacts.len(),
                history.ending
            ));
        }
        for (n, impact) in history.impacts.iter().enumerate() {
            let at = index * impacts + n;
            let claims = impact.uncertainty;
            for (found, expected, claim) in [
                (answer.time[at], impact.time, claims.time),
                (answer.interval[at], impact.interval, claims.interval * impact.interval),
                (answer.velocity[at], impact.velocity, claims.velocity * impact.velocity.abs()),
            ] {
                // f64::max would pass over what is not a number.
                if !found.is_finite() {
                    return Err(format!("{case:?}: impact {} is not a number", n + 1));
                }
                worst = worst.max((found - expected).abs() / claim);
            }
        }
        for quantity in [&answer.time, &answer.interval, &answer.velocity] {
            if !quantity[index * impacts + count..(index + 1) * impacts].iter().all(|number| number.is_nan()) {
                return Err(format!("{case:?}: something stands behind the last impact"));
            }
        }
    }
    Ok(worst)
}

/// The oracle and the lanes err independently of each other, each by as much as the oracle claims at the most.
const ALLOWED: f64 = 2.0;

/// Cases from far below the critical amplitude to far above it.
fn parameters() -> impl Strategy<Value = Parameters> {
    let omega = (-2.0..2.0f64).prop_map(|power| 10f64.powf(power));
    (-6.0..-0.5f64, omega, 0.02..0.98f64).prop_map(|(power, omega, eta)| [10f64.powf(power), omega, eta])
}

/// Cases of the paper's range.
fn ordinary() -> impl Strategy<Value = Parameters> {
    (0.005..0.035f64, 0.5..8.0f64, 0.80..0.95f64).prop_map(|(epsilon, omega, eta)| [epsilon, omega, eta])
}

/// Without a fused multiply-add, and with it.
const KINDS: [[InstructionSet; 2]; 2] =
    [[InstructionSet::Scalar, InstructionSet::Baseline], [InstructionSet::Avx2, InstructionSet::Avx512]];

/// Those of a kind that this machine has both of. (A set that it lacks is replaced by the next slower one, and would be compared with itself.)
fn comparable() -> Vec<[InstructionSet; 2]> {
    KINDS.into_iter().filter(|kind| kind.iter().all(|set| set.is_available())).collect()
}

#[test]
fn instruction_sets_that_could_not_be_compared_are_named() {
    let compared = comparable();
    for kind in KINDS {
        let verdict = if compared.contains(&kind) { "compared" } else { "NOT compared: this machine lacks one" };
        eprintln!("{kind:?}: {verdict}");
    }
    // Those that every machine has.
    assert!(compared.contains(&KINDS[0]));
    // Unless the machine lacks it, what was asked for is what runs: the two kinds round differently.
    if InstructionSet::Avx2.is_available() {
        let [plain, fused] = [InstructionSet::Baseline, InstructionSet::Avx2].map(|set| run(&many()[..200], 60, set));
        assert!((0..200).any(|case| plain.bits(case) != fused.bits(case)));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_numbers_are_those_of_the_oracle(
        cases in prop::collection::vec(prop_oneof![parameters(), ordinary()], 1..40), impacts in 1..=400usize,
    ) {
        let answer = run(&cases, impacts, InstructionSet::fastest());
        let worst = difference(&answer, &cases).map_err(TestCaseError::fail)?;
        prop_assert!(worst <= ALLOWED, "off by {worst} of what is claimed");
    }

    #[test]
    fn every_instruction_set_of_a_kind_gives_the_same_bits(
        cases in prop::collection::vec(prop_oneof![parameters(), ordinary()], 1..40), impacts in 1..=100usize,
    ) {
        for pair in comparable() {
            let [one, other] = pair.map(|set| run(&cases, impacts, set));
            for (index, case) in cases.iter().enumerate() {
                prop_assert_eq!(one.bits(index), other.bits(index), "{:?} {:?}", pair, case);
            }
            prop_assert_eq!(one.tally, other.tally);
        }
    }

    #[test]
    fn the_numbers_without_a_fused_multiply_add_are_those_of_the_oracle_too(
        cases in prop::collection::vec(prop_oneof![parameters(), ordinary()], 1..40), impacts in 1..=400usize,
    ) {
        let answer = run(&cases, impacts, InstructionSet::Scalar);
        let worst = difference(&answer, &cases).map_err(TestCaseError::fail)?;
        prop_assert!(worst <= ALLOWED, "off by {worst} of what is claimed");
    }

    #[test]
    fn a_case_does_not_depend_on_the_others(
        cases in prop::collection::vec(prop_oneof![parameters(), ordinary()], 2..40), impacts in 1..=100usize, turn in 1..40usize,
    ) {
        let together = run(&cases, impacts, InstructionSet::fastest());
        let mut turned = cases.clone();
        turned.rotate_left(turn % cases.len());
        turned.reverse();
        let elsewhere = run(&turned, impacts, InstructionSet::fastest());
        for (index, case) in cases.iter().enumerate() {
            let place = turned.iter().position(|other| other == case).unwrap();
            prop_assert_eq!(together.bits(index), elsewhere.bits(place));
            prop_assert_eq!(together.bits(index), run(&[*case], impacts, InstructionSet::fastest()).bits(0));
        }
    }
}

/// Many cases, so that there is something to share out.
fn many() -> Vec<Parameters> {
    let spread = |k: usize, by: f64| (by * k as f64).fract();
    let golden = [0.618_033_988_749_895, 0.754_877_666_246_693, 0.569_840_290_998_053];
    (1..=5000)
        .map(|k| {
            let [x, y, z] = golden.map(|by| spread(k, by));
            [0.005 + 0.03 * x, 0.5 + 7.5 * y, 0.80 + 0.15 * z]
        })
        .collect()
}

#[test]
fn the_bits_are_the_same_on_any_number_of_threads() {
    let cases = many();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| run(&cases, 60, InstructionSet::fastest()))
    };
    let one = on(1);
    for threads in [2, 3] {
        let more = on(threads);
        assert_eq!(more.tally, one.tally);
        for (index, case) in cases.iter().enumerate() {
            assert_eq!(more.bits(index), one.bits(index), "{threads} threads, {case:?}");
        }
    }
}

#[test]
fn the_workload_is_that_of_the_oracle_and_hardly_any_flight_is_left_to_the_scalar_code() {
    let cases = many();
    let answer = run(&cases, 60, InstructionSet::fastest());
    let worst = difference(&answer, &cases).unwrap();
    assert!(worst <= 1.0, "{worst}");
    assert!(answer.tally.impacts > 290_000 && answer.tally.alone * 500 < answer.tally.impacts, "{:?}", answer.tally);
}

/// How far two doubles are apart, in units of the last place.
fn ulps(x: f64, y: f64) -> u64 {
    x.to_bits().abs_diff(y.to_bits())
}

/// Where the last digits are not lost to the conditioning of the case, they are those of the oracle.
#[test]
fn most_numbers_are_within_four_units_of_the_last_place() {
    let cases = many();
    let answer = run(&cases, 60, InstructionSet::fastest());
    let (mut times, mut velocities, mut intervals, mut all) = (0, 0, 0, 0u32);
    for (index, case) in cases.iter().enumerate() {
        for (n, impact) in oracle(*case, 60).impacts.iter().enumerate() {
            let at = index * 60 + n;
            times += usize::from(ulps(answer.time[at], impact.time) <= 4);
            velocities += usize::from(ulps(answer.velocity[at], impact.velocity) <= 4);
            intervals += usize::from((answer.interval[at] / impact.interval - 1.0).abs() <= 1e-13);
            all += 1;
        }
    }
    let share = |count: usize| count as f64 / f64::from(all);
    let shares = [share(times), share(velocities), share(intervals)];
    assert!(shares[0] > 0.995 && shares[1] > 0.93 && shares[2] > 0.999_9, "{shares:?}");
    eprintln!("times {:.5}, velocities {:.5}, intervals {:.5}", shares[0], shares[1], shares[2]);
}

/// Operations for one impact, and flights left to the scalar code for a thousand impacts.
fn cost(cases: &[Parameters], impacts: usize) -> [f64; 6] {
    let column = |of: usize| cases.iter().map(|case| case[of]).collect::<Vec<_>>();
    let (operations, tally) = Batch::new(&column(0), &column(1), &column(2), impacts).unwrap().operations();
    let Operations { sums, products, fused, quotients, choices } = operations;
    [sums, products, fused, quotients, choices, 1000 * tally.alone].map(|count| count as f64 / tally.impacts as f64)
}

/// A worse first guess, a margin too narrow or a proof that fails too often change no answer, but what it costs. Where a change is meant to, its new numbers belong here.
#[test]
fn an_impact_costs_what_it_did() {
    let ordinary = many().into_iter().take(500).collect::<Vec<_>>();
    let wide: Vec<_> = many()
        .into_iter()
        .take(500)
        .map(|[epsilon, omega, eta]| [12.0 * (epsilon - 0.004), 2.0 * omega * omega / 8.0, 4.0 * (eta - 0.75) + 0.15])
        .collect();
    for (cases, impacts, recorded) in [
        (ordinary, 60, [44.432, 53.695, 48.871, 2.1736, 25.761, 0.4027]),
        (wide, 30, [56.584, 74.298, 66.926, 2.9168, 34.604, 173.20]),
    ] {
        let now = cost(&cases, impacts);
        let same = now.iter().zip(recorded).all(|(now, recorded)| (now / recorded - 1.0).abs() < 2e-3);
        assert!(same, "{now:.4?} instead of {recorded:?}");
    }
}

/// A fault of 1e-13 in one parameter is seen: what is compared is compared closely enough.
#[test]
fn a_small_fault_is_caught() {
    let cases: Vec<_> = many().into_iter().take(100).collect();
    for parameter in 0..3 {
        let mut faulty = cases.clone();
        faulty.iter_mut().for_each(|case| case[parameter] *= 1.0 + 1e-13);
        let answer = run(&faulty, 60, InstructionSet::fastest());
        let caught = difference(&answer, &cases).map_or(true, |worst| worst > ALLOWED);
        assert!(caught, "parameter {parameter}");
    }
}

/// Near the critical amplitude, on both sides, where flights graze and are left to the scalar code.
#[test]
fn the_critical_amplitude_is_where_the_oracle_has_it() {
    let cases: Vec<_> = (0..200).map(|k| [0.038_015_538 + 1e-7 * (f64::from(k) - 100.0), 2.0, 0.92]).collect();
    let answer = run(&cases, 400, InstructionSet::fastest());
    let worst = difference(&answer, &cases).unwrap();
    assert!(worst <= ALLOWED, "{worst}");
    let endings = |of: Ending| answer.sequences.iter().filter(|sequence| sequence.ending == of).count();
    assert!(endings(Ending::AtRest) > 50 && endings(Ending::Incomplete) > 50 && answer.tally.alone > 50);
}

/// What the lanes make of a flight that they are not made for once made them call it complete: found at `a = 1.316`, `ω = 59.4`, `η = 0.5`. In the others rest is
/// certain from such a flight on, which is also the last one that is asked for.
#[test]
fn what_is_left_to_the_scalar_code_is_complete_only_if_that_says_so() {
    let cases = [
        [0.316_227_766_016_837_94, 59.412_071_460_029_92, 0.5],
        [8.730_401_163_077_697e-2, 12.133_586_794_766_037, 0.077_123_460_056_306_64],
        [9.621_024_946_620_836e-3, 0.247_543_759_867_618_26, 0.046_070_139_101_819_09],
    ];
    for set in InstructionSet::available() {
        for impacts in 1..10 {
            let worst = difference(&run(&cases, impacts, set), &cases).unwrap();
            assert!(worst <= ALLOWED, "{set:?}, {impacts} impacts: {worst}");
        }
    }
}

#[test]
fn every_way_to_end_is_told() {
    let cases =
        [[0.0, 2.0, 0.92], [-0.5, 2.0, 0.92], [0.03, 2.0, 0.92], [0.05, 2.0, 0.92], [0.03, 2.0, 1e-5], [5.0, 0.3, 0.9]];
    let answer = run(&cases, 70, InstructionSet::fastest());
    assert!(difference(&answer, &cases[2..3]).is_err(), "a row of another case");
    for (index, case) in cases.iter().enumerate() {
        let history = oracle(*case, 70);
        let expected = Sequence { impacts: history.impacts.len(), ending: history.ending };
        assert_eq!(answer.sequences[index], expected, "{case:?}");
    }
    let endings: Vec<_> = answer.sequences.iter().map(|sequence| sequence.ending).collect();
    let never = Ending::NeverRocks;
    assert_eq!(endings, [never, never, Ending::AtRest, Ending::Incomplete, Ending::AtRest, endings[5]]);
    // The fifth ends where its speed has left the range of a double.
    assert!(answer.sequences[4].impacts < 70);
    let short = run(&cases[2..3], 3, InstructionSet::fastest());
    assert_eq!(short.sequences, [Sequence { impacts: 3, ending: Ending::LimitReached(Limit::Impacts) }]);
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let refused = |epsilon: &[f64], omega: &[f64], eta: &[f64], impacts| {
        Batch::new(epsilon, omega, eta, impacts).unwrap_err().to_string()
    };
    assert_eq!(refused(&[0.1, 0.1], &[2.0], &[0.9, 0.9], 5), "omega has 1 numbers, not 2");
    assert_eq!(refused(&[0.1], &[2.0], &[], 5), "eta has 0 numbers, not 1");
    let allowed = "is outside the allowed range: from 1 to 1000000 for each case";
    for impacts in [0, 1_000_001, usize::MAX] {
        assert_eq!(refused(&[0.1], &[2.0], &[0.9], impacts), format!("impacts = {impacts} {allowed}"));
        assert_eq!(refused(&[], &[], &[], impacts), format!("impacts = {impacts} {allowed}"));
    }
    assert!(refused(&[0.1, 0.1], &[2.0, 2.0], &[0.9, 1.5], 5).starts_with("case 1: eta = 1.5"));
    assert!(refused(&[f64::NAN], &[2.0], &[0.9], 5).starts_with("case 0: epsilon = NaN"));
    assert!(refused(&[0.1], &[1e9], &[0.9], 5).starts_with("case 0: omega = 1000000000.0"));
    let batch = Batch::new(&[0.1], &[2.0], &[0.9], 5).unwrap();
    let (mut time, mut interval, mut velocity) = ([0.0; 5], [0.0; 5], [0.0; 4]);
    let mut sequences = [Sequence::default()];
    let rows = Rows { time: &mut time, interval: &mut interval, velocity: &mut velocity, sequences: &mut sequences };
    assert_eq!(batch.run(rows), Err(Refusal::Length { what: "velocity", length: 4, expected: 5 }));
    // No cases are no work.
    let none = Batch::new(&[], &[], &[], 5).unwrap();
    let rows = Rows { time: &mut [], interval: &mut [], velocity: &mut [], sequences: &mut [] };
    assert_eq!(none.run(rows), Ok(Tally::default()));
}
