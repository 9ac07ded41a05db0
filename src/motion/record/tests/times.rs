//! Columns of times: rounding of what is printed, and uneven spacing.

use super::{Asked, GIVEN, Step, text, wrong};

const FILE: Asked = Asked { step: Step::OfFile, ..GIVEN };

fn file(times: impl Iterator<Item = String>) -> String {
    times.map(|time| format!("{time} 0.1\n")).collect()
}

#[test]
fn printed_times_may_be_rounded() {
    // 256 Hz with four digits, and a third of 10 ms with six.
    let read = text(&file((0..5000).map(|k| format!("{:.4}", f64::from(k) / 256.0))), FILE).unwrap();
    assert_eq!(read.dt, Some(1.0 / 256.0));
    let thirds = file((0..500).map(|k| format!("{:.6}", f64::from(k) * 0.01 / 3.0)));
    let dt = text(&thirds, FILE).unwrap().dt.unwrap();
    assert!((dt * 300.0 - 1.0).abs() < 1e-6, "{dt}");
    assert_eq!(text(&thirds, Asked { step: Step::Seconds(0.01 / 3.0), ..FILE }).unwrap().dt, Some(0.01 / 3.0));
}

#[test]
fn times_in_single_precision_are_even() {
    let single = file((0..5000_u16).map(|k| format!("{}", f64::from(f32::from(k) * 0.005_f32))));
    assert_eq!(text(&single, FILE).unwrap().dt, Some(0.005));
    let exponents = file((0..5000).map(|k| format!("{:.4e}", f64::from(k) * 0.005)));
    assert_eq!(text(&exponents, FILE).unwrap().dt, Some(0.005));
}

#[test]
fn a_decimal_step_is_that_decimal_number() {
    for step in ["0.01", "0.005", "0.02", "0.0048828125", "0.1", "0.0025"] {
        let dt: f64 = step.parse().unwrap();
        for count in [2, 3, 1000] {
            let read = text(&file((0..count).map(|k| format!("{}", f64::from(k) * dt))), FILE).unwrap();
            assert_eq!(read.dt, Some(dt), "{step} {count}");
        }
    }
}

#[test]
fn times_that_do_not_begin_at_zero_are_told() {
    let read = text("0.01 0.1\n0.02 -0.1\n0.03 0.1\n0.04 -0.1\n", FILE).unwrap();
    assert_eq!(
        (read.dt, read.notes.as_slice()),
        (Some(0.01), &["the times begin at 0.01 s; sample 0 is put at 0".to_owned()][..])
    );
}

#[test]
fn the_line_where_the_spacing_changes_is_named() {
    let even = |k: i32| format!("{:.2}", f64::from(k) * 0.01);
    let gap = file((0..20).filter(|k| *k != 12).map(even));
    assert!(
        wrong(&gap, FILE)
            .starts_with("line 13: the time 0.13 s follows 0.11 s, a step of 0.02 s after steps of 0.01 s"),
        "{}",
        wrong(&gap, FILE)
    );
    let slip = file((0..20).map(|k| if k == 7 { "0.075".to_owned() } else { even(k) }));
    assert!(wrong(&slip, FILE).starts_with("line 8: the time 0.075 s follows 0.06 s"));
    let back = file((0..20).map(|k| if k == 7 { "0.05".to_owned() } else { even(k) }));
    assert!(wrong(&back, FILE).starts_with("line 8: the time 0.05 s follows 0.06 s; expected is a later one"));
    let spectrum = file((1..20).map(|k| format!("{:.4}", 0.01 * 1.2_f64.powi(k))));
    assert!(wrong(&spectrum, FILE).contains("expected are evenly spaced times"));
    assert!(
        wrong("Period (s), SA (g)\n0.1 0.2\n0.2 0.3\n", FILE)
            .starts_with("line 1: `Period (s), SA (g)` is of a spectrum")
    );
}

#[test]
fn times_in_another_unit_are_refused() {
    for title in ["time (ms), acc (g)", "Time[ms] Accel[g]", "t_ms,acc"] {
        let told = wrong(&format!("{title}\n0 0.1\n10 0.2\n20 0.3\n"), FILE);
        assert!(
            told.starts_with(&format!("line 1: `{title}` has times in another unit; expected are seconds")),
            "{told}"
        );
    }
}

#[test]
fn times_too_coarse_for_their_step_are_refused() {
    let coarse = file((0..50).map(|k| format!("{:.2}", f64::from(k) * 0.005)));
    assert!(wrong(&coarse, FILE).contains("2 columns, none with times"));
    assert!(wrong(&format!("time acc\n{coarse}"), FILE).contains("expected is a later one"));
}

#[test]
fn the_step_of_the_scene_has_to_be_that_of_the_times() {
    let times = "0.00 0.1\n0.01 0.2\n0.02 0.3\n";
    let told = wrong(times, Asked { step: Step::Seconds(0.02), ..FILE });
    assert!(told.starts_with("line 1: the file says that its time step is 0.01 s, the scene dt = 0.02 s"), "{told}");
    for dt in [0.0, -0.01, f64::NAN, f64::INFINITY] {
        assert!(wrong(times, Asked { step: Step::Seconds(dt), ..FILE }).starts_with("dt is "));
    }
}
