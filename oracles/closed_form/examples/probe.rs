use contract::{Case, Horizon, Oracle};
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|s| s.parse().unwrap()).collect();
    let mut c = Case::from_amplitude(a[0], a[1], a[2]).unwrap().with_max_impacts(a[3] as usize).unwrap();
    if a.len() > 4 {
        c = c.with_horizon(Horizon::Until(a[4])).unwrap();
    }
    let h = closed_form::ClosedForm.history(&c).unwrap();
    for (n, i) in h.impacts.iter().enumerate() {
        println!(
            "{} {:?} {:?} {:?} {:.2e} {:.2e} {:.2e}",
            n + 1,
            i.time,
            i.interval,
            i.velocity,
            i.uncertainty.time / i.time,
            i.uncertainty.interval,
            i.uncertainty.velocity
        );
    }
    println!("{:?}", h.ending);
}
